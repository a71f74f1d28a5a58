"""Where a box of surfaces is cut in two, so that rays then have the least to try.

Source: Goldsmith and Salmon, Automatic Creation of Object Hierarchies for Ray Tracing, 1987; Wald, On Fast
Construction of SAH-based Bounding Volume Hierarchies, 2007.
"""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.visibility.boxes import NONE, X_HIGH, X_LOW, Y_HIGH, Y_LOW, Z_HIGH, Z_LOW

Array = NDArray[Any]

BINS = 12
"""Between so many bins of middles a cut is looked for."""
_WHOLE = 0.999999


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
    x_low, x_high = min(box.x_low, bins[b, X_LOW]), max(box.x_high, bins[b, X_HIGH])
    y_low, y_high = min(box.y_low, bins[b, Y_LOW]), max(box.y_high, bins[b, Y_HIGH])
    z_low, z_high = min(box.z_low, bins[b, Z_LOW]), max(box.z_high, bins[b, Z_HIGH])
    return Box(x_low, x_high, y_low, y_high, z_low, z_high)


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
