"""The line from both ends against the true line in exact arithmetic, half by half."""

from fractions import Fraction
from itertools import pairwise

from hypothesis import example, given
from hypothesis import strategies as st

from tests.algorithms.pictures import drawn
from tests.lines.exact import Ends, Point, half_away, is_tie, true_points
from workbench.algorithms.lines.bresenham import bresenham_line
from workbench.algorithms.lines.bresenham_two_ends import bresenham_line_two_ends

near = st.tuples(*[st.integers(-30, 30)] * 4)
ends = st.one_of(near, st.tuples(*[st.integers(-2000, 2000)] * 4))


def in_order(ends: Ends) -> list[tuple[int, int]]:
    """The pixels from the first end to the second."""
    pixels = list(bresenham_line_two_ends(*ends))
    return pixels[0::2] + pixels[1::2][::-1]


def test_beyond_the_middle_a_tie_falls_the_other_way() -> None:
    assert drawn(bresenham_line_two_ends(0, 0, 8, 4), 9, 5) == [
        "........#",
        "......##.",
        "...###...",
        ".##......",
        "#........",
    ]
    assert drawn(bresenham_line(0, 0, 8, 4), 9, 5) == [
        ".......##",
        ".....##..",
        "...##....",
        ".##......",
        "#........",
    ]


@given(ends=ends)
@example(ends=(3, 3, 3, 3))
@example(ends=(-32768, 32767, 32767, -32766))
def test_each_pixel_comes_once_and_the_ends_come_first(ends: Ends) -> None:
    x0, y0, x1, y1 = ends
    pixels = list(bresenham_line_two_ends(*ends))
    assert len(set(pixels)) == len(pixels) == max(abs(x1 - x0), abs(y1 - y0)) + 1
    assert set(pixels[:2]) == {ends[:2], ends[2:]}
    assert pixels[0] == ends[:2]
    for (x, y), (next_x, next_y) in pairwise(in_order(ends)):
        assert max(abs(next_x - x), abs(next_y - y)) == 1


@given(ends=ends)
@example(ends=(0, 0, 2, 1))
@example(ends=(0, 0, -1, -2))
@example(ends=(0, 0, 8, 4))
def test_each_half_is_the_nearest_and_on_a_tie_farther_from_its_end(ends: Ends) -> None:
    points = true_points(ends)
    nearer = (len(points) + 1) // 2

    def expected(k: int, point: Point) -> tuple[int, int]:
        return half_away(point, ends if k < nearer else (*ends[2:], *ends[:2]))

    assert in_order(ends) == [expected(k, point) for k, point in enumerate(points)]


@given(ends=ends)
def test_the_two_pixels_of_a_step_mirror_each_other(ends: Ends) -> None:
    x0, y0, x1, y1 = ends
    pixels = list(bresenham_line_two_ends(*ends))
    for (x, y), (x_back, y_back) in zip(pixels[0::2], pixels[1::2], strict=False):
        assert (x + x_back, y + y_back) == (x0 + x1, y0 + y1)


@given(ends=ends)
@example(ends=(0, 0, 8, 4))
@example(ends=(0, 0, 2, 1))
def test_drawn_backwards_only_a_tie_in_the_middle_differs(ends: Ends) -> None:
    x0, y0, x1, y1 = ends
    there, back = set(in_order(ends)), set(in_order((x1, y1, x0, y0)))
    middle = Fraction(x0 + x1, 2), Fraction(y0 + y1, 2)
    steps = max(abs(x1 - x0), abs(y1 - y0))
    assert (there != back) == (steps % 2 == 0 and is_tie(middle))
    assert len(there - back) <= 1


@given(ends=near)
def test_it_mirrors_exactly(ends: Ends) -> None:
    x0, y0, x1, y1 = ends
    pixels = list(bresenham_line_two_ends(*ends))
    assert list(bresenham_line_two_ends(-x0, y0, -x1, y1)) == [(-x, y) for x, y in pixels]
    assert list(bresenham_line_two_ends(x0, -y0, x1, -y1)) == [(x, -y) for x, y in pixels]
    assert list(bresenham_line_two_ends(y0, x0, y1, x1)) == [(y, x) for x, y in pixels]
