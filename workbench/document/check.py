"""What a document must hold to be worked with; edits and files are refused here, with the field's path.

What a struct's fields declare is looked at by a function made once for each type of struct; what no field
can say by itself stands in ``laws``. All of them give the first fault.
"""

import math
import re
from collections.abc import Callable
from functools import cache
from operator import attrgetter
from typing import Any

import msgspec

from workbench.document.addresses import highest
from workbench.document.differences import between
from workbench.document.errors import DocumentError
from workbench.document.faults import Fault, below, count_problem, shown
from workbench.document.fields import (
    Choice,
    Number,
    fields_of,
    numbers_of,
    once_per_type,
    structs_in,
)
from workbench.document.identities import are_ids, ids, ids_sound, new_ids_sound
from workbench.document.laws import LAWS, misplaced, places_of
from workbench.document.model import (
    MAX_PALETTE,
    Document,
    Figure,
    Sheet,
)
from workbench.document.storage.blobs import Blob
from workbench.language import _

MAX_SHEETS = 1_000
MAX_FIGURES = 100_000
MAX_VIEWS = 64
MAX_LINKS = 200
MAX_OBJECTS = 1_000
MAX_LIGHTS = 8
MAX_TRACKS = 10_000
MAX_KEYS = 100_000
MAX_NAME = 200

_ID = attrgetter("id")
_SURROGATE = re.compile("[\ud800-\udfff]")

Look = Callable[[Any, Any, Any], Fault | None]  # the value, what it was before, the sheet around it


@cache
def labels() -> dict[str, str]:
    """What a person calls a field; fields that the course writes as letters are called so."""
    kinds = structs_in(Document)
    numbers = {name: number.label for kind in kinds for name, number in numbers_of(kind).items()}
    return numbers | {
        "sheets": _("list of sheets"),
        "figures": _("list of figures"),
        "views": _("list of views"),
        "mode": _("mode"),
        "mirror": _("mirror"),
        "transforms": _("chain of transforms"),
        "objects": _("list of objects"),
        "materials": _("list of materials"),
        "lights": _("list of lights"),
        "named_views": _("list of named views"),
        "points": _("list of points"),
        "tracks": _("list of tracks"),
        "keys": _("list of keys"),
        "target": _("address"),
        "easing": _("easing"),
        "window_world": _("window"),
        "viewport_device": _("viewport"),
        "algorithm": _("algorithm"),
        "points_world": _("list of points"),
        "clip_world": _("clip window"),
        "line_clipper": _("line clipper"),
        "polygon_clipper": _("polygon clipper"),
    }


def refuse(field: str, problem: str) -> DocumentError:
    """An error whose sentence is ``field`` followed by ``problem``, which begins with a verb."""
    last = re.sub(r"\[\d+\]$", "", field.rpartition(".")[2])
    called = labels().get(last, last)
    short = _("The {field} {problem}.").format(field=called, problem=problem)
    return DocumentError(field, f"{field} {problem}.", short)


def check(document: Document, before: Document | None = None) -> Document:
    """``document`` itself when it is sound; what it shares with the sound ``before`` is not looked at again.

    Raises DocumentError with the path of the first field that is wrong.
    """
    if fault := _look_at(Document)(document, before, None):
        raise refuse(*fault)
    if not (ids_sound(document) if before is None else new_ids_sound(before, document)):
        raise _wrong_id(document)
    if before is None:
        highest(document)  # every figure keeps its own, so that the first edit has not to look at all of them
    return document


def check_part(part: Any, field: str) -> None:
    """Raises DocumentError where a struct that stands outside of a document, at ``field``, is not sound."""
    if fault := _look_at(type(part))(part, None, None):
        raise refuse(*below(field, fault))


# What the fields of a struct declare


@once_per_type
def _look_at(kind: type) -> Look:
    """What looks for the first fault in a struct of this type, given what it was before, if it was."""
    numbers, others = [], []
    for name, (holds, many) in fields_of(kind).items():
        if isinstance(holds, Number) and not many:
            types = (int,) if holds.whole else (float, int)
            numbers.append((name, holds.low, holds.high, types, holds))
        elif name != "id":
            others.append((name, _look_at_entries(kind, name, holds) if many else _look_at_value(holds)))
    places = places_of(kind)
    laws = [law for base in reversed(kind.__mro__) for law in LAWS.get(base, ())]

    def look_at_struct(struct: Any, before: Any, sheet: Any) -> Fault | None:
        for name, low, high, types, number in numbers:
            value = getattr(struct, name)
            if type(value) not in types or not low <= value <= high:
                return name, number_problem(number, value)
        sheet = struct if kind is Sheet else sheet
        for name, look in others:
            if fault := look(getattr(struct, name), getattr(before, name, None), sheet):
                return below(name, fault)
        if places and (fault := misplaced(struct, sheet)):
            return fault
        for law in laws:
            if fault := law(struct, before):
                return fault
        return None

    return look_at_struct


