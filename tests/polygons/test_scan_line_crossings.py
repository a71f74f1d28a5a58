"""The fill by crossings against exact fractions, and beside the fill with edge tables."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.polygons.exact import covered
from tests.polygons.test_scan_line_fill import Rings, coordinates, polygons, quarters
from workbench.algorithms.polygons import scan_line_crossings, scan_line_fill

far = st.one_of(st.integers(-(2**14), 2**14).map(float), quarters)


Spans = list[tuple[int, int, int]]


def spans(polygon: Rings, closed: bool, nonzero: bool) -> Spans:
    points, ends = np.array(polygon[0], np.float64).reshape(-1, 2), np.array(polygon[1], np.int64)
    return list(scan_line_crossings(points, ends, closed, nonzero))


def pixels(polygon: Rings, closed: bool, nonzero: bool) -> list[tuple[int, int]]:
    return [(x, y) for y, left, right in spans(polygon, closed, nonzero) for x in range(left, right + 1)]


@given(polygons(quarters), st.booleans(), st.booleans())
def test_on_quarters_pixels_are_those_of_exact_fractions(polygon, closed, nonzero):
    assert set(pixels(polygon, closed, nonzero)) == covered(*polygon, closed, nonzero)


@given(polygons(), st.booleans(), st.booleans())
def test_pixels_come_once_bottom_to_top_and_left_to_right(polygon, closed, nonzero):
    filled = pixels(polygon, closed, nonzero)
    assert filled == sorted(set(filled), key=lambda pixel: (pixel[1], pixel[0]))


@given(polygons(far), st.booleans(), st.booleans())
def test_far_vertices_give_the_pixels_of_the_edge_tables(polygon, closed, nonzero):
    """Of a strip: between far vertices are many rows and long spans."""
    strip = [(x, y % 50.0) for x, y in polygon[0]], polygon[1]
    points, ends = np.array(strip[0], np.float64), np.array(strip[1], np.int64)
    by_tables = list(scan_line_fill(points, ends, closed, nonzero))
    assert _merged(spans(strip, closed, nonzero)) == _merged(by_tables)


def _merged(rows: Spans) -> Spans:
    """Spans that touch as one: where crossings coincide their order is free."""
    merged: Spans = []
    for y, left, right in rows:
        if merged and merged[-1][0] == y and merged[-1][2] == left - 1:
            left = merged.pop()[1]
        merged.append((y, left, right))
    return merged


@pytest.mark.parametrize("closed", [False, True])
def test_the_triangle_of_the_course(closed):
    triangle = [(2.0, 1.0), (8.0, 1.0), (5.0, 7.0)], [3]
    rows = {y: (left, right) for y, left, right in spans(triangle, closed, False)}
    assert rows[4] == (4, 6)
    assert (7 in rows) == closed


@given(st.lists(st.tuples(coordinates, coordinates), max_size=2))
def test_less_than_a_polygon_ends(points):
    ends = [len(points)] if points else []
    assert all(left <= right for _y, left, right in spans((points, ends), True, False))
