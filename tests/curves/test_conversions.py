"""Conversions state their error: it is never less than what an independent look at both curves finds."""

import math

import numpy as np
import pytest
import shapely
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline

from tests.curves.exact import bezier, nurbs, size_of
from tests.curves.made_curves import Array, b_splines, inside, part_of_one, point_lists, weight
from workbench.algorithms.curves import (
    Pieces,
    b_spline_to_bezier,
    bezier_point,
    cardinal,
    catmull_rom,
    circle,
    elevate_b_spline,
    elevate_degree,
    homogeneous,
    lower_b_spline,
    lower_degree,
    natural_cubic,
    nurbs_to_polyline,
    open_uniform_knots,
    piece_points,
    polyline,
    projected,
    to_cubic_pieces,
    uniform_knots,
)

TOLERANCES = st.sampled_from([3.0, 1e-2, 1e-5])


def rational_pieces(points: Array, weights: Array, knots: Array, degree: int) -> Pieces:
    whole = b_spline_to_bezier(homogeneous(points, weights), knots, degree)
    return Pieces(whole.knots, *projected(whole.controls))


def distance(chain: Array, point: Array) -> float:
    return float(shapely.Point(point).distance(shapely.LineString(chain)))


@st.composite
def rational_curves(draw: st.DrawFn) -> tuple[Array, Array, Array, int]:
    points, knots, degree = draw(b_splines((1, 5)))
    weights = draw(st.lists(weight, min_size=len(points), max_size=len(points)))
    return points, np.array(weights), knots, degree


@settings(max_examples=40)
@given(rational_curves(), TOLERANCES, part_of_one)
def test_any_curve_becomes_cubic_within_the_error_stated(
    curve: tuple[Array, Array, Array, int], tolerance: float, part: float
) -> None:
    points, weights, knots, degree = curve
    pieces = rational_pieces(*curve)
    cubic, error = to_cubic_pieces(pieces, tolerance)
    size = size_of(points)
    assume(size > 1e-100)  # smaller ones the independent look cannot measure
    assert cubic.weights is None
    assert cubic.degree == 3
    assert np.isfinite(cubic.controls).all()
    assert 0.0 <= error <= max(tolerance, 2e-13 * size)
    assert set(pieces.knots) <= set(cubic.knots)
    exact = nurbs(points, weights, knots, degree, inside(knots, degree, part))
    true = np.array([float(value) for value in exact])
    fine = Pieces(cubic.knots, cubic.controls)
    us = np.linspace(0, 1, 65)
    chain = np.concatenate([bezier_point(piece, us) for piece in fine.controls])
    steps = np.sqrt((np.diff(chain, axis=0) ** 2).sum(axis=1)).max()
    assert distance(chain, true) <= error + 0.5 * steps + 1e-12 * size


@settings(max_examples=40)
@given(st.floats(0.1, 1e3), st.floats(1e-8, 1e-1))
def test_a_circle_stays_round_within_the_error(radius: float, share: float) -> None:
    cubic, error = to_cubic_pieces(rational_pieces(*circle(3, -2, radius)), share * radius)
    us = np.linspace(0, 1, 33)
    points = np.concatenate([bezier_point(piece, us) for piece in cubic.controls])
    off = np.abs(np.hypot(points[:, 0] - 3, points[:, 1] + 2) - radius).max()
    assert off <= error + 1e-12 * radius
    assert error <= share * radius
    corners, chords = nurbs_to_polyline(rational_pieces(*circle(3, -2, radius)), max(share, 1e-5) * radius)
    middles = 0.5 * (corners[1:] + corners[:-1])
    inward = radius - np.hypot(middles[:, 0] - 3, middles[:, 1] + 2).min()
    assert np.abs(np.hypot(corners[:, 0] - 3, corners[:, 1] + 2) - radius).max() <= 1e-12 * radius
    assert inward <= chords + 1e-12 * radius
    assert chords <= max(share, 1e-5) * radius