def _limits(kind: type, name: str) -> tuple[int, float, str]:
    """The least and the most entries of a list, and what one of them is called."""
    if issubclass(kind, Figure) and name == "points_world":
        return kind.least_points, kind.most_points, _("point")
    return {
        "sheets": (1, MAX_SHEETS, _("sheet")),
        "figures": (0, MAX_FIGURES, _("figure")),
        "views": (1, MAX_VIEWS, _("view")),
        "transforms": (0, MAX_LINKS, _("transform")),
        "palette": (2, MAX_PALETTE, _("colour")),
        "objects": (0, MAX_OBJECTS, _("object")),
        "materials": (0, MAX_PALETTE, _("material")),
        "lights": (0, MAX_LIGHTS, _("light")),
        "named_views": (0, MAX_VIEWS, _("view")),
        "entries": (16, 16, _("entry")),
        "tracks": (0, MAX_TRACKS, _("track")),
        "keys": (1, MAX_KEYS, _("key")),
    }.get(name, (0, math.inf, ""))


def _look_at_value(holds: Any) -> Look:
    if isinstance(holds, Number):
        return lambda value, *_others: ("", problem) if (problem := number_problem(holds, value)) else None
    if isinstance(holds, Choice):
        return lambda value, *_others: None if value in holds.names else ("", _no_choice(value, holds.names))
    looks: dict[type, Look] = {bool: _truth, str: _text, Blob: _blob, msgspec.Struct: _struct}
    return looks[holds]


def _look_at_entries(kind: type, name: str, holds: Any) -> Look:
    least, most, what = _limits(kind, name)
    look = _parts if holds is msgspec.Struct else _values(_look_at_value(holds))

    def look_at_list(values: Any, before: Any, sheet: Any) -> Fault | None:
        if problem := count_problem(values, least, most, what):
            return "", problem
        return look(values, before, sheet)

    return look_at_list


def _values(look: Look) -> Look:
    """``look`` at each of a list of values."""

    def look_at_all(values: Any, before: Any, sheet: Any) -> Fault | None:
        for index, value in enumerate(values if values is not before else ()):
            if fault := look(value, None, sheet):
                return below(f"[{index}]", fault)
        return None

    return look_at_all


def _parts(parts: Any, before: Any, sheet: Any) -> Fault | None:
    """The first fault in one of ``parts`` that is not among those ``before``, found by their ids."""
    start, old_end, end = between(before or (), parts)
    old_parts = before[start:old_end] if start < old_end else ()
    known = dict(zip(map(_ID, old_parts), old_parts, strict=True))
    for index in range(start, end):
        part = parts[index]
        old = known.get(part.id) if known else None
        if old is not part and (fault := _look_at(type(part))(part, old, sheet)):
            return below(f"[{index}]", fault)
    return None


def _struct(struct: Any, before: Any, sheet: Any) -> Fault | None:
    return None if struct is before or struct is None else _look_at(type(struct))(struct, before, sheet)


def _truth(value: Any, *_others: Any) -> Fault | None:
    if type(value) is not bool:
        return "", _("is {value}; give true or false").format(value=shown(value))
    return None


def _blob(value: Any, *_others: Any) -> Fault | None:
    return None if isinstance(value, Blob) else ("", _("is not the content of a file; import it again"))


def _text(value: Any, *_others: Any) -> Fault | None:
    if type(value) is not str or len(value) > MAX_NAME:
        return "", _("is too long; give a text of at most {most} characters").format(most=MAX_NAME)
    if not value.isascii() and _SURROGATE.search(value):
        return "", _("has a character that no file can hold; type it again")
    return None


def number_problem(number: Number, value: Any) -> str:
    """What is wrong with ``value`` as this number; empty when nothing is."""
    if number.whole:
        if type(value) is not int:
            return _("is {value}; give a whole number").format(value=shown(value))
        problem = _("is {value}; give a whole number between {low} and {high}")
    else:
        if type(value) is not int and (type(value) is not float or not math.isfinite(value)):
            return _("is {value}; give a finite number").format(value=shown(value))
        problem = _("is {value}; give a number between {low} and {high}")
    if number.low <= value <= number.high:
        return ""
    return problem.format(value=shown(value), low=_limit(number.low), high=_limit(number.high))


def _limit(limit: float) -> str:
    """A limit as a sentence gives it: an int as it is, others with six digits, a million with commas."""
    if type(limit) is int:
        return str(limit)
    return f"{limit:,.0f}" if abs(limit) == 1e6 else f"{limit:g}"


def _no_choice(value: Any, choices: tuple[str, ...]) -> str:
    return _("is {value}; choose one of {choices}").format(value=shown(value), choices=", ".join(choices))


def _wrong_id(document: Document) -> DocumentError:
    """What is wrong with the first id that is not sound."""
    seen: set[str] = set()
    for field, identity in ids(document):
        if not are_ids([identity]):
            problem = _(
                "is {value}; an id is a letter and up to 31 letters, digits, - or _, at most 15 digits last"
            )
            return refuse(field, problem.format(value=shown(identity)))
        if identity in seen:
            problem = _("is {value}, which another one already has; give it one of its own")
            return refuse(field, problem.format(value=shown(identity)))
        seen.add(identity)
    raise AssertionError("all ids are sound")
