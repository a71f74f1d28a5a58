"""Distances from the ideal curve, against fractions and against a dense search along the curve."""

from fractions import Fraction
from math import isqrt

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from workbench.geometry.distance import (
    circle_distance,
    ellipse_distance,
    line_distance,
    line_offset,
    line_tie,
)

small = st.integers(-40, 40)
radius = st.integers(1, 40)


@given(small, small, small, small, small, small)
def test_line_offset_is_zero_exactly_on_the_line(x0, y0, x1, y1, x, y):
    offset = line_offset(x0, y0, x1, y1, x, y)
    steep = abs(y1 - y0) > abs(x1 - x0)
    if (x0, y0) != (x1, y1):
        along = (x - offset, Fraction(y)) if steep else (Fraction(x), y - offset)
        assert (x1 - x0) * (along[1] - y0) == (y1 - y0) * (along[0] - x0)
        assert abs(line_distance(x0, y0, x1, y1, np.array([[x, y]], float))[0]) <= abs(offset) + 1e-9


@given(small, small, small, small, small, small)
def test_a_tie_of_a_line_is_an_offset_of_exactly_one_half(x0, y0, x1, y1, x, y):
    tie = line_tie(x0, y0, x1, y1, x, y)
    assert tie == ((x0, y0) != (x1, y1) and abs(line_offset(x0, y0, x1, y1, x, y)) == Fraction(1, 2))


def test_the_line_0_0_to_2_1_ties_in_its_middle():
    assert line_tie(0, 0, 2, 1, 1, 0)
    assert line_tie(0, 0, 2, 1, 1, 1)
    assert not line_tie(0, 0, 2, 1, 0, 0)


@given(radius, radius)
def test_circles_and_ellipses_never_tie(rx, ry):
    """No whole column meets the ellipse exactly half way between two rows (nor, mirrored, a row)."""
    for x in range(rx + 1):
        square = Fraction(ry * ry * (rx * rx - x * x), rx * rx)
        root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
        assert root * root != square or (2 * root).denominator != 1 or root.denominator == 1


@given(radius, small, small)
def test_circle_and_round_ellipse_agree(r, x, y):
    point = np.array([[x, y]], float)
    assert np.allclose(circle_distance(0, 0, r, point), ellipse_distance(0, 0, r, r, point), atol=1e-9)


@given(st.integers(1, 30), st.integers(1, 30), small, small, small, small)
def test_ellipse_distance_against_a_dense_search(rx, ry, xc, yc, dx, dy):
    angle = np.linspace(0, 2 * np.pi, 40_001)
    away = np.hypot(rx * np.cos(angle) - dx, ry * np.sin(angle) - dy).min()
    found = float(ellipse_distance(xc, yc, rx, ry, np.array([[xc + dx, yc + dy]], float))[0])
    assert np.isfinite(found)
    assert abs(abs(found) - away) < 1e-4 * (1 + max(rx, ry))
    inside = Fraction(dx * dx, rx * rx) + Fraction(dy * dy, ry * ry) < 1
    assert (found < 0) == inside or abs(found) < 1e-9


@given(small, small, small, small, small, small)
def test_line_distance_does_not_depend_on_which_end_is_first(x0, y0, x1, y1, x, y):
    point = np.array([[x, y]], float)
    forth = line_distance(x0, y0, x1, y1, point)
    back = line_distance(x1, y1, x0, y0, point)
    if (x0, y0) != (x1, y1):
        assert np.allclose(forth, back, atol=1e-9)


def test_degenerate_curves_have_distances():
    point = np.array([[3.0, 4.0]])
    assert line_distance(0, 0, 0, 0, point)[0] == 5.0
    assert circle_distance(0, 0, 0, point)[0] == 5.0
    assert ellipse_distance(0, 0, 3, 0, point)[0] == 4.0
    assert ellipse_distance(0, 0, 0, 4, point)[0] == 3.0
    assert ellipse_distance(0, 0, 0, 0, point)[0] == 5.0
