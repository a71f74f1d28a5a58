"""What is drawn of a construction that divides legs: its levels, each in an ink of its own."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import Ink, Mark, Points, Spot, Stroke, along
from workbench.geometry.curves.basis_functions import knot_spans

_INKS: tuple[Ink, ...] = ("data2", "data3", "data4", "data5", "data6", "data1")
_MOST_TOLD_APART = 64


def triangle_marks(controls: Points, emitted: NDArray[np.float64]) -> Iterator[Mark]:
    """The levels that are there: of ``controls`` (k, 2) k - 1 legs are divided, then k - 2, and so on.

    The last point is ringed. Of so many that nobody could tell them apart only that one is drawn.
    """
    count = len(controls)
    told_apart = count <= _MOST_TOLD_APART
    if told_apart:
        yield Stroke(controls, "text", "hair", "dot")
    first = 0
    for r in range(1, count - 1):
        level, ink = emitted[first : first + count - r], _INKS[(r - 1) % len(_INKS)]
        first += count - r
        if not told_apart:
            continue
        if len(level):
            yield Stroke(level, ink)
        for x, y in level.tolist():
            yield Spot(x, y, ink, "dot", "small")
    if len(emitted):
        x, y = emitted[-1].tolist()
        yield Spot(x, y, "text" if len(emitted) > first else "accent", "ring", "large")


def leg_marks(
    start: tuple[float, float], end: tuple[float, float], point: tuple[float, float], last: bool
) -> tuple[Mark, ...]:
    """The leg that is divided, both its ends, and where; the ``last`` point is that of the curve."""
    return (
        Stroke(along(start, end), "text", "medium"),
        Spot(*start, "text", "dot", "small"),
        Spot(*end, "text", "dot", "small"),
        Spot(*point, "text" if last else "accent", "ring", "large"),
    )


def bezier_marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The levels of de Casteljau's construction."""
    yield from triangle_marks(np.asarray(arguments[0], np.float64), emitted)


def b_spline_marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The levels of de Boor's construction, with weights or without, on the points that matter."""
    points, *_weights, knots, degree, u = arguments
    span = int(now["span"] if "span" in now else knot_spans(knots, degree, u))
    yield from triangle_marks(np.asarray(points, np.float64)[span - degree : span + 1], emitted)
