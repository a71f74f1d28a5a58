"""Boxes, extrema, curvature and hulls against fractions, SciPy, dense samples and known curves."""

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BPoly

from tests.curves import exact
from tests.curves.made_curves import Array, point_lists
from tests.curves.rational_curves import dense_points, pieces_of_any_kind, whole_circle
from workbench.algorithms.curves import (
    Pieces,
    bounding_box,
    convex_hull,
    curvature,
    curvature_comb,
    derivatives,
    extrema,
    osculating_circle,
)
from workbench.geometry.curves.roots import roots

ONE = np.array([0.0, 1.0])


@given(pieces_of_any_kind())
def test_the_box_holds_the_curve_and_touches_it(pieces: Pieces) -> None:
    low, high = bounding_box(pieces)
    size = max(exact.size_of(pieces.controls), 1e-300)
    places = dense_points(pieces)
    assert (places >= low - 1e-12 * size).all()
    assert (places <= high + 1e-12 * size).all()
    if pieces.weights is not None and np.ptp(np.log10(pieces.weights), axis=1).max() > 6:
        return  # what turns back within the last steps of u is reached, but has no u to be named by
    sides = [pieces.controls[np.diff(pieces.knots) > 0][:, [0, -1]].reshape(-1, 2)]
    sides += [point[None] for _u, _axis, point in extrema(pieces)]
    touching = np.concatenate(sides)
    assert np.abs(touching.min(axis=0) - low).max() <= 1e-9 * size
    assert np.abs(touching.max(axis=0) - high).max() <= 1e-9 * size


@given(st.lists(st.floats(-5, 5).filter(lambda v: v == 0 or abs(v) > 1e-60), min_size=3, max_size=8))
def test_roots_are_where_the_sign_of_the_exact_value_changes(values: list[float]) -> None:
    coefficients = np.array([values])
    _rows, found = roots(coefficients, np.abs(coefficients))
    rows = np.array(values)[:, None]
    noise = Fraction(max(map(abs, values))) / 2**45
    breaks = [0.0, *found, 1.0]
    for left, right in pairwise(breaks):
        inside = [exact.bezier(rows, left + (right - left) * part)[0] for part in (0.02, 0.3, 0.5, 0.7, 0.98)]
        signs = {v > 0 for v in inside if abs(v) > noise}
        assert len(signs) <= 1
    for at in found:
        slope = len(values) * 2 * max(map(abs, values))
        assert abs(exact.bezier(rows, at)[0]) <= Fraction(slope) / 10**12


@settings(max_examples=30)
@given(point_lists(4, 4))
def test_extrema_are_the_roots_that_scipy_finds(points: Array) -> None:
    found = extrema(Pieces(ONE, points[None]))
    size = max(exact.size_of(points), 1e-300)
    for axis in (0, 1):
        slopes = np.diff(points[:, axis])
        if np.abs(slopes).max() < 1e-3 * size:
            continue
        ours = [u for u, of, _point in found if of == axis]
        peer = BPoly(points[:, axis : axis + 1], [0, 1]).derivative()
        for u in ours:
            assert abs(peer(u)) <= 1e-11 * size or u == 0
        at = np.linspace(0, 1, 401)
        values = peer(at)
        sure = np.abs(values) > 1e-9 * size
        changes = np.count_nonzero(np.diff(np.sign(values[sure])) != 0)
        inner = [u for u in ours if 0 < u < 1]
        assert len(inner) >= changes


def test_the_extrema_of_a_circle_are_its_four_quarters() -> None:
    found = extrema(whole_circle())
    assert [(u, axis, point.tolist()) for u, axis, point in found] == [
        (0, 0, [4, 2]),
        (1, 1, [1, 5]),
        (2, 0, [-2, 2]),
        (3, 1, [1, -1]),
    ]
    low, high = bounding_box(whole_circle())
    assert (low.tolist(), high.tolist()) == ([-2, -1], [4, 5])


def test_a_straight_line_off_by_rounding_has_no_extrema() -> None:
    level = np.stack([np.linspace(0, 7, 6), np.full(6, 0.1 * 3)], axis=1)
    level[2, 1] = np.nextafter(level[2, 1], 1)
    assert extrema(Pieces(ONE, level[None])) == []


def test_a_curve_of_no_length_is_a_point() -> None:
    pieces = Pieces(np.array([1.0, 1.0]), np.array([[[2.0, 3], [4, 4], [5, 0]]]))
    low, high = bounding_box(pieces)
    assert (low.tolist(), high.tolist()) == ([2, 3], [2, 3])
    assert extrema(pieces) == []


