"""Two algorithms on one figure, and the distance from the ideal, against fractions."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms import catalogue
from workbench.algorithms.lines import bresenham_line, dda_line
from workbench.document.model import Circle, Line, Polyline, WorldPoint
from workbench.document.samples.examples import blank_sheet
from workbench.rendering.comparing import compare, distances, figure_pixels, is_line
from workbench.rendering.mapping import Call

SHEET = blank_sheet(64, 48).sheets[0]
ends = st.tuples(st.integers(0, 63), st.integers(0, 47))


def line(start, end, algorithm="bresenham_line"):
    return Line("f1", (WorldPoint("p1", *start), WorldPoint("p2", *end)), algorithm)


def cells(array):
    return {tuple(row) for row in array.tolist()}


@given(ends, ends)
def test_the_parts_of_a_comparison_are_the_two_sets(start, end):
    result = compare(SHEET, line(start, end), "bresenham_line", "dda_line")
    first, second = set(bresenham_line(*start, *end)), set(dda_line(*start, *end))
    both, only_first, only_second, tied_first, tied_second = map(cells, result)
    assert both == first & second
    assert only_first | tied_first == first - second
    assert only_second | tied_second == second - first
    assert not only_first & tied_first


@given(ends, ends)
def test_bresenham_and_dda_differ_by_exact_ties_alone(start, end):
    (x0, y0), (x1, y1) = start, end
    result = compare(SHEET, line(start, end), "bresenham_line", "dda_line")
    assert len(result.only_first) == len(result.only_second) == 0
    steep = abs(y1 - y0) > abs(x1 - x0)
    for x, y in (*result.tied_first.tolist(), *result.tied_second.tolist()):
        if steep:
            offset = x - (x0 + Fraction((x1 - x0) * (y - y0), y1 - y0))
        else:
            offset = y - (y0 + Fraction((y1 - y0) * (x - x0), x1 - x0))
        assert abs(offset) == Fraction(1, 2)


def test_a_line_whose_ties_fall_apart():
    """From (4, 2) down to (0, 0) the line passes half way at x = 1 and x = 3."""
    result = compare(SHEET, line((4, 2), (0, 0)), "bresenham_line", "dda_line")
    assert result.ties == 2
    assert cells(result.both) == {(4, 2), (2, 1), (0, 0)}


@given(ends, ends)
def test_every_pixel_of_a_line_lies_within_half_a_pixel(start, end):
    found = distances(SHEET, line(start, end))
    assert len(found) == len(figure_pixels(SHEET, line(start, end)))
    assert np.isfinite(found).all()
    assert (np.abs(found) <= 0.5 + 1e-12).all()


@given(st.integers(1, 20))
def test_every_pixel_of_a_circle_lies_near_it(radius):
    circle = Circle("f1", (WorldPoint("p1", 30, 24),), "midpoint_circle", radius_world=radius)
    found = distances(SHEET, circle)
    assert len(found) == len(figure_pixels(SHEET, circle)) > 0
    assert (np.abs(found) < 0.5 + 1e-12).all()


def test_a_polyline_is_compared_piece_by_piece():
    points = tuple(WorldPoint(f"p{k}", *at) for k, at in enumerate([(0, 0), (4, 2), (8, 0)]))
    polyline = Polyline("f1", points, "bresenham_line")
    assert len(distances(SHEET, polyline)) == 10
    result = compare(SHEET, polyline, "bresenham_line", "midpoint_line")
    assert len(result.both) + len(result.only_first) + len(result.tied_first) == len(
        cells(figure_pixels(SHEET, polyline))
    )


def test_an_unknown_algorithm_is_refused():
    with pytest.raises(LookupError, match="no_such_line"):
        compare(SHEET, line((0, 0), (4, 2)), "bresenham_line", "no_such_line")


def test_only_what_paints_a_line_can_tie():
    for slug in ("bresenham_line", "dda_line", "wu_line"):
        assert is_line(Call(catalogue.get(slug), (0, 0, 4, 2)))
    for slug in ("cohen_sutherland", "liang_barsky", "midpoint_circle", "scan_line_exact"):
        assert not is_line(Call(catalogue.get(slug), ()))
