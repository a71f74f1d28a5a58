"""The edge table, and what the scan-line fill does with one edge of it.

y_start, y_end      first and last row that the edge is crossed on
x                   where it crosses the row
slope               1/m, the change of x from row to row
left                first pixel that is not left of the crossing: a span beginning here begins with it
right               last pixel of a span ending here
winding             1 for an edge that goes up round its ring, -1 down, 0 where it is not counted
low, high           numbers of its two vertices
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.orientation import side_of

# Adding 1/m row by row is wrong by less than this, while coordinates stay below 2^20.
NEAR = 2.0**-10


class Edge(NamedTuple):
    """An edge as it crosses one row: in the edge table the first one, in the active list the current one."""

    y_start: int
    y_end: int
    x: float
    slope: float
    left: int
    right: int
    winding: int
    low: int
    high: int


def crossing(vertices: NDArray[Any], closed: bool, edge: Edge, y: int, x: float) -> Edge:
    """The edge on row y, where it crosses at x, but for the rounding errors that 1/m adds up.

    They must not decide a pixel: where x is that near to one, its side of the edge is reckoned exactly.
    """
    left = math.ceil(x - NEAR)
    right = left - 1
    if left - x < NEAR:
        x_low, y_low = float(vertices[edge.low, 0]), float(vertices[edge.low, 1])
        x_high, y_high = float(vertices[edge.high, 0]), float(vertices[edge.high, 1])
        side = side_of(x_low, y_low, x_high, y_high, float(left), float(y))
        if side < 0.0:
            left += 1
        if side < 0.0 or (side == 0.0 and closed):
            right += 1
    winding = edge.winding
    if closed and y == edge.y_end and y == vertices[edge.high, 1]:
        winding = 0  # the vertex rule: an upper end is counted with the edge that goes on, if one does
    return Edge(edge.y_start, edge.y_end, x, edge.slope, left, right, winding, edge.low, edge.high)


def table_edge(vertices: NDArray[Any], closed: bool, start: int, end: int) -> Edge:
    """The edge from vertex ``start`` to vertex ``end``, on its first row; an empty one ends before it begins.

    half_open has the rows y_low <= y < y_high, closed also y = y_high, and edges along a row.
    """
    low, high, winding = start, end, 1
    if vertices[end, 1] < vertices[start, 1]:
        low, high, winding = end, start, -1
    x_low, y_low = float(vertices[low, 0]), float(vertices[low, 1])
    x_high, y_high = float(vertices[high, 0]), float(vertices[high, 1])
    y_start = math.ceil(y_low)
    y_end = math.floor(y_high) if closed else math.ceil(y_high) - 1
    if y_low == y_high:
        left, right = math.ceil(min(x_low, x_high)), math.floor(max(x_low, x_high))
        return Edge(y_start, y_end, x_low, 0.0, left, right, 0, low, high)
    dx, dy = x_high - x_low, y_high - y_low
    edge = Edge(y_start, y_end, x_low, dx / dy, 0, 0, winding, low, high)
    return crossing(vertices, closed, edge, y_start, x_low + (y_start - y_low) / dy * dx)


def edge_table(vertices: NDArray[Any], ring_ends: NDArray[Any], closed: bool) -> list[Edge]:
    """All edges that cross a row, sorted by their first one: each row's are a bucket of the book's table."""
    edges = [Edge(0, 0, 0.0, 0.0, 0, 0, 0, 0, 0)]
    edges.pop()
    start = 0
    for ring_end in ring_ends:
        end = min(int(ring_end), len(vertices))
        for k in range(start, end):
            edge = table_edge(vertices, closed, k, k + 1 if k + 1 < end else start)
            if edge.y_start <= edge.y_end:
                edges.append(edge)
        start = end
    if len(edges) == 0:
        return edges

    # Count the edges of each bucket, and place them
    first_row = min([edge.y_start for edge in edges])
    last_row = max([edge.y_start for edge in edges])
    place = np.zeros(last_row - first_row + 2, np.int64)
    for edge in edges:
        place[edge.y_start - first_row + 1] += 1
    for row in range(1, len(place)):
        place[row] += place[row - 1]
    table = edges[:]
    for edge in edges:
        table[place[edge.y_start - first_row]] = edge
        place[edge.y_start - first_row] += 1
    return table
