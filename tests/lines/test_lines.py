"""Lines against the true line in exact arithmetic, and against one another."""

from collections import defaultdict
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import pairwise

import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from skimage.draw import line as skimage_line

from tests.algorithms.pictures import drawn
from tests.lines.exact import Ends, half_away, half_up, is_tie, true_points
from workbench.algorithms import catalogue
from workbench.algorithms.lines import (
    bresenham_line,
    dda_line,
    dda_line_fixed,
    dda_line_single,
    midpoint_line,
    wu_line,
)
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

near = st.tuples(*[st.integers(-30, 30)] * 4)
far = st.tuples(*[st.integers(-2000, 2000)] * 4)
ends = st.one_of(near, far)
# The longest line that parameters allow, with no step of it exactly halfway
WIDEST = (-32768, 32767, 32767, -32766)

PIXEL_LINES = [dda_line, dda_line_single, dda_line_fixed, bresenham_line, midpoint_line]


def test_the_example_of_the_course() -> None:
    assert list(bresenham_line(20, 10, 30, 18)) == list(
        zip(range(20, 31), [10, 11, 12, 12, 13, 14, 15, 16, 16, 17, 18], strict=True)
    )


def test_backwards_at_45_degrees() -> None:
    for line in PIXEL_LINES:
        assert list(line(25, 20, 15, 10)) == [(25 - k, 20 - k) for k in range(11)]


def test_a_flat_and_a_steep_line_as_pictures() -> None:
    assert drawn(bresenham_line(0, 0, 8, 3), 9, 4) == [
        ".......##",
        "....###..",
        "..##.....",
        "##.......",
    ]
    assert drawn(bresenham_line(3, 7, 0, 0), 4, 8) == [
        "...#",
        "...#",
        "..#.",
        "..#.",
        ".#..",
        ".#..",
        "#...",
        "#...",
    ]


@pytest.mark.parametrize("line", PIXEL_LINES)
@given(ends=ends)
@example(ends=WIDEST)
def test_one_connected_pixel_for_each_step(
    line: Callable[..., Iterator[tuple[int, int]]], ends: Ends
) -> None:
    x0, y0, x1, y1 = ends
    pixels = list(line(*ends))
    assert len(pixels) == max(abs(x1 - x0), abs(y1 - y0)) + 1
    assert pixels[0] == (x0, y0)
    for (x, y), (next_x, next_y) in pairwise(pixels):
        assert max(abs(next_x - x), abs(next_y - y)) == 1


@pytest.mark.parametrize("line", [dda_line, bresenham_line, midpoint_line])
@given(ends=ends)
@example(ends=WIDEST)
def test_both_ends_are_included(line: Callable[..., Iterator[tuple[int, int]]], ends: Ends) -> None:
    pixels = list(line(*ends))
    assert (pixels[0], pixels[-1]) == (ends[:2], ends[2:])


@given(ends=ends)
@example(ends=(0, 0, 2, 1))
@example(ends=(0, 0, -1, -2))
@example(ends=(5, 5, 5, 5))
def test_bresenham_takes_the_nearest_and_on_a_tie_the_one_farther_from_the_start(ends: Ends) -> None:
    assert list(bresenham_line(*ends)) == [half_away(point, ends) for point in true_points(ends)]


@given(ends=ends)
def test_the_midpoint_line_is_bresenhams(ends: Ends) -> None:
    assert list(midpoint_line(*ends)) == list(bresenham_line(*ends))


@settings(max_examples=25)
@given(ends=near)
@example(ends=(2, 1, 13, 8))
def test_the_midpoint_line_decides_by_its_function_at_the_midpoint(ends: Ends) -> None:
    """F is positive where the line has passed the midpoint, that is where it lies beyond it."""
    x0, y0, x1, y1 = ends
    steep = abs(y1 - y0) > abs(x1 - x0)
    (ax, ay), (bx, by) = ((y0, x0), (y1, x1)) if steep else ((x0, y0), (x1, y1))
    step_x = 1 if ax < bx else -1
    steps = Steps(catalogue.get("midpoint_line"), record(midpoint_line, *ends))
    x, y = ax, ay
    for _k, value, pixel in [step.row for step in list(steps)[1:]]:
        beyond = abs(y - ay) + Fraction(1, 2)
        assert value == abs(by - ay) * abs(x + step_x - ax) - abs(bx - ax) * beyond
        x, y = pixel[::-1] if steep else pixel


@given(ends=near)
def test_bresenham_mirrors_exactly(ends: Ends) -> None:
    x0, y0, x1, y1 = ends
    pixels = list(bresenham_line(*ends))
    assert list(bresenham_line(-x0, y0, -x1, y1)) == [(-x, y) for x, y in pixels]
    assert list(bresenham_line(x0, -y0, x1, -y1)) == [(x, -y) for x, y in pixels]
    assert list(bresenham_line(y0, x0, y1, x1)) == [(y, x) for x, y in pixels]


@given(ends=near)
def test_drawn_backwards_only_ties_differ(ends: Ends) -> None:
    x0, y0, x1, y1 = ends
    backwards = list(bresenham_line(x1, y1, x0, y0))[::-1]
    for point, there, back in zip(true_points(ends), bresenham_line(*ends), backwards, strict=True):
        assert (there != back) == is_tie(point)


