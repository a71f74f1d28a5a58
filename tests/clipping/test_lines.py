"""Clipped lines against exact fractions, against shapely and against one another."""

from collections.abc import Callable, Iterator
from fractions import Fraction
from random import Random

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st
from shapely import LineString, box

from tests.clipping.exact import grown, inside, near_a_side, visible
from tests.clipping.inputs import Line, Window, cases, coordinates, grid_windows, on_grid, scale, windows
from workbench.algorithms import catalogue
from workbench.algorithms.clipping import clip_point, cohen_sutherland, liang_barsky
from workbench.algorithms.clipping.edges import BOTTOM, LEFT, RIGHT, TOP, region_code
from workbench.engine.counts import counts
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

Point = tuple[Fraction, Fraction]
Ends = tuple[Point, Point]
Clipper = Callable[..., Iterator[tuple[float, float, float, float]]]

COURSE: Window = (0.0, 0.0, 30.0, 20.0)
EXAMPLE: tuple[Line, Window] = ((10.0, 30.0, 40.0, 0.0), COURSE)
both = pytest.mark.parametrize("clip", [cohen_sutherland, liang_barsky])


def clipped(clip: Clipper, line: Line, window: Window) -> Line | None:
    found = list(clip(*line, *window))
    assert len(found) <= 1
    return found[0] if found else None


def limits(line: Line, window: Window) -> tuple[Ends | None, Ends | None]:
    """The ends of what is surely visible and of what may be: the window shrunk and grown by a rounding."""
    rounding = Fraction(scale(*line, *window)) * Fraction(2) ** -48
    return visible(line, grown(window, -rounding)), visible(line, grown(window, rounding))


def within(end: tuple[float, ...], one: Point, other: Point, near: float) -> bool:
    """Whether ``end`` lies in the box of these two points, or this near to it."""
    (ax, ay), (bx, by) = one, other
    return inside(end, grown((min(ax, bx), min(ay, by), max(ax, bx), max(ay, by)), near))


@both
def test_the_example_of_the_course(clip: Clipper) -> None:
    assert clipped(clip, *EXAMPLE) == (20, 20, 30, 10)


def test_region_codes_are_top_bottom_right_left() -> None:
    codes = [[region_code(x, y, *COURSE) for x in (-1, 15, 31)] for y in (21, 10, -1)]
    assert [[f"{code:04b}" for code in row] for row in codes] == [
        ["1001", "1000", "1010"],
        ["0001", "0000", "0010"],
        ["0101", "0100", "0110"],
    ]
    assert (TOP, BOTTOM, RIGHT, LEFT) == (0b1000, 0b0100, 0b0010, 0b0001)
    assert all(region_code(x, y, *COURSE) == 0 for x in (0.0, 30.0) for y in (0.0, 20.0))


@both
@pytest.mark.parametrize(
    ("line", "left"),
    [
        ((1.0, 2.0, 3.0, 4.0), (1.0, 2.0, 3.0, 4.0)),
        ((-5.0, -5.0, 40.0, -1.0), None),
        ((-15.0, 10.0, 10.0, 30.0), None),
        ((-1.0, 10.0, 31.0, 10.0), (0.0, 10.0, 30.0, 10.0)),
        ((15.0, 25.0, 15.0, -25.0), (15.0, 20.0, 15.0, 0.0)),
        ((-9.0, 0.0, 9.0, 0.0), (0.0, 0.0, 9.0, 0.0)),
        ((30.0, 5.0, 30.0, 50.0), (30.0, 5.0, 30.0, 20.0)),
        ((30.5, 5.0, 30.5, 15.0), None),
        ((7.0, 7.0, 7.0, 7.0), (7.0, 7.0, 7.0, 7.0)),
        ((30.0, 20.0, 30.0, 20.0), (30.0, 20.0, 30.0, 20.0)),
        ((31.0, 7.0, 31.0, 7.0), None),
        ((30.0, 20.0, 40.0, 30.0), (30.0, 20.0, 30.0, 20.0)),
        ((-10.0, -20.0, 50.0, 40.0), (10.0, 0.0, 30.0, 20.0)),
    ],
)
def test_inside_outside_across_and_along_an_edge(clip: Clipper, line: Line, left: Line | None) -> None:
    assert clipped(clip, line, COURSE) == left


