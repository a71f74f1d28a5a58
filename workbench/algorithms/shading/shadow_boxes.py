"""Boxes in boxes around what may take light away: a ray to a light that misses a box misses all in it.

Blockers are corners (3 k, 3) of triangles of the world. A box among them is three rows, too, before all that
is in it: its lowest corner, its highest, and how many rows are in it, followed by infinity.
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.visibility.back_faces import SpaceVector
from workbench.algorithms.visibility.box_cuts import BINS, cheapest_cut, put_apart
from workbench.algorithms.visibility.boxes import (
    FEW,
    NONE,
    Boxes,
    divide,
    one_box,
)

Array = NDArray[Any]

_SPARE = 1e-9
"""By so much of a scene's reach boxes are larger than what is in them, so that no rounding decides."""


def boxed_blockers(blockers: Array) -> Iterator[tuple[float, float, float]]:
    """Triangles (3 k, 3) with boxes around them. Emits: the rows."""
    extents = extents_of_blockers(blockers)
    order = np.arange(len(extents))
    boxes = one_box(extents, order)
    total = divide_all(boxes, extents, order)
    rows = rows_in(boxes, total)
    waiting = [0]
    if len(extents) <= FEW:  # of few a box would save nothing
        waiting.pop()
        for k in range(len(blockers)):
            yield float(blockers[k, 0]), float(blockers[k, 1]), float(blockers[k, 2])
    while waiting:
        box = waiting.pop()
        x_low, x_high, y_low, y_high, z_low, z_high = boxes.extents[box]
        yield float(x_low), float(y_low), float(z_low)
        yield float(x_high), float(y_high), float(z_high)
        yield float(rows[box] - 3), math.inf, math.inf
        inner = int(boxes.inner[box])
        if inner != NONE:
            waiting.append(inner + 1)
            waiting.append(inner)
            continue
        for place in range(boxes.first[box], boxes.end[box]):
            for k in range(3 * order[place], 3 * order[place] + 3):
                yield float(blockers[k, 0]), float(blockers[k, 1]), float(blockers[k, 2])


def extents_of_blockers(blockers: Array) -> Array:
    """From where to where each triangle reaches (k, 6) along x, y and z, and a little more."""
    extents = np.zeros((len(blockers) // 3, 6))
    reach = 0.0
    for k in range(len(blockers)):
        for axis in range(3):
            reach = max(reach, abs(blockers[k, axis]))
    for n in range(len(extents)):
        for axis in range(3):
            a, b, c = blockers[3 * n, axis], blockers[3 * n + 1, axis], blockers[3 * n + 2, axis]
            extents[n, 2 * axis] = min(a, b, c) - _SPARE * reach
            extents[n, 2 * axis + 1] = max(a, b, c) + _SPARE * reach
    return extents


def divide_all(boxes: Boxes, extents: Array, order: Array) -> int:
    """Divide a box, and those in it, as ``ray_casting_boxes`` does; returns how many boxes there are then."""
    total, work, bins = 1, [0], np.zeros((BINS, 8))
    while work:
        here = work.pop()
        first, end = int(boxes.first[here]), int(boxes.end[here])
        if end - first > FEW:
            cut = cheapest_cut(extents, order, first, end, 1.0, bins)
            if cut.axis != NONE:
                divide(boxes, here, total, extents, order, put_apart(extents, order, first, end, cut))
                work.append(total)
                work.append(total + 1)
                total += 2
    return total


def rows_in(boxes: Boxes, total: int) -> Array:
    """How many rows each box (n,) takes with all in it."""
    rows = np.zeros(total, np.int64)
    for box in range(total - 1, -1, -1):  # those in a box come after it
        inner = int(boxes.inner[box])
        if inner == NONE:
            rows[box] = 3 + 3 * (boxes.end[box] - boxes.first[box])
        else:
            rows[box] = 3 + rows[inner] + rows[inner + 1]
    return rows


def is_box(blockers: Array, k: int) -> bool:
    """Whether the three rows from row k on are a box."""
    return math.isinf(blockers[k + 2, 1])


def passes_by(place: SpaceVector, way: SpaceVector, reach: float, blockers: Array, k: int) -> bool:
    """Whether a ray from a place misses a box, whose first row is k, on its way, as far as it ``reach``es."""
    start, end = 0.0, reach
    for axis in range(3):
        low, high = (
            blockers[k, axis] - coordinate(place, axis),
            blockers[k + 1, axis] - coordinate(place, axis),
        )
        along = coordinate(way, axis)
        if along == 0.0:
            if low > 0.0 or high < 0.0:
                return True
        else:
            start = max(start, min(low / along, high / along))
            end = min(end, max(low / along, high / along))
    return start > end


def coordinate(a: SpaceVector, axis: int) -> float:
    """x, y or z of a vector by its number."""
    return a.x if axis == 0 else a.y if axis == 1 else a.z
