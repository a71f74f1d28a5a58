"""Circles and ellipses against the sign of their function at the midpoints, in whole numbers."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from math import isqrt

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from skimage.draw import circle_perimeter

from tests.algorithms.pictures import drawn
from workbench.algorithms.circles import midpoint_circle, midpoint_ellipse

radii = st.one_of(st.integers(0, 40), st.integers(41, 1500))
small = st.one_of(st.integers(0, 30), st.integers(31, 200))
centre = st.integers(-100, 100)
HALF = Fraction(1, 2)


def nearest_in_each_column(r: int) -> set[tuple[int, int]]:
    """The circle about the origin: in the octant x <= y the nearest row of each column, eight times mirrored.

    A row y is nearest when r^2 - x^2 is at least (y - 1/2)^2, that is 2y - 1 <= sqrt(4 (r^2 - x^2)).
    """
    octant = [(x, (1 + isqrt(4 * (r * r - x * x))) // 2) for x in range(r + 1)]
    turned = {point for x, y in octant if x <= y for point in ((x, y), (y, x))}
    return {(sx * x, sy * y) for x, y in turned for sx in (1, -1) for sy in (1, -1)}


def quarter(rx: int, ry: int) -> Iterator[tuple[int, int]]:
    """The ellipse's quarter, each choice by the sign of its function at the midpoint, reckoned anew."""

    def function(x: Fraction | int, y: Fraction | int) -> Fraction:
        return Fraction(ry * ry * x * x + rx * rx * y * y - rx * rx * ry * ry)

    x, y = 0, ry
    yield x, y
    while ry * ry * x < rx * rx * y:
        if function(x + 1, y - HALF) >= 0:
            y -= 1
        x += 1
        yield x, y
    while y > 0:
        if function(x + HALF, y - 1) <= 0:
            x += 1
        y -= 1
        yield x, y
    while x < rx:
        x += 1
        yield x, y


def test_the_first_octant_of_the_course() -> None:
    octant = [(0, 10), (1, 10), (2, 10), (3, 10), (4, 9), (5, 9), (6, 8), (7, 7)]
    assert [p for p in sorted(midpoint_circle(0, 0, 10)) if 0 <= p[0] <= p[1]] == octant


def test_a_circle_and_an_ellipse_as_pictures() -> None:
    assert drawn(midpoint_circle(4, 4, 4), 9, 9) == [
        "...###...",
        ".##...##.",
        ".#.....#.",
        "#.......#",
        "#.......#",
        "#.......#",
        ".#.....#.",
        ".##...##.",
        "...###...",
    ]
    assert drawn(midpoint_ellipse(6, 3, 6, 3), 13, 7) == [
        "...#######...",
        ".##.......##.",
        "#...........#",
        "#...........#",
        "#...........#",
        ".##.......##.",
        "...#######...",
    ]


def test_the_ellipse_of_the_book() -> None:
    points = [(0, 6), (1, 6), (2, 6), (3, 6), (4, 5), (5, 5), (6, 4), (7, 3), (8, 2), (8, 1), (8, 0)]
    assert [(x, y) for x, y in midpoint_ellipse(0, 0, 8, 6) if x >= 0 and y >= 0] == points


@given(xc=centre, yc=centre, r=radii)
@example(xc=0, yc=0, r=0)
@example(xc=0, yc=0, r=1)
def test_the_circle_is_the_nearest_in_each_column_each_pixel_once(xc: int, yc: int, r: int) -> None:
    pixels = list(midpoint_circle(xc, yc, r))
    assert len(set(pixels)) == len(pixels)
    assert {(x - xc, y - yc) for x, y in pixels} == nearest_in_each_column(r)


@given(xc=centre, yc=centre, r=radii)
def test_the_eight_mirror_images_of_each_pixel_are_there(xc: int, yc: int, r: int) -> None:
    pixels = {(x - xc, y - yc) for x, y in midpoint_circle(xc, yc, r)}
    for mirrored in (
        {(-x, y) for x, y in pixels},
        {(x, -y) for x, y in pixels},
        {(y, x) for x, y in pixels},
    ):
        assert mirrored == pixels


@given(r=radii)
def test_neighbours_on_the_circle_touch(r: int) -> None:
    walk = sorted({p for p in midpoint_circle(0, 0, r) if min(p) >= 0}, key=lambda p: (p[0], -p[1]))
    assert (walk[0], walk[-1]) == ((0, r), (r, 0))
    for (x, y), (next_x, next_y) in pairwise(walk):
        assert max(abs(next_x - x), abs(next_y - y)) == 1


@pytest.mark.parametrize("r", range(1, 60))
def test_the_circle_is_that_of_skimage(r: int) -> None:
    rows, columns = circle_perimeter(0, 0, r)
    assert set(midpoint_circle(0, 0, r)) == set(zip(columns.tolist(), rows.tolist(), strict=True))


