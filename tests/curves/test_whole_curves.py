"""Whole curves: sampled B-splines against fractions and SciPy, flattened ones within their tolerance."""

import math
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline

from tests.curves import exact
from tests.curves.made_curves import Array, Curve, b_splines, coordinate, part_of_one, point_lists
from workbench.algorithms.curves import b_spline_curve, bezier_point, flatten_bezier, open_uniform_knots


@settings(max_examples=40)
@given(b_splines(), st.integers(2, 30))
def test_samples_are_exact_to_rounding(curve: Curve, samples: int) -> None:
    points, knots, degree = curve
    found = list(b_spline_curve(points, knots, degree, samples))
    assert len(found) == samples
    first, last = knots[degree], knots[len(points)]
    for k in {0, 1, samples // 2, samples - 1}:
        u = float(first + (last - first) / (samples - 1) * k if k < samples - 1 else last)
        exact.close(found[k], exact.b_spline(points, knots, degree, u), exact.size_of(points))


@pytest.mark.parametrize("degree", [1, 2, 3, 7])
def test_a_long_curve_is_scipys(degree: int) -> None:
    points = np.random.default_rng(degree).normal(size=(300, 2))
    knots = open_uniform_knots(300, degree)
    found = list(b_spline_curve(points, knots, degree, 2001))
    u = np.linspace(0, 300 - degree, 2001)
    assert np.abs(np.array(found) - BSpline(knots, points, degree)(u)).max() <= 1e-12


def test_the_last_sample_is_the_end_even_of_a_tiny_span() -> None:
    points = np.array([[0, 0], [0, 0], [0, 0], [0, 1]], float)
    knots = np.array([-1, -1, 0, 0.5, 0.5 + 1e-9, 0.5 + 1e-9])
    assert list(b_spline_curve(points, knots, 1, 2)) == [(0, 0), (0, 1)]


def test_where_a_knot_parts_the_curve_the_right_part_is_taken() -> None:
    points = np.array([[0, 0], [1, 1], [5, 5], [6, 4]], float)
    found = list(b_spline_curve(points, np.array([0, 0, 1, 1, 2, 2], float), 1, 5))
    assert found == [(0, 0), (0.5, 0.5), (5, 5), (5.5, 4.5), (6, 4)]


def distance_to_chain(places: Array, chain: Array) -> Array:
    """Distance of each place from the nearest line of the chain."""
    begin, leg = chain[:-1], np.diff(chain, axis=0)
    length = (leg * leg).sum(axis=1)
    offset = places[:, None] - begin
    along = np.divide((offset * leg).sum(axis=2), length, out=np.zeros(offset.shape[:2]), where=length > 0)
    away = offset - np.clip(along, 0, 1)[..., None] * leg
    return np.sqrt((away * away).sum(axis=2)).min(axis=1)


@given(point_lists(2, 6), st.sampled_from([1e-3, 0.05, 1.0, 40.0]))
def test_the_chain_is_within_the_tolerance(points: Array, part: float) -> None:
    size = max(exact.size_of(points), 1e-3)
    tolerance = part * size / 10
    chain = np.array(list(flatten_bezier(points, tolerance)))
    assert tuple(chain[0]) == tuple(points[0])
    assert tuple(chain[-1]) == tuple(points[-1])
    places = bezier_point(points, np.linspace(0, 1, 257))
    assert distance_to_chain(places, chain).max() <= tolerance * (1 + 1e-9) + 1e-13 * size
    at_corners = bezier_point(points, np.linspace(0, 1, 4097))
    for corner in chain[:: max(len(chain) // 8, 1)]:
        step = (len(points) - 1) * 2 * size / 4096
        assert np.hypot(*(at_corners - corner).T).min() <= step


@settings(max_examples=40)
@given(point_lists(2, 6), st.sampled_from([1e-3, 0.05, 1.0]))
def test_the_corners_follow_the_curve(points: Array, part: float) -> None:
    """Each corner is found among dense samples no earlier than the one before it."""
    size = max(exact.size_of(points), 1e-3)
    chain = list(flatten_bezier(points, part * size / 10))
    assert (chain[0], chain[-1]) == (tuple(points[0]), tuple(points[-1]))
    places = bezier_point(points, np.linspace(0, 1, 4097))
    step, reached = (len(points) - 1) * 2 * size / 4096, 0
    for corner in chain:
        here = np.hypot(*(places[reached:] - corner).T) <= step
        assert here.any()
        reached += int(here.argmax())


@settings(max_examples=40)
@given(
    st.integers(1, 7).flatmap(lambda p: st.tuples(b_splines((p, p)), st.integers(0, p))), st.integers(2, 9)
)
def test_a_polynomial_of_its_degree_is_reproduced(curve_and_power: tuple[Curve, int], samples: int) -> None:
    """Marsden: over the control points of u^k, the means of products of k knots, the curve is u^k."""
    (_points, knots, degree), power = curve_and_power
    count = len(knots) - degree - 1
    heights = [
        sum(math.prod(chosen) for chosen in combinations(knots[i + 1 : i + degree + 1].tolist(), power))
        / math.comb(degree, power)
        for i in range(count)
    ]
    rising = np.array([np.mean(knots[i + 1 : i + degree + 1]) for i in range(count)])
    found = np.array(list(b_spline_curve(np.column_stack([rising, heights]), knots, degree, samples)))
    size = max(1.0, np.abs(knots).max()) ** degree
    assert np.abs(found[:, 1] - found[:, 0] ** power).max() <= 1e-11 * size * degree


@given(
    st.tuples(coordinate, coordinate, coordinate, coordinate),
    st.lists(part_of_one, max_size=4),
    st.sampled_from([1e-6, 0.1]),
)
def test_a_straight_curve_is_one_line(ends: tuple[float, ...], inner: list[float], part: float) -> None:
    """Its control points lie on a line, in their order; rounding puts them beside it."""
    start, end = np.array(ends[:2]), np.array(ends[2:])
    points = start + np.outer([0.0, *sorted(inner), 1.0], end - start)
    size = max(exact.size_of(points), 1e-3)
    assert list(flatten_bezier(points, part * size)) == [tuple(points[0]), tuple(points[-1])]


@pytest.mark.parametrize("parts", [[0, 0.1, 0.2, 1], [0, 0, 0, 1], [0, 0.7, 0.8, 1]])
def test_a_straight_curve_of_the_smallest_tolerance_is_one_line(parts: list[float]) -> None:
    points = np.array([2.0, 3.0]) + np.outer(parts, [16.0, 8.0])
    assert list(flatten_bezier(points, 1e-9)) == [(2, 3), (18, 11)]


def test_a_curve_that_turns_back_is_followed_to_its_turn() -> None:
    chain = list(flatten_bezier(np.array([[0, 0], [8, 0], [8, 0], [0, 0]], float), 0.01))
    assert max(x for x, _y in chain) == pytest.approx(6, abs=0.01)


@pytest.mark.parametrize("beyond", [5, 7, 30])
def test_a_curve_that_overshoots_its_end_is_followed(beyond: float) -> None:
    points = np.array([[0, 0], [beyond, 0], [beyond, 0], [4, 0]])
    farthest = bezier_point(points, np.linspace(0, 1, 1001))[:, 0].max()
    chain = list(flatten_bezier(points, 0.001))
    assert max(x for x, _y in chain) == pytest.approx(farthest, abs=0.002)


def test_points_in_one_place_are_one_line_and_an_end_is_found_without_mercy() -> None:
    assert list(flatten_bezier(np.ones((4, 2)), 1e-300)) == [(1, 1), (1, 1)]


def test_a_tolerance_below_the_rounding_errors_ends_all_the_same() -> None:
    far = np.array([[2.0**52, 0], [2.0**52 + 4, 2.0**52 + 6], [2.0**52, 2.0**52 + 16]])
    assert 2 < len(list(flatten_bezier(far, 1e-300))) < 1000
