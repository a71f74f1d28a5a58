"""Addresses of attributes: they name sheet, figure and point by id, and so survive every edit of the others.

As text: ``s1/width_px``, ``s1/palette.2``, ``s1/v3/window_world.xmin``, ``s1/f2/radius_world``,
``s1/f2/p3/x``, ``s1/f2/t4/angle``. A view of a sheet, and an object, a material, a light or a named view
of its scene, stand where a figure does, a knot or a link of a chain where a point does:
``s1/scene.camera.eye.x``, ``s1/o5/solid.radius``, ``s1/o5/t6/angle``; so do a track of its motion and its
keys: ``s1/a7/k8/frame``. ``*`` in place of the attribute means the whole sheet, figure or point; ``sheets``,
``s1/figures``, ``s1/scene.objects`` and ``s1/f2/points_world`` mean what is in the list and in which order.
"""

from collections.abc import Collection
from operator import attrgetter
from typing import Any

import msgspec

from workbench.document.differences import between
from workbench.document.errors import DocumentError
from workbench.document.fields import Field, fields_of, parts_of
from workbench.document.model import AnyFigure, Document, Sheet, View, WorldPoint
from workbench.document.motion.model import Track
from workbench.document.parts import number_of
from workbench.document.scene.model import Thing
from workbench.language import _

WHOLE = "*"


class Address(msgspec.Struct, frozen=True, order=True):
    """Where an attribute is: sheet, figure (or view) and point (or knot, or link) by id, and its name.

    An id is empty where the attribute lies further up.
    """

    sheet: str = ""
    figure: str = ""
    point: str = ""
    attribute: str = WHOLE

    def __str__(self) -> str:
        return "/".join(part for part in (self.sheet, self.figure, self.point, self.attribute) if part)


def parse(text: str | Address) -> Address:
    """The address that ``text`` writes; raises DocumentError where it writes none."""
    if isinstance(text, Address):
        return text
    parts = text.split("/")
    if not 1 <= len(parts) <= 4 or not all(parts):
        raise DocumentError(
            text,
            _("{text!r} is not an address; write one such as s1/f2/p3/x or s1/f2/radius_world.").format(
                text=text
            ),
        )
    sheet, figure, point = (*parts[:-1], "", "", "")[:3]
    return Address(sheet, figure, point, parts[-1])


def sheet_with(document: Document, sheet: str) -> Sheet:
    """The sheet with this id; raises DocumentError."""
    for candidate in document.sheets:
        if candidate.id == sheet:
            return candidate
    raise DocumentError(
        sheet, _("There is no sheet {id!r}; choose one of the document's sheets.").format(id=sheet)
    )


def figure_with(document: Document, figure: str) -> tuple[Sheet, AnyFigure]:
    """The figure with this id and the sheet it is on; raises DocumentError."""
    for sheet in document.sheets:
        for candidate in sheet.figures:
            if candidate.id == figure:
                return sheet, candidate
    raise DocumentError(figure, _("There is no figure {id!r}; it may have been removed.").format(id=figure))


def figures_with(document: Document, figures: Collection[str]) -> list[AnyFigure]:
    """The figures with these ids, in the order of ``figures``; raises DocumentError."""
    ids = frozenset(figures)
    found = {figure.id: figure for sheet in document.sheets for figure in sheet.figures if figure.id in ids}
    for identity in figures:
        if identity not in found:
            figure_with(document, identity)
    return [found[identity] for identity in figures]


def point_with(figure: AnyFigure, point: str) -> WorldPoint:
    """The control point of ``figure`` with this id; raises DocumentError."""
    for candidate in figure.points_world:
        if candidate.id == point:
            return candidate
    raise _no_point(figure, point)


def _no_point(holder: AnyFigure | Thing | Track, point: str) -> DocumentError:
    sentence = (
        _("{figure!r} has no part {id!r}; it may have been removed.")
        if isinstance(holder, Thing | Track)
        else _("Figure {figure!r} has no point {id!r}; it may have been removed.")
    )
    return DocumentError(f"{holder.id}/{point}", sentence.format(figure=holder.id, id=point))


def view_with(document: Document, view: str) -> tuple[Sheet, View]:
    """The view with this id and the sheet it is of; raises DocumentError."""
    for sheet in document.sheets:
        for candidate in sheet.views:
            if candidate.id == view:
                return sheet, candidate
    raise DocumentError(view, _("There is no view {id!r}; it may have been removed.").format(id=view))


def part_with(holder: AnyFigure | Thing | Track, part: str) -> Any:
    """The point, knot, link or key with this id of what has such parts; raises DocumentError."""
    candidate = next((candidate for candidate in holder.parts if candidate.id == part), None)
    if candidate is None:
        raise _no_point(holder, part)
    return candidate