@given(point_lists(5, 8), TOLERANCES)
def test_a_plain_curve_is_passed_within_the_error_at_every_u(points: Array, tolerance: float) -> None:
    pieces = Pieces(np.array([0.0, 1.0]), points[None])
    cubic, error = to_cubic_pieces(pieces, tolerance)
    us = np.linspace(0, 1, 501)
    apart = float(np.hypot(*(piece_points(cubic, us) - bezier_point(points, us)).T).max())
    assert apart <= error + 1e-12 * size_of(points)
    if len(cubic.controls) == 1:
        assert error <= 3.0 * apart + 1e-9 * size_of(points)


def test_a_circle_takes_as_few_cubics_as_in_a_drawing_program() -> None:
    pieces = rational_pieces(*circle(0, 0, 100))
    assert [len(to_cubic_pieces(pieces, t)[0].controls) for t in (0.1, 1e-3, 1e-5)] == [4, 8, 16]


@given(point_lists(4, 8), st.sampled_from([0.0, 0.5, 1.0]), st.floats(-1, 1))
def test_curves_through_points_are_bezier_pieces_with_error_0(
    points: Array, alpha: float, tension: float
) -> None:
    for pieces in (catmull_rom(points, alpha), cardinal(points, tension), natural_cubic(points)):
        cubic, error = to_cubic_pieces(pieces, 1e-9)
        assert error == 0.0
        assert np.array_equal(cubic.controls, pieces.controls)


@given(point_lists(2, 3))
def test_lines_and_parabolas_are_cubics_exactly(points: Array) -> None:
    cubic, error = to_cubic_pieces(Pieces(np.array([0.0, 1.0]), points[None]), 1.0)
    assert error == 0.0
    for u in (0.0, 0.3, 1.0):
        true = np.array([float(v) for v in bezier(points, u)])
        assert np.abs(piece_points(cubic, u) - true).max() <= 1e-13 * max(size_of(points), 1e-300)


@settings(max_examples=40)
@given(rational_curves(), st.sampled_from([3.0, 0.1]), part_of_one)
def test_a_polyline_is_within_the_error_stated(
    curve: tuple[Array, Array, Array, int], tolerance: float, part: float
) -> None:
    points, weights, knots, degree = curve
    assume(size_of(points) > 1e-100)  # smaller ones the independent look cannot measure
    chain, error = nurbs_to_polyline(rational_pieces(*curve), tolerance)
    assert error <= tolerance
    exact = nurbs(points, weights, knots, degree, inside(knots, degree, part))
    true = np.array([float(value) for value in exact])
    assert distance(chain, true) <= error + 1e-11 * size_of(points)
    equal_steps = polyline(rational_pieces(*curve), tolerance)
    assert distance(equal_steps, true) <= tolerance + 1e-11 * size_of(points)


@settings(max_examples=40)
@given(b_splines((1, 5)), st.integers(0, 2**32 - 1), st.sampled_from([3.0, 0.1]), part_of_one)
def test_lines_at_equal_steps_are_within_the_tolerance(
    curve: tuple[Array, Array, int], seed: int, tolerance: float, part: float
) -> None:
    points, knots, degree = curve
    assume(size_of(points) > 1e-100)
    weights = np.random.default_rng(seed).uniform(0.2, 5.0, len(points))
    chain = polyline(rational_pieces(points, weights, knots, degree), tolerance)
    exact = nurbs(points, weights, knots, degree, inside(knots, degree, part))
    assert distance(chain, np.array([float(value) for value in exact])) <= tolerance + 1e-11 * size_of(points)


@given(point_lists(3, 9))
def test_a_lower_degree_is_as_far_off_as_stated(points: Array) -> None:
    lowered, error = lower_degree(points)
    size = max(size_of(points), 1e-300)
    assert len(lowered) == len(points) - 1
    assert np.array_equal(lowered[[0, -1]], points[[0, -1]])
    us = np.linspace(0, 1, 401)
    apart = bezier_point(points, us) - bezier_point(lowered, us) if len(lowered) > 1 else None
    assert apart is not None
    found = float(np.hypot(*apart.T).max())
    assert found <= error + 1e-11 * size
    assert error <= 1.02 * found + 1e-11 * size


