"""The `.gwb` file: one readable, versioned JSON text; ``saving`` puts it on the disk.

    {"format": "graphics-workbench", "version": 8, "document": ..., "session": ..., "blobs": {...}}

Blobs (large meshes, pictures) are base64 by the SHA-256 of their content. Whatever is wrong with a file is
told as a DocumentError that names the field.
"""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import msgspec

from workbench.document.check import check, refuse
from workbench.document.errors import DocumentError
from workbench.document.model import Document
from workbench.document.places import line_of, path_at
from workbench.document.state import SessionState, check_state
from workbench.document.storage.blobs import MAX_BLOB_BYTES, Blob
from workbench.document.storage.content import Progress, read_content, silent
from workbench.document.storage.embedding import blobs_of, from_text, with_contents
from workbench.document.storage.encoding import pieces
from workbench.document.storage.renumbering import with_room
from workbench.document.storage.saving import replace_file
from workbench.document.storage.upgrades import UPGRADES, Upgrade
from workbench.language import _, legible

FORMAT = "graphics-workbench"
VERSION = 8
# What is opened, and so what is saved: a few of the largest blobs, and fewer values than memory is there for.
MAX_BYTES = 128 * 2**20
MAX_VALUES = 2_000_000  # numbers, texts, lists and objects together
_CHUNK = 2**20
_LONGEST_REASON = 200
_LONGEST_CONSTANT = 40  # NaN or Infinity, and the blanks before it