@both
@given(case=cases())
@example(case=EXAMPLE)
@example(case=((-1.0000000000000002, 0.0, -1.0, -2.0), (-1.0, -2.0, 0.0, -1.0)))
@example(case=((0.4, 0.0, -0.4, 0.8), (0.0, 0.0, 3.7, 0.4)))
@example(case=((1.4, 11.0, 1.4, 0.1), (0.0, 0.0, 2.0, 4.0)))
def test_what_is_left_is_what_is_visible(clip: Clipper, case: tuple[Line, Window]) -> None:
    """Against exact fractions: each end lies where it would if the window were off by a rounding at most."""
    line, window = case
    near = 1e-9 * scale(*line, *window)
    found = clipped(clip, line, window)
    surely, perhaps = limits(line, window)
    if found is None:
        assert surely is None
        return
    assert perhaps is not None
    for number, end in enumerate((found[:2], found[2:])):
        assert inside(end, window)
        assert near_a_side([line[:2], line[2:]], end, near)
        assert within(end, perhaps[number], surely[number] if surely else perhaps[1 - number], near)


@given(case=cases())
@example(case=EXAMPLE)
def test_both_find_the_same(case: tuple[Line, Window]) -> None:
    """But for lines that run along an edge within a rounding, told in exact fractions."""
    line, window = case
    near = 1e-9 * scale(*line, *window)
    surely, perhaps = limits(line, window)
    one, other = clipped(cohen_sutherland, line, window), clipped(liang_barsky, line, window)
    if perhaps is None:
        assert one is None
        assert other is None
    elif surely is not None and all(within(a, b, b, near) for a, b in zip(surely, perhaps, strict=True)):
        assert one is not None
        assert other is not None
        assert max(abs(a - b) for a, b in zip(one, other, strict=True)) <= 3 * near


@both
@given(case=cases())
def test_an_end_inside_stays_as_it_is_and_clipping_again_changes_nothing(
    clip: Clipper, case: tuple[Line, Window]
) -> None:
    line, window = case
    found = clipped(clip, line, window)
    for at in (0, 2):
        if inside(line[at : at + 2], window):
            assert found is not None
            assert found[at : at + 2] == line[at : at + 2]
    if found is not None:
        assert clipped(clip, found, window) == found


@both
@given(case=cases())
def test_the_ends_keep_their_order(clip: Clipper, case: tuple[Line, Window]) -> None:
    line, window = case
    found = clipped(clip, line, window)
    assume(found is not None)
    assert found is not None
    along = (found[2] - found[0]) * (line[2] - line[0]) + (found[3] - found[1]) * (line[3] - line[1])
    assert along >= -1e-9 * scale(*line, *window) ** 2


@both
@given(case=cases())
def test_mirrored_lines_give_mirrored_lines_to_the_last_digit(
    clip: Clipper, case: tuple[Line, Window]
) -> None:
    (x0, y0, x1, y1), (xmin, ymin, xmax, ymax) = case
    found = clipped(clip, *case)
    across = clipped(clip, (-x0, y0, -x1, y1), (-xmax, ymin, -xmin, ymax))
    over = clipped(clip, (x0, -y0, x1, -y1), (xmin, -ymax, xmax, -ymin))
    assert across == (found and (-found[0], found[1], -found[2], found[3]))
    assert over == (found and (found[0], -found[1], found[2], -found[3]))


@given(case=cases())
def test_liang_barsky_takes_columns_for_rows(case: tuple[Line, Window]) -> None:
    (x0, y0, x1, y1), (xmin, ymin, xmax, ymax) = case
    found = clipped(liang_barsky, *case)
    turned = clipped(liang_barsky, (y0, x0, y1, x1), (ymin, xmin, ymax, xmax))
    assert turned == (found and (found[1], found[0], found[3], found[2]))


@both
@given(line=on_grid, window=grid_windows, by=st.tuples(st.integers(-999, 999), st.integers(-999, 999)))
def test_a_shifted_line_gives_the_shifted_line(
    clip: Clipper, line: Line, window: Window, by: tuple[int, int]
) -> None:
    there: Line = tuple(number + by[k % 2] for k, number in enumerate(line))  # type: ignore[assignment]
    window_there: Window = tuple(number + by[k % 2] for k, number in enumerate(window))  # type: ignore[assignment]
    found, shifted = clipped(clip, line, window), clipped(clip, there, window_there)
    assert (found is None) == (shifted is None)
    if found is not None and shifted is not None:
        back = [number - by[k % 2] for k, number in enumerate(shifted)]
        assert max(abs(a - b) for a, b in zip(found, back, strict=True)) <= 1e-11


