"""Curves fitted to points: within the tolerance, with few pieces, smooth where the points are."""

import math

import numpy as np
import pytest
import shapely
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from tests.curves.made_curves import Array, point_lists
from workbench.algorithms.curves import Pieces, bezier_point, fit_pieces
from workbench.geometry.curves import directions


def chain(pieces: Pieces, steps: int = 200) -> Array:
    return np.concatenate([bezier_point(piece, np.linspace(0, 1, steps)) for piece in pieces.controls])


def farthest(pieces: Pieces, points: Array) -> float:
    line = shapely.LineString(chain(pieces))
    return float(shapely.distance(line, shapely.points(points)).max())


def angles(pieces: Pieces) -> Array:
    """The turn at each joint, radians."""
    legs = np.diff(pieces.controls, axis=1)
    one, other = legs[:-1, -1], legs[1:, 0]
    return np.abs(np.arctan2(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0], (one * other).sum(axis=1)))


@settings(max_examples=60)
@given(point_lists(2, 25), st.sampled_from([10.0, 0.5, 1e-3]))
def test_every_point_is_passed_within_the_error(points: Array, tolerance: float) -> None:
    if len(np.unique(points, axis=0)) == 1:
        with pytest.raises(ValueError, match="in one place"):
            fit_pieces(points, tolerance)
        return
    pieces, error = fit_pieces(points, tolerance)
    assert 0.0 <= error <= tolerance
    assert np.isfinite(pieces.controls).all()
    assert (np.diff(pieces.knots) > 0).all()
    assert np.array_equal(pieces.controls[0, 0], points[0])
    assert np.array_equal(pieces.controls[-1, -1], points[-1])
    assert np.array_equal(pieces.controls[1:, 0], pieces.controls[:-1, -1])
    size = float(np.abs(points).max())
    assert farthest(pieces, points) <= error + 1e-2 * size


@given(point_lists(3, 12), st.integers(0, 11), st.sampled_from([10.0, 0.5, 1e-3]))
@example(np.array([[0.0, 0], [1, 2], [3, 3], [6, 2]]), 0, 1e-3)
@example(np.array([[0.0, 0], [1, 2], [3, 3], [6, 2]]), 3, 1e-3)
def test_a_point_given_twice_changes_nothing(points: Array, twice: int, tolerance: float) -> None:
    assume(len(np.unique(points, axis=0)) > 1)
    pieces, error = fit_pieces(points, tolerance)
    again, same = fit_pieces(
        np.insert(points, twice % len(points), points[twice % len(points)], axis=0), tolerance
    )
    assert same == error
    assert np.array_equal(again.knots, pieces.knots)
    assert np.array_equal(again.controls, pieces.controls)


@given(st.integers(0, 2**32 - 1))
def test_points_of_one_cubic_give_it_back(seed: int) -> None:
    rng = np.random.default_rng(seed)
    cubic = np.array([[0, 0], [30, 40], [70, 40], [100, 0]]) + rng.uniform(-9, 9, (4, 2))
    pieces, error = fit_pieces(bezier_point(cubic, np.linspace(0, 1, 200)), 0.05)
    assert len(pieces.controls) <= 4
    assert farthest(pieces, bezier_point(cubic, np.linspace(0, 1, 999))) <= error + 0.01


@pytest.mark.parametrize(("tolerance", "most"), [(1.0, 3), (0.1, 6), (0.01, 10), (0.001, 16)])
def test_a_circle_takes_few_pieces_and_closes_smoothly(tolerance: float, most: int) -> None:
    turn = np.linspace(0, 2 * math.pi, 241)
    points = 50 * np.column_stack([np.cos(turn), np.sin(turn)])
    points[-1] = points[0]
    pieces, error = fit_pieces(points, tolerance)
    assert error <= tolerance
    assert len(pieces.controls) <= most
    off = np.abs(np.hypot(*chain(pieces).T) - 50)
    assert off.max() <= error + 0.01 * tolerance + 0.005
    around = Pieces(np.arange(len(pieces.controls) + 2.0), np.vstack([pieces.controls, pieces.controls[:1]]))
    assert angles(around).max() <= 1e-9


