"""Boxes in boxes around surfaces, which rays go through; where they are cut in two is told by ``box_cuts``.

Source: Goldsmith and Salmon, Automatic Creation of Object Hierarchies for Ray Tracing, 1987; Wald, On Fast
Construction of SAH-based Bounding Volume Hierarchies, 2007.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.visibility.surfaces import NEAR_ZERO, Surface, farthest_z, nearest_z

Array = NDArray[Any]

NONE = -1
FEW = 4
"""So many surfaces in a box are not divided further."""

X_LOW, X_HIGH, Y_LOW, Y_HIGH, Z_LOW, Z_HIGH = 0, 1, 2, 3, 4, 5
"""The columns of extents."""


class Boxes(NamedTuple):
    """``extents`` (n, 6) of each box; its surfaces are those from place ``first`` to before ``end`` of the
    order (n,); ``inner`` (n,) is the first of the two boxes in it, the other comes next, or NONE."""

    extents: Array
    first: Array
    end: Array
    inner: Array


def extents_of(surfaces: list[Surface]) -> Array:
    """From where to where each surface reaches (m, 6) along x, y and z, and no rounding beyond."""
    extents = np.zeros((len(surfaces), 6))
    for number in range(len(surfaces)):
        low, middle, high = surfaces[number].low, surfaces[number].middle, surfaces[number].high
        extents[number, X_LOW] = min(low.x, middle.x, high.x) - NEAR_ZERO
        extents[number, X_HIGH] = max(low.x, middle.x, high.x) + NEAR_ZERO
        extents[number, Y_LOW], extents[number, Y_HIGH] = low.y, high.y
        extents[number, Z_LOW] = nearest_z(surfaces[number]) - NEAR_ZERO
        extents[number, Z_HIGH] = farthest_z(surfaces[number]) + NEAR_ZERO
    return extents


def one_box(extents: Array, order: Array) -> Boxes:
    """A box around all surfaces of the order, and room for those that it may be divided into."""
    most = max(2 * len(order), 1)
    firsts, ends, inner = np.zeros(most, np.int64), np.zeros(most, np.int64), np.zeros(most, np.int64)
    boxes = Boxes(np.zeros((most, 6)), firsts, ends, inner)
    put_box(boxes, 0, extents, order, 0, len(order))
    return boxes


def put_box(boxes: Boxes, here: int, extents: Array, order: Array, first: int, end: int) -> None:
    """Put a box around some surfaces of the order."""
    boxes.first[here], boxes.end[here], boxes.inner[here] = first, end, NONE
    for axis in range(3):
        low, high = math.inf, -math.inf
        for k in range(first, end):
            low = min(low, extents[order[k], 2 * axis])
            high = max(high, extents[order[k], 2 * axis + 1])
        boxes.extents[here, 2 * axis], boxes.extents[here, 2 * axis + 1] = low, high


def divide(boxes: Boxes, here: int, inner: int, extents: Array, order: Array, middle: int) -> None:
    """Put two boxes into one: around its surfaces before the place ``middle``, and around the others."""
    boxes.inner[here] = inner
    put_box(boxes, inner, extents, order, boxes.first[here], middle)
    put_box(boxes, inner + 1, extents, order, middle, boxes.end[here])


def depth_scale(boxes: Boxes) -> float:
    """What z is multiplied with, so that the scene is as deep as it is wide."""
    x_low, x_high, y_low, y_high, z_low, z_high = boxes.extents[0]
    if not z_low < z_high:
        return 1.0
    return float(max(x_high - x_low, y_high - y_low) / (z_high - z_low))


def missed(boxes: Boxes, box: int, x: int, y: int, nearest: float) -> bool:
    """Whether a ray along z passes a box by, or has met something nearer than all that is in it."""
    if x < boxes.extents[box, X_LOW] or x > boxes.extents[box, X_HIGH]:
        return True
    if y < boxes.extents[box, Y_LOW] or y > boxes.extents[box, Y_HIGH]:
        return True
    return bool(boxes.extents[box, Z_LOW] > nearest)


def nearer_first(boxes: Boxes, box: int) -> tuple[int, int]:
    """The two boxes in a box, that which begins nearer first."""
    one = int(boxes.inner[box])
    if boxes.extents[one + 1, Z_LOW] < boxes.extents[one, Z_LOW]:
        return one + 1, one
    return one, one + 1
