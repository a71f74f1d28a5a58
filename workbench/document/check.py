"""What a document must hold to be worked with; edits and files are refused here, with the field's path.

What a struct's fields declare is looked at by a function made once for each type of struct; what no field
can say by itself stands in ``_LAWS``. All of them give the first fault: a path below the struct, empty for
the struct itself, and what is said of it, which begins with a verb.
"""

import math
import re
from collections.abc import Callable
from functools import cache
from operator import attrgetter
from typing import Any

import msgspec

from workbench.algorithms import catalogue
from workbench.document.addresses import highest
from workbench.document.differences import between
from workbench.document.errors import DocumentError
from workbench.document.fields import (
    Choice,
    Number,
    fields_of,
    numbers_of,
    once_per_type,
    structs_in,
)
from workbench.document.identities import are_ids, ids, ids_sound, new_ids_sound
from workbench.document.model import (
    LINE_CLIPPERS,
    MAX_PALETTE,
    POLYGON_CLIPPERS,
    AnyFigure,
    Curve,
    Document,
    Figure,
    Polygon,
    Rectangle,
    Sheet,
)
from workbench.document.scene import laws as scene_laws
from workbench.document.storage.blobs import Blob
from workbench.document.transforms.chains import LARGEST
from workbench.language import _, ngettext

MIN_EXTENT = 1e-6
MAX_SHEETS = 1_000
MAX_FIGURES = 100_000
MAX_VIEWS = 64
MAX_LINKS = 200
MAX_OBJECTS = 1_000
MAX_LIGHTS = 8
MAX_NAME = 200
RING_LEAST = 3

_ID = attrgetter("id")
_SURROGATE = re.compile("[\ud800-\udfff]")

Fault = tuple[str, str]
Look = Callable[[Any, Any, Any], Fault | None]  # the value, what it was before, the sheet around it


@cache
def labels() -> dict[str, str]:
    """What a person calls a field; fields that the course writes as letters are called so."""
    kinds = structs_in(Document)
    numbers = {name: number.label for kind in kinds for name, number in numbers_of(kind).items()}
    return numbers | {
        "views": _("list of views"),
        "mode": _("mode"),
        "mirror": _("mirror"),
        "transforms": _("chain of transforms"),
        "objects": _("list of objects"),
        "materials": _("list of materials"),
        "lights": _("list of lights"),
        "points": _("list of points"),
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


def shown(value: Any) -> str:
    """``value`` as an error shows it: at most forty characters."""
    try:
        text = repr(value)
    except ValueError:
        return _("a number of thousands of digits")
    return text if len(text) <= 40 else text[:39] + "…"


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
        raise refuse(*_below(field, fault))


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
    places = _places_of(kind)
    laws = [law for base in reversed(kind.__mro__) for law in _LAWS.get(base, ())]

    def look_at_struct(struct: Any, before: Any, sheet: Any) -> Fault | None:
        for name, low, high, types, number in numbers:
            value = getattr(struct, name)
            if type(value) not in types or not low <= value <= high:
                return name, number_problem(number, value)
        sheet = struct if kind is Sheet else sheet
        for name, look in others:
            if fault := look(getattr(struct, name), getattr(before, name, None), sheet):
                return _below(name, fault)
        if places and (fault := _misplaced(struct, sheet)):
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
        "entries": (16, 16, _("entry")),
    }.get(name, (0, math.inf, ""))


def _below(name: str, fault: Fault) -> Fault:
    path, problem = fault
    return f"{name}{path}" if path[:1] in ("", "[") else f"{name}.{path}", problem


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
        if problem := _count(values, least, most, what):
            return "", problem
        return look(values, before, sheet)

    return look_at_list


def _values(look: Look) -> Look:
    """``look`` at each of a list of values."""

    def look_at_all(values: Any, before: Any, sheet: Any) -> Fault | None:
        for index, value in enumerate(values if values is not before else ()):
            if fault := look(value, None, sheet):
                return _below(f"[{index}]", fault)
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
            return _below(f"[{index}]", fault)
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


def _count(values: Any, least: int, most: float, what: str) -> str:
    """What is wrong with a list of what is called ``what``; empty when nothing is."""
    if not isinstance(values, tuple):
        return _("is not a list; give one")
    if len(values) < least:
        problem = ngettext(
            "has {count} of at least {least} {what}; add what is missing",
            "has {count} of at least {least} {what}s; add what is missing",
            least,
        )
        return problem.format(count=len(values), least=least, what=what)
    if len(values) > most:
        problem = _("has {count:,} entries of at most {most:,}; remove some")
        return problem.format(count=len(values), most=most)
    return ""


# What no field can say by itself


def _drawable(figure: AnyFigure, before: AnyFigure | None) -> Fault | None:
    problem = _("is {value}, which cannot draw this figure; choose one of {choices}")
    return _not_among(figure.algorithms, "algorithm", figure, before, problem)