def test_a_line_that_differs_backwards_and_one_whose_mirror_image_differs() -> None:
    assert set(bresenham_line(0, 0, 2, 1)) != set(bresenham_line(2, 1, 0, 0))
    assert [(x, -y) for x, y in dda_line(0, 0, 2, 1)] != list(dda_line(0, 0, 2, -1))


@given(ends=ends)
def test_bresenham_agrees_with_skimage_but_for_ties(ends: Ends) -> None:
    x0, y0, x1, y1 = ends
    rows, columns = skimage_line(y0, x0, y1, x1)
    theirs = list(zip(columns.tolist(), rows.tolist(), strict=True))
    for point, mine, other in zip(true_points(ends), bresenham_line(*ends), theirs, strict=True):
        assert mine == other or is_tie(point)


@given(ends=ends)
@example(ends=WIDEST)
def test_dda_in_64_bits_is_nearest_but_for_ties(ends: Ends) -> None:
    for point, pixel in zip(true_points(ends), dda_line(*ends), strict=True):
        assert pixel == half_up(point) or is_tie(point)


@given(
    start=st.tuples(st.integers(-500, 500), st.integers(-500, 500)),
    doublings=st.integers(0, 9),
    share=st.floats(-1, 1),
    steep=st.booleans(),
)
def test_halves_go_up_where_the_sum_is_exact(
    start: tuple[int, int], doublings: int, share: float, steep: bool
) -> None:
    """With 2^n steps every partial sum of the DDA is a whole number of 2^n-ths, and ties are true ones."""
    longer = 1 << doublings
    shorter = round(share * longer)
    dx, dy = (shorter, longer) if steep else (longer, shorter)
    ends = (*start, start[0] + dx, start[1] + dy)
    expected = [half_up(point) for point in true_points(ends)]
    assert list(dda_line(*ends)) == expected
    assert list(dda_line_single(*ends)) == expected
    assert list(dda_line_fixed(*ends, 10)) == expected


def test_dda_drifts_off_a_tie_since_it_adds_up() -> None:
    assert 5 + 7 * (-3 / 14) == 3.5
    assert half_up(true_points((5, 5, 2, -9))[7]) == (4, -2)
    assert list(dda_line(5, 5, 2, -9))[7] == (3, -2)


@given(ends=ends)
@example(ends=(-2000, -2000, 2000, 1999))
def test_fixed_point_with_24_bits_is_nearest_but_for_ties(ends: Ends) -> None:
    for point, pixel in zip(true_points(ends), dda_line_fixed(*ends, 24), strict=True):
        assert pixel == half_up(point) or is_tie(point)


@given(ends=ends, bits=st.integers(1, 24))
def test_fixed_point_is_off_by_at_most_half_a_part_for_each_step(ends: Ends, bits: int) -> None:
    part = Fraction(1, 1 << bits)
    for k, (point, pixel) in enumerate(zip(true_points(ends), dda_line_fixed(*ends, bits), strict=True)):
        bound = Fraction(1, 2) + k * part / 2
        assert max(abs(pixel[0] - point[0]), abs(pixel[1] - point[1])) <= bound


def test_fixed_point_misses_the_end_of_a_long_line_and_bresenham_does_not() -> None:
    assert list(dda_line_fixed(0, 0, 1000, 333))[-1] == (1000, 332)
    assert list(dda_line_fixed(0, 0, 1000, 333, 16))[-1] == (1000, 333)
    assert list(bresenham_line(0, 0, 1000, 333))[-1] == (1000, 333)


def test_32_bits_take_other_pixels_than_the_true_line_on_a_long_one() -> None:
    ends = (0, 0, 30000, 12345)
    wrong = [
        point
        for point, pixel in zip(true_points(ends), dda_line_single(*ends), strict=True)
        if pixel != half_up(point) and not is_tie(point)
    ]
    assert len(wrong) > 100
    assert list(dda_line_single(*ends))[-1] != (30000, 12345)


@settings(max_examples=300)
@given(ends=st.tuples(*[st.integers(0, 255)] * 4))
@example(ends=(0, 0, 255, 254))
@example(ends=(255, 255, 0, 2))
def test_32_bits_take_the_pixels_of_64_near_the_origin_but_for_ties(ends: Ends) -> None:
    assume(not any(map(is_tie, true_points(ends))))
    pixels = list(dda_line_single(*ends))
    assert pixels == list(dda_line(*ends)) == [half_up(point) for point in true_points(ends)]


@given(ends=ends)
def test_wu_shares_the_light_of_each_column_and_its_middle_is_on_the_line(ends: Ends) -> None:
    x0, y0, x1, y1 = ends
    steep = abs(y1 - y0) > abs(x1 - x0)
    columns: dict[int, list[tuple[int, float]]] = defaultdict(list)
    for x, y, coverage in wu_line(*ends):
        assert 0 < coverage <= 1
        columns[y if steep else x].append((x if steep else y, coverage))
    points = true_points(ends)
    assert len(columns) == len(points)
    for x, y in points:
        column, true = (y, x) if steep else (x, y)
        shares = columns[int(column)]
        assert len({row for row, _ in shares}) == len(shares) <= 2
        low = true // 1
        expected = {int(low): float(low + 1 - true), int(low) + 1: float(true - low)}
        assert dict(shares) == {row: share for row, share in expected.items() if share > 0}


@given(ends=near)
def test_wu_is_the_same_backwards(ends: Ends) -> None:
    x0, y0, x1, y1 = ends
    assert sorted(wu_line(*ends)) == sorted(wu_line(x1, y1, x0, y0))
