"""Whole curves: sampled B-splines against fractions and SciPy, flattened ones within their tolerance."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline

from tests.curves import exact
from tests.curves.made_curves import Array, Curve, b_splines, point_lists
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


@pytest.mark.parametrize("parts", [[0, 0.1, 0.2, 1], [0, 0, 0, 1], [0, 0.7, 0.8, 1]])
def test_a_straight_curve_is_one_line(parts: list[float]) -> None:
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
