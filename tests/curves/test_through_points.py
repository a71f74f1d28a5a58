"""Splines that pass through their points, against SciPy and against their own definitions."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline, make_interp_spline

from tests.curves import exact
from tests.curves.made_curves import Array, point_lists
from workbench.algorithms.curves import (
    Pieces,
    bezier_point,
    cardinal,
    catmull_rom,
    clamped_cubic,
    hermite,
    joints,
    kochanek_bartels,
    natural_cubic,
    periodic_cubic,
    piece_derivative,
    piece_points,
)

steps = st.lists(st.floats(0.05, 5), min_size=11, max_size=11)


def slack(points: Array, part: float = 1e-12) -> float:
    return part * max(exact.size_of(points), 1e-300)


def between(t: Array) -> Array:
    return np.linspace(t[0], t[-1], 97)


@given(point_lists(3, 12), steps)
def test_the_natural_spline_is_scipys(points: Array, lengths: list[float]) -> None:
    t = np.cumsum([0, *lengths])[: len(points)]
    truth = CubicSpline(t, points, bc_type="natural")
    found = natural_cubic(points, t)
    assert np.abs(piece_points(found, between(t)) - truth(between(t))).max() <= slack(points, 1e-11)


@given(point_lists(2, 12))
def test_a_natural_spline_joins_its_points_smoothly_and_ends_straight(points: Array) -> None:
    pieces = natural_cubic(points)
    assert (piece_points(pieces, range(len(points))) == points).all()
    assert all(joint.parametric == "C2" for joint in joints(pieces))
    bend = piece_derivative(piece_derivative(pieces)).controls
    assert np.abs(bend[[0, -1], [0, -1]]).max() <= slack(points, 1e-11)


@given(point_lists(2, 12), steps)
def test_the_clamped_spline_is_scipys(points: Array, lengths: list[float]) -> None:
    t = np.cumsum([0, *lengths])[: len(points)]
    truth = CubicSpline(t, points, bc_type=((1, [3, -1]), (1, [0, 2])))
    found = clamped_cubic(points, [3, -1], [0, 2], t)
    assert np.abs(piece_points(found, between(t)) - truth(between(t))).max() <= slack(points, 1e-11) + 1e-11


@given(point_lists(3, 11), steps)
def test_the_periodic_spline_is_scipys(points: Array, lengths: list[float]) -> None:
    t = np.cumsum([0, *lengths])[: len(points) + 1]
    around = np.vstack([points, points[:1]])
    truth = CubicSpline(t, around, bc_type="periodic")
    found = periodic_cubic(points, t)
    assert np.abs(piece_points(found, between(t)) - truth(between(t))).max() <= slack(points, 1e-11)
    assert all(joint.parametric == "C2" for joint in joints(found, closed=True, tolerance=1e-8))


def test_the_natural_spline_is_the_interpolating_b_spline() -> None:
    points = np.random.default_rng(4).normal(size=(9, 2))
    truth = make_interp_spline(np.arange(9.0), points, 3, bc_type="natural")
    u = np.linspace(0, 8, 101)
    assert np.abs(piece_points(natural_cubic(points), u) - truth(u)).max() <= 1e-13


def test_cubics_are_reproduced_by_clamped_and_straight_lines_by_all() -> None:
    u = np.array([0, 0.5, 2, 3, 7])
    cubic = np.column_stack([u, u**3 - 2 * u])
    found = clamped_cubic(cubic, [1, -2], [1, 3 * 49 - 2], u)
    where = np.linspace(0, 7, 50)
    assert np.abs(piece_points(found, where) - np.column_stack([where, where**3 - 2 * where])).max() <= 1e-11
    line = np.outer(np.arange(6.0), [3, -1])
    for spline in (natural_cubic(line), cardinal(line), catmull_rom(line, 0), kochanek_bartels(line)):
        begin = spline.controls[0, 0]
        found = piece_points(spline, spline.knots[0] + np.linspace(0, 3, 20))
        assert np.abs(found - begin - np.outer(np.linspace(0, 3, 20), [3, -1])).max() <= 1e-13


def test_hermite_is_the_courses_matrix() -> None:
    """p(u) = [u^3 u^2 u 1] M_H [p_k, p_{k+1}, Dp_k, Dp_{k+1}]."""
    matrix = np.array([[2, -2, 1, 1], [-3, 3, -2, -1], [0, 0, 1, 0], [1, 0, 0, 0]])
    ends, tangents = np.array([[1, 2], [5, -1]]), np.array([[0, 4], [3, 3]])
    u = np.linspace(0, 1, 11)
    truth = np.column_stack([u**3, u**2, u, np.ones(11)]) @ matrix @ np.vstack([ends, tangents])
    assert np.abs(piece_points(hermite(ends, tangents), u) - truth).max() <= 1e-14 * 9


@pytest.mark.parametrize("tension", [-0.5, 0, 0.3, 1])
def test_cardinal_is_the_courses_matrix(tension: float) -> None:
    s = (1 - tension) / 2
    matrix = np.array([[-s, 2 - s, s - 2, s], [2 * s, s - 3, 3 - 2 * s, -s], [-s, 0, s, 0], [0, 1, 0, 0]])
    points = np.array([[0, 0], [1, 4], [5, 3], [6, -2], [9, 9]], float)
    u = np.linspace(0, 1, 11)
    powers = np.column_stack([u**3, u**2, u, np.ones(11)])
    pieces = cardinal(points, tension)
    assert len(pieces.controls) == 2
    for k in (0, 1):
        truth = powers @ matrix @ points[k : k + 4]
        assert np.abs(bezier_point(pieces.controls[k], u) - truth).max() <= 1e-14 * 20


@given(point_lists(4, 9))
def test_where_their_numbers_say_so_the_three_are_one(points: Array) -> None:
    for ends in ("inner", "through", "closed"):
        plain = cardinal(points, 0.0, ends).controls
        assert np.abs(kochanek_bartels(points, ends=ends).controls - plain).max() <= slack(points)
        assert np.abs(catmull_rom(points, 0.0, ends).controls - plain).max() <= slack(points)


@settings(max_examples=30)
@given(point_lists(4, 4), st.sampled_from([0.0, 0.5, 1.0]))
def test_catmull_rom_is_barrys_and_goldmans_pyramid(points: Array, alpha: float) -> None:
    legs = np.hypot(*np.diff(points, axis=0).T)
    t = np.append(0, np.cumsum(legs**alpha))
    pieces = catmull_rom(points, alpha, "inner")
    if legs.min() < 1e-3 * max(legs.max(), 1):
        assert np.isfinite(pieces.controls).all()
        return
    for part in np.linspace(0, 1, 7):
        u = t[1] + part * (t[2] - t[1])
        level = points
        for width in (1, 2, 3):
            begin, end = t[:-width], t[width:]
            if width == 3:
                begin, end = t[1:2], t[2:3]
            share = ((u - begin) / (end - begin))[:, None]
            level = (1 - share) * level[:-1] + share * level[1:]
        assert np.abs(piece_points(pieces, u - t[1]) - level[0]).max() <= slack(points, 1e-9)


@given(point_lists(3, 9), st.sampled_from([0.0, 0.5, 1.0]), st.sampled_from(["through", "closed"]))
def test_they_pass_through_every_point(points: Array, alpha: float, ends: str) -> None:
    found = catmull_rom(points, alpha, ends)  # type: ignore[arg-type]
    wanted = np.vstack([points, points[:1]]) if ends == "closed" else points
    assert (found.controls[:, 0] == wanted[:-1]).all()
    assert (found.controls[:, -1] == wanted[1:]).all()
    assert np.isfinite(found.controls).all()


def test_two_points_in_one_place_stop_the_curve() -> None:
    points = np.array([[0, 0], [3, 1], [3, 1], [5, 0]], float)
    pieces = catmull_rom(points, 0.5)
    assert np.diff(pieces.knots)[1] == 0
    assert (pieces.controls[1] == points[1]).all()
    assert (piece_points(pieces, pieces.knots[1]) == points[1]).all()
    assert (piece_points(pieces, pieces.knots[-1]) == points[-1]).all()
    assert np.isfinite(piece_derivative(pieces).controls).all()


def test_a_curve_of_one_place_only_is_that_place() -> None:
    found: Pieces = catmull_rom(np.ones((3, 2)), 1.0)
    assert (piece_points(found, [0, 1]) == 1).all()
    assert np.abs(piece_points(natural_cubic(np.ones((5, 2))), [0, 0.3, 4]) - 1).max() <= 1e-15


@pytest.mark.parametrize(("t", "c", "b"), [(0.2, 0.5, -0.3), (-0.4, -1, 0.7), (0, 0, 1)])
def test_kochanek_bartels_has_the_tangents_of_the_book(t: float, c: float, b: float) -> None:
    points = np.array([[0, 0], [2, 3], [5, 3], [7, 0]], float)
    legs = np.diff(points, axis=0)
    begin, first, second, end = kochanek_bartels(points, t, c, b).controls[0]
    leaving = (1 - t) / 2 * ((1 + b) * (1 - c) * legs[0] + (1 - b) * (1 + c) * legs[1])
    arriving = (1 - t) / 2 * ((1 + b) * (1 + c) * legs[1] + (1 - b) * (1 - c) * legs[2])
    assert 3 * (first - begin) == pytest.approx(leaving, abs=1e-13)
    assert 3 * (end - second) == pytest.approx(arriving, abs=1e-13)


@pytest.mark.parametrize("c", [-1.0, -0.3, 0.0, 0.6])
def test_the_paper_writes_the_continuity_with_the_other_sign(c: float) -> None:
    """DD_i and DS_i, the destination and source derivatives of the paper's equations 9 and 8."""
    points, (t, b) = np.array([[0, 0], [2, 3], [5, 3], [7, 0]], float), (0.2, -0.3)
    legs = np.diff(points, axis=0)
    begin, first, second, end = kochanek_bartels(points, t, c, b, signed_by="paper").controls[0]
    leaving = (1 - t) / 2 * ((1 + b) * (1 + c) * legs[0] + (1 - b) * (1 - c) * legs[1])
    arriving = (1 - t) / 2 * ((1 + b) * (1 - c) * legs[1] + (1 - b) * (1 + c) * legs[2])
    assert 3 * (first - begin) == pytest.approx(leaving, abs=1e-13)
    assert 3 * (end - second) == pytest.approx(arriving, abs=1e-13)
    theirs = kochanek_bartels(points, t, -c, b)
    np.testing.assert_array_equal(theirs.controls[0], [begin, first, second, end])


def test_tension_continuity_and_bias_do_what_their_names_say() -> None:
    points = np.array([[0, 0], [2, 3], [5, 3], [7, 0], [9, 4]], float)
    straight = kochanek_bartels(points, tension=1).controls
    (x0, y0), (x1, y1) = (straight[:, k].T - straight[:, 0].T for k in (1, 3))
    assert (x0 * y1 == y0 * x1).all()
    assert [joint.geometric for joint in joints(kochanek_bartels(points, continuity=-0.5))] == ["G0"]
    along = kochanek_bartels(points, bias=1).controls
    assert np.abs(3 * (along[1, 1] - along[1, 0]) - (points[2] - points[1])).max() <= 1e-14
    each = kochanek_bartels(points, tension=[0, 1, 0])
    assert (each.controls[1, 0] == each.controls[1, 1]).all()
