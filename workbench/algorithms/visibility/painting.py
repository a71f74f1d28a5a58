"""From back to front: surfaces in order of their depth, and how one is painted."""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.visibility.surfaces import (
    Surface,
    end_row,
    farthest_z,
    first_row,
    in_view,
    span_on,
)

Array = NDArray[Any]
Spans = Iterator[tuple[int, int, int, int]]
"""(y, x_left, x_right, surface), both ends included."""


def farthest_first(surfaces: list[Surface]) -> list[int]:
    """The numbers of the surfaces by their greatest depths, the farthest first; of equals the last one."""
    ranked = [(farthest_z(surfaces[number]), number) for number in in_view(surfaces)]
    run = 1
    while run < len(ranked):
        merged = ranked[:]
        for start in range(0, len(ranked), 2 * run):
            middle = min(start + run, len(ranked))
            end = min(middle + run, len(ranked))
            first, second = start, middle
            for k in range(start, end):
                if second >= end or (first < middle and ranked[first] > ranked[second]):
                    merged[k] = ranked[first]
                    first += 1
                else:
                    merged[k] = ranked[second]
                    second += 1
        ranked = merged
        run *= 2
    return [number for _z, number in ranked]


def paint_surface(image: Array, surfaces: list[Surface], number: int, colours: Array) -> Spans:
    """Paint every pixel that a surface covers. Emits: (y, x_left, x_right, surface), both ends included."""
    height, width = image.shape
    surface = surfaces[number]
    for y in range(first_row(surface), end_row(surface, height)):
        left, right = span_on(surface, y, width)
        if left < right:
            image[y, left:right] = int(colours[number])
            yield y, left, right - 1, number
