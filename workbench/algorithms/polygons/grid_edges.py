"""Edges of a polygon in whole numbers, for vertices on a grid of 1/4096 px.

An edge crosses a row at column - remainder / divisor, where column is the first pixel that is not left of it.
From row to row column grows by stride, and remainder shrinks by part; below 0 it borrows one column. So no
crossing is ever rounded.
"""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.conventions import GRID

Array = NDArray[Any]

REACH = 2.0**18
"""Within so many pixels the products of whole numbers stay below 2^63."""

# What is kept of an edge, and of its crossing with the current row
COLUMN, REMAINDER, STRIDE, PART, DIVISOR, AROUND, END_ROW, FIRST_ROW = range(8)
FIELDS = 8

FAR = 1 << 40  # beyond all rows and columns
MOST_BITS = 11  # of a digit that edges are sorted by: a table of its values fits the nearest memory


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


def in_order(edges: Array, count: int) -> Array:
    """The numbers of the edges by their first rows, on one row from left to right; unsigned, to index fast.

    Sorted by one digit of ``rank`` after another, lowest first, with about as many values as there are edges.
    """
    rank, most = ranks(edges, count)
    bits = 2
    while bits < MOST_BITS and 1 << bits < count:
        bits += 1
    mask, shift = (1 << bits) - 1, 0
    place = np.empty(1 << bits, np.int64)
    order, moved = np.arange(count).astype(np.uint64), np.empty(count, np.uint64)
    while most >> shift > 0:
        place[:] = 0
        for k in range(count):
            place[rank[k] >> shift & mask] += 1
        following = count
        for digit in range(mask, -1, -1):
            following -= place[digit]
            place[digit] = following
        for k in range(count):
            digit = rank[order[k]] >> shift & mask
            moved[place[digit]] = order[k]
            place[digit] += 1
        order, moved = moved, order
        shift += bits
    return order


def ranks(edges: Array, count: int) -> tuple[Array, int]:
    """A number from 0 for each edge, less where it begins lower, or as low further left; the largest one."""
    lowest, leftmost, rightmost = FAR, FAR, -FAR
    for k in range(count):
        lowest = min(lowest, edges[k, FIRST_ROW])
        leftmost, rightmost = min(leftmost, edges[k, COLUMN]), max(rightmost, edges[k, COLUMN])
    width = rightmost - leftmost + 1
    rank, most = np.empty(count, np.int64), 0
    for k in range(count):
        rank[k] = (edges[k, FIRST_ROW] - lowest) * width + edges[k, COLUMN] - leftmost
        most = max(most, rank[k])
    return rank, most
