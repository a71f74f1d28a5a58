"""Crossings of a curve with itself against chords and against curves whose crossings are known."""

import numpy as np
import pytest
from hypothesis import given, settings

from tests.curves import exact
from tests.curves.made_curves import Array
from tests.curves.rational_curves import pieces_of_any_kind, whole_circle
from workbench.algorithms.curves import Pieces, natural_cubic, piece_points, self_intersections

ONE = np.array([0.0, 1.0])
LOOP = np.array([[0, 0], [3, 2], [-2, 2], [1, 0]], float)


def chords_that_cross(points: Array) -> int:
    """How many pairs of chords of a chain cross."""
    begin, leg = points[:-1], np.diff(points, axis=0)
    end = points[1:]

    def sides(a: Array, along: Array, c: Array) -> Array:
        to = c[None] - a[:, None]
        return np.asarray(along[:, None, 0] * to[..., 1] - along[:, None, 1] * to[..., 0])

    across = sides(begin, leg, begin) * sides(begin, leg, end) < 0
    return int(np.triu(across & across.T, 2).sum())


def test_a_loop_crosses_once_where_its_symmetry_says() -> None:
    ((u, v, point),) = self_intersections(Pieces(ONE, LOOP[None]), 1e-9)
    root = np.sqrt(3) / 4
    assert (u, v) == pytest.approx((0.5 - root, 0.5 + root), abs=1e-12)
    assert point == pytest.approx([0.5, 0.375], abs=1e-12)


def test_a_loop_with_weights_crosses_once_too() -> None:
    for weight in (0.8, 3.0):
        pieces = Pieces(ONE, LOOP[None], np.array([[1, weight, weight, 1]]))
        ((u, v, point),) = self_intersections(pieces, 1e-9)
        assert u + v == pytest.approx(1, abs=1e-9)
        assert piece_points(pieces, [u, v]) == pytest.approx(np.stack([point, point]), abs=1e-9)


@pytest.mark.parametrize(
    "points",
    [
        [[0, 0], [1, 1], [0, 1], [1, 0]],
        [[0, 0], [0, 0], [0, 0], [0, 0]],
        [[0, 0], [1, 2], [2, -1], [3, 1]],
        [[0, 0], [2, 1], [2, 2], [0, 0]],
    ],
)
def test_cusps_points_waves_and_closed_curves_do_not_cross(points: list[list[float]]) -> None:
    assert self_intersections(Pieces(ONE, np.array([points], float)), 1e-6) == []


def test_a_circle_does_not_cross_and_two_pieces_do() -> None:
    assert self_intersections(whole_circle(), 1e-9) == []
    lines = np.array([[[0, 0], [4, 0]], [[4, 0], [4, 4]], [[4, 4], [1, -2]]], float)
    ((u, v, point),) = self_intersections(Pieces(np.array([0.0, 1, 3, 4]), lines), 1e-9)
    assert (u, v) == pytest.approx((0.5, 3 + 2 / 3))
    assert point == pytest.approx([2, 0])


@pytest.mark.parametrize("seed", range(4))
def test_as_many_as_fine_chords_show(seed: int) -> None:
    pieces = natural_cubic(np.random.default_rng(seed).uniform(0, 9, (14, 2)))
    found = self_intersections(pieces, 1e-9)
    assert len(found) == chords_that_cross(piece_points(pieces, np.linspace(0, 13, 2601)))
    for u, v, point in found:
        assert u < v
        assert piece_points(pieces, [u, v]) == pytest.approx(np.stack([point, point]), abs=1e-9)


@settings(max_examples=12, deadline=None)
@given(pieces_of_any_kind(most=3, degrees=(1, 4)))
def test_whatever_the_curve_each_crossing_is_one_place(pieces: Pieces) -> None:
    size = max(exact.size_of(pieces.controls), 1e-300)
    found = self_intersections(pieces, 1e-6 * size, most=50)
    assert len(found) <= 50
    for u, v, point in found:
        assert u <= v
        if (np.diff(pieces.knots) > 0).all() and pieces.weights is None:
            both = np.stack([piece_points(pieces, [u, v]), piece_points(pieces, np.nextafter([u, v], 0))])
            assert np.abs(both - point).max(axis=2).min(axis=0).max() <= 1.1e-6 * size


def test_a_curve_along_itself_gives_no_more_than_was_asked_for() -> None:
    back = np.array([[[0, 0], [8, 1]], [[8, 1], [4, 5]], [[4, 5], [0, 0]], [[0, 0], [8, 1]]], float)
    found = self_intersections(Pieces(np.arange(5.0), back), 1e-3, most=20)
    assert len(found) == 20
    with pytest.raises(ValueError, match="tolerance is 0; choose a finite one above 0"):
        self_intersections(whole_circle(), 0.0)


@pytest.mark.parametrize("short", [1e-4, -1e-4])
def test_a_tip_that_stops_short_of_a_line_by_less_than_the_tolerance_touches_it(short: float) -> None:
    lines = np.array([[[0, 0], [4, 0]], [[4, 0], [4, 4]], [[4, 4], [2, short]], [[2, short], [0, 4]]])
    found = self_intersections(Pieces(np.arange(5.0), lines), 1e-3)
    assert found
    for u, v, point in found:
        assert (u, v) == pytest.approx((0.5, 3), abs=1e-4)
        assert point == pytest.approx([2, 0], abs=1e-3)
    assert not self_intersections(Pieces(np.arange(5.0), lines), 1e-5) or short < 0


def test_neighbours_that_leave_their_corner_side_by_side_may_cross_later() -> None:
    there = [[3, 3], [1.5, 1.5], [0, 0]]
    back = [[0, 0], [1, 0], [3, 9]]
    ((u, v, point),) = self_intersections(Pieces(np.arange(3.0), np.array([there, back], float)), 1e-9)
    assert (u, v) == pytest.approx((0.8125, 1.25), abs=1e-9)
    assert point == pytest.approx([0.5625, 0.5625], abs=1e-9)
