"""What is drawn of a point that is a sum: what each control point counts, and how the sum grows."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import MOST_SPOTS, MOST_WORDS, Mark, Points, Spot, Stroke, Word, along
from workbench.algorithms.numerals import numeral
from workbench.geometry.curves.basis_functions import basis_table
from workbench.geometry.curves.bernstein import bernstein


def sum_marks(
    controls: Points, blends: Sequence[tuple[int, float]], emitted: NDArray[np.float64], ended: bool
) -> Iterator[Mark]:
    """The control polygon (n, 2) and the sums from the origin on, one for each of the ``blends``.

    These are the numbers of the control points that are added, in their order, and how much of each.
    """
    yield Stroke(controls, "text", "hair", "dot")
    if len(blends) <= MOST_WORDS:
        for k, blend in blends[: len(emitted)]:
            x, y = controls[k].tolist()
            yield Word(numeral(blend), x, y, "data3", right=1, up=-1, carded=True)
    if not len(emitted):
        return
    sums = np.vstack([np.zeros((1, 2)), emitted])
    yield Stroke(sums, "data2", "thin", "dash")
    if len(sums) <= MOST_SPOTS:
        for x, y in sums[:-1].tolist():
            yield Spot(x, y, "data2", "dot", "small")
    x, y = sums[-1].tolist()
    yield Spot(x, y, "text" if ended else "accent", "ring", "large")


def term_marks(control: tuple[float, float], total: tuple[float, float], last: bool) -> tuple[Mark, ...]:
    """The control point that is added, its place as a vector, and the sum; the ``last`` is on the curve."""
    return (
        Stroke(along((0.0, 0.0), control), "data3", "hair", "dot"),
        Spot(*control, "data3", "square", "medium"),
        Spot(*total, "text" if last else "accent", "ring", "large"),
    )


def bernstein_marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The sum over the Bernstein polynomials."""
    controls, u = np.asarray(arguments[0], np.float64), arguments[1]
    blends = list(enumerate(bernstein(len(controls) - 1, u).tolist()))
    yield from sum_marks(controls, blends, emitted, ended)


def b_spline_sum_marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The sum over the blending functions that are not 0."""
    points, knots, degree, u = arguments
    blends = [(k, blend) for k, blend in enumerate(basis_table(knots, degree, u).tolist()) if blend > 0.0]
    yield from sum_marks(np.asarray(points, np.float64), blends, emitted, ended)


def blending_rows(
    lower: Sequence[float], blending: Sequence[float], knots: Sequence[float]
) -> list[tuple[int, float, float, float]]:
    """The blending functions of two orders that are not both 0: (k, t_k, B_{k,d-1}, B_{k,d})."""
    rows = [(k, knots[k], lower[k], value) for k, value in enumerate(blending)]
    return [row for row in rows if row[2] > 0.0 or row[3] > 0.0]
