"""What holds of every point that a construction emits, also of those between the levels."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.algorithms.runs import arguments
from tests.curves import exact
from tests.curves.made_curves import Array, part_of_one, point_lists
from workbench.algorithms import catalogue
from workbench.algorithms.curves import de_boor, de_boor_rational, de_casteljau
from workbench.algorithms.entry import Entry

few = settings(max_examples=40)
FLOAT_ERROR = 1e-12


def span_of(knots: Array, degree: int, u: float) -> int:
    """The last knot that is no greater than u and begins a span of the curve that is not empty."""
    count = len(knots) - degree - 1
    starts = [i for i in range(degree, count) if knots[i] < knots[i + 1]]
    return max((i for i in starts if knots[i] <= u), default=starts[0])


def points_that_matter(entry: Entry, run: tuple[Any, ...]) -> Array:
    """The control points that the curve's point is made of."""
    points = np.asarray(run[0])
    if entry.function is de_casteljau:
        return points
    *_others, knots, degree, u = run
    span = span_of(knots, degree, u)
    return points[span - degree : span + 1]


def emitted(entry: Entry, run: tuple[Any, ...]) -> Array:
    return np.array(list(entry.function(*run)), float).reshape(-1, 2)


@pytest.mark.parametrize("slug", ["de_casteljau", "de_boor", "de_boor_rational"])
@few
@given(data=st.data())
def test_every_point_of_a_construction_lies_in_the_hull_of_the_points_that_matter(
    slug: str, data: st.DataObject
) -> None:
    """No farther in any of twelve directions than the farthest control point."""
    entry = catalogue.get(slug)
    run = data.draw(arguments(entry))
    around = points_that_matter(entry, run)
    slack = FLOAT_ERROR * max(exact.size_of(run[0]), 1e-300)
    for turn in np.linspace(0, 2 * np.pi, 12, endpoint=False):
        along = np.array([np.cos(turn), np.sin(turn)])
        assert (emitted(entry, run) @ along).max(initial=-np.inf) <= (around @ along).max() + slack


@few
@given(data=st.data())
def test_only_degree_and_one_control_points_matter(data: st.DataObject) -> None:
    entry = catalogue.get("de_boor")
    points, knots, degree, u = data.draw(arguments(entry))
    span = span_of(knots, degree, u)
    others = np.full_like(points, 77.0)
    others[span - degree : span + 1] = points[span - degree : span + 1]
    assert list(de_boor(others, knots, degree, u)) == list(de_boor(points, knots, degree, u))


@pytest.mark.parametrize("slug", ["de_casteljau", "de_boor"])
@few
@given(data=st.data(), numbers=st.tuples(*[st.floats(-3, 3)] * 6))
def test_what_is_done_to_the_control_points_is_done_to_every_point(
    slug: str, data: st.DataObject, numbers: tuple[float, ...]
) -> None:
    entry = catalogue.get(slug)
    points, *rest = data.draw(arguments(entry))
    matrix, move = np.array(numbers[:4]).reshape(2, 2), np.array(numbers[4:])
    before = emitted(entry, (points, *rest)) @ matrix.T + move
    after = emitted(entry, (points @ matrix.T + move, *rest))
    assert np.abs(before - after).max() <= FLOAT_ERROR * max(10 * exact.size_of(points), 10)


@few
@given(point_lists(2, 6), part_of_one, part_of_one)
def test_the_outer_points_of_the_levels_are_the_two_halves(points: Array, u: float, part: float) -> None:
    """In fractions: over them the curve runs from 0 to u, and from u to 1."""
    rows = iter(de_casteljau(points, u))
    levels = [points.tolist(), *([next(rows) for _point in range(n)] for n in range(len(points) - 1, 0, -1))]
    before = np.array([level[0] for level in levels])
    after = np.array([level[-1] for level in levels[::-1]])
    size = exact.size_of(points)
    exact.close(
        np.array(exact.bezier(before, part), float),
        exact.bezier(points, exact.Fraction(u) * exact.Fraction(part)),
        size,
    )
    beyond = exact.Fraction(u) + (1 - exact.Fraction(u)) * exact.Fraction(part)
    exact.close(np.array(exact.bezier(after, part), float), exact.bezier(points, beyond), size)


@few
@given(data=st.data(), factor=st.sampled_from([1e-3, 0.7, 3.0, 1e3]))
def test_all_weights_times_the_same_number_give_the_same_points(data: st.DataObject, factor: float) -> None:
    points, weights, knots, degree, u = data.draw(arguments(catalogue.get("de_boor_rational")))
    found = np.array(list(de_boor_rational(points, weights, knots, degree, u)))
    scaled = np.array(list(de_boor_rational(points, factor * weights, knots, degree, u)))
    assert np.abs(found - scaled).max() <= FLOAT_ERROR * max(exact.size_of(points), 1e-300)
