"""Polygons and clipping on their way to the frame buffer: rings, fractions, far corners, clip windows."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from workbench.document.model import Circle, Line, Polygon, Rectangle, SeedFill, Sheet
from workbench.document.samples.figures import document_of, line, points_at, polygon
from workbench.engine.limited import collect_limited
from workbench.rendering import clipper_calls, display_list, figure_calls, frame_buffer, painter_of
from workbench.rendering.limits import POLYGON_REACH_PX, clip_ring

TRIANGLE = [(2, 1), (8, 1), (5, 7)]


def sheet_of(*figures, size=(12, 10), clip=None) -> Sheet:
    return document_of("", *size, list(figures), clip).sheets[0]


def painted(sheet: Sheet) -> np.ndarray:
    return painter_of(sheet) >= 0


def test_corners_are_given_on_the_grid_on_which_crossings_are_exact() -> None:
    places = [(1 / 3, 0.1), (7.7, 1.0), (5.0, 20 / 3)]
    sheet = sheet_of(polygon([places], 1, ""))
    (call,) = figure_calls(sheet, sheet.figures[0])
    corners = call.arguments[0]
    assert np.array_equal(corners * 4096, np.round(corners * 4096))
    assert np.abs(corners - places).max() <= 1 / 8192


@pytest.mark.parametrize(("closed", "pixels"), [(True, 25), (False, 21)])
def test_the_triangle_of_the_course(closed: bool, pixels: int) -> None:
    sheet = sheet_of(polygon([TRIANGLE], 1, "", closed=closed))
    assert painted(sheet).sum() == pixels
    assert np.flatnonzero(painted(sheet)[4]).tolist() == [4, 5, 6]


def test_a_ring_in_a_ring_is_a_hole_unless_windings_are_counted() -> None:
    outer, inner = [(1, 1), (10, 1), (10, 9), (1, 9)], [(3, 3), (8, 3), (8, 7), (3, 7)]
    hole = painted(sheet_of(polygon([outer, inner], 1, "")))
    assert not hole[5, 5]
    assert hole[2, 2]
    assert painted(sheet_of(polygon([outer, inner], 1, "", nonzero=True)))[5, 5]


def test_corners_are_not_rounded() -> None:
    (call,) = figure_calls(sheet_of(), polygon([[(0.25, 0.5), (7.75, 0.5), (4, 6.5)]], 1, ""))
    assert call.arguments[0].tolist() == [[0.25, 0.5], [7.75, 0.5], [4.0, 6.5]]
    assert call.arguments[1].tolist() == [3]
    assert call.arguments[2:] == (False, False)


def _inside(points: np.ndarray, x: float, y: float) -> bool:
    """Even-odd by a ray to the right."""
    inside = False
    for (x0, y0), (x1, y1) in zip(points, np.roll(points, -1, axis=0), strict=True):
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0):
            inside = not inside
    return inside


far = st.floats(-3e5, 3e5) | st.floats(-20, 30)


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(far, far), min_size=3, max_size=7))
def test_what_is_cut_off_far_away_changes_no_inside_in_reach(corners: list[tuple[float, float]]) -> None:
    ring = np.array(corners, np.float64)
    cut = clip_ring(ring, 12, 10)
    if len(cut):
        assert cut.min() >= -POLYGON_REACH_PX - 1e-9
        assert cut.max() <= 12 + POLYGON_REACH_PX + 1e-9
    rng = np.random.default_rng(1)
    for x, y in rng.uniform(-250, 250, (40, 2)):
        nearest = min(abs(_side(ring, k, x, y)) for k in range(len(ring)))
        if nearest > 1e-6:
            assert _inside(ring, x, y) == (len(cut) > 2 and _inside(cut, x, y))


def _side(ring: np.ndarray, k: int, x: float, y: float) -> float:
    (x0, y0), (x1, y1) = ring[k - 1], ring[k]
    length = max(float(np.hypot(x1 - x0, y1 - y0)), 1e-12)
    return float(((x1 - x0) * (y - y0) - (y1 - y0) * (x - x0)) / length)


def test_a_polygon_that_reaches_far_out_is_filled_in_the_picture() -> None:
    huge = [(-9e5, -9e5), (9e5, -9e5), (9e5, 9e5), (-9e5, 9e5)]
    assert painted(sheet_of(polygon([huge], 1, ""))).all()
    away = [(9e5, 9e5), (9.5e5, 9e5), (9e5, 9.5e5)]
    assert not painted(sheet_of(polygon([away], 1, ""))).any()


def test_lines_and_polygons_are_clipped_before_they_are_scan_converted() -> None:
    clip = Rectangle(3, 2, 8, 6)
    clipped = sheet_of(line((0, 0), (11, 9)), polygon([TRIANGLE], 2, "", closed=True), clip=clip)
    rows, columns = np.nonzero(painted(clipped))
    assert (rows.min(), rows.max(), columns.min(), columns.max()) == (2, 6, 3, 7)
    (call,) = clipper_calls(clipped, clipped.figures[0])
    assert call.entry.slug == "cohen_sutherland"
    assert call.arguments == (0.0, 0.0, 11.0, 9.0, 3.0, 2.0, 8.0, 6.0)
    other = replace(clipped, line_clipper="liang_barsky")
    assert (frame_buffer(other) == frame_buffer(clipped)).all()
    assert clipper_calls(other, other.figures[0])[0].entry.slug == "liang_barsky"


def test_what_no_algorithm_clips_is_clipped_pixel_by_pixel() -> None:
    circle = Circle("", points_at((6, 5)), "midpoint_circle", 1, radius_world=4.0)
    clip = Rectangle(2.5, 2.0, 9.0, 20.0)
    whole, cut = painted(sheet_of(circle)), painted(sheet_of(circle, clip=clip))
    inside = np.zeros_like(whole)
    inside[2:, 3:10] = True
    assert (cut == (whole & inside)).all()
    assert cut.any()


def test_a_vector_tube_draws_the_outline_of_what_is_left() -> None:
    strokes = display_list(sheet_of(polygon([TRIANGLE], 1, ""), clip=Rectangle(0, 0, 12, 4)))
    assert max(max(stroke.y0, stroke.y1) for stroke in strokes) == 4.0
    ends = [(stroke.x0, stroke.y0, stroke.x1, stroke.y1) for stroke in strokes]
    assert (2.0, 1.0, 8.0, 1.0) in ends
    # What is left is closed: it ends where it began.
    assert ends[-1][2:] == ends[0][:2]


def test_a_filled_circle_is_its_outline_with_what_is_inside() -> None:
    outline = painted(sheet_of(Circle("", points_at((6, 5)), "midpoint_circle", 1, radius_world=4.0)))
    area = painted(sheet_of(Circle("", points_at((6, 5)), "circle_fill", 1, radius_world=4.0)))
    assert (area & outline == outline).all()
    assert area[5, 6]


@settings(max_examples=30, deadline=None)
@given(st.integers(10, 120), st.integers(0, 11), st.integers(0, 9))
def test_a_recursion_that_is_stopped_has_coloured_a_beginning(limit: int, x: int, y: int) -> None:
    wall = line((5, 0), (5, 6))

    def fill(recursion_limit: int) -> Sheet:
        seed = SeedFill(
            "", points_at((x, y)), "boundary_fill_recursive", 2, recursion_limit=recursion_limit, boundary=1
        )
        return sheet_of(wall, seed)

    stopped, whole = painter_of(fill(limit)) == 1, painter_of(fill(1000)) == 1
    assert (stopped & ~whole).sum() == 0
    (call,) = figure_calls(fill(limit), fill(limit).figures[1])
    found = collect_limited(
        call.entry.function, limit, *(a.copy() if hasattr(a, "copy") else a for a in call.arguments)
    )
    assert found.overflowed == bool((stopped != whole).any()) or found.overflowed
    assert found.deepest <= limit
    assert len(found.rows) == stopped.sum()


def test_a_line_is_not_clipped_where_there_is_no_window() -> None:
    figure = Line("f", points_at((0, 0), (11, 9)), "bresenham_line")
    assert clipper_calls(sheet_of(figure), figure) == []
    assert isinstance(sheet_of(polygon([TRIANGLE], 1, "")).figures[0], Polygon)