def _clippable(sheet: Sheet, before: Sheet | None) -> Fault | None:
    lines = _("is {value}, which cannot clip lines; choose one of {choices}")
    polygons = _("is {value}, which cannot clip polygons; choose one of {choices}")
    return _not_among(LINE_CLIPPERS, "line_clipper", sheet, before, lines) or _not_among(
        POLYGON_CLIPPERS, "polygon_clipper", sheet, before, polygons
    )


def _not_among(slugs: tuple[str, ...], name: str, struct: Any, before: Any, problem: str) -> Fault | None:
    """A slug that the catalogue lacks may stay, but is never chosen."""
    slug = getattr(struct, name)
    chosen = before is not None and getattr(before, name) != slug
    if slug in slugs or not (chosen or catalogue.known(slug)):
        return None
    return name, problem.format(value=shown(slug), choices=", ".join(slugs))


def _misplaced(holder: Any, sheet: Sheet) -> Fault | None:
    """The first number of ``holder`` that is a place in a list of the sheet, but not one that is there."""
    for name, list_name in _places_of(type(holder)):
        place, count = getattr(holder, name), len(getattr(sheet, list_name))
        if not 0 <= place < count:
            problem = _("is {value}, but the palette has the colours 0 to {last}; choose one of these")
            return name, problem.format(value=shown(place), last=count - 1)
    return None


@once_per_type
def _places_of(kind: type) -> tuple[tuple[str, str], ...]:
    """Each number of a struct that is a place in a list of the sheet, and that list."""
    return tuple((name, number.indexes) for name, number in numbers_of(kind).items() if number.indexes)


def _held_colours(sheet: Sheet, before: Sheet | None) -> Fault | None:
    """Every figure looks again at a palette that has become shorter."""
    if before is None or len(sheet.palette) >= len(before.palette):
        return None
    for index, figure in enumerate(sheet.figures):
        if fault := _misplaced(figure, sheet):
            return _below(f"figures[{index}]", fault)
    return None


def _chain(figure: AnyFigure, _before: Any) -> Fault | None:
    """What a chain makes of any point can still be drawn."""
    matrix = figure.matrix
    if matrix is None or all(-LARGEST <= number <= LARGEST for row in matrix.tolist() for number in row):
        return None
    problem = _("has a matrix with numbers beyond {most:g}; make a scale factor or a shear smaller")
    return "transforms", problem.format(most=LARGEST)


def _rings(polygon: Polygon, _before: Any) -> Fault | None:
    start, last = 0, len(polygon.points_world)
    for index, end in enumerate(polygon.ring_ends):
        if end - start < RING_LEAST:
            problem = _("has {count} of at least {least} points in ring {ring}; add what is missing")
            count = max(end - start, 0)
            return "ring_ends", problem.format(count=count, least=RING_LEAST, ring=index + 1)
        start = end
    if polygon.ring_ends and start != last:
        problem = _("ends at {end}, but there are {count} points; end the last ring there")
        return "ring_ends", problem.format(end=start, count=last)
    return None


def needed_knots(curve: Curve) -> int:
    """How many knots points and degree ask for; of a closed curve those of one turn, both ends counted."""
    return len(curve.points_world) + (1 if curve.closed else curve.degree + 1)


def _knots(curve: Curve, _before: Any) -> Fault | None:
    needed = needed_knots(curve) if curve.knot_rule == "free" else 0
    if problem := _count(curve.knots, needed, needed, _("knot")):
        return "knots", problem
    for index in range(1, len(curve.knots)):
        low, high = curve.knots[index - 1].u, curve.knots[index].u
        if high < low:
            problem = _(
                "is {value}, less than the knot before it, {before}; knots may not decrease: raise it"
            )
            return f"knots[{index}].u", problem.format(value=shown(high), before=shown(low))
    return None


def _extent(rectangle: Rectangle, _before: Any) -> Fault | None:
    for low, high, side in (("xmin", "xmax", _("width")), ("ymin", "ymax", _("height"))):
        a, b = getattr(rectangle, low), getattr(rectangle, high)
        if not b - a >= MIN_EXTENT:
            problem = _(
                "has no {side}: {low} is {a} and {high} is {b}; drag one of its sides, or type another value"
            )
            return "", problem.format(side=side, low=low, a=a, high=high, b=b)
    return None


_LAWS: dict[type, tuple[Callable[[Any, Any], Fault | None], ...]] = {
    **scene_laws.LAWS,
    Sheet: (_held_colours, _clippable),
    Figure: (_drawable, _chain),
    Polygon: (_rings,),
    Curve: (_knots,),
    Rectangle: (_extent,),
}


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
            problem = _("is {value}, which another has too; give it its own")
            return refuse(field, problem.format(value=shown(identity)))
        seen.add(identity)
    raise AssertionError("all ids are sound")