def owner(document: Document, address: Address) -> Any:
    """What the attribute of ``address`` belongs to; raises DocumentError."""
    if not address.sheet:
        return document
    sheet = sheet_with(document, address.sheet)
    if not address.figure:
        return sheet
    for figure in sheet.figures:
        if figure.id == address.figure:
            return part_with(figure, address.point) if address.point else figure
    for view in sheet.views:
        if view.id == address.figure and not address.point:
            return view
    for thing in sheet.things[len(sheet.figures) :]:
        if thing.id == address.figure:
            return part_with(thing, address.point) if address.point else thing
    raise DocumentError(
        str(address),
        _("{address}: there is no such figure; it may have been removed.").format(address=address),
    )


def resolve(document: Document, address: Address | str) -> Any:
    """The value at ``address`` (for ``*`` the sheet, figure or point itself); raises DocumentError."""
    address = parse(address)
    value: Any = owner(document, address)
    if address.attribute == WHOLE:
        return value
    for name in address.attribute.split("."):
        if isinstance(value, tuple) and name.isdecimal() and int(name) < len(value):
            value = value[int(name)]
        elif isinstance(value, msgspec.Struct) and name in value.__struct_fields__:
            value = getattr(value, name)
        else:
            raise DocumentError(
                str(address),
                _("{address}: there is no such attribute; choose one that is there.").format(address=address),
            )
    return value


def declared_at(document: Document, address: Address | str) -> Field:
    """What is declared of the attribute at ``address``; raises DocumentError where there is none."""
    address = parse(address)
    resolve(document, address)
    holder: Any = owner(document, address)
    field = Field(msgspec.Struct)
    for name in address.attribute.split(".") if address.attribute != WHOLE else ():
        if name.isdecimal():
            field, holder = Field(field.kind), holder[int(name)]
        else:
            field, holder = fields_of(type(holder))[name], getattr(holder, name)
    return field


def changed(old: Document, new: Document) -> frozenset[Address]:
    """The addresses of everything that differs. What came or went is one address of the whole (``*``)."""
    addresses: set[Address] = set()
    if old.sheets is not new.sheets:
        _lists(addresses, old.sheets, new.sheets, Address(), "sheets", 0)
    return frozenset(addresses)


_LEVELS = ("sheet", "figure", "point")


def _lists(
    found: set[Address],
    old: tuple[Any, ...],
    new: tuple[Any, ...],
    above: Address,
    attribute: str,
    level: int,
) -> None:
    for identity, a, b in _different(found, old, new, msgspec.structs.replace(above, attribute=attribute)):
        at = msgspec.structs.replace(above, **{_LEVELS[level]: identity})
        if a is None or b is None or type(a) is not type(b):
            found.add(at)
            continue
        _fields(found, a, b, at, "", level)


def _fields(found: set[Address], a: Any, b: Any, at: Address, above: str, level: int) -> None:
    """What differs in two structs of a type; ``above`` is the path of attributes down to them."""
    inner = parts_of(type(a))
    for name in a.__struct_fields__:
        x, y = getattr(a, name), getattr(b, name)
        if x is y or name == "id":
            continue
        if name in inner:
            _lists(found, x, y, at, f"{above}{name}", level + 1)
        elif isinstance(x, msgspec.Struct) and type(x) is type(y):
            _fields(found, x, y, at, f"{above}{name}.", level)
        elif x != y:
            parts = _parts(f"{above}{name}", x, y)
            found.update(msgspec.structs.replace(at, attribute=text) for text in parts)


def _different(
    found: set[Address], old: tuple[Any, ...], new: tuple[Any, ...], whole: Address
) -> list[tuple[str, Any, Any]]:
    """Id, old and new of what is not the same; the ``whole`` list is found too where its order differs."""
    start, old_end, new_end = between(old, new)
    before = {item.id: item for item in old[start:old_end]}
    after = {item.id: item for item in new[start:new_end]}
    if list(before) != list(after):
        found.add(whole)
    names = before.keys() | after.keys()
    pairs = ((name, before.get(name), after.get(name)) for name in names)
    return [(name, a, b) for name, a, b in pairs if a is not b]


def _parts(name: str, old: Any, new: Any) -> list[str]:
    if isinstance(old, tuple):
        parts = [f"{name}.{index}" for index, (a, b) in enumerate(zip(old, new, strict=False)) if a != b]
        return parts if len(old) == len(new) else [name, *parts]
    return [name]


def highest(document: Document) -> int:
    """The highest number that an id in ``document`` ends in; each figure looks for its own only once."""
    sheets = document.sheets
    figures = [max(map(attrgetter("highest"), sheet.things), default=0) for sheet in sheets]
    own = [number_of(name) for sheet in sheets for name in (sheet.id, *(view.id for view in sheet.views))]
    return max(*figures, *own)


def new_ids(document: Document, prefix: str, count: int) -> list[str]:
    """``count`` ids that ``document`` has never given, such as f7, f8: prefix s, f or p by habit."""
    first = max(document.last_id, highest(document)) + 1
    return [f"{prefix}{first + index}" for index in range(count)]
