"""The fill by crossings against exact fractions, and beside the fill with edge tables."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.polygons.exact import covered
from tests.polygons.test_scan_line_fill import Rings, coordinates, polygons, quarters
from workbench.algorithms.polygons import scan_line_crossings, scan_line_fill

far = st.one_of(st.integers(-(2**14), 2**14).map(float), quarters)


def spans(
    polygon: Rings, closed: bool, nonzero: bool, fill=scan_line_crossings
) -> list[tuple[int, int, int]]:
    points, ends = polygon
    return list(fill(np.array(points, np.float64).reshape(-1, 2), np.array(ends, np.int64), closed, nonzero))


def pixels(polygon: Rings, closed: bool, nonzero: bool) -> list[tuple[int, int]]:
    return [(x, y) for y, left, right in spans(polygon, closed, nonzero) for x in range(left, right + 1)]


@given(polygons(quarters), st.booleans(), st.booleans())
def test_on_quarters_pixels_are_those_of_exact_fractions(polygon, closed, nonzero):
    assert set(pixels(polygon, closed, nonzero)) == covered(*polygon, closed, nonzero)


@given(polygons(), st.booleans(), st.booleans())
def test_pixels_come_once_bottom_to_top_and_left_to_right(polygon, closed, nonzero):
    filled = pixels(polygon, closed, nonzero)
    assert filled == sorted(set(filled), key=lambda pixel: (pixel[1], pixel[0]))


@given(polygons(far), st.booleans())
def test_far_whole_vertices_give_the_pixels_of_the_edge_tables(polygon, nonzero):
    """On a few rows of a polygon that may be 32,768 pixels high."""
    near = [(x, y % 50.0) for x, y in polygon[0]], polygon[1]
    assert spans(near, False, nonzero) == spans(near, False, nonzero, scan_line_fill)


@pytest.mark.parametrize("closed", [False, True])
def test_the_triangle_of_the_course(closed):
    triangle = [(2.0, 1.0), (8.0, 1.0), (5.0, 7.0)], [3]
    rows = dict((y, (left, right)) for y, left, right in spans(triangle, closed, False))
    assert rows[4] == (4, 6)
    assert (7 in rows) == closed


@given(st.lists(st.tuples(coordinates, coordinates), max_size=2))
def test_less_than_a_polygon_ends(points):
    ends = [len(points)] if points else []
    assert all(left <= right for _y, left, right in spans((points, ends), True, False))
