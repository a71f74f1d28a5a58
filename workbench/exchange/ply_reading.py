"""PLY (Stanford): as text, and as bytes of either order, with whatever further properties and elements."""

import re
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.document.storage.content import Progress
from workbench.exchange.mesh_limits import MOST_FACES, Refuse
from workbench.exchange.mesh_reading import Raw
from workbench.exchange.mesh_rows import numbers_of, whole_numbers
from workbench.geometry.meshes import Faces
from workbench.language import _, ngettext

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
    "float": "f4", "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2",
    "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8", "int64": "i8", "uint64": "u8",
}  # fmt: skip
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_CORNERS = ("vertex_indices", "vertex_index")
_LONGEST_HEAD = 2**16
_END = re.compile(rb"end_header[^\r\n]*(\r\n|\r|\n)")
_BLOCK = 2**22
_MOST_DIGITS = 12  # of a number of entries


class _Property(NamedTuple):
    name: str
    type: str
    count_type: str = ""  # of a list


class _Element(NamedTuple):
    name: str
    entries: int
    properties: list[_Property]


def read_ply(content: bytes, progress: Progress, refuse: Refuse) -> Raw:
    """What a PLY says. Raises: ValueError where it is none, or breaks off."""
    elements, order, at = _head(content)
    counts = {element.name: element.entries for element in elements}
    if "vertex" not in counts or "face" not in counts:
        raise ValueError(_("The file has no vertices or no faces; choose one with a mesh in it."))
    refuse(counts["vertex"], counts["face"])
    body: _Body = _Bytes(content, at, order) if order else _Words(content[at:], progress)
    points, faces, coloured = np.zeros((0, 3)), Faces.of([]), False
    for element in elements:
        names = {each.name for each in element.properties if not each.count_type}
        if element.name == "vertex":
            if not {"x", "y", "z"} <= names:
                raise ValueError(_("The vertices of the file have no x, y and z; choose another file."))
            columns, _lists = body.take(element, ("x", "y", "z"), ())
            points, coloured = np.column_stack(columns), "red" in names
        elif element.name == "face":
            lists = {each.name for each in element.properties if each.count_type}
            named = next((name for name in _CORNERS if name in lists), None)
            if named is None:
                raise ValueError(_("The faces of the file name no vertices; choose another file."))
            _columns, (faces,) = body.take(element, (), (named,))
        else:
            body.take(element, (), ())
        progress(0.5 if element.name == "vertex" else 1.0)
        if element.name == "face" and len(points):
            break
    return Raw(points, faces, 0, coloured)


def _head(content: bytes) -> tuple[list[_Element], str, int]:
    """The elements, the order of bytes (empty for text), and where the head ends."""
    refusal = _("This is not a PLY file: its header is missing or damaged.")
    if not content.startswith(b"ply"):
        raise ValueError(refusal)
    end = _END.search(content, 0, _LONGEST_HEAD)
    if end is None:
        raise ValueError(refusal)
    elements: list[_Element] = []
    order = None
    for line in content[: end.start()].decode("latin-1").replace("\r", "\n").split("\n"):
        match line.split():
            case ["format", name, _version] if name in _ORDERS:
                order = _ORDERS[name]
            case ["element", name, count] if count.isascii() and count.isdecimal():
                if len(count.lstrip("0")) > _MOST_DIGITS:
                    sentence = _(
                        "The header of the PLY file announces too many entries: {line!r}, and at most "
                        "{most:,} vertices and as many faces can be read; choose a simpler mesh."
                    )
                    raise ValueError(sentence.format(line=line.strip()[:60], most=MOST_FACES))
                elements.append(_Element(name, int(count.lstrip("0") or 0), []))
            case ["property", "list", count_type, type_, name] if (
                elements and {count_type, type_} <= _TYPES.keys() and _TYPES[count_type][0] != "f"
            ):
                elements[-1].properties.append(_Property(name, _TYPES[type_], _TYPES[count_type]))
            case ["property", type_, name] if elements and type_ in _TYPES:
                elements[-1].properties.append(_Property(name, _TYPES[type_]))
            case [] | ["ply"] | ["comment", *_] | ["obj_info", *_]:
                pass
            case _other:
                raise ValueError(
                    _("The header of the PLY file has a line that is not known: {line!r}.").format(
                        line=line.strip()[:60]
                    )
                )
    if order is None:
        raise ValueError(refusal)
    return elements, order, end.end()


