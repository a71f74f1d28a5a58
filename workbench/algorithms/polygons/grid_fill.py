"""What paints the scan-line fill: crossings in whole numbers, for vertices on a grid of 1/4096 px.

An edge crosses a row at column - remainder / divisor, where column is the first pixel that is not left of it.
From row to row column grows by stride, and remainder shrinks by part; below 0 it borrows one column. So no
crossing is ever rounded. All that the fill asks of a crossing is its column.
"""

import math
from collections.abc import Generator, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

GRID = 4096
REACH = 2.0**18
"""Within so many pixels the products of whole numbers stay below 2^63."""

# What is kept of an edge, and of its crossing with the current row
COLUMN, REMAINDER, STRIDE, PART, DIVISOR, AROUND, END_ROW, FIRST_ROW = range(8)
FIELDS = 8


def fill_on_grid(
    vertices: Array, ring_ends: Array, closed: bool, nonzero: bool
) -> Generator[tuple[int, int, int], None, bool]:
    """Emit the pixels of ``scan_line_exact``, whose arguments it takes, if it can; whether it could.

    Where the winding number comes back to 0 and leaves it at one column, two spans stand for one.
    """
    if closed or not is_on_grid(vertices):
        return False
    edges = np.empty((len(vertices), FIELDS), np.int64)
    active = np.empty((len(vertices), FIELDS), np.int64)
    order = by_first_row(edges, edges_on_grid(edges, vertices, ring_ends))
    waiting = crossed = until = 0
    while waiting < len(order) or crossed > 0:
        y = until if crossed > 0 else edges[order[waiting], FIRST_ROW]
        crossed, waiting = crossed_on(active, crossed, edges, order, waiting, y)
        until = first_change(active, crossed, edges, order, waiting)
        if crossed == 2:
            yield from between_two(active, y, until)
        else:
            yield from between_all(active, crossed, y, until, nonzero)
    return True


def is_on_grid(vertices: Array) -> bool:
    """Whether all vertices, in pixels, are whole multiples of 1/4096 and not too far away."""
    for k in range(len(vertices)):
        x, y = float(vertices[k, 0]), float(vertices[k, 1])
        if not (abs(x) <= REACH and abs(y) <= REACH):
            return False
        if x * GRID != math.floor(x * GRID) or y * GRID != math.floor(y * GRID):
            return False
    return True


def edges_on_grid(edges: Array, vertices: Array, ring_ends: Array) -> int:
    """Write the edges that cross a row, from vertex to vertex; how many they are."""
    count = start = 0
    for ring_end in ring_ends:
        end = min(int(ring_end), len(vertices))
        before = end - 1
        for k in range(start, end):
            x_low, y_low = int(vertices[before, 0] * GRID), int(vertices[before, 1] * GRID)
            x_high, y_high = int(vertices[k, 0] * GRID), int(vertices[k, 1] * GRID)
            before = k
            around = 1
            if y_high < y_low:
                x_low, y_low, x_high, y_high = x_high, y_high, x_low, y_low
                around = -1
            first_row, end_row = -(-y_low // GRID), -(-y_high // GRID)
            if first_row == end_row:
                continue
            dx, dy = x_high - x_low, y_high - y_low
            divisor = dy * GRID
            dividend = x_low * dy + (first_row * GRID - y_low) * dx
            column, stride = -(-dividend // divisor), dx * GRID // divisor
            edges[count, COLUMN] = column
            edges[count, REMAINDER] = column * divisor - dividend
            edges[count, STRIDE] = stride
            edges[count, PART] = dx * GRID - stride * divisor
            edges[count, DIVISOR] = divisor
            edges[count, AROUND] = around
            edges[count, END_ROW] = end_row
            edges[count, FIRST_ROW] = first_row
            count += 1
        start = max(start, end)
    return count


def by_first_row(edges: Array, count: int) -> Array:
    """The numbers of the edges, those of the lowest row first: merged in runs of 1, 2, 4 ... edges."""
    order, merged = np.arange(count), np.arange(count)
    run = 1
    while run < count:
        for start in range(0, count, 2 * run):
            middle = min(start + run, count)
            end = min(middle + run, count)
            first, second = start, middle
            for k in range(start, end):
                if second >= end or (
                    first < middle and edges[order[first], FIRST_ROW] <= edges[order[second], FIRST_ROW]
                ):
                    merged[k] = order[first]
                    first += 1
                else:
                    merged[k] = order[second]
                    second += 1
        order, merged = merged, order
        run *= 2
    return order


def crossed_on(
    active: Array, crossed: int, edges: Array, order: Array, waiting: int, y: int
) -> tuple[int, int]:
    """Drop the edges that have ended below row y, let in those that begin; how many it crosses, who waits."""
    kept = 0
    for k in range(crossed):
        if active[k, END_ROW] > y:
            for item in range(FIELDS):
                active[kept, item] = active[k, item]
            kept += 1
    while waiting < len(order) and edges[order[waiting], FIRST_ROW] == y:
        for item in range(FIELDS):
            active[kept, item] = edges[order[waiting], item]
        move_left(active, kept)
        kept += 1
        waiting += 1
    return kept, waiting


def first_change(active: Array, crossed: int, edges: Array, order: Array, waiting: int) -> int:
    """The next row on which an edge begins or ends."""
    row = edges[order[waiting], FIRST_ROW] if waiting < len(order) else active[0, END_ROW]
    for k in range(crossed):
        row = min(row, active[k, END_ROW])
    return int(row)


def move_left(active: Array, place: int) -> None:
    """Put an edge before those that are crossed right of it."""
    while place > 0 and active[place - 1, COLUMN] > active[place, COLUMN]:
        for item in range(FIELDS):
            active[place - 1, item], active[place, item] = active[place, item], active[place - 1, item]
        place -= 1


def between_two(active: Array, y: int, until: int) -> Iterator[tuple[int, int, int]]:
    """Fill between two edges, and leave them at row ``until``: their crossings need no place in between."""
    column, remainder = active[0, COLUMN], active[0, REMAINDER]
    stride, part, divisor = active[0, STRIDE], active[0, PART], active[0, DIVISOR]
    column_2, remainder_2 = active[1, COLUMN], active[1, REMAINDER]
    stride_2, part_2, divisor_2 = active[1, STRIDE], active[1, PART], active[1, DIVISOR]
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
    active[0, COLUMN], active[0, REMAINDER] = column, remainder
    active[1, COLUMN], active[1, REMAINDER] = column_2, remainder_2
    move_left(active, 1)


def between_all(
    active: Array, crossed: int, y: int, until: int, nonzero: bool
) -> Iterator[tuple[int, int, int]]:
    """Fill between any number of edges, each moved on and kept in order as soon as it was looked at."""
    for row in range(y, until):
        winding, left, farthest = 0, 0, -(1 << 40)
        for k in range(crossed):
            column = active[k, COLUMN]
            if winding == 0:
                left = column
            winding = winding + active[k, AROUND] if nonzero else 1 - winding
            if winding == 0 and left < column:
                yield row, left, column - 1
            remainder = active[k, REMAINDER] - active[k, PART]
            borrowed = remainder >> 63
            column += active[k, STRIDE] - borrowed
            active[k, COLUMN] = column
            active[k, REMAINDER] = remainder + (active[k, DIVISOR] & borrowed)
            if column < farthest:
                move_left(active, k)
            else:
                farthest = column
