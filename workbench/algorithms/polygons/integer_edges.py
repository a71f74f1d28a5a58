"""The edge table of the scan-line fill in whole numbers: each crossing as a whole part and a counter."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.polygons.sides import Side, sides


class WholeEdge(NamedTuple):
    """A row of the edge table: first and last row, and where it crosses the first: at x + counter/delta_y.

    A row further up it is ``step`` pixels and ``rest``/delta_y further. ``winding`` as in Side. A level edge
    has ``width``, from x on; ``low`` and ``high`` are its vertices.
    """

    y_start: int
    y_end: int
    x: int
    counter: int
    step: int
    rest: int
    delta_y: int
    winding: int
    width: int
    low: int
    high: int


def whole_corners(vertices: NDArray[Any]) -> NDArray[Any]:
    """The vertices (n, 2), each on the nearest pixel."""
    return np.floor(vertices + 0.5)


def whole_edge_table(corners: NDArray[Any], ring_ends: NDArray[Any], closed: bool) -> list[WholeEdge]:
    """All edges that count on a row, those of the lowest row first: the book's buckets one after another."""
    return [whole_edge_of(corners, side) for side in sides(corners, ring_ends, closed)]


def whole_edge_of(corners: NDArray[Any], side: Side) -> WholeEdge:
    """An edge as it enters the table, on its lower vertex."""
    x_low, y_low = int(corners[side.low, 0]), int(corners[side.low, 1])
    x_high, y_high = int(corners[side.high, 0]), int(corners[side.high, 1])
    y_start, y_end, winding, low, high = side
    if winding == 0:
        x, width = min(x_low, x_high), abs(x_high - x_low)
        return WholeEdge(y_start, y_end, x, 0, 0, 0, 1, 0, width, low, high)
    delta_x, delta_y = x_high - x_low, y_high - y_low
    step, rest = delta_x // delta_y, delta_x % delta_y
    return WholeEdge(y_start, y_end, x_low, 0, step, rest, delta_y, winding, 0, low, high)


def crossing(edge: WholeEdge, x: int, counter: int) -> WholeEdge:
    """The edge where it crosses another row."""
    y_start, y_end, _x, _counter, step, rest, delta_y, winding, width, low, high = edge
    return WholeEdge(y_start, y_end, x, counter, step, rest, delta_y, winding, width, low, high)


def drop_ended(active: list[WholeEdge], y: int) -> None:
    """Drop the edges whose last row is below row y; the others keep their order."""
    kept = 0
    for edge in active:
        if edge.y_end >= y:
            active[kept] = edge
            kept += 1
    while len(active) > kept:
        active.pop()


def sort_by_crossing(active: list[WholeEdge]) -> None:
    """Put the edges in order from left to right: each moves left past those that are further right."""
    for k in range(1, len(active)):
        edge = active[k]
        place = k
        while place > 0 and is_left_of(edge, active[place - 1]):
            active[place] = active[place - 1]
            place -= 1
        active[place] = edge


def is_left_of(edge: WholeEdge, other: WholeEdge) -> bool:
    """Whether an edge crosses the row left of another one: by the whole parts, then by the counters."""
    if edge.x != other.x:
        return edge.x < other.x
    return edge.counter * other.delta_y < other.counter * edge.delta_y


def first_pixel(edge: WholeEdge) -> int:
    """The first pixel on a crossing or right of it."""
    return edge.x if edge.counter == 0 else edge.x + 1


def last_pixel(edge: WholeEdge, closed: bool) -> int:
    """The last pixel up to a crossing, which closed takes in; of a level edge the last one on it."""
    return edge.x + edge.width if closed else first_pixel(edge) - 1