def _breaks_off(element: _Element) -> ValueError:
    text = ngettext(
        "The file ends before the {count:,} entry that it announces as {name}; get it again.",
        "The file ends before the last of {count:,} entries that it announces as {name}; get it again.",
        element.entries,
    )
    return ValueError(text.format(count=element.entries, name=element.name[:40]))


class _Body:
    """What follows the head, read from ``at`` to ``end`` in units: bytes, or the words of a text."""

    at = 0
    end = 0

    def take(
        self, element: _Element, scalars: tuple[str, ...], lists: tuple[str, ...]
    ) -> tuple[list[Array], list[Faces]]:
        """The columns and lists of these names, of the next element. Raises: ValueError."""
        names = [each.name for each in element.properties]
        sizes = self._first_sizes(element)
        table = self.table(element, sizes)
        if table is not None:
            columns = [table[names.index(name)].astype(np.float64) for name in scalars]
            return columns, [Faces.of(_corners(table[names.index(name)])) for name in lists]
        if not any(each.count_type for each in element.properties):
            raise _breaks_off(element)
        return self._walk(element, scalars, lists)

    def width(self, type_: str) -> int:
        """How many units a number has."""
        raise NotImplementedError

    def count(self, type_: str, at: int) -> int:
        """The number that begins at ``at``, the length of a list; -1 where none can be there."""
        raise NotImplementedError

    def numbers(self, places: Index, type_: str) -> Any:
        """The numbers that begin at ``places``."""
        raise NotImplementedError

    def table(self, element: _Element, sizes: list[int]) -> list[Any] | None:
        """Each property as a column, of a list its rows, and past them; None where its ``sizes`` differ."""
        raise NotImplementedError

    def _first_sizes(self, element: _Element) -> list[int]:
        """How many entries each list of the first row has, 0 where it is no list."""
        sizes, at = [], self.at
        for each in element.properties if element.entries else ():
            size = 0
            if each.count_type:
                size = self._size(each.count_type, at, element)
                at += self.width(each.count_type)
            sizes.append(size)
            at += self.width(each.type) * (size if each.count_type else 1)
        return sizes or [0] * len(element.properties)

    def _size(self, type_: str, at: int, element: _Element) -> int:
        size = self.count(type_, at) if at < self.end else -1
        if not 0 <= size <= self.end - at:
            raise _breaks_off(element)
        return size

    def _walk(
        self, element: _Element, scalars: tuple[str, ...], lists: tuple[str, ...]
    ) -> tuple[list[Array], list[Faces]]:
        """As ``take``, where rows are of different lengths: each is looked for behind the one before."""
        at = self.at
        names = [each.name for each in element.properties]
        places: list[list[int]] = [[] for _each in names]
        sizes: list[list[int]] = [[] for _each in names]
        steps = [
            (places[number], sizes[number], each.count_type, self.width(each.type))
            for number, each in enumerate(element.properties)
        ]
        for _row in range(element.entries):
            for begins, lengths, count_type, width in steps:
                count = 1
                if count_type:
                    count = self._size(count_type, at, element)
                    at += self.width(count_type)
                    lengths.append(count)
                begins.append(at)
                at += count * width
            if at > self.end:
                raise _breaks_off(element)
        self.at = at
        types = [each.type for each in element.properties]
        columns = [
            self.numbers(np.array(places[number]), types[number]).astype(np.float64)
            for number in map(names.index, scalars)
        ]
        rows = []
        for number in map(names.index, lists):
            length = np.array(sizes[number], np.int64)
            ends = np.cumsum(length)
            step = np.arange(int(length.sum())) - np.repeat(ends - length, length)
            begin = np.repeat(np.array(places[number], np.int64), length)
            rows.append(
                Faces(_corners(self.numbers(begin + step * self.width(types[number]), types[number])), ends)
            )
        return columns, rows