@given(xc=centre, yc=centre, rx=small, ry=small)
@example(xc=0, yc=0, rx=0, ry=0)
@example(xc=3, yc=-2, rx=0, ry=7)
@example(xc=3, yc=-2, rx=7, ry=0)
@example(xc=0, yc=0, rx=30, ry=1)
@example(xc=0, yc=0, rx=1, ry=30)
@example(xc=0, yc=0, rx=200, ry=2)
def test_the_ellipse_chooses_by_the_exact_sign_each_pixel_once(xc: int, yc: int, rx: int, ry: int) -> None:
    pixels = list(midpoint_ellipse(xc, yc, rx, ry))
    assert len(set(pixels)) == len(pixels)
    expected = {(xc + sx * x, yc + sy * y) for x, y in quarter(rx, ry) for sx in (1, -1) for sy in (1, -1)}
    assert set(pixels) == expected
    ends = {(xc + rx, yc), (xc - rx, yc), (xc, yc + ry), (xc, yc - ry)}
    assert ends <= set(pixels)
    assert all(abs(x - xc) <= rx and abs(y - yc) <= ry for x, y in pixels)


@given(rx=small, ry=small)
def test_neighbours_on_the_ellipse_touch(rx: int, ry: int) -> None:
    walk = sorted(
        {(x, y) for x, y in midpoint_ellipse(0, 0, rx, ry) if x >= 0 and y >= 0}, key=lambda p: (p[0], -p[1])
    )
    for (x, y), (next_x, next_y) in pairwise(walk):
        assert max(abs(next_x - x), abs(next_y - y)) == 1


@given(rx=st.integers(1, 150), ry=st.integers(1, 150))
def test_the_true_ellipse_passes_within_a_pixel(rx: int, ry: int) -> None:
    def sign(x: int, y: int) -> int:
        value = ry * ry * x * x + rx * rx * y * y - rx * rx * ry * ry
        return (value > 0) - (value < 0)

    for x, y in midpoint_ellipse(0, 0, rx, ry):
        around = {sign(x + dx, y + dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1)}
        assert 0 in around or {-1, 1} <= around


@given(r=radii)
def test_with_equal_radii_the_ellipse_is_the_circle(r: int) -> None:
    assert set(midpoint_ellipse(0, 0, r, r)) == set(midpoint_circle(0, 0, r))


def test_of_radii_up_to_90_every_17th_pair_is_not_the_other_turned() -> None:
    quarters = {(rx, ry): set(whole_quarter(rx, ry)) for rx in range(91) for ry in range(91)}
    differing = [
        (rx, ry) for (rx, ry), points in quarters.items() if {(y, x) for x, y in points} != quarters[ry, rx]
    ]
    assert (2, 3) in differing
    assert (len(differing), len(quarters)) == (494, 8281)
    for rx, ry in ((2, 3), (3, 2)):
        assert {(x, y) for x, y in midpoint_ellipse(0, 0, rx, ry) if x >= 0 and y >= 0} == quarters[rx, ry]


@pytest.mark.parametrize(("rx", "ry"), [(16383, 16383), (16383, 16001), (11003, 16383), (16383, 3)])
def test_no_sign_of_a_large_ellipse_is_rounded(rx: int, ry: int) -> None:
    ours = [(x, y) for x, y in midpoint_ellipse(0, 0, rx, ry) if x >= 0 and y >= 0]
    assert ours == list(whole_quarter(rx, ry))


@pytest.mark.parametrize(("rx", "ry"), [(8, 6), (16383, 16001), (11003, 16383)])
def test_p_is_the_ellipses_function_at_the_next_midpoint_exactly(rx: int, ry: int) -> None:
    """Read from the generator where it waits, every 97th pixel; a float of 53 bits holds it."""
    walk = midpoint_ellipse(0, 0, rx, ry)
    for number, _pixel in enumerate(walk):
        now = walk.gi_frame.f_locals  # type: ignore[attr-defined]
        if number % 97 or now["x"] == rx:
            continue
        x, y = (now["x"] + HALF, now["y"] - 1) if "k" in now else (now["x"] + 1, now["y"] - HALF)
        assert Fraction(now["p"]) == ry * ry * x * x + rx * rx * y * y - rx * rx * ry * ry


def whole_quarter(rx: int, ry: int) -> Iterator[tuple[int, int]]:
    """As ``quarter``, in whole numbers of any size."""

    def function(x: int, y: int) -> int:
        """Four times the ellipse's function at (x/2, y/2)."""
        return ry * ry * x * x + rx * rx * y * y - 4 * rx * rx * ry * ry

    x, y = 0, ry
    yield x, y
    while ry * ry * x < rx * rx * y:
        y -= function(2 * x + 2, 2 * y - 1) >= 0
        x += 1
        yield x, y
    while y > 0:
        x += function(2 * x + 1, 2 * y - 2) <= 0
        y -= 1
        yield x, y
    yield from ((further, 0) for further in range(x + 1, rx + 1))


def test_a_flat_ellipse_is_closed_by_its_tip() -> None:
    assert drawn(midpoint_ellipse(10, 1, 10, 1), 21, 3) == [
        "..#################..",
        "##.................##",
        "..#################..",
    ]


def test_the_circle_is_not_the_nearest_by_squared_distance() -> None:
    ours = set(midpoint_circle(0, 0, 4))
    assert (3, 3) in ours
    assert abs(3 * 3 + 3 * 3 - 16) == 2
