"""Interpolation against approximation in numbers: distances, overshoot and wiggle."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar

from tests.curves import exact
from tests.curves.made_curves import point_lists
from tests.curves.rational_curves import dense_points, pieces_of_any_kind, whole_circle
from workbench.algorithms.curves import (
    Pieces,
    b_spline_to_bezier,
    cardinal,
    closest_place,
    closest_point,
    distances,
    in_rows,
    inflections,
    natural_cubic,
    open_uniform_knots,
    overshoot,
    piece_points,
    wiggle,
)
from workbench.engine import compiled

ONE = np.array([0.0, 1.0])
SQUARE = np.array([[4, 2], [1, 5], [-2, 2], [1, -1]], float)
# The points of the paper's figure: a step, beside which interpolation overshoots
STEP = np.array([[0, 0], [1, 0], [2, 0], [3, 4], [4, 4], [5, 4]], float)


@given(pieces_of_any_kind(), point_lists(1, 4))
def test_distances_are_those_that_the_stepped_text_finds(pieces: Pieces, points: np.ndarray) -> None:
    if pieces.weights is not None:
        # Beside weights a million apart half a piece may lie in the last steps of u, which are not searched.
        pieces = pieces._replace(weights=np.clip(pieces.weights, 1e-3, 1e3))
    size = max(exact.size_of(pieces.controls), exact.size_of(points), 1e-300)
    found = distances(pieces, points)
    stepped = [compiled.collect(closest_point, *in_rows(pieces), *point)[-1, 3] for point in points.tolist()]
    assert np.abs(found - stepped).max() <= 1e-9 * size
    for place, distance in zip(points, found, strict=True):
        assert np.hypot(*(dense_points(pieces) - place).T).min() >= distance - 1e-9 * size


@given(pieces_of_any_kind(), point_lists(1, 1))
def test_the_closest_place_is_on_the_curve_and_as_far_as_the_distance(
    pieces: Pieces, points: np.ndarray
) -> None:
    u, away = closest_place(pieces, points[0])
    size = max(exact.size_of(pieces.controls), exact.size_of(points), 1e-300)
    assert away == pytest.approx(distances(pieces, points)[0], abs=1e-9 * size)
    assert pieces.knots[0] <= u <= pieces.knots[-1]
    # Where pieces meet without joining it may be the end of the one before.
    both = piece_points(pieces, [u, np.nextafter(u, -np.inf)]) - points[0]
    if pieces.weights is None and (np.diff(pieces.knots) > 0).all():
        assert np.abs(np.hypot(*both.T) - away).min() <= 1e-9 * size


@pytest.mark.parametrize("v", [0.25, 0.5, 0.75])
def test_a_place_that_is_met_at_the_first_look_is_told_with_its_u(v: float) -> None:
    pieces = Pieces(ONE, np.array([[[0, 0], [0, 5], [0, 6]]], float))
    assert closest_place(pieces, piece_points(pieces, v)) == (v, 0.0)


@settings(max_examples=25)
@given(point_lists(4, 4), st.tuples(st.floats(-9, 9), st.floats(-9, 9)))
def test_scipy_finds_nothing_closer(points: np.ndarray, place: tuple[float, float]) -> None:
    piece = Pieces(ONE, points[None])
    (found,) = distances(piece, [place])
    size = max(exact.size_of(points), 9.0)

    def away(u: float) -> float:
        return math.hypot(*(piece_points(piece, u) - place))

    for k in range(10):
        peer = minimize_scalar(
            away, bounds=(k / 10, k / 10 + 0.1), method="bounded", options={"xatol": 1e-10}
        )
        assert peer.fun >= found - 1e-9 * size


def test_a_spline_through_its_points_is_at_no_distance_and_a_b_spline_is() -> None:
    assert distances(natural_cubic(STEP), STEP).max() <= 1e-12
    beside = b_spline_to_bezier(STEP, open_uniform_knots(6, 3), 3)
    assert distances(beside, STEP)[[0, -1]].max() <= 1e-12
    assert distances(beside, STEP)[2:4].min() > 0.1


def test_through_the_step_a_natural_spline_overshoots_and_a_b_spline_does_not() -> None:
    box, between = overshoot(natural_cubic(STEP), STEP)
    dense = piece_points(natural_cubic(STEP), np.linspace(0, 5, 100_001))
    assert box == pytest.approx(dense[:, 1].max() - 4, abs=1e-6)
    assert between >= box > 0.1
    beside = overshoot(b_spline_to_bezier(STEP, open_uniform_knots(6, 3), 3), STEP)
    assert beside.box == 0
    assert math.isnan(beside.between)


def test_between_neighbours_is_told_for_closed_and_for_inner_curves() -> None:
    around = cardinal(SQUARE, 0.0, "closed")
    box, between = overshoot(around, SQUARE)
    assert box <= between
    assert math.isfinite(overshoot(cardinal(STEP, 0.0, "inner"), STEP).between)
    with pytest.raises(ValueError, match="0 points, and 1 are needed"):
        overshoot(around, np.empty((0, 2)))


@given(point_lists(2, 6))
def test_a_bezier_curve_does_not_turn_more_than_its_polygon(points: np.ndarray) -> None:
    turning, polygon, count = wiggle(Pieces(ONE, points[None]), points)
    size = max(exact.size_of(points), 1e-300)
    legs = np.diff(points, axis=0)
    if np.hypot(*legs.T).min() > 1e-3 * size and np.abs(points[0] - points[-1]).max() > 1e-3 * size:
        assert turning <= polygon + 1e-4
    assert count == len(inflections(Pieces(ONE, points[None])))
    assert math.isfinite(turning)


@given(pieces_of_any_kind())
def test_every_wiggle_is_finite(pieces: Pieces) -> None:
    assert all(math.isfinite(number) for number in wiggle(pieces, SQUARE))
    assert math.isfinite(overshoot(pieces, SQUARE).box)


def test_a_circle_turns_once_and_an_s_there_and_back() -> None:
    assert wiggle(whole_circle(), SQUARE) == pytest.approx((2 * math.pi, 2 * math.pi, 0), abs=1e-5)
    arcs = np.array([[[0, 0], [1, 1], [2, 0]], [[2, 0], [3, -1], [4, 0]]], float)
    found = wiggle(Pieces(np.arange(3.0), arcs), arcs.reshape(-1, 2))
    assert found == pytest.approx((math.pi, math.pi, 1), abs=1e-5)
    back = Pieces(ONE, np.array([[[0.0, 0], [8, 0], [8, 0], [1, 0]]]))
    assert wiggle(back, SQUARE).turning == pytest.approx(math.pi)