@given(point_lists(2, 12))
def test_a_raised_degree_is_lowered_again(points: Array) -> None:
    lowered, error = lower_degree(elevate_degree(points))
    size = max(size_of(points), 1e-300)
    assert error <= 1e-10 * size
    assert np.abs(lowered - points).max() <= 1e-9 * size


@given(point_lists(4, 7))
def test_no_other_curve_of_the_lower_degree_has_nearer_control_points(points: Array) -> None:
    lowered, _error = lower_degree(points)
    count = len(lowered)
    raising = np.column_stack([elevate_degree(column[:, None])[:, 0] for column in np.eye(count)])
    ends = raising[:, [0, -1]] @ points[[0, -1]]
    best = np.linalg.lstsq(raising[:, 1:-1], points - ends, rcond=None)[0]
    assert np.abs(lowered[1:-1] - best).max() <= 1e-9 * max(size_of(points), 1e-300)


@settings(max_examples=40)
@given(st.integers(2, 6), st.integers(1, 6), st.booleans(), st.integers(0, 2**32 - 1))
def test_a_lower_b_spline_is_as_far_off_as_stated(degree: int, more: int, open_: bool, seed: int) -> None:
    points = np.random.default_rng(seed).uniform(-9, 9, (degree + more, 2))
    knots = (open_uniform_knots if open_ else uniform_knots)(len(points), degree)
    lowered, fewer, error = lower_b_spline(points, knots, degree)
    assert len(fewer) == len(lowered) + degree
    first, last = knots[degree], knots[len(points)]
    assert (fewer[degree - 1], fewer[len(lowered)]) == (first, last)
    us = np.linspace(first, last, 301)
    apart = BSpline(knots, points, degree)(us) - BSpline(fewer, lowered, degree - 1)(us)
    found = float(np.hypot(*apart.T).max())
    assert found <= error + 1e-10
    assert error <= 1.05 * found + 1e-10
    if open_:
        assert np.array_equal(lowered[[0, -1]], points[[0, -1]])


@settings(max_examples=40)
@given(st.integers(1, 5), st.integers(1, 6), st.integers(0, 2**32 - 1))
def test_a_raised_b_spline_is_lowered_again(degree: int, more: int, seed: int) -> None:
    points = np.random.default_rng(seed).uniform(-9, 9, (degree + more, 2))
    knots = open_uniform_knots(len(points), degree)
    lowered, fewer, error = lower_b_spline(*elevate_b_spline(points, knots, degree), degree + 1)
    assert np.array_equal(fewer, knots)
    assert error <= 1e-9
    assert np.abs(lowered - points).max() <= 1e-8


def test_a_tolerance_too_small_to_be_kept_is_not_claimed() -> None:
    pieces = rational_pieces(*circle(0, 0, 1))
    chain, error = nurbs_to_polyline(pieces, 1e-12)
    assert 1e-12 < error < 1e-8
    assert len(chain) < 200_000


def test_what_cannot_be_converted_is_said() -> None:
    line = Pieces(np.array([0.0, 1.0]), np.array([[[0.0, 0.0], [1.0, 1.0]]]))
    for tolerance in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(ValueError, match="The tolerance is"):
            to_cubic_pieces(line, tolerance)
        with pytest.raises(ValueError, match="The tolerance is"):
            nurbs_to_polyline(line, tolerance)
    with pytest.raises(ValueError, match="not finite"):
        to_cubic_pieces(Pieces(line.knots, line.controls + math.inf), 1.0)
    with pytest.raises(ValueError, match="3 are needed"):
        lower_degree([[0, 0], [1, 1]])
    with pytest.raises(ValueError, match="degree 1, the lowest"):
        lower_b_spline([[0, 0], [1, 1]], [0, 0, 1, 1], 1)
