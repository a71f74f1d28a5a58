"""Squares of pixels, and how a surface lies to one."""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.visibility.device_plane import Corner
from workbench.algorithms.visibility.painting import Spans
from workbench.algorithms.visibility.surfaces import (
    NEAR_ZERO,
    NOTHING,
    Surface,
    covers,
    depth_at,
    end_row,
    first_row,
    span_on,
)

Array = NDArray[Any]

OUTSIDE, INSIDE, OVERLAPPING, SURROUNDING = 0, 1, 2, 3


class Square(NamedTuple):
    """A square of pixels, and the surfaces that are not outside the one it is a quarter of."""

    x: int
    y: int
    size: int
    members: list[int]


class Seen(NamedTuple):
    """A surface, and how it lies to the square."""

    number: int
    relation: int


def least_size(width: int, height: int) -> int:
    """The least power of two that is not less than either."""
    size = 1
    while size < width or size < height:
        size *= 2
    return size


def relation(surface: Surface, square: Square) -> int:
    """How a surface lies to the centres of a square's pixels: one of the four."""
    left, right = square.x, square.x + square.size - 1
    bottom, top = square.y, square.y + square.size - 1
    low, middle, high = surface.low, surface.middle, surface.high
    x_low, x_high = min(low.x, middle.x, high.x), max(low.x, middle.x, high.x)
    if x_high < left or right < x_low or high.y < bottom or top < low.y:
        return OUTSIDE
    below = covers(surface, left, bottom) and covers(surface, right, bottom)
    if below and covers(surface, left, top) and covers(surface, right, top):
        return SURROUNDING
    for start, end, third in ((low, middle, high), (middle, high, low), (high, low, middle)):
        if beyond_edge(start, end, third, left, right, bottom, top):
            return OUTSIDE
    if left <= x_low and x_high <= right and bottom <= low.y and high.y <= top:
        return INSIDE
    return OVERLAPPING


def beyond_edge(
    start: Corner, end: Corner, third: Corner, left: int, right: int, bottom: int, top: int
) -> bool:
    """Whether a square lies wholly on the other side of an edge than the triangle's third corner."""
    A, B = end.y - start.y, start.x - end.x
    D = -(A * start.x + B * start.y)
    sign = 1.0 if A * third.x + B * third.y + D > 0.0 else -1.0
    # The corner of the square that reaches farthest towards the triangle
    x = right if A * sign > 0.0 else left
    y = top if B * sign > 0.0 else bottom
    value = sign * (A * x + B * y + D)
    return value < -NEAR_ZERO * (abs(A * x) + abs(B * y) + abs(D))


def surely_nearer(surface: Surface, other: Surface, square: Square) -> bool:
    """Whether a surface's plane is nearer than another's at all corners of a square, beyond any rounding."""
    far = square.size - 1
    for x, y in (
        (square.x, square.y),
        (square.x + far, square.y),
        (square.x, square.y + far),
        (square.x + far, square.y + far),
    ):
        if depth_at(surface, x, y) >= depth_at(other, x, y) - NEAR_ZERO:
            return False
    return True


def hiding(surfaces: list[Surface], seen: list[Seen], square: Square) -> int:
    """The surrounding surface that hides all others in a square, or NOTHING."""
    for one in seen:
        if one.relation == SURROUNDING:
            hides = True
            for other in seen:
                if other.number != one.number and hides:
                    hides = surely_nearer(surfaces[one.number], surfaces[other.number], square)
            if hides:
                return one.number
    return NOTHING


def nearest_at(surfaces: list[Surface], seen: list[Seen], x: int, y: int) -> int:
    """The nearest of some surfaces at the centre of a pixel, or NOTHING."""
    nearest, number = math.inf, NOTHING
    for one in seen:
        if covers(surfaces[one.number], x, y):
            z = depth_at(surfaces[one.number], x, y)
            if z < nearest:
                nearest, number = z, one.number
    return number


def paint_in(square: Square, image: Array, surfaces: list[Surface], number: int, colours: Array) -> Spans:
    """Paint what of a surface is in a square. Emits: (y, x_left, x_right, surface), both ends included."""
    height, width = image.shape
    surface = surfaces[number]
    for y in range(max(first_row(surface), square.y), min(end_row(surface, height), square.y + square.size)):
        left, end = span_on(surface, y, width)
        left, end = max(left, square.x), min(end, square.x + square.size)
        if left < end:
            image[y, left:end] = int(colours[number])
            yield y, left, end - 1, number
