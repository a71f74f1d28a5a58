"""Point clipping: the four comparisons on which all clipping rests.

inside      whether the point passes all four
"""

from collections.abc import Iterator, Mapping
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.clipping.cutting import pixels
from workbench.algorithms.clipping.window import POINT, WINDOW, point_and_window
from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.marks import Mark, Spot


def clip_point(
    x: float, y: float, xmin: float, ymin: float, xmax: float, ymax: float
) -> Iterator[tuple[float, float]]:
    """Emit the point if it lies in the window or on its edge.

    Args: the point and the window, in device coordinates. Emits: (x, y), or nothing.
    Source: Hearn and Baker, Computer Graphics, C Version, section 6-6.
    """
    # Compare with all four edges
    inside = xmin <= x <= xmax and ymin <= y <= ymax

    # Keep the point if it is inside
    if inside:
        yield x, y


_COMPARE = "Compare with all four edges"
_POINT = "pixels(((x, y),))"
_OPTIONS = "('keep', 'leave out')"
_ROW = (
    "('yes' if xmin <= x else 'no', 'yes' if x <= xmax else 'no', 'yes' if ymin <= y else 'no', "
    "'yes' if y <= ymax else 'no', {verdict!r})"
)


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], _emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The point."""
    yield Spot(float(arguments[0]), float(arguments[1]), "accent", "ring", "large")


ENTRY = Entry(
    function=clip_point,
    topic="clipping",
    title="Point clipping",
    summary="Four comparisons tell whether a point lies in the window.",
    parameters=(*POINT, *WINDOW),
    arguments=point_and_window,
    clips=("point",),
    emits="points",
    source="Hearn and Baker, Computer Graphics, C Version, section 6-6",
    columns=("x_{min} ≤ x", "x ≤ x_{max}", "y_{min} ≤ y", "y ≤ y_{max}", "point"),
    view_functions=(pixels,),
    views=(
        View(
            block=_COMPARE,
            when="inside",
            candidates=_POINT,
            chosen=_POINT,
            row=_ROW.format(verdict="keep"),
            options=_OPTIONS,
            answer="'keep'",
            sentence="{xmin} ≤ {x} ≤ {xmax} and {ymin} ≤ {y} ≤ {ymax}: keep the point.",
        ),
        View(
            block=_COMPARE,
            when="not xmin <= x <= xmax",
            candidates=_POINT,
            rejected=_POINT,
            row=_ROW.format(verdict="leave out"),
            options=_OPTIONS,
            answer="'leave out'",
            sentence="x = {x} is not between {xmin} and {xmax}: leave the point out.",
        ),
        View(
            block=_COMPARE,
            candidates=_POINT,
            rejected=_POINT,
            row=_ROW.format(verdict="leave out"),
            options=_OPTIONS,
            answer="'leave out'",
            sentence="y = {y} is not between {ymin} and {ymax}: leave the point out.",
        ),
    ),
    laws=(
        Law(
            "A point in the window or on its edge is kept as it is, any other is left out.",
            "clipping/test_lines.py::test_a_point_is_kept_where_it_lies_in_the_window",
        ),
    ),
    labs=("Clipping: points",),
    next_rung="cohen_sutherland",
    marks=marks,
)
