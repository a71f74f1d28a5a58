"""Points of Bézier curves, B-splines and NURBS against fractions and SciPy."""

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline

from tests.curves import exact
from tests.curves.made_curves import (
    RATIONAL_RUNS,
    Array,
    Curve,
    b_splines,
    inside,
    part_of_one,
    point_lists,
    weight,
)
from workbench.algorithms.curves import (
    b_spline_point,
    basis_functions,
    basis_table,
    bernstein,
    bezier_point,
    circle,
    de_boor,
    de_boor_rational,
    de_casteljau,
    nurbs_point,
    open_uniform_knots,
)
from workbench.geometry.curves.rational import homogeneous, projected

few = settings(max_examples=40)


def last(points: Array, u: float) -> tuple[float, float]:
    return list(de_casteljau(points, u))[-1]


def test_the_curve_of_the_course() -> None:
    points = np.array([[1, 1], [2, 3], [4, 3], [6, 4]], float)
    emitted = list(de_casteljau(points, 0.5))
    assert emitted == [(1.5, 2), (3, 3), (5, 3.5), (2.25, 2.5), (4, 3.25), (3.125, 2.875)]


@few
@given(point_lists(2, 9), part_of_one)
def test_bezier_points_are_those_of_the_bernstein_sum(points: Array, u: float) -> None:
    truth, size = exact.bezier(points, u), exact.size_of(points)
    exact.close(last(points, u), truth, size)
    exact.close(bezier_point(points, u), truth, size)


@given(point_lists(2, 8))
def test_a_bezier_curve_begins_and_ends_at_its_end_points(points: Array) -> None:
    assert last(points, 0.0) == tuple(points[0])
    assert last(points, 1.0) == tuple(points[-1])


@few
@given(b_splines(), part_of_one)
def test_b_spline_points_are_exact_to_rounding(curve: Curve, part: float) -> None:
    points, knots, degree = curve
    u = inside(knots, degree, part)
    truth, size = exact.b_spline(points, knots, degree, u), exact.size_of(points)
    emitted = list(de_boor(points, knots, degree, u))
    assert len(emitted) == degree * (degree + 1) // 2
    exact.close(emitted[-1], truth, size)
    exact.close(b_spline_point(points, knots, degree, u), truth, size)


@few
@given(RATIONAL_RUNS)
def test_points_of_rational_b_splines_are_exact_to_rounding(run: tuple[Any, ...]) -> None:
    points, weights, knots, degree, u = run
    truth, size = exact.nurbs(*run), exact.size_of(points)
    emitted = list(de_boor_rational(*run))
    assert len(emitted) == degree * (degree + 1) // 2
    exact.close(emitted[-1], truth, size)
    plain = list(de_boor(points, knots, degree, u))
    even = list(de_boor_rational(points, np.full(len(points), 4.0), knots, degree, u))
    np.testing.assert_allclose(even, plain, atol=1e-12 * size)
    doubled = list(de_boor_rational(points, 2.0 * weights, knots, degree, u))
    assert doubled == emitted
    low, high = points.min(axis=0) - 1e-12 * size, points.max(axis=0) + 1e-12 * size
    assert all((low <= point).all() and (point <= high).all() for point in np.array(emitted))


def test_a_heavy_weight_makes_much_of_the_last_step_before_a_knot() -> None:
    run = (np.array([[0.0, 0.0], [1.0, 2.0]]), np.array([1e9, 1e-9]), np.array([0.0, 0, 3, 3]), 1)
    u = math.nextafter(3.0, 0.0)
    truth = exact.nurbs(*run, u)
    assert 0.001 < truth[0] < 0.01
    exact.close(list(de_boor_rational(*run, u))[-1], truth, 2.0)


@settings(max_examples=25)
@given(b_splines((1, 5)))
def test_at_a_knot_the_span_to_its_right_is_taken_and_the_left_one_at_the_end(curve: Curve) -> None:
    points, knots, degree = curve
    for u in np.unique(knots[degree : len(points) + 1]).tolist():
        truth, size = exact.b_spline(points, knots, degree, u), exact.size_of(points)
        exact.close(list(de_boor(points, knots, degree, u))[-1], truth, size)
        exact.close(b_spline_point(points, knots, degree, u), truth, size)


def test_where_a_knot_parts_the_curve_the_right_part_begins() -> None:
    points, knots = np.array([[0, 0], [1, 1], [5, 5], [6, 4]], float), np.array([0, 0, 1, 1, 2, 2], float)
    assert list(de_boor(points, knots, 1, 1.0)) == [(5, 5)]
    assert b_spline_point(points, knots, 1, [1, 2]).tolist() == [[5, 5], [6, 4]]


@given(b_splines(), part_of_one)
def test_basis_functions_are_not_negative_and_add_up_to_one(curve: Curve, part: float) -> None:
    _points, knots, degree = curve
    u = inside(knots, degree, part)
    span, values = basis_functions(knots, degree, u)
    assert knots[span] <= u <= knots[span + 1]
    assert knots[span] < knots[span + 1]
    assert (values >= 0).all()
    assert abs(values.sum() - 1) <= 1e-14 * (degree + 1)


