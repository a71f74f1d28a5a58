"""Finds what Sutherland-Hodgman leaves of a concave polygon between its parts: edges that run back over one
another along the window's boundary, with no area between them.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise

Point = tuple[float, float]


def degenerate_edges(
    polygon: Sequence[Sequence[float]], window: Sequence[float]
) -> list[tuple[Point, Point]]:
    """The stretches of the window's boundary that ``polygon`` runs along in both directions.

    ``polygon`` is what ``sutherland_hodgman`` emitted, ``window`` (xmin, ymin, xmax, ymax). Each stretch is
    a pair of points, left or bottom one first; on the left edge first, then right, bottom, top.
    """
    xmin, ymin, xmax, ymax = window
    found: list[tuple[Point, Point]] = []
    for axis, level in ((0, xmin), (0, xmax), (1, ymin), (1, ymax)):
        for low, high in _both_ways(list(_sides_along(polygon, axis, float(level)))):
            stretch = ((level, low), (level, high)) if axis == 0 else ((low, level), (high, level))
            found.append(stretch)
    return found


def _sides_along(polygon: Sequence[Sequence[float]], axis: int, level: float) -> Iterator[Point]:
    """From where to where each side runs that lies on the line ``axis`` = ``level``."""
    for i in range(len(polygon)):
        start, end = polygon[i - 1], polygon[i]
        if start[axis] == end[axis] == level and start[1 - axis] != end[1 - axis]:
            yield float(start[1 - axis]), float(end[1 - axis])


def _both_ways(sides: list[Point]) -> Iterator[Point]:
    """The stretches, as long as they can be, on which sides run upwards and sides run downwards."""
    places = sorted({place for side in sides for place in side})
    begin: float | None = None
    for low, high in pairwise(places):
        up = any(start <= low and high <= end for start, end in sides)
        down = any(end <= low and high <= start for start, end in sides)
        if up and down and begin is None:
            begin = low
        elif not (up and down) and begin is not None:
            yield begin, low
            begin = None
    if begin is not None:
        yield begin, places[-1]
