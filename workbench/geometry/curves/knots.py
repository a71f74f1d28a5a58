"""Knot vectors, and the two ways of counting them.

The course counts n + 1 points from P_0 to P_n, the order d, one more than the degree, and n + d + 1 knots.
Source: Hearn and Baker, Computer Graphics, C Version, section 10-9.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse, there_are

Array = NDArray[np.float64]


class Counting(NamedTuple):
    """How many of everything: ``n`` and ``d`` are the course's, the others the usual ones.

    The curve goes from knot ``first`` to knot ``last``, counted from 0, in ``spans`` pieces if no knot is
    repeated between them.
    """

    points: int
    degree: int
    knots: int
    n: int
    d: int
    first: int
    last: int
    spans: int


def counting(count: int, degree: int) -> Counting:
    """Both countings of a B-spline of ``count`` points. Raises: ValueError for too few of them."""
    refuse(faults(np.zeros((count, 1)), degree=degree))
    return Counting(
        points=count,
        degree=degree,
        knots=count + degree + 1,
        n=count - 1,
        d=degree + 1,
        first=degree,
        last=count,
        spans=count - degree,
    )


def uniform_knots(count: int, degree: int) -> Array:
    """Knots 0, 1, 2 and so on, for ``count`` points. The curve reaches neither the first nor the last one."""
    return np.arange(counting(count, degree).knots, dtype=float)


def open_uniform_knots(count: int, degree: int) -> Array:
    """Knots 0, 1, 2 and so on, both ends degree + 1 times: the curve begins and ends at its end points."""
    inner = np.arange(counting(count, degree).spans + 1, dtype=float)
    return np.pad(inner, degree, mode="edge")


def closed_b_spline(points: ArrayLike, degree: int, knots: ArrayLike | None = None) -> tuple[Array, Array]:
    """Points and knots of the closed curve: the first ``degree`` points come once more at the end.

    Args: knots (n+1,) of one turn, ascending; if none are given, all knots are 0, 1, 2 and so on.
    Raises: ValueError for fewer than three points, or knots of another number.
    """
    controls = np.asarray(points, float)
    refuse(faults(controls, least=3))
    count = len(controls)
    turn = np.arange(degree, count + degree + 1.0) if knots is None else np.asarray(knots, float)
    if turn.shape != (count + 1,):
        there = there_are(turn.size, "knot")
        raise ValueError(f"{there}, and {count} closed points need {count + 1}.")
    around = controls[np.arange(count + degree) % count]
    at = np.arange(-degree, count + degree + 1)
    repeated = turn[at % count] + (turn[-1] - turn[0]) * (at // count)
    repeated[degree : degree + count + 1] = turn
    return around, repeated


def multiplicity(knots: ArrayLike, u: float) -> int:
    """How many knots are u."""
    return int(np.count_nonzero(np.asarray(knots, float) == u))