class _Bytes(_Body):
    """The body of a binary file."""

    def __init__(self, content: bytes, at: int, order: str) -> None:
        self._content, self._order = content, order
        self._byte_order: Literal["little", "big"] = "little" if order == "<" else "big"
        self.at, self.end = at, len(content)

    def width(self, type_: str) -> int:
        """Bytes."""
        return int(type_[1])

    def count(self, type_: str, at: int) -> int:
        """As of ``_Body``."""
        if type_ == "u1":
            return self._content[at]
        return int.from_bytes(
            self._content[at : at + self.width(type_)], self._byte_order, signed=type_[0] == "i"
        )

    def numbers(self, places: Index, type_: str) -> Any:
        """As of ``_Body``."""
        data = np.frombuffer(self._content, np.uint8)
        return data[places[:, None] + np.arange(self.width(type_))].view(self._order + type_)[:, 0]

    def table(self, element: _Element, sizes: list[int]) -> list[Any] | None:
        """As of ``_Body``."""
        fields: list[Any] = []
        for number, each in enumerate(element.properties):
            if each.count_type:
                fields.append((f"n{number}", self._order + each.count_type))
            shape = (sizes[number],) if each.count_type else ()
            fields.append((f"p{number}", self._order + each.type, shape))
        row = np.dtype(fields)
        if row.itemsize * element.entries > self.end - self.at:
            return None
        rows = np.frombuffer(self._content, row, element.entries, self.at)
        for number, each in enumerate(element.properties):
            if each.count_type and (rows[f"n{number}"] != sizes[number]).any():
                return None
        self.at += row.itemsize * element.entries
        return [rows[f"p{number}"] for number in range(len(element.properties))]


class _Words(_Body):
    """The body of a text file."""

    def __init__(self, text: bytes, progress: Progress) -> None:
        self._numbers = _every_number(text, progress)
        self.at, self.end = 0, len(self._numbers)

    def width(self, _type: str) -> int:
        """One word."""
        return 1

    def count(self, _type: str, at: int) -> int:
        """As of ``_Body``."""
        number = self._numbers[at]
        return int(number) if 0 <= number <= self.end else -1

    def numbers(self, places: Index, _type: str) -> Any:
        """As of ``_Body``."""
        return self._numbers[places.astype(np.int64)]

    def table(self, element: _Element, sizes: list[int]) -> list[Any] | None:
        """As of ``_Body``."""
        is_list = [bool(each.count_type) for each in element.properties]
        width = len(is_list) + sum(sizes[number] for number, some in enumerate(is_list) if some)
        if width * element.entries > self.end - self.at:
            return None
        words = self._numbers[self.at : self.at + width * element.entries].reshape(element.entries, width)
        columns: list[Any] = []
        at = 0
        for size, some in zip(sizes, is_list, strict=True):
            if some and (words[:, at] != size).any():
                return None
            columns.append(words[:, at + 1 : at + 1 + size] if some else words[:, at])
            at += 1 + size
        self.at += words.size
        return columns


def _corners(numbers: Any) -> Index:
    return whole_numbers(numbers, -1)


def _every_number(text: bytes, progress: Progress) -> Array:
    """All numbers of a text. Raises: ValueError, a sentence, where it holds anything else."""
    text = text.replace(b"\r", b"\n").replace(b"\t", b" ")
    parts: list[Array] = []
    begin = 0
    try:
        while begin < len(text):
            end = text.find(b"\n", begin + _BLOCK)
            end = len(text) if end < 0 else end + 1
            parts.append(numbers_of(text[begin:end]))
            begin = end
            progress(0.5 * end / len(text))
    except ValueError:
        sentence = _("The file has something other than numbers after its header; choose another file.")
        raise ValueError(sentence) from None
    return np.concatenate(parts or [np.zeros(0)])
