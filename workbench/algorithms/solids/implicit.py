"""Solids by an equation: where its value is not above 0 is their inside; and the values that a cube has.

The numbers of a shape, in coordinates of its own: ELLIPSOID its half axes, TORUS R and r round the y axis,
CYLINDER and CONE r and height on y = 0, BLOCK half its width, height and depth, BLOBS a and T and then the
middle of each ball, HALF_SPACE A, B, C, D. Values in a cube are told by interval arithmetic: exact where each
coordinate is in the equation once, else never too narrow.

Source: Hearn and Baker, Computer Graphics, C Version, sections 10-3 and 10-5; Moore, Interval Analysis, 1966.
"""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

Array = NDArray[Any]

ELLIPSOID, TORUS, CYLINDER, CONE, BLOCK, BLOBS, HALF_SPACE = 0, 1, 2, 3, 4, 5, 6
EMPTY, FULL, PARTIAL = 0, 1, 2


class Range(NamedTuple):
    """All values from the least to the greatest."""

    low: float
    high: float


def state_of(shape: int, numbers: Array, inverse: Array, corner: Array, size: float) -> int:
    """Whether a cube of the world is EMPTY, FULL, or filled in PARTIAL; as far as its values tell.

    ``inverse`` (3, 4) takes the world into the coordinates of the shape; corner (3,) is the cube's lowest.
    """
    x = own_range(inverse, 0, corner, size)
    y = own_range(inverse, 1, corner, size)
    z = own_range(inverse, 2, corner, size)
    values = values_in(shape, numbers, x, y, z)
    if values.high <= 0.0:
        return FULL
    return EMPTY if values.low >= 0.0 else PARTIAL


def own_range(inverse: Array, axis: int, corner: Array, size: float) -> Range:
    """From where to where a cube reaches along an axis of the shape."""
    middle, half = float(inverse[axis, 3]), 0.0
    for k in range(3):
        middle += float(inverse[axis, k]) * (float(corner[k]) + size / 2)
        half += abs(float(inverse[axis, k])) * size / 2
    return Range(middle - half, middle + half)


def values_in(shape: int, numbers: Array, x: Range, y: Range, z: Range) -> Range:
    """All values of the shape's equation in a block."""
    a = float(numbers[0])
    if shape == ELLIPSOID:
        ends = added(added(square(x, a), square(y, float(numbers[1]))), square(z, float(numbers[2])))
        return shifted(ends, -1.0)
    if shape == TORUS:
        from_ring = shifted(root(added(square(x, 1.0), square(z, 1.0))), -a)
        return shifted(added(square(from_ring, 1.0), square(y, 1.0)), -float(numbers[1]) * float(numbers[1]))
    if shape == CYLINDER:
        sides = shifted(root(added(square(x, 1.0), square(z, 1.0))), -a)
        return both(sides, between(y, 0.0, float(numbers[1])))
    if shape == CONE:
        slope = a / float(numbers[1])
        sides = added(
            root(added(square(x, 1.0), square(z, 1.0))), Range(slope * y.low - a, slope * y.high - a)
        )
        return both(sides, between(y, 0.0, float(numbers[1])))
    if shape == BLOCK:
        sides = both(between(x, -a, a), between(y, -float(numbers[1]), float(numbers[1])))
        return both(sides, between(z, -float(numbers[2]), float(numbers[2])))
    if shape == BLOBS:
        return minus_density(numbers, x, y, z)
    ends = added(times(x, a), added(times(y, float(numbers[1])), times(z, float(numbers[2]))))
    return shifted(ends, float(numbers[3]))


def minus_density(numbers: Array, x: Range, y: Range, z: Range) -> Range:
    """The threshold less the density of blobs: each ball adds exp(-a r^2)."""
    low, high = float(numbers[1]), float(numbers[1])
    for k in range(2, len(numbers) - 2, 3):
        dx, dy = shifted(x, -float(numbers[k])), shifted(y, -float(numbers[k + 1]))
        r_squared = added(
            added(square(dx, 1.0), square(dy, 1.0)), square(shifted(z, -float(numbers[k + 2])), 1.0)
        )
        low -= math.exp(-float(numbers[0]) * r_squared.low)
        high -= math.exp(-float(numbers[0]) * r_squared.high)
    return Range(low, high)


def square(a: Range, unit: float) -> Range:
    """(a / unit)^2."""
    low, high = a.low / unit, a.high / unit
    least = 0.0 if low < 0.0 < high else min(low * low, high * high)
    return Range(least, max(low * low, high * high))


def root(a: Range) -> Range:
    """The square root of what is not negative."""
    return Range(math.sqrt(a.low), math.sqrt(a.high))


def added(a: Range, b: Range) -> Range:
    """a + b."""
    return Range(a.low + b.low, a.high + b.high)


def shifted(a: Range, by: float) -> Range:
    """a + by."""
    return Range(a.low + by, a.high + by)


def times(a: Range, factor: float) -> Range:
    """a times a number."""
    return Range(min(a.low * factor, a.high * factor), max(a.low * factor, a.high * factor))


def between(a: Range, low: float, high: float) -> Range:
    """How far outside of low to high: negative inside."""
    return both(Range(low - a.high, low - a.low), Range(a.low - high, a.high - high))


def both(a: Range, b: Range) -> Range:
    """The greater of two values: inside where both are."""
    return Range(max(a.low, b.low), max(a.high, b.high))
