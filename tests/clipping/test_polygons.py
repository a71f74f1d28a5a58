"""Clipped polygons against exact fractions and shapely, and the edges that run back over themselves."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st
from numpy.typing import NDArray
from shapely import Polygon, box

from tests.clipping.exact import (
    area,
    clipped_convex,
    corners,
    cross,
    fractions,
    hull,
    inside,
    near_a_side,
    sides,
    winding,
)
from tests.clipping.inputs import (
    Window,
    coordinates,
    grid_windows,
    polygons,
    quarters,
    scale,
    star_shaped,
    windows,
)
from workbench.algorithms import catalogue
from workbench.algorithms.clipping import degenerate_edges, sutherland_hodgman
from workbench.engine.counts import counts
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

Points = Sequence[tuple[float, float]]
ENTRY = catalogue.get("sutherland_hodgman")
COURSE: Window = (0.0, 0.0, 30.0, 20.0)


def clipped(polygon: Points | NDArray[np.float64], window: Window) -> list[tuple[float, float]]:
    return list(sutherland_hodgman(np.array(polygon, float).reshape(-1, 2), *window))


def size_of(polygon: Points, window: Window) -> float:
    return scale(*window, *(number for point in polygon for number in point))


def test_a_triangle_over_a_corner() -> None:
    assert clipped([(20, 10), (40, 10), (20, 40)], COURSE) == [(20, 20), (20, 10), (30, 10), (30, 20)]


@pytest.mark.parametrize(
    ("polygon", "left"),
    [
        ([(1, 1), (9, 1), (5, 7)], [(1, 1), (9, 1), (5, 7)]),
        ([(0, 0), (30, 0), (30, 20), (0, 20)], [(0, 0), (30, 0), (30, 20), (0, 20)]),
        ([(-9, -9), (90, -9), (90, 90), (-9, 90)], [(0, 20), (0, 0), (30, 0), (30, 20)]),
        ([(-9, 5), (-1, 5), (-5, 9)], []),
        ([(31, 21), (40, 21), (31, 29)], []),
        ([], []),
        ([(5, 5)], [(5, 5)]),
        ([(-5, 5)], []),
    ],
)
def test_inside_outside_around_and_hardly_a_polygon(polygon: Points, left: Points) -> None:
    found = clipped(polygon, COURSE)
    assert sorted(found) == sorted(left)
    if found:
        start = left.index(found[0])
        assert found == [*left[start:], *left[:start]]


@given(polygon=polygons(coordinates, least=0), window=windows())
def test_every_vertex_lies_in_the_window_and_clipping_again_changes_nothing(
    polygon: Points, window: Window
) -> None:
    found = clipped(polygon, window)
    assert all(inside(point, window) for point in found)
    assert clipped(found, window) == found


@given(polygon=polygons(coordinates, least=0), window=windows())
def test_vertices_inside_stay_in_order(polygon: Points, window: Window) -> None:
    staying = [point for point in polygon if inside(point, window)]
    found = iter([*clipped(polygon, window)] * 2)
    assert all(point in found for point in staying)


@given(polygon=polygons(quarters), window=grid_windows, share=st.tuples(*[st.integers(1, 96)] * 2))
def test_each_point_in_the_window_is_gone_round_as_often_as_before(
    polygon: Points, window: Window, share: tuple[int, int]
) -> None:
    """Of any polygon, also one that crosses itself; in exact fractions."""
    xmin, ymin, xmax, ymax = fractions(window)
    point = (xmin + (xmax - xmin) * share[0] / 97, ymin + (ymax - ymin) * share[1] / 97)
    assume(not near_a_side(polygon, point, 1e-6))
    found = clipped(polygon, window)
    assert winding([fractions(vertex) for vertex in found], point) == winding(polygon, point)


@given(points=polygons(quarters, most=12), window=grid_windows)
@example(points=[(-3.0, -3.0), (3.0, 3.0), (-3.0, 3.0)], window=(0.0, 0.0, 2.0, 2.0))
@example(points=[(0.0, 0.0), (2.0, 0.0), (1.0, 5.0)], window=(-4.0, -3.0, 4.0, 0.0))
def test_of_a_convex_polygon_exactly_what_lies_in_the_window_is_left(points: Points, window: Window) -> None:
    convex = hull(points)
    assume(len(convex) > 2)
    polygon = [(float(x), float(y)) for x, y in convex]
    near = 1e-9 * size_of(polygon, window)
    found, true = clipped(polygon, window), clipped_convex(convex, window)
    for x, y in true:
        assert any(abs(Fraction(a) - x) <= near and abs(Fraction(b) - y) <= near for a, b in found)
    for vertex in found:
        assert len(true) > 0
        assert near_a_side(true, vertex, near) or vertex in [(float(x), float(y)) for x, y in true]
    assert abs(area(found) - area(true)) <= near * size_of(polygon, window)
    theirs = Polygon(polygon).intersection(box(*window))
    assert float(area(true)) == pytest.approx(theirs.area, abs=near * size_of(polygon, window))
    if theirs.area > near:
        assert Polygon(found).symmetric_difference(theirs).area <= near * size_of(polygon, window)
    assert not degenerate_edges(found, window) or not theirs.area


@given(polygon=star_shaped(), window=windows(st.integers(-12, 12).map(float)))
def test_the_area_in_the_window_is_left(polygon: NDArray[np.float64], window: Window) -> None:
    """And where shapely finds several parts, edges run back over themselves."""
    assume(len(polygon) > 2 and Polygon(polygon).is_valid)
    found = clipped(polygon, window)
    theirs = Polygon(polygon).intersection(box(*window))
    assert abs(float(area(found))) == pytest.approx(theirs.area, rel=1e-9, abs=1e-9)
    parts = [part for part in getattr(theirs, "geoms", [theirs]) if part.area > 0]
    assert len(parts) < 2 or degenerate_edges(found, window)


@given(polygon=st.one_of(star_shaped(), polygons(quarters)), window=windows(st.integers(-6, 6).map(float)))
def test_degenerate_edges_are_where_sides_run_both_ways(polygon: Points, window: Window) -> None:
    """Looked at in the middle of each piece of the boundary between vertices."""
    found = clipped(polygon, window)
    back = degenerate_edges(found, window)
    rim = corners(window)
    for start, end in sides(rim):
        direction = (end[0] - start[0], end[1] - start[1])
        marks = sorted({fractions(p) for p in [*found, start, end] if cross(start, end, p) == 0})
        for low, high in pairwise(marks):
            middle = ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2)
            ways = {
                (b[0] - a[0]) * direction[0] + (b[1] - a[1]) * direction[1] > 0
                for a, b in (map(fractions, side) for side in sides(found))
                if a != b and cross(a, b, low) == cross(a, b, high) == 0 and between(middle, a, b)
            }
            assert (len(ways) == 2) == any(between(middle, *map(fractions, stretch)) for stretch in back)


def between(point: Sequence[Fraction], a: Sequence[Fraction], b: Sequence[Fraction]) -> bool:
    box_of = (min(a[0], b[0]), min(a[1], b[1]), max(a[0], b[0]), max(a[1], b[1]))
    return cross(a, b, point) == 0 and inside(point, box_of)


def test_a_fork_is_left_in_one_piece_with_an_edge_that_runs_back_over_itself() -> None:
    vertices, *window = ENTRY.example
    found = clipped(vertices, tuple(window))
    assert degenerate_edges(found, window) == [((30, found[4][1]), (30, found[5][1]))]
    assert (found[4][0], found[5][0]) == (30, 30)
    theirs = Polygon(vertices).intersection(box(*window))
    assert len(theirs.geoms) == 2


def test_degenerate_edges_are_found_on_all_four_edges_and_as_long_as_they_are() -> None:
    window = (0.0, 0.0, 4.0, 4.0)
    around = [(0, 1), (0, 3), (1, 4), (3, 4), (4, 3), (4, 1), (3, 0), (1, 0)]
    there_and_back = [*around, *around[-2:0:-1]]
    assert degenerate_edges(there_and_back, window) == [
        ((0, 1), (0, 3)),
        ((4, 1), (4, 3)),
        ((1, 0), (3, 0)),
        ((1, 4), (3, 4)),
    ]
    assert degenerate_edges(around, window) == []
    assert degenerate_edges([], window) == []
    forked = [(0, 0), (0, 1), (2, 1), (0, 2), (0, 3), (2, 3), (0, 4), (4, 4), (4, 0)]
    assert degenerate_edges(forked, window) == []
    split = [(0, 4), (0, 3), (2, 3), (0, 2), (0, 1.5), (0, 1), (2, 1), (0, 0), (0, 3.5), (1, 4)]
    assert degenerate_edges(split, window) == [((0, 1), (0, 2)), ((0, 3), (0, 3.5))]


@given(polygon=polygons(quarters), window=grid_windows, by=st.tuples(*[st.integers(-999, 999)] * 2))
def test_a_shifted_polygon_gives_the_shifted_polygon(
    polygon: Points, window: Window, by: tuple[int, int]
) -> None:
    dx, dy = by
    there = (window[0] + dx, window[1] + dy, window[2] + dx, window[3] + dy)
    found = clipped(polygon, window)
    shifted = [(x - dx, y - dy) for x, y in clipped([(x + dx, y + dy) for x, y in polygon], there)]
    for mine, theirs in ((found, shifted), (shifted, found)):
        for x, y in mine:
            assert any(abs(x - a) <= 1e-10 and abs(y - b) <= 1e-10 for a, b in theirs)
    assert float(area(found)) == pytest.approx(float(area(shifted)), abs=1e-8)


@given(polygon=polygons(quarters), window=grid_windows)
def test_mirrored_its_area_is_mirrored(polygon: Points, window: Window) -> None:
    xmin, ymin, xmax, ymax = window
    mirrored = clipped([(-x, y) for x, y in polygon], (-xmax, ymin, -xmin, ymax))
    assert float(area(mirrored)) == pytest.approx(-float(area(clipped(polygon, window))), abs=1e-8)


@given(polygon=polygons(quarters, least=0), window=grid_windows)
def test_counted_intersections_are_the_crossings_of_the_stages(polygon: Points, window: Window) -> None:
    vertices = np.array(polygon, float).reshape(-1, 2)
    work = counts(sutherland_hodgman, vertices, *window)
    reckoned = work.block_visits["Find the intersection"]
    assert work.divisions == reckoned <= work.multiplications  # beside a corner its side is asked for too
    steps = list(Steps(ENTRY, record(sutherland_hodgman, vertices, *window)))[1:]
    assert reckoned == sum(step.answer in ("in → out", "out → in") for step in steps)
    if all(inside(point, window) for point in polygon):
        assert reckoned == 0


def test_the_four_cases_in_the_hand_table() -> None:
    polygon = np.array([[5.0, 10.0], [40.0, 10.0], [40.0, 18.0], [5.0, 18.0]])
    steps = list(Steps(ENTRY, record(sutherland_hodgman, polygon, *COURSE)))[1:]
    assert [step.row for step in steps[4:8]] == [
        ("right", (5, 18), (5, 10), "in → in", (5, 10)),
        ("right", (5, 10), (40, 10), "in → out", (30, 10)),
        ("right", (40, 10), (40, 18), "out → out", ""),
        ("right", (40, 18), (5, 18), "out → in", ((30, 18), (5, 18))),
    ]
    assert [step.row[0] for step in steps] == ["left"] * 4 + ["right"] * 4 + ["bottom"] * 4 + ["top"] * 4
    assert steps[7].tables["Vertices handed on"] == (("x", "y"), ((5, 10), (30, 10), (30, 18), (5, 18)))
    assert steps[7].tables["Vertices taken"][1][0] == (5, 10)
    said = "".join(part.text for part in steps[5].sentence)
    assert said == (
        "xₘₐₓ: (5, 10) to (40, 10) goes out: hand on the intersection, (30, 10). "
        "x = 30, y = 10 + (10 − 10)(30 − 5)/(40 − 5) = 10."
    )


@given(polygon=polygons(quarters), low=st.tuples(quarters, quarters))
def test_a_window_of_one_point_and_one_turned_inside_out_come_to_an_end(
    polygon: Points, low: tuple[float, float]
) -> None:
    assert set(clipped(polygon, (*low, *low))) <= {low}
    clipped(polygon, (low[0], low[1], low[0] - 3, low[1] - 3))
