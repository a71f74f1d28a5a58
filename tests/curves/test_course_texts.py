"""The course's own texts for a point of a curve, against fractions and SciPy."""

from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline, CubicHermiteSpline, CubicSpline

from tests.algorithms.runs import arguments
from tests.curves import exact
from tests.curves.made_curves import Array, part_of_one, point_lists
from workbench.algorithms import catalogue
from workbench.algorithms.curves import (
    b_spline_sum,
    bernstein_curve,
    de_boor,
    de_casteljau,
    hermite_blend,
    natural_cubic,
    natural_cubic_system,
)

few = settings(max_examples=40)


def runs_of(slug: str) -> st.SearchStrategy[tuple[Any, ...]]:
    return arguments(catalogue.get(slug))


@few
@given(point_lists(2, 40), part_of_one)
def test_the_bernstein_sum_is_exact_to_rounding(points: Array, u: float) -> None:
    sums = list(bernstein_curve(points, u))
    assert len(sums) == len(points)
    exact.close(sums[-1], exact.bezier(points, u), exact.size_of(points))
    divided = list(de_casteljau(points, u))[-1]
    np.testing.assert_allclose(sums[-1], divided, rtol=0, atol=1e-12 * max(exact.size_of(points), 1e-300))


@few
@given(runs_of("b_spline_sum"))
def test_the_sum_of_a_b_spline_is_exact_to_rounding(run: tuple[Any, ...]) -> None:
    points, knots, degree, u = run
    sums, size = list(b_spline_sum(*run)), exact.size_of(points)
    exact.close(sums[-1], exact.b_spline(points, knots, degree, u), size)
    assert len(sums) == sum(value > 0 for value in exact.all_basis(knots, degree, u)) <= degree + 1
    divided = list(de_boor(*run))[-1]
    np.testing.assert_allclose(sums[-1], divided, rtol=0, atol=1e-12 * max(size, 1e-300))


@few
@given(runs_of("b_spline_sum"), part_of_one)
def test_the_polynomials_that_count_the_points_add_up_to_one(run: tuple[Any, ...], part: float) -> None:
    """The sum of points that are all (1, 1) is the sum of what they count."""
    points, *rest = run
    *_others, of_b_spline = b_spline_sum(np.ones_like(points), *rest)
    *_others, of_bezier = bernstein_curve(np.ones_like(points), part)
    assert np.abs(np.array([of_b_spline, of_bezier]) - 1.0).max() <= 1e-13


@pytest.mark.parametrize("degree", [1, 2, 3, 5, 7])
def test_the_sum_of_a_b_spline_is_scipys(degree: int) -> None:
    rng = np.random.default_rng(degree)
    points, knots = rng.normal(size=(12, 2)), np.sort(rng.uniform(0, 9, 13 + degree))
    u = rng.uniform(knots[degree], knots[12], 40)
    sums = np.array([list(b_spline_sum(points, knots, degree, each))[-1] for each in u.tolist()])
    assert np.abs(sums - BSpline(knots, points, degree)(u)).max() <= 1e-12


@given(point_lists(2, 2), point_lists(2, 2))
def test_a_sum_begins_and_ends_at_its_end_points(points: Array, tangents: Array) -> None:
    for u, end in ((0.0, points[0]), (1.0, points[1])):
        assert list(bernstein_curve(points, u))[-1] == tuple(end)
        assert list(hermite_blend(points, tangents, u))[-1] == tuple(end)


def exact_hermite(points: Array, tangents: Array, u: float) -> list[Fraction]:
    """The cubic with these values and derivatives at 0 and 1, from its coefficients by powers of u."""
    (p0, p1), (d0, d1), v = exact.fractions(points), exact.fractions(tangents), Fraction(u)
    cubic = [2 * (a - b) + c + d for a, b, c, d in zip(p0, p1, d0, d1, strict=True)]
    square = [3 * (b - a) - 2 * c - d for a, b, c, d in zip(p0, p1, d0, d1, strict=True)]
    return [((x3 * v + x2) * v + x1) * v + x0 for x3, x2, x1, x0 in zip(cubic, square, d0, p0, strict=True)]