@few
@given(b_splines((1, 4)), part_of_one)
def test_each_basis_function_is_relatively_exact(curve: Curve, part: float) -> None:
    _points, knots, degree = curve
    u = inside(knots, degree, part)
    table = basis_table(knots, degree, u)
    for value, truth in zip(table, exact.all_basis(knots, degree, u), strict=True):
        assert abs(value - truth) <= truth / 10**12 + Fraction(1e-300)


@few
@given(b_splines(), part_of_one, st.data())
def test_rational_points_bear_any_weights(curve: Curve, part: float, data: st.DataObject) -> None:
    points, knots, degree = curve
    weights = np.array(data.draw(st.lists(weight, min_size=len(points), max_size=len(points))))
    u = inside(knots, degree, part)
    found = nurbs_point(points, weights, knots, degree, u)
    exact.close(found, exact.nurbs(points, weights, knots, degree, u), exact.size_of(points))
    from_above, _weight = projected(b_spline_point(homogeneous(points, weights), knots, degree, u))
    assert np.abs(from_above - found).max() <= 1e-12 * max(exact.size_of(points), 1e-300)


def test_bernstein_polynomials_add_up_to_one() -> None:
    u = np.linspace(0, 1, 201)
    for degree in range(21):
        values = bernstein(degree, u)
        assert values.shape == (201, degree + 1)
        assert (values >= 0).all()
        assert np.abs(values.sum(axis=-1) - 1).max() <= 1e-14


@few
@given(b_splines(), part_of_one, st.tuples(*[st.floats(-3, 3)] * 6))
def test_what_is_done_to_the_points_is_done_to_the_curve(
    curve: Curve, part: float, numbers: tuple[float, ...]
) -> None:
    points, knots, degree = curve
    a, b, c, d, e, f = numbers
    matrix, move = np.array([[a, b], [c, d]]), np.array([e, f])
    u = inside(knots, degree, part)
    before = np.array(list(de_boor(points, knots, degree, u)))
    after = np.array(list(de_boor(points @ matrix.T + move, knots, degree, u)))
    assert np.abs(before @ matrix.T + move - after).max() <= 1e-12 * max(10 * exact.size_of(points), 10)


@given(b_splines(), part_of_one)
def test_a_point_lies_in_the_hull_of_the_points_that_matter(curve: Curve, part: float) -> None:
    points, knots, degree = curve
    u = inside(knots, degree, part)
    span, _values = basis_functions(knots, degree, u)
    around = points[span - degree : span + 1]
    x, y = list(de_boor(points, knots, degree, u))[-1]
    for turn in np.linspace(0, np.pi, 12, endpoint=False):
        along = np.array([np.cos(turn), np.sin(turn)])
        heights = around @ along
        slack = 1e-12 * max(exact.size_of(points), 1e-300)
        assert heights.min() - slack <= np.array([x, y]) @ along <= heights.max() + slack


@few
@given(point_lists(2, 8), part_of_one)
def test_without_inner_knots_it_is_de_casteljaus_construction(points: Array, u: float) -> None:
    degree = len(points) - 1
    knots = open_uniform_knots(len(points), degree)
    assert list(de_boor(points, knots, degree, u)) == list(de_casteljau(points, u))


@pytest.mark.parametrize("degree", range(1, 8))
def test_b_splines_are_scipys(degree: int) -> None:
    rng = np.random.default_rng(degree)
    points = rng.normal(size=(40, 2))
    knots = np.sort(rng.uniform(0, 9, 41 + degree))
    u = rng.uniform(knots[degree], knots[40], 500)
    assert np.abs(b_spline_point(points, knots, degree, u) - BSpline(knots, points, degree)(u)).max() <= 1e-12


@pytest.mark.parametrize("degree", range(1, 8))
def test_polynomials_are_reproduced(degree: int) -> None:
    """With the points at the knots' means the curve is x = u: a straight graph."""
    rng = np.random.default_rng(degree)
    knots = np.sort(rng.integers(0, 12, 20)).astype(float)
    knots[-degree - 1 :] += 1
    means = np.array([knots[i + 1 : i + degree + 1].mean() for i in range(19 - degree)])
    u = np.linspace(knots[degree], knots[19 - degree], 101)
    found = b_spline_point(np.column_stack([means, 3 * means - 1]), knots, degree, u)
    assert np.abs(found - np.column_stack([u, 3 * u - 1])).max() <= 1e-12


def test_the_circle_is_round() -> None:
    around = circle(3, -2, 5)
    u = np.linspace(0, 4, 1001)
    found = nurbs_point(around.points, around.weights, around.knots, around.degree, u)
    assert np.abs(np.hypot(found[:, 0] - 3, found[:, 1] + 2) - 5).max() <= 1e-14 * 10
    assert (
        np.abs(found[[0, 250, 500, 750, 1000]] - [[8, -2], [3, 3], [-2, -2], [3, -7], [8, -2]]).max()
        < 1e-14 * 9
    )
