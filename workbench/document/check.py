"""What a document must hold to be worked with; edits and files are refused here, with the field's path."""

import math
import re
from collections.abc import Iterator
from typing import Any

from workbench.algorithms import catalogue
from workbench.document.addresses import highest
from workbench.document.differences import between
from workbench.document.errors import DocumentError
from workbench.document.identities import are_ids, ids_sound, new_ids_sound
from workbench.document.model import (
    ENDS,
    JOINTS,
    KNOT_RULES,
    LINE_CLIPPERS,
    POLYGON_CLIPPERS,
    SPLINES,
    AnyFigure,
    Circle,
    Curve,
    CurvePoint,
    Document,
    Ellipse,
    Polygon,
    Rectangle,
    SeedFill,
    Sheet,
    WorldPoint,
)
from workbench.language import _, ngettext

MAX_COORDINATE = 1_000_000.0
MIN_EXTENT = 1e-6
MAX_SIDE_PX = 4096
MAX_SHEETS = 1_000
MAX_FIGURES = 100_000
MAX_PALETTE = 256
MAX_NAME = 200
RECURSION_LIMITS = (10, 4_000)
MAX_DEGREE = 7
WEIGHTS = (1e-9, 1e9)
RING_LEAST = 3


def labels() -> dict[str, str]:
    """What a person calls a field; fields that the course writes as letters are called so."""
    return {
        "radius_world": _("radius"),
        "radius_x_world": _("horizontal radius"),
        "radius_y_world": _("vertical radius"),
        "width_px": _("width"),
        "height_px": _("height"),
        "window_world": _("window"),
        "viewport_device": _("viewport"),
        "colour": _("colour"),
        "boundary": _("boundary colour"),
        "background": _("background"),
        "algorithm": _("algorithm"),
        "points_world": _("list of points"),
        "ring_ends": _("list of rings"),
        "recursion_limit": _("recursion limit"),
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
    _integer("last_id", document.last_id, 0, 2**53)
    _count("sheets", document.sheets, 1, MAX_SHEETS, _("sheet"))
    known = {id(sheet): sheet for sheet in before.sheets} if before else {}
    by_id = {sheet.id: sheet for sheet in before.sheets} if before else {}
    for index, sheet in enumerate(document.sheets):
        if id(sheet) not in known:
            _sheet(f"sheets[{index}]", sheet, by_id.get(sheet.id))
    if not (ids_sound(document) if before is None else new_ids_sound(before, document)):
        raise _wrong_id(document)
    if before is None:
        highest(document)  # every figure keeps its own, so that the first edit has not to look at all of them
    return document


def _sheet(at: str, sheet: Sheet, before: Sheet | None) -> None:
    _name(f"{at}.name", sheet.name)
    _integer(f"{at}.width_px", sheet.width_px, 1, MAX_SIDE_PX)
    _integer(f"{at}.height_px", sheet.height_px, 1, MAX_SIDE_PX)
    _rectangle(f"{at}.window_world", sheet.window_world)
    _rectangle(f"{at}.viewport_device", sheet.viewport_device)
    if sheet.clip_world is not None:
        _rectangle(f"{at}.clip_world", sheet.clip_world)
    _choice(f"{at}.line_clipper", sheet.line_clipper, LINE_CLIPPERS)
    _choice(f"{at}.polygon_clipper", sheet.polygon_clipper, POLYGON_CLIPPERS)
    _count(f"{at}.palette", sheet.palette, 2, MAX_PALETTE, _("colour"))
    for index, colour in enumerate(sheet.palette):
        _integer(f"{at}.palette[{index}]", colour, 0, 0xFFFFFF)
    _palette_index(f"{at}.background", sheet.background, sheet)
    _count(f"{at}.figures", sheet.figures, 0, MAX_FIGURES, _("figure"))
    figures = before.figures if before is not None else ()
    if before is not None and len(sheet.palette) < len(before.palette):
        for index, figure in enumerate(sheet.figures):
            _colours(f"{at}.figures[{index}]", figure, sheet)
    start, old_end, new_end = between(figures, sheet.figures)
    known = {figure.id: figure for figure in figures[start:old_end]}
    for index in range(start, new_end):
        figure = sheet.figures[index]
        old = known.get(figure.id)
        if old is not figure:
            _figure(f"{at}.figures[{index}]", figure, sheet, old)


def _figure(at: str, figure: AnyFigure, sheet: Sheet, before: AnyFigure | None) -> None:
    _name(f"{at}.name", figure.name)
    _truth(f"{at}.visible", figure.visible)
    if hasattr(figure, "closed"):
        _truth(f"{at}.closed", figure.closed)
    _name(f"{at}.algorithm", figure.algorithm)
    chosen = before is not None and before.algorithm != figure.algorithm
    if figure.algorithm not in figure.algorithms and (chosen or catalogue.known(figure.algorithm)):
        choices = ", ".join(figure.algorithms)
        problem = _("is {value}, which cannot draw this figure; choose one of {choices}")
        raise refuse(f"{at}.algorithm", problem.format(value=shown(figure.algorithm), choices=choices))
    _colours(at, figure, sheet)
    _count(f"{at}.points_world", figure.points_world, figure.least_points, figure.most_points, _("point"))
    known = before.points_world if before is not None and type(before) is type(figure) else ()
    start, old_end, new_end = between(known, figure.points_world)
    moved = set(map(id, known[start:old_end]))
    for index in range(start, new_end):
        if id(figure.points_world[index]) not in moved:
            _point(f"{at}.points_world[{index}]", figure.points_world[index])
    if isinstance(figure, Circle):
        _radius(f"{at}.radius_world", figure.radius_world)
    elif isinstance(figure, Ellipse):
        _radius(f"{at}.radius_x_world", figure.radius_x_world)
        _radius(f"{at}.radius_y_world", figure.radius_y_world)
    elif isinstance(figure, SeedFill):
        _integer(f"{at}.recursion_limit", figure.recursion_limit, *RECURSION_LIMITS)
    elif isinstance(figure, Polygon):
        _rings(f"{at}.ring_ends", figure)
        _truth(f"{at}.closed_interior", figure.closed_interior)
        _truth(f"{at}.nonzero", figure.nonzero)
    elif isinstance(figure, Curve):
        _curve(at, figure)


def _colours(at: str, figure: AnyFigure, sheet: Sheet) -> None:
    _palette_index(f"{at}.colour", figure.colour, sheet)
    if isinstance(figure, SeedFill):
        _palette_index(f"{at}.boundary", figure.boundary, sheet)


def _point(at: str, point: WorldPoint) -> None:
    _coordinate(f"{at}.x", point.x)
    _coordinate(f"{at}.y", point.y)
    if isinstance(point, CurvePoint):
        _between(f"{at}.weight", point.weight, *WEIGHTS)
        _coordinate(f"{at}.tangent_x", point.tangent_x)
        _coordinate(f"{at}.tangent_y", point.tangent_y)
        _choice(f"{at}.joint", point.joint, JOINTS)


def _curve(at: str, curve: Curve) -> None:
    _choice(f"{at}.spline", curve.spline, SPLINES)
    for index, spline in enumerate(curve.beside):
        _choice(f"{at}.beside[{index}]", spline, SPLINES)
    _integer(f"{at}.degree", curve.degree, 1, MAX_DEGREE)
    _choice(f"{at}.knot_rule", curve.knot_rule, KNOT_RULES)
    _choice(f"{at}.ends", curve.ends, ENDS)
    for name, low, high in (
        ("tension", -10.0, 10.0),
        ("continuity", -10.0, 10.0),
        ("bias", -10.0, 10.0),
        ("alpha", 0.0, 1.0),
        ("tolerance_px", 1e-4, 100.0),
    ):
        _between(f"{at}.{name}", getattr(curve, name), low, high)
    _knots(f"{at}.knots", curve)


def needed_knots(curve: Curve) -> int:
    """How many knots points and degree ask for; of a closed curve those of one turn, both ends counted."""
    return len(curve.points_world) + (1 if curve.closed else curve.degree + 1)


def _knots(field: str, curve: Curve) -> None:
    if curve.knot_rule != "free":
        _count(field, curve.knots, 0, 0, _("knot"))
        return
    needed = needed_knots(curve)
    _count(field, curve.knots, needed, needed, _("knot"))
    for index, knot in enumerate(curve.knots):
        _coordinate(f"{field}[{index}].u", knot.u)
        if index and knot.u < curve.knots[index - 1].u:
            problem = _(
                "is {value}, less than the knot before it, {before}; knots may not decrease: raise it"
            )
            raise refuse(
                f"{field}[{index}].u",
                problem.format(value=shown(knot.u), before=shown(curve.knots[index - 1].u)),
            )


def _rings(field: str, polygon: Polygon) -> None:
    if not isinstance(polygon.ring_ends, tuple):
        raise refuse(field, _("is not a list; give one"))
    start, last = 0, len(polygon.points_world)
    for index, end in enumerate(polygon.ring_ends):
        _whole(f"{field}[{index}]", end)
        if end - start < RING_LEAST:
            problem = _("has {count} of at least {least} points in ring {ring}; add what is missing")
            raise refuse(field, problem.format(count=max(end - start, 0), least=RING_LEAST, ring=index + 1))
        start = end
    if polygon.ring_ends and start != last:
        problem = _("ends at {end}, but there are {count} points; end the last ring there")
        raise refuse(field, problem.format(end=start, count=last))


def ids(document: Document) -> Iterator[tuple[str, str]]:
    """(path, id) of everything in ``document`` that has an id."""
    for s, sheet in enumerate(document.sheets):
        yield f"sheets[{s}].id", sheet.id
        for f, figure in enumerate(sheet.figures):
            yield f"sheets[{s}].figures[{f}].id", figure.id
            for p, point in enumerate(figure.points_world):
                yield f"sheets[{s}].figures[{f}].points_world[{p}].id", point.id
            if isinstance(figure, Curve):
                for k, knot in enumerate(figure.knots):
                    yield f"sheets[{s}].figures[{f}].knots[{k}].id", knot.id


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


def _coordinate(field: str, value: Any) -> None:
    _number(field, value)
    if not abs(value) <= MAX_COORDINATE:
        problem = _("is {value}; give a number between -{most:,.0f} and {most:,.0f}")
        raise refuse(field, problem.format(value=shown(value), most=MAX_COORDINATE))


def _radius(field: str, value: Any) -> None:
    _number(field, value)
    if not 0 <= value <= MAX_COORDINATE:
        problem = _("is {value}; give a number between 0 and {most:,.0f}")
        raise refuse(field, problem.format(value=shown(value), most=MAX_COORDINATE))


def _between(field: str, value: Any, low: float, high: float) -> None:
    _number(field, value)
    if not low <= value <= high:
        problem = _("is {value}; give a number between {low:g} and {high:g}")
        raise refuse(field, problem.format(value=shown(value), low=low, high=high))


def _rectangle(field: str, rectangle: Rectangle) -> None:
    for name in ("xmin", "ymin", "xmax", "ymax"):
        _coordinate(f"{field}.{name}", getattr(rectangle, name))
    for low, high, side in (("xmin", "xmax", _("width")), ("ymin", "ymax", _("height"))):
        a, b = getattr(rectangle, low), getattr(rectangle, high)
        if not b - a >= MIN_EXTENT:
            problem = _(
                "has no {side}: {low} is {a} and {high} is {b}; drag one of its sides, or type another value"
            )
            raise refuse(field, problem.format(side=side, low=low, a=a, high=high, b=b))


def _palette_index(field: str, value: Any, sheet: Sheet) -> None:
    _whole(field, value)
    if not 0 <= value < len(sheet.palette):
        problem = _("is {value}, but the palette has the colours 0 to {last}; choose one of these")
        raise refuse(field, problem.format(value=shown(value), last=len(sheet.palette) - 1))


def _choice(field: str, value: Any, choices: tuple[str, ...]) -> None:
    if value not in choices:
        problem = _("is {value}; choose one of {choices}")
        raise refuse(field, problem.format(value=shown(value), choices=", ".join(choices)))


def _integer(field: str, value: Any, low: int, high: int) -> None:
    _whole(field, value)
    if not low <= value <= high:
        problem = _("is {value}; give a whole number between {low} and {high}")
        raise refuse(field, problem.format(value=shown(value), low=low, high=high))


def _number(field: str, value: Any) -> None:
    if type(value) is not int and (type(value) is not float or not math.isfinite(value)):
        raise refuse(field, _("is {value}; give a finite number").format(value=shown(value)))


def _whole(field: str, value: Any) -> None:
    if type(value) is not int:
        raise refuse(field, _("is {value}; give a whole number").format(value=shown(value)))


def _truth(field: str, value: Any) -> None:
    if type(value) is not bool:
        raise refuse(field, _("is {value}; give true or false").format(value=shown(value)))


def _name(field: str, value: Any) -> None:
    if type(value) is not str or len(value) > MAX_NAME:
        raise refuse(field, _("is too long; give a text of at most {most} characters").format(most=MAX_NAME))
    if any(0xD800 <= ord(character) <= 0xDFFF for character in value):
        raise refuse(field, _("has a character that no file can hold; type it again"))


def _count(field: str, values: Any, least: int, most: int, what: str) -> None:
    if not isinstance(values, tuple):
        raise refuse(field, _("is not a list; give one"))
    if len(values) < least:
        problem = ngettext(
            "has {count} of at least {least} {what}; add what is missing",
            "has {count} of at least {least} {what}s; add what is missing",
            least,
        )
        raise refuse(field, problem.format(count=len(values), least=least, what=what))
    if len(values) > most:
        problem = _("has {count:,} entries of at most {most:,}; remove some")
        raise refuse(field, problem.format(count=len(values), most=most))
