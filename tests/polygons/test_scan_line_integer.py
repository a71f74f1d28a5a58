"""The fill in whole numbers: exact between whole corners, however far apart."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.polygons.exact import covered
from tests.polygons.test_scan_line_exact import Rings, polygons
from workbench.algorithms import catalogue
from workbench.algorithms.polygons import scan_line_exact, scan_line_integer
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

whole = st.integers(-6, 9).map(float)
far = st.integers(-(2**20), 2**20).map(float)


def spans(fill, polygon: Rings, closed: bool, nonzero: bool) -> list[tuple[int, int, int]]:
    points, ends = np.array(polygon[0], np.float64).reshape(-1, 2), np.array(polygon[1], np.int64)
    return list(fill(points, ends, closed, nonzero))


def pixels(polygon: Rings, closed: bool, nonzero: bool) -> list[tuple[int, int]]:
    rows = spans(scan_line_integer, polygon, closed, nonzero)
    return [(x, y) for y, left, right in rows for x in range(left, right + 1)]


@given(polygons(whole), st.booleans(), st.booleans())
def test_between_whole_corners_pixels_are_those_of_exact_fractions(polygon, closed, nonzero):
    assert set(pixels(polygon, closed, nonzero)) == covered(*polygon, closed, nonzero)


@given(st.lists(st.tuples(far, st.integers(0, 40).map(float)), min_size=3, max_size=5), st.booleans())
@settings(max_examples=30)
def test_far_corners_give_the_pixels_of_the_exact_fill(corners, closed):
    polygon = corners, [len(corners)]
    assert _merged(spans(scan_line_integer, polygon, closed, False)) == _merged(
        spans(scan_line_exact, polygon, closed, False)
    )


def _merged(rows: list[tuple[int, int, int]]) -> list[tuple[int, int, int]]:
    """Spans that touch as one: where crossings coincide their order is free."""
    merged: list[tuple[int, int, int]] = []
    for y, left, right in rows:
        if merged and merged[-1][0] == y and merged[-1][2] == left - 1:
            left = merged.pop()[1]
        merged.append((y, left, right))
    return merged


@given(polygons(), st.booleans(), st.booleans())
def test_corners_go_to_the_nearest_pixel(polygon, closed, nonzero):
    nearest = [(math.floor(x + 0.5), math.floor(y + 0.5)) for x, y in polygon[0]]
    assert pixels(polygon, closed, nonzero) == pixels((nearest, polygon[1]), closed, nonzero)


@given(polygons(), st.booleans(), st.booleans())
def test_pixels_come_once_bottom_to_top_and_left_to_right(polygon, closed, nonzero):
    filled = pixels(polygon, closed, nonzero)
    assert filled == sorted(set(filled), key=lambda pixel: (pixel[1], pixel[0]))


@given(st.lists(st.tuples(whole, whole), min_size=3, max_size=5), st.booleans())
@settings(max_examples=30)
def test_whole_part_and_counter_are_the_exact_crossing(corners, closed):
    run = np.array(corners), np.array([len(corners)]), closed, False
    recording = record(scan_line_integer, *run)
    for step in Steps(catalogue.get("scan_line_integer"), recording):
        if step.row:
            active = recording[step.last].variables["active"]
            for edge in active:
                (x0, y0), (x1, y1) = corners[edge.low], corners[edge.high]
                if edge.winding == 0:
                    assert edge.counter == 0
                    continue
                exact = Fraction(x0) + Fraction(step.row[0] - y0) * Fraction(x1 - x0) / Fraction(y1 - y0)
                assert edge.x + Fraction(edge.counter, edge.delta_y) == exact
                assert 0 <= edge.counter < edge.delta_y


@pytest.mark.parametrize("closed", [False, True])
def test_the_triangle_of_the_course(closed):
    triangle = [(2.0, 1.0), (8.0, 1.0), (5.0, 7.0)], [3]
    assert len(pixels(triangle, closed, False)) == (25 if closed else 21)
    steps = Steps(
        catalogue.get("scan_line_integer"),
        record(scan_line_integer, np.array(triangle[0]), np.array([3]), closed, False),
    )
    assert [step.row for step in steps if step.row][3] == (4, "3 + 3/6, 6 + 3/6", "4 to 6", 3)