@given(st.floats(0, 4))
def test_a_circle_bends_alike_everywhere(u: float) -> None:
    assert curvature(whole_circle(), u) == pytest.approx(1 / 3, rel=1e-13)
    centre, radius = osculating_circle(whole_circle(), u)
    assert centre == pytest.approx([1, 2], abs=1e-13)
    assert radius == pytest.approx(3, rel=1e-13)


@given(pieces_of_any_kind(degrees=(2, 5), rational=False), st.floats(0, 1))
def test_curvature_is_the_rate_at_which_the_direction_turns(pieces: Pieces, part: float) -> None:
    u = part * pieces.knots[-1]
    first, second = derivatives(pieces, u, 2)[1:]
    speed = float(np.hypot(*first))
    found = float(curvature(pieces, u))
    if speed > 1e-6 * max(exact.size_of(pieces.controls), 1e-9):
        truth = Fraction(first[0]) * Fraction(second[1]) - Fraction(first[1]) * Fraction(second[0])
        bound = 1e-12 * float(np.hypot(*second)) / speed**2
        assert abs(found - float(truth) / speed**3) <= bound + 1e-12 * abs(found)
    else:
        assert np.isnan(found) or np.isfinite(found)


@pytest.mark.parametrize("points", [[[0, 0], [0, 0], [1, 1], [2, 0]], [[0, 0], [1, 1], [0, 1], [1, 0]]])
def test_where_it_stands_still_it_says_that_there_is_none(points: list[list[float]]) -> None:
    pieces = Pieces(ONE, np.array([points], float) + 0.1)
    u = 0.0 if points[1] == [0, 0] else 0.5
    assert np.isnan(curvature(pieces, u))
    centre, radius = osculating_circle(pieces, u)
    assert np.isnan(centre).all()
    assert np.isnan(radius)
    assert np.isfinite(curvature_comb(pieces, 4)).all()


def test_a_straight_place_has_an_infinite_circle() -> None:
    centre, radius = osculating_circle(Pieces(ONE, np.array([[[0.0, 0], [1, 1], [2, 2]]])), 0.3)
    assert radius == np.inf
    assert np.isnan(centre).all()


def test_the_teeth_of_the_comb_stand_outside_and_are_as_long_as_the_curvature() -> None:
    comb = curvature_comb(whole_circle(), 8, 9.0)
    assert comb.shape == (4, 9, 2, 2)
    assert np.hypot(*(comb[..., 0, :] - [1, 2]).T) == pytest.approx(3)
    assert np.hypot(*(comb[..., 1, :] - [1, 2]).T) == pytest.approx(6)
    with pytest.raises(ValueError, match="0 teeth for each piece; ask for 1 or more"):
        curvature_comb(whole_circle(), 0)


@given(pieces_of_any_kind(rational=True))
def test_whatever_the_weights_the_comb_is_finite(pieces: Pieces) -> None:
    assert np.isfinite(curvature_comb(pieces, 5)).all()


@given(point_lists(1, 12))
def test_the_hull_is_convex_and_holds_every_point(points: Array) -> None:
    hull = convex_hull(points)
    corners = [tuple(map(Fraction, corner)) for corner in hull.tolist()]
    assert {tuple(c) for c in hull.tolist()} <= {tuple(p) for p in points.tolist()}

    def left_of(a: tuple[Fraction, ...], b: tuple[Fraction, ...], c: tuple[Fraction, ...]) -> Fraction:
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    around = [*corners, corners[0]]
    for i in range(len(corners) if len(corners) > 2 else 0):
        assert left_of(around[i], around[i + 1], corners[(i + 2) % len(corners)]) > 0
        assert all(left_of(around[i], around[i + 1], tuple(map(Fraction, p))) >= 0 for p in points.tolist())
    if len(corners) == 2:
        assert all(left_of(corners[0], corners[1], tuple(map(Fraction, p))) == 0 for p in points.tolist())
        assert all(corners[0] <= tuple(map(Fraction, p)) <= corners[1] for p in points.tolist())
    if len(corners) == 1:
        assert (points == points[0]).all()


def test_no_points_have_no_hull() -> None:
    with pytest.raises(ValueError, match="0 points, and 1 are needed"):
        convex_hull(np.empty((0, 2)))
