"""The active edge table of the scan-line fill: the edges on a row, from left to right."""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.polygons.edges import Edge, crossing_at


class Crossing(NamedTuple):
    """A row of the active edge table: where edge number ``edge`` crosses the current row; then as in Edge."""

    x: float
    slope: float
    winding: int
    y_top: int
    edge: int


def end_of_level(vertices: NDArray[Any], edge: Edge) -> int:
    """The last pixel of an edge along a row."""
    return math.floor(max(float(vertices[edge.low, 0]), float(vertices[edge.high, 0])))


def put_in_order(active: list[Crossing], place: int, crossing: Crossing) -> None:
    """Put a crossing among the first ``place`` ones of the active edge table; those right of it move up."""
    while place > 0 and active[place - 1].x > crossing.x:
        active[place] = active[place - 1]
        place -= 1
    active[place] = crossing


def change_over(active: list[Crossing], edges: list[Edge], waiting: int, y: int) -> int:
    """Drop the edges that have ended below row y and let in those that begin on it; returns who waits then.

    An edge that under closed is still on the row of its upper end stays for it, uncounted: by the vertex rule
    that vertex counts with the edge that goes on upwards, or, where none does, as an empty pair.
    """
    kept = 0
    for k in range(len(active)):
        crossing = active[k]
        if crossing.y_top > y:
            active[kept] = crossing
            kept += 1
        elif edges[crossing.edge].y_end == y:
            active[kept] = Crossing(crossing.x, crossing.slope, 0, y + 1, crossing.edge)
            kept += 1
    while len(active) > kept:
        active.pop()
    first_new = waiting
    while waiting < len(edges) and edges[waiting].y_start == y:
        edge = edges[waiting]
        active.append(Crossing(edge.x, edge.slope, edge.winding, edge.y_top, waiting))
        waiting += 1

    # Merge both from the right, since each is in order already
    old, new, place = kept - 1, waiting - 1, len(active) - 1
    while new >= first_new:
        edge = edges[new]
        if old >= 0 and active[old].x > edge.x:
            active[place] = active[old]
            old -= 1
        else:
            active[place] = Crossing(edge.x, edge.slope, edge.winding, edge.y_top, new)
            new -= 1
        place -= 1
    return waiting


def next_change(active: list[Crossing], edges: list[Edge], waiting: int, y: int) -> int:
    """The next row above y on which an edge begins or ends; y itself when none is active."""
    if len(active) == 0:
        return y
    row = edges[waiting].y_start if waiting < len(edges) else active[0].y_top
    for k in range(len(active)):
        row = min(row, active[k].y_top)
    return row


def settle(active: list[Crossing], edges: list[Edge], vertices: NDArray[Any], y: int) -> None:
    """Put the crossings with row y right, and in order again."""
    for k in range(len(active)):
        crossing = active[k]
        if crossing.slope == math.inf:
            continue
        edge = edges[crossing.edge]
        x = crossing_at(vertices, edge.low, edge.high, crossing.x, y)
        put_in_order(active, k, Crossing(x, crossing.slope, crossing.winding, crossing.y_top, crossing.edge))