class Stored(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What a file holds: the picture, the session beside it, and further blobs by their SHA-256.

    The others are set in recovery files only. ``origin``: the file that the picture came from, empty when it
    had none; ``origin_stamp``: the state in which that file was known; ``blobs_beside``: the digests of blobs
    that are files of their own.
    """

    document: Document
    session: SessionState = SessionState()
    blobs: dict[str, bytes] = {}
    origin: str | None = None
    origin_stamp: tuple[int, int, int] | None = None
    blobs_beside: tuple[str, ...] = ()


class _Head(msgspec.Struct):
    format: str
    version: int


class _File(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True):
    format: str
    version: int
    document: Document
    session: SessionState
    blobs: dict[str, bytes]
    origin: str | None = None
    origin_stamp: tuple[int, int, int] | None = None
    blobs_beside: tuple[str, ...] = ()


def load(path: Path | str) -> Document:
    """The document in a file; raises DocumentError."""
    return read(path).document


def save(document: Document, path: Path | str) -> None:
    """Put ``document`` into a file, atomically; raises DocumentError, and the old file stays."""
    write(Stored(document), path)


def read(path: Path | str, progress: Progress = silent) -> Stored:
    """Everything in a file; raises DocumentError."""
    return decode(read_content(path, MAX_BYTES, progress))


def write(stored: Stored, path: Path | str) -> None:
    """Put ``stored`` into a file, atomically; raises DocumentError, and the old file stays.

    Other threads go on meanwhile: nothing here holds the interpreter for long.
    """
    replace_file(Path(path), pieces_of(stored))


def encode(stored: Stored) -> bytes:
    """The text of a file; raises DocumentError when ``stored`` is not sound."""
    return b"".join(pieces_of(stored))


def pieces_of(stored: Stored) -> Iterator[bytes]:
    """The text of a file, each piece proven to read back as what it is of.

    Raises DocumentError when ``stored`` is not sound, or larger than can be opened.
    """
    check(stored.document)
    check_state(stored.session, stored.document)
    blobs = {name: content for name, content in all_blobs(stored).items() if name not in stored.blobs_beside}
    whole = msgspec.structs.replace(stored, blobs=sound_blobs(blobs))
    file = _File(FORMAT, VERSION, *(getattr(whole, name) for name in whole.__struct_fields__))
    size = 0
    for piece in pieces(file, _file_decoder):
        size += len(piece)
        if size > MAX_BYTES:
            sentence = _("The file would have over {most:,} bytes, too many to be opened; remove something.")
            raise DocumentError("", sentence.format(most=MAX_BYTES))
        yield piece


def decode(data: bytes) -> Stored:
    """What the text of a file holds; raises DocumentError, and nothing else, for whatever bytes."""
    _refuse_too_much(data)
    data = data.removeprefix(b"\xef\xbb\xbf")
    if not data or data.isspace():
        raise DocumentError("", _("The file is empty; open another copy of it."))
    wrong = _not_utf_8(data)
    if wrong is not None:
        raise _broken(data, wrong, _("is not UTF-8 text"))
    try:
        file = _typed(data)
    except msgspec.ValidationError as error:
        raise _translated(str(error)) from error
    except msgspec.DecodeError as error:
        raise _malformed(data, str(error)) from error
    except RecursionError as error:
        raise DocumentError("", _("The file is nested too deeply; open another copy of it.")) from error
    blobs = sound_blobs(file.blobs)
    document = with_contents(file.document, blobs, frozenset(file.blobs_beside))
    check(document)
    check_state(file.session, document)
    for digest in blobs_of(document):
        blobs.pop(digest, None)
    document, session = with_room(document, file.session)
    return Stored(document, session, blobs, file.origin, file.origin_stamp, file.blobs_beside)


def _refuse_too_much(data: bytes) -> None:
    if len(data) > MAX_BYTES:
        sentence = _("The file has {size:,} bytes, but at most {most:,} can be opened; choose a smaller one.")
        raise DocumentError("", sentence.format(size=len(data), most=MAX_BYTES))
    # Every value but the first in a list or an object follows a comma; those in texts are counted too.
    values = sum(data.count(sign) for sign in (b",", b"[", b"{"))
    if values > MAX_VALUES:
        sentence = _(
            "The file has {count:,} values, but at most {most:,} can be opened; choose a smaller one."
        )
        raise DocumentError("", sentence.format(count=values, most=MAX_VALUES))


def _not_utf_8(data: bytes) -> int | None:
    """The first byte that is no UTF-8, found without a second copy of the whole."""
    begin = 0
    while begin < len(data):
        end = begin + _CHUNK
        while end < len(data) and end > begin + _CHUNK - 4 and data[end] & 0xC0 == 0x80:
            end -= 1  # a character is not cut in two
        try:
            data[begin:end].decode("utf-8")
        except UnicodeDecodeError as error:
            return begin + error.start
        begin = end
    return None


# Made while the module is imported, by one thread: msgspec 0.22 crashes when two threads decode a type for
# the first time at once, as saving and keeping safe may.
_head_decoder = msgspec.json.Decoder(_Head)
_file_decoder = msgspec.json.Decoder(_File, dec_hook=from_text)


def _typed(data: bytes) -> _File:
    try:
        head = _head_decoder.decode(data)
    except msgspec.ValidationError as error:
        if "`$" in str(error):
            raise
        field = _translated(str(error)).field
        if field == "document":
            raise DocumentError("", _not_ours()) from error
        sentence = _("This is not a Graphics Workbench file ({field}); choose one that it saved.")
        raise DocumentError(field, sentence.format(field=field)) from error
    if head.format != FORMAT:
        problem = _("is {value!r}; choose a file that Graphics Workbench saved")
        raise refuse("format", problem.format(value=legible(head.format)))
    if head.version == VERSION:
        return _file_decoder.decode(data)
    raw = upgraded(msgspec.json.decode(data), head.version)
    return msgspec.convert(raw, _File, dec_hook=from_text)


def upgraded(
    raw: dict[str, Any], version: int, upgrades: Mapping[int, Upgrade] = UPGRADES, newest: int = VERSION
) -> dict[str, Any]:
    """``raw``, the JSON values of a file of an older version, as the newest version; raises DocumentError."""
    if version > newest:
        sentence = _("is {value}, newer than this program reads ({newest}); update the program to open it")
        raise refuse("version", sentence.format(value=version, newest=newest))
    while version < newest:
        if version not in upgrades:
            raise refuse(
                "version",
                _("is {value}, which no program has written; open another copy").format(value=version),
            )
        try:
            raw = upgrades[version](raw)
        except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
            problem = _("is {value}, but the file lacks what such a file must contain; open another copy")
            raise refuse("version", problem.format(value=version)) from error
        version += 1
    return {**raw, "version": newest}


def all_blobs(stored: Stored) -> dict[str, bytes]:
    """The blobs of a picture, those in its document and those beside it, by their digests."""
    return {**stored.blobs, **blobs_of(stored.document)}


def with_blobs(stored: Stored, blobs: Mapping[str, bytes]) -> Stored:
    """``stored`` with all its blobs, none of which is beside it any more; raises DocumentError."""
    sound = sound_blobs(blobs)
    document = check(with_contents(stored.document, sound, frozenset()))
    inside = blobs_of(document)
    outside = {name: content for name, content in sound.items() if name not in inside}
    return msgspec.structs.replace(stored, document=document, blobs=outside, blobs_beside=())


def sound_blobs(blobs: Mapping[str, bytes]) -> dict[str, bytes]:
    """``blobs`` as values that know their digest; raises DocumentError where that is not their name."""
    sound: dict[str, bytes] = {}
    for name, content in blobs.items():
        field = f"blobs.{name if len(name) <= 16 else name[:16] + '…'}"
        if len(content) > MAX_BLOB_BYTES:
            problem = _("has {size:,} bytes, but at most {most:,} can be kept; open another copy")
            raise refuse(field, problem.format(size=len(content), most=MAX_BLOB_BYTES))
        blob = content if isinstance(content, Blob) else Blob(content)
        if blob.digest != name:
            raise refuse(field, _("does not match its content, which was damaged; open another copy"))
        sound[name] = blob
    return sound


# A high surrogate without its low one. At the very end of a file msgspec reports it as "input was truncated".
_ESCAPE = 6
_HALF = re.compile(rb"\\u[dD][89abAB][0-9a-fA-F]{2}(?=[^\\])")


def _not_ours() -> str:
    return _("This is not a picture of Graphics Workbench; choose another file.")


def _malformed(data: bytes, message: str) -> DocumentError:
    offset = re.search(r"\(byte (\d+)\)", message)
    if offset is None:
        half = _HALF.search(data, len(data) - 2 * _ESCAPE)
        if half is not None:
            return _broken(data, half.start(), _("is not JSON"))
        return _broken(data, len(data), _("breaks off"))
    at = int(offset.group(1))
    around = data[max(0, at - 1) : at + _LONGEST_CONSTANT]
    constant = re.match(rb"-?(NaN|Infinity)", around.lstrip(b" :[,\n")) or re.match(
        rb"-?(NaN|Infinity)", data[at : at + _LONGEST_CONSTANT]
    )
    if constant:
        field = _field_at(data, at)
        return refuse(field, _("is {value}; give a finite number").format(value=constant.group().decode()))
    return _broken(data, at, _("is not JSON"))


def _field_at(data: bytes, offset: int) -> str:
    """The path there; what a damaged file has for names may be as long as the file."""
    return legible(path_at(data, offset).removeprefix("document."), _LONGEST_REASON)


def _broken(data: bytes, offset: int, problem: str) -> DocumentError:
    field = _field_at(data, offset)
    if not data.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{"):
        return DocumentError("", _not_ours())
    if not field:
        sentence = _("The file {problem} at line {line}; open another copy of it.")
        return DocumentError("", sentence.format(problem=problem, line=line_of(data, offset)))
    sentence = _("The file {problem} at line {line}, in {field}; open another copy of it.")
    return DocumentError(field, sentence.format(problem=problem, line=line_of(data, offset), field=field))


def _kinds() -> dict[str, str]:
    return {
        "float": _("a number"),
        "int": _("a whole number"),
        "str": _("a text"),
        "bool": _("true or false"),
        "array": _("a list"),
        "object": _("an object"),
        "null": _("nothing"),
        "bytes": _("base64 text"),
    }


def _translated(message: str) -> DocumentError:
    """A DocumentError for what msgspec says of a value of the wrong shape."""
    what, _separator, path = message.partition(" - at `$")
    field = path.rstrip("`").removeprefix(".").removeprefix("document.").replace("[...]", "")
    field = legible(field, _LONGEST_REASON)
    named = re.search(r"(unknown|missing required) field `(.*)`", what, re.DOTALL)
    if named:
        inside = "" if field == "document" else field
        name = legible(named.group(2))
        field = f"{inside}.{name}" if inside else name
        if named.group(1) == "unknown":
            return refuse(field, _("is a field that this version does not know; remove it from the file"))
        return refuse(field, _("is missing; add it to the file or open another copy"))
    kinds = _kinds()
    wrong = re.fullmatch(r"Expected `([^`]*)`, got `([^`]*)`.*", what, re.DOTALL)
    if wrong:
        kinds_wanted = _(" or ").join(kinds.get(kind, kind) for kind in wrong.group(1).split(" | "))
        got = kinds.get(wrong.group(2), wrong.group(2))
        problem = _("is {got} where {wanted} belongs; correct it in the file or open another copy")
        return refuse(field or "document", problem.format(got=got, wanted=kinds_wanted))
    problem = _("is not right ({what}); correct it in the file or open another copy")
    return refuse(
        field or "document", problem.format(what=legible(what[0].lower() + what[1:], _LONGEST_REASON))
    )
