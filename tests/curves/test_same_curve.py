"""What must leave the curve as it is: knots put in, degrees raised, parts cut, other forms."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.curves import exact
from tests.curves.made_curves import Array, Curve, b_splines, inside, part_of_one, point_lists
from workbench.algorithms.curves import (
    b_spline_point,
    b_spline_to_bezier,
    bezier_point,
    circle,
    closed_b_spline,
    counting,
    elevate_b_spline,
    elevate_degree,
    homogeneous,
    insert_knot,
    multiplicity,
    open_uniform_knots,
    piece_derivative,
    piece_points,
    projected,
    split_b_spline,
    subdivide,
    uniform_knots,
)

few = settings(max_examples=40)
PARTS = np.linspace(0, 1, 33)


def places(knots: Array, degree: int) -> Array:
    return np.array([inside(knots, degree, part) for part in PARTS])


def assert_same(found: Array, expected: Array, points: Array, slack: float = 1.0) -> None:
    assert np.abs(found - expected).max() <= slack * 1e-12 * max(exact.size_of(points), 1e-300)


@given(point_lists(2, 9))
def test_one_degree_higher_a_bezier_curve_stays(points: Array) -> None:
    raised = elevate_degree(points)
    assert len(raised) == len(points) + 1
    assert_same(bezier_point(raised, PARTS), bezier_point(points, PARTS), points)


@given(point_lists(2, 9), part_of_one)
def test_the_two_parts_are_the_curve(points: Array, u: float) -> None:
    first, second = subdivide(points, u)
    assert_same(bezier_point(first, PARTS), bezier_point(points, u * PARTS), points)
    assert_same(bezier_point(second, PARTS), bezier_point(points, u + (1 - u) * PARTS), points)
    assert (first[-1] == second[0]).all()


@few
@given(b_splines(), part_of_one, st.integers(1, 7))
def test_a_knot_put_in_leaves_the_curve(curve: Curve, part: float, times: int) -> None:
    points, knots, degree = curve
    u = inside(knots, degree, part)
    times = min(times, degree - multiplicity(knots, u))
    assume(times >= 1)
    new_points, new_knots = insert_knot(points, knots, degree, u, times)
    assert len(new_points) == len(points) + times
    assert multiplicity(new_knots, u) == multiplicity(knots, u) + times
    assert (np.diff(new_knots) >= 0).all()
    where = places(knots, degree)
    assert_same(
        b_spline_point(new_points, new_knots, degree, where),
        b_spline_point(points, knots, degree, where),
        points,
    )


@few
@given(b_splines(), st.floats(0.01, 0.99))
def test_split_parts_are_the_curve(curve: Curve, part: float) -> None:
    points, knots, degree = curve
    u = inside(knots, degree, part)
    assume(knots[degree] < u < knots[len(points)])
    for half_points, half_knots in split_b_spline(points, knots, degree, u):
        where = np.linspace(half_knots[degree], half_knots[len(half_points)], 17)[:-1]
        assert_same(
            b_spline_point(half_points, half_knots, degree, where),
            b_spline_point(points, knots, degree, where),
            points,
        )
    assert half_knots[degree] == u


def test_where_a_knot_parts_the_curve_it_is_split_without_a_knot_more() -> None:
    points, knots = np.array([[0, 0], [1, 1], [5, 5], [6, 4]], float), np.array([0, 0, 1, 1, 2, 2], float)
    parts = split_b_spline(points, knots, 1, 1.0)
    assert [(rows.tolist(), own.tolist()) for rows, own in parts] == [
        ([[0, 0], [1, 1]], [0, 0, 1, 1]),
        ([[5, 5], [6, 4]], [1, 1, 2, 2]),
    ]


@few
@given(b_splines())
def test_bezier_pieces_are_the_curve(curve: Curve) -> None:
    points, knots, degree = curve
    pieces = b_spline_to_bezier(points, knots, degree)
    where = places(knots, degree)
    assert_same(piece_points(pieces, where), b_spline_point(points, knots, degree, where), points)


@few
@given(b_splines((1, 6)))
def test_one_degree_higher_a_b_spline_stays(curve: Curve) -> None:
    points, knots, degree = curve
    raised, new_knots = elevate_b_spline(points, knots, degree)
    assert len(new_knots) == len(raised) + degree + 2
    where = places(knots, degree)
    assert_same(
        b_spline_point(raised, new_knots, degree + 1, where),
        b_spline_point(points, knots, degree, where),
        points,
        slack=10,
    )


def test_a_circle_stays_when_degree_and_knots_are_changed() -> None:
    points, weights, knots, degree = circle(1, 2, 3)
    new, new_knots = insert_knot(homogeneous(points, weights), knots, degree, 0.3)
    new, new_knots = elevate_b_spline(new, new_knots, degree)
    found, _weights = projected(b_spline_point(new, new_knots, degree + 1, np.linspace(0, 4, 301)))
    assert np.abs(np.hypot(found[:, 0] - 1, found[:, 1] - 2) - 3).max() <= 1e-13


def test_both_countings() -> None:
    count = counting(6, 3)
    assert (count.n, count.d) == (5, 4)
    assert count.knots == count.n + count.d + 1 == len(uniform_knots(6, 3))
    assert uniform_knots(4, 2).tolist() == [0, 1, 2, 3, 4, 5, 6]
    assert open_uniform_knots(5, 2).tolist() == [0, 0, 0, 1, 2, 3, 3, 3]
    with pytest.raises(ValueError, match="There are 3 points, and 4 are needed; add 1"):
        counting(3, 3)


@pytest.mark.parametrize("even", [True, False])
@pytest.mark.parametrize("degree", range(1, 8))
def test_a_closed_curve_goes_round_smoothly(degree: int, even: bool) -> None:
    rng = np.random.default_rng(degree)
    points, turn = rng.normal(size=(7, 2)), np.cumsum(rng.uniform(0.3, 1.5, 8))
    around, knots = closed_b_spline(points, degree, None if even else turn)
    first, last = knots[degree], knots[len(around)]
    assert (last - first == 7) if even else ((first, last) == (turn[0], turn[-1]))
    pieces = b_spline_to_bezier(around, knots, degree)
    for _order in range(degree):
        found = piece_points(pieces, [first, last])
        assert np.abs(found[0] - found[1]).max() <= 1e-9
        pieces = piece_derivative(pieces)


def test_a_narrow_span_between_far_knots_bears_one_degree_more() -> None:
    points = np.array([[0.0, 0]] * 5 + [[0, 1], [0, 0]])
    knots = np.array([0.0] * 6 + [1.0] + [1 + 1e-9] * 3 + [2 + 1e-9] * 4)
    raised, new_knots = elevate_b_spline(points, knots, 6)
    where = places(knots, 6)
    assert_same(b_spline_point(raised, new_knots, 7, where), b_spline_point(points, knots, 6, where), points)
