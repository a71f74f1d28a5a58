"""The edge table of the course's scan-line fill, in floats: each edge with its first crossing and 1/m."""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.polygons.row_crossings import corner
from workbench.algorithms.polygons.sides import Side, sides


class Edge(NamedTuple):
    """A row of the edge table: first and last row, where it crosses the first one, what x gains per row.

    ``winding`` as in Side. A level edge has ``width``, from x on; ``low`` and ``high`` are its vertices.
    """

    y_start: int
    y_end: int
    x: float
    slope: float
    winding: int
    width: float
    low: int
    high: int


def edge_table(vertices: NDArray[Any], ring_ends: NDArray[Any], closed: bool) -> list[Edge]:
    """All edges that count on a row, those of the lowest row first: the book's buckets one after another."""
    return [edge_of(vertices, side) for side in sides(vertices, ring_ends, closed)]


def edge_of(vertices: NDArray[Any], side: Side) -> Edge:
    """An edge as it enters the table: 1/m, and x on its first row."""
    x_low, y_low = corner(vertices, side.low)
    x_high, y_high = corner(vertices, side.high)
    if side.winding == 0:
        x, width = min(x_low, x_high), abs(x_high - x_low)
        return Edge(side.y_start, side.y_end, x, 0.0, 0, width, side.low, side.high)
    slope = (x_high - x_low) / (y_high - y_low)
    x = x_low + (side.y_start - y_low) * slope
    return Edge(side.y_start, side.y_end, x, slope, side.winding, 0.0, side.low, side.high)


def at(edge: Edge, x: float) -> Edge:
    """The edge where it crosses another row."""
    return Edge(edge.y_start, edge.y_end, x, edge.slope, edge.winding, edge.width, edge.low, edge.high)


def drop_ended(active: list[Edge], y: int) -> None:
    """Drop the edges whose last row is below row y; the others keep their order."""
    kept = 0
    for edge in active:
        if edge.y_end >= y:
            active[kept] = edge
            kept += 1
    while len(active) > kept:
        active.pop()


def last_pixel(edge: Edge, closed: bool) -> int:
    """The last pixel up to a crossing, which closed takes in; of a level edge the last one on it."""
    return math.floor(edge.x + edge.width) if closed else math.ceil(edge.x) - 1
