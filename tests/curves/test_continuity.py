"""Continuity in numbers: joints whose residuals are known."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.curves.made_curves import Array, Curve, b_splines, point_lists
from workbench.algorithms.curves import (
    b_spline_to_bezier,
    circle,
    continuity,
    homogeneous,
    joints,
    piece_derivative,
    subdivide,
)

FIRST = np.array([[0, 0], [1, 2], [3, 3], [5, 3]], float)


@given(point_lists(3, 6), st.sampled_from([0.25, 0.5, 0.8]))
def test_a_curve_that_was_cut_joins_with_c2_where_the_parameter_says_so(points: Array, u: float) -> None:
    first, second = subdivide(points, u)
    assert continuity(first, second, u, 1 - u, tolerance=1e-8).parametric == "C2"


def test_at_another_speed_it_is_only_geometric() -> None:
    first, second = subdivide(FIRST, 0.25)
    found = continuity(first, second)
    assert (found.parametric, found.geometric) == ("C0", "G2")
    speed = 3 * np.hypot(*(first[-1] - first[-2]))
    assert found.c1 == pytest.approx(2 * speed)


def test_residuals_are_the_differences() -> None:
    second = np.array([[5, 4], [6, 4], [7, 5], [9, 9]], float)
    found = continuity(FIRST, second)
    assert (found.parametric, found.geometric) == ("", "")
    assert found.c0 == found.g0 == 1
    assert found.c1 == pytest.approx(math.hypot(3 * 1 - 3 * 2, 0))
    assert found.c2 == pytest.approx(6 * math.hypot(0 - 0, 1 - -1))
    assert found.g1 == 0


def test_a_corner_is_told_by_its_angle() -> None:
    turned = np.array([[5, 3], [5, 4], [6, 6], [7, 7]], float)
    found = continuity(FIRST, turned)
    assert found.geometric == "G0"
    assert found.g1 == pytest.approx(math.pi / 2, abs=1e-15)


def test_a_line_into_an_arc_is_g1_and_its_curvature_is_said() -> None:
    line = np.array([[-4, 0], [0, 0]], float)
    k = 4 / 3 * (math.sqrt(2) - 1)
    arc = 2 * np.array([[0, 0], [k, 0], [1, 1 - k], [1, 1]])
    found = continuity(line, arc)
    assert found.geometric == "G1"
    assert found.g2 == pytest.approx(2 * (1 - k) / (3 * k * k) / 2)


def test_where_a_tangent_vanishes_its_direction_is_still_known() -> None:
    cusp = np.array([[5, 3], [5, 3], [7, 3], [8, 8]], float)
    found = continuity(FIRST, cusp)
    assert found.geometric == "G1"
    assert math.isnan(found.g2)
    assert math.isnan(continuity(FIRST, np.full((4, 2), [5.0, 3.0])).g1)


@given(b_splines((3, 6), repeated=1))
def test_a_b_spline_is_smooth_at_knots_that_are_not_repeated(curve: Curve) -> None:
    points, knots, degree = curve
    if np.diff(np.unique(knots)).min() > 0.01:
        pieces = b_spline_to_bezier(points, knots, degree)
        assert all(joint.parametric == "C2" for joint in joints(pieces, tolerance=1e-8))
        assert len(joints(pieces)) == len(pieces.controls) - 1


def test_a_repeated_knot_takes_one_order_each_time() -> None:
    points = np.array([[0, 0], [1, 3], [2, -1], [4, 4], [6, 0], [7, 5], [9, 2], [11, 3]], float)
    for repeated, told in ((1, "C2"), (2, "C1"), (3, "C0"), (4, "")):
        inner = [1.0] * repeated
        knots = np.array([0.0] * 4 + inner + [2.0] * 4)
        pieces = b_spline_to_bezier(points[: 4 + repeated], knots, 3)
        assert [joint.parametric for joint in joints(pieces)] == [told]


def test_the_quarters_of_a_circle_in_homogeneous_points_are_c0_and_their_curvature_is_one() -> None:
    points, weights, knots, degree = circle(0, 0, 1)
    pieces = b_spline_to_bezier(homogeneous(points, weights), knots, degree)
    assert {joint.parametric for joint in joints(pieces, closed=True)} <= {"C0", "C1"}
    assert piece_derivative(pieces).degree == 1


def test_a_piece_without_length_is_refused() -> None:
    with pytest.raises(ValueError, match="no length in the parameter; move its knots apart"):
        continuity(FIRST, FIRST, 0.0, 1.0)
