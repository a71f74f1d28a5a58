"""Which rows each edge of a polygon counts on: the vertex rule of the scan-line fills with edge tables."""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.polygons.row_crossings import next_vertices


class Side(NamedTuple):
    """An edge of a polygon and its first and last row, between its vertices ``low`` and ``high``.

    ``winding`` is 1 where it goes up round its ring, -1 down, 0 where it is level.
    """

    y_start: int
    y_end: int
    winding: int
    low: int
    high: int


def sides(vertices: NDArray[Any], ring_ends: NDArray[Any], closed: bool) -> list[Side]:
    """The edges that count on a row, those of the lowest rows first; level ones only under closed."""
    after = next_vertices(vertices, ring_ends)
    before = vertices_before(after)
    on_rows: list[Side] = []
    for k in range(len(after)):
        side = side_of_ring(vertices, after, before, closed, k)
        if side.y_start <= side.y_end and (closed or side.winding != 0):
            on_rows.append(side)
    return by_first_row(on_rows)


def by_first_row(sides: list[Side]) -> list[Side]:
    """The edges in order of their first rows, counted into one bucket for each row."""
    if len(sides) == 0:
        return sides
    lowest = highest = sides[0].y_start
    for side in sides:
        lowest = min(lowest, side.y_start)
        highest = max(highest, side.y_start)
    places = [0] * (highest - lowest + 2)
    for side in sides:
        places[side.y_start - lowest + 1] += 1
    for row in range(highest - lowest):
        places[row + 1] += places[row]
    ordered = sides[:]
    for side in sides:
        ordered[places[side.y_start - lowest]] = side
        places[side.y_start - lowest] += 1
    return ordered


def side_of_ring(vertices: NDArray[Any], after: list[int], before: list[int], closed: bool, k: int) -> Side:
    """The edge from vertex k to the next one.

    An edge that goes on upwards from its upper end is one row shorter, so that a vertex where the polygon
    goes on counts once, and one where it turns back twice. Half_open leaves out every upper end.
    """
    low, high, winding, turn = k, after[k], 1, after
    if vertices[high, 1] < vertices[low, 1]:
        low, high, winding, turn = after[k], k, -1, before
    y_low, y_high = float(vertices[low, 1]), float(vertices[high, 1])
    if y_low == y_high:
        return Side(math.ceil(y_low), math.floor(y_high), 0, low, high)
    if closed and not goes_on_upwards(vertices, turn, high):
        return Side(math.ceil(y_low), math.floor(y_high), winding, low, high)
    return Side(math.ceil(y_low), math.ceil(y_high) - 1, winding, low, high)


def goes_on_upwards(vertices: NDArray[Any], turn: list[int], vertex: int) -> bool:
    """Whether the ring, followed from a vertex by ``turn``, leaves the vertex's row upwards."""
    further = turn[vertex]
    while vertices[further, 1] == vertices[vertex, 1]:
        further = turn[further]
    return bool(vertices[further, 1] > vertices[vertex, 1])


def vertices_before(after: list[int]) -> list[int]:
    """For each vertex the number of the one before it round its ring."""
    before = after[:]
    for k in range(len(after)):
        before[after[k]] = k
    return before
