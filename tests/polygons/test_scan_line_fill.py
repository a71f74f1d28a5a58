"""The fill with edge table and active edge table: exact where floats hold 1/m; else it drifts and says so."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.polygons.exact import covered
from tests.polygons.test_scan_line_exact import Rings, polygons
from workbench.algorithms import catalogue
from workbench.algorithms.marks import Spot
from workbench.algorithms.polygons import scan_line_fill
from workbench.algorithms.polygons.exactness import has_exact_slopes
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

# Levels between which every height is a power of two
LEVELS = ([0.0, 4.0, 8.0], [-1.5, 0.5, 2.5], [0.25, 0.5, 0.75, 1.0, 1.25], [-3.0, -2.0, -1.0])


@st.composite
def dyadic(draw: st.DrawFn) -> Rings:
    """Polygons whose edges all have a 1/m of few bits."""
    levels = draw(st.sampled_from(LEVELS))
    points, ends = draw(polygons())
    heights = [draw(st.sampled_from(levels[:3])) for _point in points]
    columns = st.integers(-24, 36).map(lambda number: number / 4)
    return [(draw(columns), y) for y in heights], ends


def arrays(polygon: Rings) -> tuple[np.ndarray, np.ndarray]:
    return np.array(polygon[0], np.float64).reshape(-1, 2), np.array(polygon[1], np.int64)


def pixels(polygon: Rings, closed: bool, nonzero: bool) -> list[tuple[int, int]]:
    rows = scan_line_fill(*arrays(polygon), closed, nonzero)
    return [(x, y) for y, left, right in rows for x in range(left, right + 1)]


@given(dyadic(), st.booleans(), st.booleans())
def test_where_floats_hold_each_slope_pixels_are_those_of_exact_fractions(polygon, closed, nonzero):
    assert has_exact_slopes(*arrays(polygon), closed, nonzero)
    assert set(pixels(polygon, closed, nonzero)) == covered(*polygon, closed, nonzero)


@given(polygons(st.integers(-6, 9).map(float)), st.booleans(), st.booleans())
def test_the_condition_of_the_law_is_that_of_fractions(polygon, closed, nonzero):
    points, ends = polygon
    starts = [0, *ends[:-1]]
    rings = [points[start:end] for start, end in zip(starts, ends, strict=True)]
    edges = [(a, b) for ring in rings for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)]
    slopes = [Fraction(b[0] - a[0]) / Fraction(b[1] - a[1]) for a, b in edges if a[1] != b[1]]
    expected = all(slope.denominator in {2**k for k in range(17)} for slope in slopes)
    assert has_exact_slopes(*arrays(polygon), closed, nonzero) == expected


@given(polygons(), st.booleans(), st.booleans())
def test_pixels_come_once_bottom_to_top_and_left_to_right(polygon, closed, nonzero):
    filled = pixels(polygon, closed, nonzero)
    assert filled == sorted(set(filled), key=lambda pixel: (pixel[1], pixel[0]))


@given(
    polygons(st.integers(-6, 9).map(float) | st.integers(-24, 36).map(lambda number: number / 4)),
    st.booleans(),
    st.booleans(),
)
def test_a_pixel_that_no_crossing_is_near_is_decided_rightly(polygon, closed, nonzero):
    """Drift is far too small to reach a centre that no edge passes through."""
    wrong = set(pixels(polygon, closed, nonzero)) ^ covered(*polygon, closed, nonzero)
    points, ends = polygon
    starts = [0, *ends[:-1]]
    for x, y in wrong:
        rings = [points[start:end] for start, end in zip(starts, ends, strict=True)]
        edges = [(a, b) for ring in rings for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)]
        through = [
            (Fraction(b[0] - a[0])) * Fraction(y - a[1]) == Fraction(b[1] - a[1]) * Fraction(x - a[0])
            for a, b in edges
        ]
        assert any(through)


def steps_of(polygon: Rings, closed: bool, nonzero: bool = False) -> Steps:
    run = (*arrays(polygon), closed, nonzero)
    return Steps(catalogue.get("scan_line_fill"), record(scan_line_fill, *run))


@given(st.lists(st.tuples(*[st.integers(-9, 9).map(float)] * 2), min_size=3, max_size=3), st.booleans())
@example([(0.0, 0.0), (6.0, 1.0), (1.0, 6.0)], True)
def test_each_row_that_drift_makes_wrong_says_so_and_crosses_the_pixels(corners, closed):
    polygon = corners, [3]
    wrong = set(pixels(polygon, closed, False)) ^ covered(*polygon, closed, False)
    told = set()
    for step in steps_of(polygon, closed):
        crosses = {(int(mark.x), int(mark.y)) for mark in step.marks if isinstance(mark, Spot)}
        sentence = "".join(part.text for part in step.sentence)
        assert ("has drifted" in sentence) == bool(crosses)
        told |= crosses
    assert told == wrong


def test_many_closed_triangles_of_whole_corners_lose_a_pixel():
    """As the entry's not-law says."""
    chance = np.random.default_rng(1)
    wrong = 0
    for _triangle in range(40):
        polygon = [tuple(map(float, corner)) for corner in chance.integers(0, 40, (3, 2))], [3]
        wrong += set(pixels(polygon, True, False)) != covered(*polygon, True, False)
    assert wrong > 4


LEVEL_STEP = [(1, 1), (7, 1), (7, 3), (9, 3), (9, 5), (5, 8), (1, 5)]


@pytest.mark.parametrize(
    ("closed", "rows"),
    [
        (True, {1: "1, 7", 3: "1, 9", 5: "1, 9", 8: "5, 5"}),
        (False, {1: "1, 7", 3: "1, 9", 5: "1, 9", 8: ""}),
    ],
)
def test_a_vertex_counts_once_or_twice(closed, rows):
    """Twice where the polygon turns back, once where it goes on, also over a level edge."""
    told = {step.row[0]: step.row[1] for step in steps_of((LEVEL_STEP, [7]), closed) if step.row}
    assert {y: told[y] for y in rows} == rows
    for step in steps_of((LEVEL_STEP, [7]), closed):
        if step.row:
            crossing = [row for row in step.tables["Active edge table"][1] if row[-1] != 0]
            assert len(crossing) == (step.row[1].count(",") + 1 if step.row[1] else 0)


def test_the_whole_edge_table_stands_before_the_first_row():
    before = steps_of(([(2.0, 1.0), (8.0, 1.0), (5.0, 7.0)], [3]), True)[0]
    columns, rows = before.tables["Edge table"]
    assert columns == ("first y", "last y", "x", "1/m", "from", "to")
    assert sorted(row[2:4] for row in rows if row[3] != "level") == [(2.0, 0.5), (8.0, -0.5)]
    assert len(rows) == 3
    assert before.tables["Active edge table"][1] == ()


def test_the_triangle_of_the_course():
    steps = steps_of(([(2.0, 1.0), (8.0, 1.0), (5.0, 7.0)], [3]), True)
    assert [step.row for step in steps if step.row][3] == (4, "3.5, 6.5", "4 to 6", 3)


@given(st.lists(st.tuples(*[st.integers(-9, 9).map(float)] * 2), max_size=2), st.booleans())
def test_less_than_a_polygon_ends(points, closed):
    ends = [len(points)] if points else []
    assert all(left <= right for _y, left, right in scan_line_fill(*arrays((points, ends)), closed, False))
