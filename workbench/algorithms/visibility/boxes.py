"""Boxes in boxes around surfaces: each box is cut in two where rays then have the least to try.

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
BINS = 12
"""Between so many bins of middles a cut is looked for."""
_WHOLE = 0.999999

X_LOW, X_HIGH, Y_LOW, Y_HIGH, Z_LOW, Z_HIGH = 0, 1, 2, 3, 4, 5
"""The columns of extents."""


class Boxes(NamedTuple):
    """``extents`` (n, 6) of each box; its surfaces are those from place ``first`` to before ``end`` of the
    order (n,); ``inner`` (n,) is the first of the two boxes in it, the other comes next, or NONE."""

    extents: Array
    first: Array
    end: Array
    inner: Array


class Cut(NamedTuple):
    """Across an axis, 0 to 2, or NONE: bins of middles begin at ``start``, ``per_unit`` of them in a unit,
    and those below number ``bin`` are the first part.

    Middles are told by the sum of both ends.
    """

    axis: int
    start: float
    per_unit: float
    bin: int

    @property
    def at(self) -> float:
        """Where along the axis it is."""
        return (self.start + self.bin / self.per_unit) / 2


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
    boxes = Boxes(
        np.zeros((most, 6)), np.zeros(most, np.int64), np.zeros(most, np.int64), np.zeros(most, np.int64)
    )
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


def cheapest_cut(extents: Array, order: Array, first: int, end: int, scale: float, bins: Array) -> Cut:
    """The cut across the longest axis after which a ray, on the average, is tried on the fewest surfaces.

    z counts ``scale`` times; ``bins`` (BINS, 8) is written: extents, number, and cost of what is below.
    """
    axis, start, reach, longest = NONE, 0.0, 0.0, 0.0
    for k in range(3):
        low, high = math.inf, -math.inf
        for place in range(first, end):
            middle = extents[order[place], 2 * k] + extents[order[place], 2 * k + 1]
            low, high = min(low, middle), max(high, middle)
        length = (high - low) * (scale if k == 2 else 1.0)
        if length > longest:
            axis, start, reach, longest = k, low, high - low, length
    if axis == NONE:
        return Cut(NONE, 0.0, 0.0, 0)
    cut = Cut(axis, start, BINS * _WHOLE / reach, 0)
    fill_bins(extents, order, first, end, cut, bins)
    return Cut(axis, start, cut.per_unit, cheapest_bin(bins, scale))


def bin_of(extents: Array, number: int, cut: Cut) -> int:
    """The bin that a surface's middle is in."""
    middle = extents[number, 2 * cut.axis] + extents[number, 2 * cut.axis + 1]
    return int((middle - cut.start) * cut.per_unit)


def fill_bins(extents: Array, order: Array, first: int, end: int, cut: Cut, bins: Array) -> None:
    """Count surfaces by their middles, and put a box around those of each bin."""
    for b in range(BINS):
        for k in range(3):
            bins[b, 2 * k], bins[b, 2 * k + 1] = math.inf, -math.inf
        bins[b, 6] = 0.0
    for place in range(first, end):
        n = order[place]
        b = bin_of(extents, n, cut)
        for k in range(3):
            bins[b, 2 * k] = min(bins[b, 2 * k], extents[n, 2 * k])
            bins[b, 2 * k + 1] = max(bins[b, 2 * k + 1], extents[n, 2 * k + 1])
        bins[b, 6] += 1.0


def cheapest_bin(bins: Array, scale: float) -> int:
    """The bin before which a cut costs least: of both sides the surface of the box times the number in it."""
    box, count = Box(math.inf, -math.inf, math.inf, -math.inf, math.inf, -math.inf), 0.0
    for b in range(BINS - 1):
        box, count = joined(box, bins, b), count + bins[b, 6]
        bins[b, 7] = surface_of_box(box, scale) * count
    box, count = Box(math.inf, -math.inf, math.inf, -math.inf, math.inf, -math.inf), 0.0
    best, least = 1, math.inf
    for b in range(BINS - 1, 0, -1):
        box, count = joined(box, bins, b), count + bins[b, 6]
        cost = bins[b - 1, 7] + surface_of_box(box, scale) * count
        if cost < least:
            best, least = b, cost
    return best


class Box(NamedTuple):
    """A box that grows."""

    x_low: float
    x_high: float
    y_low: float
    y_high: float
    z_low: float
    z_high: float


def joined(box: Box, bins: Array, b: int) -> Box:
    """The box around a box and a bin."""
    return Box(
        min(box.x_low, bins[b, X_LOW]),
        max(box.x_high, bins[b, X_HIGH]),
        min(box.y_low, bins[b, Y_LOW]),
        max(box.y_high, bins[b, Y_HIGH]),
        min(box.z_low, bins[b, Z_LOW]),
        max(box.z_high, bins[b, Z_HIGH]),
    )


def surface_of_box(box: Box, scale: float) -> float:
    """Half the surface of a box: how likely a ray is to meet it."""
    wide, high, deep = box.x_high - box.x_low, box.y_high - box.y_low, (box.z_high - box.z_low) * scale
    return wide * high + (wide + high) * deep


def put_apart(extents: Array, order: Array, first: int, end: int, cut: Cut) -> int:
    """Put those below a cut before the others in the order; returns where the others begin.

    Neither part is empty: the least middle is in bin 0, the greatest in the last.
    """
    low, high = first, end
    while low < high:
        n = order[low]
        if bin_of(extents, n, cut) < cut.bin:
            low += 1
        else:
            high -= 1
            order[low], order[high] = order[high], n
    return low


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