@few
@given(runs_of("hermite_blend"))
def test_the_hermite_sum_is_exact_to_rounding_and_scipys(run: tuple[Any, ...]) -> None:
    points, tangents, u = run
    *_sums, last = hermite_blend(*run)
    size = max(exact.size_of(points), exact.size_of(tangents), 1e-300)
    exact.close(last, exact_hermite(*run), size)
    truth = CubicHermiteSpline([0.0, 1.0], points, tangents)(u)
    np.testing.assert_allclose(last, truth, rtol=0, atol=1e-12 * size)


@given(runs_of("hermite_blend"))
def test_the_two_points_of_a_hermite_piece_make_a_point_of_the_chord(run: tuple[Any, ...]) -> None:
    points, _tangents, u = run
    _first, on_chord, *_rest = hermite_blend(*run)
    share = 3 * u * u - 2 * u * u * u
    there = (1 - share) * points[0] + share * points[1]
    np.testing.assert_allclose(on_chord, there, rtol=0, atol=1e-13 * max(exact.size_of(points), 1e-300))


def tangents_of(points: Array, knots: Array) -> Array:
    """The tangents that the text emits, those of the first point first."""
    solved = np.array(list(natural_cubic_system(points, knots)))[::-1]
    np.testing.assert_array_equal(solved[:, :2], points)
    return np.asarray(solved[:, 2:])


@few
@given(runs_of("natural_cubic_system"))
def test_the_tangents_of_the_natural_spline_are_scipys(run: tuple[Any, ...]) -> None:
    points, knots = run
    tangents = tangents_of(*run)
    size = exact.size_of(points) / float(np.diff(knots).min())
    pieces = natural_cubic(points, knots)
    first = 3.0 * (pieces.controls[:, 1] - pieces.controls[:, 0]) / np.diff(knots)[:, None]
    np.testing.assert_allclose(tangents[:-1], first, rtol=0, atol=1e-10 * max(size, 1e-300))
    if len(points) > 2:
        truth = CubicSpline(knots, points, bc_type="natural").derivative()(knots)
        np.testing.assert_allclose(tangents, truth, rtol=0, atol=1e-10 * max(size, 1e-300))


@few
@given(runs_of("natural_cubic_system"))
def test_the_tangents_of_the_natural_spline_solve_the_system(run: tuple[Any, ...]) -> None:
    """In fractions: the second derivatives before and after each point differ by rounding only."""
    points, knots = (exact.fractions(each) for each in run)
    tangents = exact.fractions(tangents_of(*run))
    lengths = [b - a for a, b in pairwise(knots)]
    slack = Fraction(max(exact.size_of(run[0]), 1e-300)) / min(lengths) ** 2 / 10**12
    for k in range(2):
        bend = []
        for i, h in enumerate(lengths):
            slope = (points[i + 1][k] - points[i][k]) / h
            bend.append((6 * slope - 4 * tangents[i][k] - 2 * tangents[i + 1][k]) / h)
            bend.append((-6 * slope + 2 * tangents[i][k] + 4 * tangents[i + 1][k]) / h)
        differences = [bend[0], bend[-1], *(b - a for a, b in zip(bend[1::2], bend[2::2], strict=False))]
        assert max(map(abs, differences)) <= slack


@given(st.integers(2, 9), st.floats(-5, 5), st.floats(-5, 5))
def test_points_on_a_line_have_its_tangent(count: int, dx: float, dy: float) -> None:
    points = np.outer(np.arange(float(count)), [dx, dy]) + 1.0
    np.testing.assert_allclose(tangents_of(points, np.arange(float(count))), [[dx, dy]] * count, atol=1e-12)
