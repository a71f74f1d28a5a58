"""Generated curves: coincident points, repeated knots and empty spans among them."""

from typing import Any

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

Array = NDArray[np.float64]
Curve = tuple[Array, Array, int]

# The squares of smaller numbers than 1e-100 may vanish, and with them what they would prove
coordinate = st.one_of(
    st.integers(-6, 6).map(float), st.floats(-1e3, 1e3).map(lambda x: x if abs(x) > 1e-100 else 0.0)
)
part_of_one = st.one_of(
    st.sampled_from([0.0, 0.5, 1.0, 1e-9, 1 - 1e-9]), st.floats(0, 1, allow_subnormal=False)
)
weight = st.one_of(st.sampled_from([1e-9, 1.0, 1e9]), st.floats(1e-9, 1e9))


def point_lists(least: int, most: int) -> st.SearchStrategy[Array]:
    """(n, 2) points, some of them coincident."""
    return st.lists(st.tuples(coordinate, coordinate), min_size=least, max_size=most).map(np.array)


@st.composite
def knot_vectors(draw: st.DrawFn, count: int, degree: int, repeated: int | None = None) -> Array:
    """Ascending knots for ``count`` points, none repeated more than ``repeated`` (degree + 1) times inside.

    Steps between them are 0, 1e-9, whole or between 1/16 and 4; the ends are free or repeated.
    """
    most = degree + 1 if repeated is None else repeated
    knots: list[float] = [float(draw(st.integers(-3, 3)))]
    while len(knots) < count + degree + 1:
        step = draw(st.one_of(st.sampled_from([0.0, 1e-9, 1.0, 2.0]), st.floats(0.0625, 4)))
        if step == 0.0 and len(knots) >= most and knots[-most] == knots[-1]:
            step = 1.0
        knots.append(knots[-1] + step)
    found = np.array(knots)
    if draw(st.booleans()):
        found[:degree] = found[degree]
        found[count + 1 :] = found[count]
    if found[degree] == found[count]:
        found[count:] += 1.0
    return found


@st.composite
def b_splines(draw: st.DrawFn, degrees: tuple[int, int] = (1, 7), repeated: int | None = None) -> Curve:
    """Points, knots and degree that fit each other."""
    degree = draw(st.integers(*degrees))
    points = draw(point_lists(degree + 1, degree + 6))
    return points, draw(knot_vectors(len(points), degree, repeated)), degree


def inside(knots: Array, degree: int, part: float) -> float:
    """The parameter at a part of the whole curve."""
    first, last = float(knots[degree]), float(knots[len(knots) - degree - 1])
    return min(max(first + part * (last - first), first), last)


def _with_parameter(found: tuple[Curve, float]) -> tuple[Any, ...]:
    (points, knots, degree), part = found
    return points, knots, degree, inside(knots, degree, part)


DE_BOOR_RUNS = st.tuples(b_splines(), part_of_one).map(_with_parameter)
some_weight = st.sampled_from([1e-9, 0.5, 1.0, 3.0, 1e9]) | st.floats(0.1, 10)


@st.composite
def weighted_runs(draw: st.DrawFn) -> tuple[Any, ...]:
    """Points, weights, knots, degree and a u of a rational B-spline."""
    points, knots, degree, u = draw(DE_BOOR_RUNS)
    weights = draw(st.lists(some_weight, min_size=len(points), max_size=len(points)))
    return points, np.array(weights, np.float64), knots, degree, u


RATIONAL_RUNS = weighted_runs()
