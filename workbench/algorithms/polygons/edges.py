"""The edge table of the scan-line fill."""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.geometry.orientation import side_of

# Adding 1/m row by row is wrong by less than SLACK between whole vertices up to WHOLE, which cross a row on a
# pixel's centre or at least 2 SLACK beside it; and by less than NEAR between any others up to 2^20.
SLACK = 2.0**-17
WHOLE = 2.0**14
NEAR = 2.0**-10
NUDGE = 2.0**-30
STEEPEST = 1.0e300  # an infinite 1/m is that of an edge along a row


class Edge(NamedTuple):
    """A row of the edge table: the rows it is on, where it crosses the first one, 1/m, and its two vertices.

    From row ``y_top`` on it is no longer crossed; ``y_end`` is its last row, under closed perhaps ``y_top``.
    ``winding`` is 1 for an edge that goes up round its ring, -1 down, 0 where it is on a row but not crossed.
    """

    y_start: int
    y_top: int
    y_end: int
    x: float
    slope: float
    winding: int
    low: int
    high: int


def crossing_at(vertices: NDArray[Any], low: int, high: int, x: float, y: int) -> float:
    """Where an edge crosses row y: at x, put right where a rounding error could decide a pixel.

    Near a pixel's centre its side is computed exactly: x becomes that centre, or is on its true side of it.
    """
    centre = float(math.floor(x + 0.5))
    if abs(x - centre) >= NEAR:
        return x
    x_low, y_low = float(vertices[low, 0]), float(vertices[low, 1])
    x_high, y_high = float(vertices[high, 0]), float(vertices[high, 1])
    side = side_of(x_low, y_low, x_high, y_high, centre, float(y))
    if side == 0.0:
        return centre
    return min(x, centre - NUDGE) if side > 0.0 else max(x, centre + NUDGE)


def edge_of(vertices: NDArray[Any], closed: bool, start: int, end: int) -> Edge:
    """The edge from vertex ``start`` to vertex ``end``; one that is on no row ends before it begins.

    It is crossed where y_low <= y < y_high. Under closed it is also on the row y = y_high, uncounted.
    """
    low, high, winding = start, end, 1
    if vertices[end, 1] < vertices[start, 1]:
        low, high, winding = end, start, -1
    x_low, y_low = float(vertices[low, 0]), float(vertices[low, 1])
    x_high, y_high = float(vertices[high, 0]), float(vertices[high, 1])
    y_start, y_top = math.ceil(y_low), math.ceil(y_high)
    y_end = math.floor(y_high) if closed else y_top - 1
    if y_start == y_top:
        winding, y_top = 0, y_start + 1
    if y_low == y_high:
        x = min(x_low, x_high)
        x = max(x, math.ceil(x) - 1 + NUDGE)
        return Edge(y_start, y_top, y_end, x, math.inf, winding, low, high)
    dx, dy = x_high - x_low, y_high - y_low
    x = crossing_at(vertices, low, high, x_low + (y_start - y_low) / dy * dx, y_start)
    slope = min(max(dx / dy, -STEEPEST), STEEPEST)
    return Edge(y_start, y_top, y_end, x, slope, winding, low, high)


def edge_table(vertices: NDArray[Any], ring_ends: NDArray[Any], closed: bool) -> list[Edge]:
    """All edges that are on a row, those of the lowest first: the book's buckets, one after another."""
    edges = [Edge(0, 0, 0, 0.0, 0.0, 0, 0, 0)]
    edges.pop()
    start = 0
    for ring_end in ring_ends:
        end = min(int(ring_end), len(vertices))
        for k in range(start, end):
            edge = edge_of(vertices, closed, k, k + 1 if k + 1 < end else start)
            if edge.y_start <= edge.y_end:
                edges.append(edge)
        start = max(start, end)
    return sorted_edges(edges)


def sorted_edges(edges: list[Edge]) -> list[Edge]:
    """The edges by their first row, on one row from left to right: merged in runs of 1, 2, 4 ... edges."""
    run = 1
    while run < len(edges):
        merged = edges[:]
        for start in range(0, len(edges), 2 * run):
            middle = min(start + run, len(edges))
            end = min(middle + run, len(edges))
            first, second = start, middle
            for k in range(start, end):
                if second >= end or (first < middle and not comes_before(edges[second], edges[first])):
                    merged[k] = edges[first]
                    first += 1
                else:
                    merged[k] = edges[second]
                    second += 1
        edges = merged
        run *= 2
    return edges


def comes_before(edge: Edge, other: Edge) -> bool:
    """Whether an edge begins on a lower row than another, or on the same one further left."""
    return edge.y_start < other.y_start or (edge.y_start == other.y_start and edge.x < other.x)


def all_whole(vertices: NDArray[Any]) -> bool:
    """Whether all vertices are whole and so near that adding 1/m cannot decide a pixel wrongly."""
    for k in range(len(vertices)):
        x, y = float(vertices[k, 0]), float(vertices[k, 1])
        if x != math.floor(x) or y != math.floor(y) or max(abs(x), abs(y)) > WHOLE:
            return False
    return True
