"""What paints the scan-line fill: crossings in whole numbers, for vertices on a grid of 1/4096 px.

All that the fill asks of a crossing is its column, the first pixel that is not left of it (``grid_edges``).
"""

from collections.abc import Generator, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.polygons.grid_edges import (
    AROUND,
    COLUMN,
    DIVISOR,
    END_ROW,
    FAR,
    FIELDS,
    FIRST_ROW,
    PART,
    REMAINDER,
    STRIDE,
    edges_on_grid,
    in_order,
    is_on_grid,
)

Array = NDArray[Any]


def fill_on_grid(
    vertices: Array, ring_ends: Array, closed: bool, nonzero: bool
) -> Generator[tuple[int, int, int], None, bool]:
    """Emit the pixels of ``scan_line_exact``, whose arguments it takes, if it can; whether it could.

    Where the winding number comes back to 0 and leaves it at one column, two spans stand for one.
    """
    if closed or not is_on_grid(vertices):
        return False
    edges = np.empty((len(vertices), FIELDS), np.int64)
    order = in_order(edges, edges_on_grid(edges, vertices, ring_ends))
    active = np.empty(len(order), np.uint64)
    waiting = crossed = until = 0
    while waiting < len(order) or crossed > 0:
        y = until if crossed > 0 else edges[order[waiting], FIRST_ROW]
        crossed, waiting, until = change_edges(active, crossed, edges, order, waiting, y)
        if crossed == 2:
            yield from between_two(active, edges, y, until)
        elif crossed > 0:
            yield from between_all(active, crossed, edges, y, until, nonzero)
    return True


def change_edges(
    active: Array, crossed: int, edges: Array, order: Array, waiting: int, y: int
) -> tuple[int, int, int]:
    """Drop the edges that have ended below row y, and let in those that begin.

    Returns how many cross it then, who waits, and the next row on which an edge begins or ends.
    """
    kept, until = 0, FAR
    for k in range(crossed):
        edge = active[k]
        if edges[edge, END_ROW] > y:
            until = min(until, edges[edge, END_ROW])
            active[kept] = edge
            kept += 1
    first_new = waiting
    while waiting < len(order) and edges[order[waiting], FIRST_ROW] == y:
        until = min(until, edges[order[waiting], END_ROW])
        waiting += 1
    if waiting < len(order):
        until = min(until, edges[order[waiting], FIRST_ROW])

    # Merge both from the right, since each is in order already
    old, new = kept - 1, waiting - 1
    while new >= first_new:
        place = old + 1 + new - first_new
        if old >= 0 and edges[active[old], COLUMN] > edges[order[new], COLUMN]:
            active[place] = active[old]
            old -= 1
        else:
            active[place] = order[new]
            new -= 1
    return kept + waiting - first_new, waiting, until


def put_in_place(active: Array, place: int, edges: Array, edge: int) -> None:
    """Put an edge among the first ``place`` ones that are crossed; those right of it move up."""
    column = edges[edge, COLUMN]
    while place > 0 and edges[active[place - 1], COLUMN] > column:
        active[place] = active[place - 1]
        place -= 1
    active[place] = edge


def between_two(active: Array, edges: Array, y: int, until: int) -> Iterator[tuple[int, int, int]]:
    """Fill between two edges, and leave them at row ``until``: their crossings need no place in between."""
    one, two = active[0], active[1]
    column, remainder = edges[one, COLUMN], edges[one, REMAINDER]
    stride, part, divisor = edges[one, STRIDE], edges[one, PART], edges[one, DIVISOR]
    column_2, remainder_2 = edges[two, COLUMN], edges[two, REMAINDER]
    stride_2, part_2, divisor_2 = edges[two, STRIDE], edges[two, PART], edges[two, DIVISOR]
    for row in range(y, until):
        left, right = min(column, column_2), max(column, column_2)
        if left < right:
            yield row, left, right - 1
        remainder -= part
        borrowed = remainder >> 63  # -1 below 0, else 0
        remainder += divisor & borrowed
        column += stride - borrowed
        remainder_2 -= part_2
        borrowed = remainder_2 >> 63
        remainder_2 += divisor_2 & borrowed
        column_2 += stride_2 - borrowed
    edges[one, COLUMN], edges[one, REMAINDER] = column, remainder
    edges[two, COLUMN], edges[two, REMAINDER] = column_2, remainder_2
    put_in_place(active, 1, edges, two)


def between_all(
    active: Array, crossed: int, edges: Array, y: int, until: int, nonzero: bool
) -> Iterator[tuple[int, int, int]]:
    """Fill between any number of edges, each moved on and kept in order as soon as it was looked at."""
    for row in range(y, until):
        winding, left, farthest = 0, 0, -FAR
        for k in range(crossed):
            edge = active[k]
            column = edges[edge, COLUMN]
            if winding == 0:
                left = column
            winding = winding + edges[edge, AROUND] if nonzero else 1 - winding
            if winding == 0 and left < column:
                yield row, left, column - 1
            remainder = edges[edge, REMAINDER] - edges[edge, PART]
            borrowed = remainder >> 63
            column += edges[edge, STRIDE] - borrowed
            edges[edge, COLUMN] = column
            edges[edge, REMAINDER] = remainder + (edges[edge, DIVISOR] & borrowed)
            if column < farthest:
                put_in_place(active, k, edges, edge)
            else:
                farthest = column