def test_corners_stay_sharp() -> None:
    side = np.linspace(0, 10, 30)[:-1]
    zero = np.zeros(29)
    square = np.concatenate(
        [
            np.column_stack(pair)
            for pair in ((side, zero), (zero + 10, side), (10 - side, zero + 10), (zero, 10 - side))
        ]
    )
    pieces, error = fit_pieces(np.vstack([square, square[:1]]), 0.05)
    assert len(pieces.controls) == 4
    assert error <= 1e-12
    assert np.allclose(angles(pieces), math.pi / 2)
    assert {tuple(p) for p in pieces.controls[:, 0].round(9)} == {(0, 0), (10, 0), (10, 10), (0, 10)}


def test_a_corner_cut_by_less_than_can_be_seen_is_one_corner() -> None:
    side = np.linspace(0, 10, 41)
    along, up = np.column_stack([side, 0 * side]), np.column_stack([0 * side + 10.1, side + 0.1])
    pieces, _error = fit_pieces(np.vstack([along, up]), 0.5)
    assert len(pieces.controls) == 2
    assert angles(pieces).min() > math.pi / 3


@given(st.integers(0, 2**32 - 1))
def test_what_a_mouse_draws_becomes_a_smooth_curve(seed: int) -> None:
    turn = np.linspace(0, 3, 150)
    ideal = np.column_stack([60 * turn, 40 * np.sin(1.7 * turn)])
    drawn = np.floor(ideal + np.random.default_rng(seed).uniform(-0.3, 0.3, ideal.shape) + 0.5)
    pieces, error = fit_pieces(drawn, 1.5)
    assert error <= 1.5
    assert len(pieces.controls) <= 12
    assert angles(pieces).max(initial=0.0) <= 1e-9
    assert farthest(pieces, ideal) <= 3.0


def test_pieces_do_not_move_with_the_frame() -> None:
    turn = np.linspace(0, 4, 90)
    points = np.column_stack([9 * turn, 5 * np.sin(3 * turn)])
    pieces, error = fit_pieces(points, 0.05)
    turned = np.array([[0.6, -0.8], [0.8, 0.6]])
    again, same = fit_pieces(3 * points @ turned.T + [40, -7], 0.15)
    assert np.allclose(again.controls, 3 * pieces.controls @ turned.T + [40, -7], atol=1e-6)
    assert same == pytest.approx(3 * error, rel=1e-6)


def test_what_cannot_be_fitted_is_said() -> None:
    with pytest.raises(ValueError, match="2 are needed"):
        fit_pieces([[1, 1]], 1.0)
    with pytest.raises(ValueError, match="Point 1 is not finite"):
        fit_pieces([[1, 1], [math.nan, 2]], 1.0)
    with pytest.raises(ValueError, match="The tolerance is 0"):
        fit_pieces([[1, 1], [2, 2]], 0.0)


def test_more_pieces_than_are_allowed_are_refused_and_the_share_is_told() -> None:
    turn = np.linspace(0, 40, 3000)
    points = np.column_stack([3 * turn, 50 * np.sin(turn)])
    shares: list[float] = []
    pieces, error = fit_pieces(points, 0.1, progress=shares.append)
    assert error <= 0.1
    assert shares == sorted(shares)
    assert 0.0 <= shares[0] <= shares[-1] <= 1.0
    count = len(pieces.controls)
    assert len(fit_pieces(points, 0.1, most_pieces=count + 20)[0].controls) == count
    with pytest.raises(ValueError, match=f"more than {count // 2} pieces"):
        fit_pieces(points, 0.1, most_pieces=count // 2)


@given(st.integers(0, 2**32 - 1), st.sampled_from([0.1, 1.0, 30.0]))
def test_the_first_points_far_enough_away_are_those_of_each_point_alone(seed: int, reach: float) -> None:
    points = np.random.default_rng(seed).normal(0, 1, (40, 2)).cumsum(axis=0)
    for step in (-1, 1):
        alone = [directions._away(points, at, step, reach) for at in range(len(points))]
        assert directions._all_away(points, step, reach).tolist() == alone
