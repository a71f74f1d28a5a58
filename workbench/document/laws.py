"""What no field of a document can say by itself; each law gives the first fault in a struct."""

from collections.abc import Callable
from typing import Any

import numpy as np

from workbench.algorithms import catalogue
from workbench.document.differences import between
from workbench.document.faults import Fault, below, count_problem, shown
from workbench.document.fields import numbers_of, once_per_type
from workbench.document.model import (
    LINE_CLIPPERS,
    POLYGON_CLIPPERS,
    AnyFigure,
    Curve,
    Figure,
    Polygon,
    Rectangle,
    Sheet,
)
from workbench.document.motion import laws as motion_laws
from workbench.document.scene import laws as scene_laws
from workbench.document.transforms.chains import LARGEST, matrices_of
from workbench.language import _

MIN_EXTENT = 1e-6
RING_LEAST = 3


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


def misplaced(holder: Any, sheet: Sheet) -> Fault | None:
    """The first number of ``holder`` that is a place in a list of the sheet, but not one that is there."""
    for name, list_name in places_of(type(holder)):
        place, count = getattr(holder, name), len(getattr(sheet, list_name))
        if not 0 <= place < count:
            problem = _("is {value}, but the palette has the colours 0 to {last}; choose one of these")
            return name, problem.format(value=shown(place), last=count - 1)
    return None


@once_per_type
def places_of(kind: type) -> tuple[tuple[str, str], ...]:
    """Each number of a struct that is a place in a list of the sheet, and that list."""
    return tuple((name, number.indexes) for name, number in numbers_of(kind).items() if number.indexes)


def _held_colours(sheet: Sheet, before: Sheet | None) -> Fault | None:
    """Every figure looks again at a palette that has become shorter."""
    if before is None or len(sheet.palette) >= len(before.palette):
        return None
    for index, figure in enumerate(sheet.figures):
        if fault := misplaced(figure, sheet):
            return below(f"figures[{index}]", fault)
    return None


def _chains(sheet: Sheet, before: Sheet | None) -> Fault | None:
    """What the chain of a figure makes of any point can still be drawn."""
    old = before.figures if before is not None else ()
    start, old_end, end = between(old, sheet.figures)
    sound = set(map(id, old[start:old_end]))
    new = [at for at in range(start, end) if id(sheet.figures[at]) not in sound]
    matrices = matrices_of([sheet.figures[at] for at in new])
    for at in np.flatnonzero(~(np.abs(matrices) <= LARGEST).all(axis=(1, 2))).tolist():
        problem = _("has a matrix with numbers beyond {most:g}; make a scale factor or a shear smaller")
        return f"figures[{new[at]}].transforms", problem.format(most=LARGEST)
    return None


def _rings(polygon: Polygon, _before: Any) -> Fault | None:
    start, last = 0, len(polygon.points_world)
    for index, end in enumerate(polygon.ring_ends):
        if end - start < RING_LEAST:
            problem = _("has {count} of at least {least} points in ring {ring}; add what is missing")
            count = max(end - start, 0)
            return "ring_ends", problem.format(count=count, least=RING_LEAST, ring=index + 1)
        start = end
    if polygon.ring_ends and start != last:
        problem = _("ends at {end}, but there are {count} points; the last ring must end there")
        return "ring_ends", problem.format(end=start, count=last)
    return None


def needed_knots(curve: Curve) -> int:
    """How many knots points and degree ask for; of a closed curve those of one turn, both ends counted."""
    return len(curve.points_world) + (1 if curve.closed else curve.degree + 1)


def _knots(curve: Curve, _before: Any) -> Fault | None:
    needed = needed_knots(curve) if curve.knot_rule == "free" else 0
    if problem := count_problem(curve.knots, needed, needed, _("knot")):
        return "knots", problem
    for index in range(1, len(curve.knots)):
        low, high = curve.knots[index - 1].u, curve.knots[index].u
        if high < low:
            problem = _(
                "is {value}, less than the knot before it, {before}; knots must not decrease, so raise it"
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


LAWS: dict[type, tuple[Callable[[Any, Any], Fault | None], ...]] = {
    **scene_laws.LAWS,
    **motion_laws.LAWS,
    Sheet: (_held_colours, _clippable, _chains),
    Figure: (_drawable,),
    Polygon: (_rings,),
    Curve: (_knots,),
    Rectangle: (_extent,),
}