@st.composite
def touches(draw: st.DrawFn, most: int) -> tuple[Line, Window]:
    """A line of whole numbers through a corner of a window of whole numbers, within ``most``."""
    whole = st.integers(-most // 2, most // 2).map(float)
    xmin, ymin, xmax, ymax = window = draw(windows(whole))
    x, y = draw(st.sampled_from([(xmin, ymin), (xmin, ymax), (xmax, ymin), (xmax, ymax)]))
    step = max(most // 2**13, 1)
    dx, dy = draw(st.tuples(*[st.integers(-step, step)] * 2))
    back, forth = draw(st.tuples(*[st.integers(0, 2**11)] * 2))
    return (x - back * dx, y - back * dy, x + forth * dx, y + forth * dy), window


@both
@given(case=touches(2**24), data=st.data())
def test_of_whole_numbers_nothing_visible_is_lost(
    clip: Clipper, case: tuple[Line, Window], data: st.DataObject
) -> None:
    """Among them lines that only touch a corner; differences and products stay below 2^53."""
    line, window = case
    assert visible(line, window) is not None
    assert clipped(clip, line, window) is not None
    whole = st.integers(-(2**24), 2**24).map(float)
    any_line = data.draw(st.tuples(whole, whole, whole, whole))
    if visible(any_line, window) is not None:
        assert clipped(clip, any_line, window) is not None


@given(case=st.one_of(touches(2 * 10**12), cases()))
@example(case=((-1.2, -1.5, 1.2, 1.9), (0.0, 0.0, 0.3, 0.2)))
@example(case=((-1.6, -2.0, 0.8, 1.3), (0.0, 0.0, 0.3, 0.2)))
def test_cohen_sutherland_finds_a_line_just_where_any_of_it_is_visible(case: tuple[Line, Window]) -> None:
    line, window = case
    assert (clipped(cohen_sutherland, line, window) is None) == (visible(line, window) is None)


def test_touches_of_a_corner_far_out_are_not_lost() -> None:
    """Where the products of the intersection have more than 53 bits."""
    chance = Random(5)
    for _touch in range(300):
        x, y = float(chance.randint(2 * 10**8, 10**12)), float(chance.randint(2 * 10**8, 10**12))
        dx, dy = chance.randint(10**5, 10**8), chance.randint(10**5, 10**8)
        back, forth = chance.randint(1, 99), chance.randint(1, 99)
        line = (x - back * dx, y + back * dy, x + forth * dx, y - forth * dy)
        window = (x - 10.0**6, y - 10.0**6, x, y)
        found = clipped(cohen_sutherland, line, window)
        assert visible(line, window) == ((x, y), (x, y))
        assert found == (x, y, x, y)


def test_a_corner_passed_by_less_than_a_rounding_may_be_told_wrongly_by_liang_barsky() -> None:
    window = (0.0, 0.0, 0.3, 0.2)
    lost = (-1.6, 0.2 - 1.6, 0.2, 0.4)
    assert visible(lost, window) is not None
    assert clipped(liang_barsky, lost, window) is None
    found = (-1.6, -2.0, 0.8, 1.3)
    assert visible(found, window) is None
    assert clipped(liang_barsky, found, window) is not None


def test_liang_barsky_may_leave_an_end_a_digit_off_the_edge() -> None:
    found = clipped(liang_barsky, (-14.0, 1.0, 11.0, 1.0), (0.0, 0.0, 3.0, 2.0))
    assert found is not None
    assert 0 < found[0] < 1e-14
    assert clipped(cohen_sutherland, (-14.0, 1.0, 11.0, 1.0), (0.0, 0.0, 3.0, 2.0)) == (0, 1, 3, 1)


@both
@given(line=on_grid, window=grid_windows)
def test_shapely_finds_the_same(clip: Clipper, line: Line, window: Window) -> None:
    assume(line[:2] != line[2:])
    ends = visible(line, window)
    assume(ends is None or ends[0] != ends[1])
    theirs = LineString([line[:2], line[2:]]).intersection(box(*window))
    found = clipped(clip, line, window)
    assert (found is None) == (ends is None) == theirs.is_empty
    if found is not None:
        assert LineString([found[:2], found[2:]]).hausdorff_distance(theirs) <= 1e-9 * scale(*line, *window)


@both
@given(line=on_grid, low=st.tuples(coordinates, coordinates))
def test_a_window_of_one_point_and_one_turned_inside_out_come_to_an_end(
    clip: Clipper, line: Line, low: tuple[float, float]
) -> None:
    found = clipped(clip, line, (*low, *low))
    assert found is None or found == (*low, *low)
    clipped(clip, line, (low[0], low[1], low[0] - 3, low[1] - 3))


@given(case=cases())
def test_no_more_intersections_than_are_promised(case: tuple[Line, Window]) -> None:
    line, window = case
    work = counts(cohen_sutherland, *line, *window)
    reckoned = work.block_visits.get("Find the intersection", 0)
    assert reckoned <= 4
    assert work.divisions == reckoned
    corners = [(x, y) for x in (window[0], window[2]) for y in (window[1], window[3])]
    near = 2.0**-40 * scale(*line, *window)
    if not any(near_a_side([line[:2], line[2:]], corner, near) for corner in corners):
        assert work.multiplications == reckoned  # beside a corner its side is asked for exactly
    codes = region_code(*line[:2], *window), region_code(*line[2:], *window)
    if codes[0] | codes[1] == 0 or codes[0] & codes[1] != 0:
        assert reckoned == 0
    work = counts(liang_barsky, *line, *window)
    ends = [work.block_visits[f"Find the intersection on {way}"] for way in ("entering", "leaving")]
    assert max(ends) <= 1
    assert work.divisions <= 4


def test_cohen_sutherland_cuts_off_an_end_that_is_beyond_the_edge_s_extension_twice() -> None:
    line = (-30.0, -10.0, 60.0, 29.0)
    assert counts(cohen_sutherland, *line, *COURSE).block_visits["Find the intersection"] == 4
    assert counts(liang_barsky, *line, *COURSE).divisions == 4


@given(x=coordinates, y=coordinates, window=windows())
def test_a_point_is_kept_where_it_lies_in_the_window(x: float, y: float, window: Window) -> None:
    assert list(clip_point(x, y, *window)) == ([(x, y)] if inside((x, y), window) else [])
    for edge_x in window[::2]:
        for edge_y in window[1::2]:
            assert list(clip_point(edge_x, edge_y, *window)) == [(edge_x, edge_y)]


def table(slug: str, *arguments: float) -> list[tuple[object, ...]]:
    entry = catalogue.get(slug)
    steps = Steps(entry, record(entry.function, *arguments))
    assert all(step.answer in step.options for step in list(steps)[1:])
    return [step.row for step in list(steps)[1:]]


def test_the_hand_table_of_codes() -> None:
    assert table("cohen_sutherland", *EXAMPLE[0], *COURSE) == [
        (0, "1000, 0010", "1010", "0000", "clip top", (10, 30), (20, 20)),
        (1, "0000, 0010", "0010", "0000", "clip right", (40, 0), (30, 10)),
        (2, "0000, 0000", "0000", "0000", "accept", "", ""),
    ]
    assert table("cohen_sutherland", -5.0, 30.0, -1.0, 5.0, *COURSE) == [
        (0, "1001, 0001", "1001", "0001", "reject", "", "")
    ]


def test_the_hand_table_of_p_and_q() -> None:
    assert table("liang_barsky", *EXAMPLE[0], *COURSE) == [
        (1, -30, 10, -1 / 3, 0, 1),
        (2, 30, 20, 2 / 3, 0, 2 / 3),
        (3, 30, 30, 1, 0, 2 / 3),
        (4, -30, -10, 1 / 3, 1 / 3, 2 / 3),
    ]
    assert table("liang_barsky", 31.0, 5.0, 31.0, 9.0, *COURSE) == [
        (1, 0, 31, "", 0, 1),
        (2, 0, -1, "", 0, 1),
    ]


def test_each_verdict_has_its_sentence() -> None:
    said = {}
    entry = catalogue.get("liang_barsky")
    for line in [EXAMPLE[0], (31.0, 5.0, 31.0, 9.0), (-9.0, 10.0, 9.0, 40.0), (5.0, 5.0, 5.0, 30.0)]:
        for step in list(Steps(entry, record(entry.function, *line, *COURSE)))[1:]:
            said.setdefault(step.answer, "".join(part.text for part in step.sentence))
    assert set(said) == {"u1 grows", "u2 shrinks", "nothing changes", "reject"}
    assert said["u2 shrinks"].startswith("xₘₐₓ: p = 30 > 0, the line leaves, at r = 20/30 = 0.6667")
