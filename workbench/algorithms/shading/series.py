"""A cosine over a triangle as a sum of powers up to the second, and stepped along a row by differences.

Source: Bishop and Weimer, Fast Phong Shading, SIGGRAPH 1986. They expand N . L / |N|, whose N is linear on
the screen, about the middle of the triangle, so that two additions carry it from a pixel to the next. (Duff,
1979, steps numerator and square of the denominator apart, which is exact and costs a root and a division.)
"""

import math
from typing import NamedTuple

from workbench.algorithms.shading.directions import minus
from workbench.algorithms.shading.normal_corners import NormalCorner
from workbench.algorithms.visibility.back_faces import SpaceVector, dot_product


class Bend(NamedTuple):
    """The normal N of a triangle in its middle (x, y) on the device, and its change from pixel to pixel."""

    x: float
    y: float
    N: SpaceVector
    per_x: SpaceVector
    per_y: SpaceVector


class Series(NamedTuple):
    """T0 + T1 u + T2 v + T3 u^2 + T4 u v + T5 v^2, for a pixel (u, v) from the middle."""

    T0: float
    T1: float
    T2: float
    T3: float
    T4: float
    T5: float


class Differences(NamedTuple):
    """The value at a pixel, its first difference, and its second, which stays."""

    value: float
    first: float
    second: float


def bend_of(a: NormalCorner, b: NormalCorner, c: NormalCorner) -> Bend:
    """How the normal bends over a triangle that is not seen edge on."""
    ux, uy, vx, vy = b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y
    area = ux * vy - vx * uy
    along, across = minus(b.normal, a.normal), minus(c.normal, a.normal)
    dN_dx = weighted(along, vy / area, across, -uy / area)
    dN_dy = weighted(along, -vx / area, across, ux / area)
    x, y = (a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0
    from_a = weighted(dN_dx, x - a.x, dN_dy, y - a.y)
    return Bend(x, y, weighted(a.normal, 1.0, from_a, 1.0), dN_dx, dN_dy)


def weighted(a: SpaceVector, s: float, b: SpaceVector, t: float) -> SpaceVector:
    """s a + t b."""
    return SpaceVector(s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z)


def series_of(bend: Bend, L: SpaceVector) -> Series:
    """N . L / |N| about the middle; 0 where N is 0 there."""
    square = dot_product(bend.N, bend.N)
    if square == 0.0:
        return Series(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    # N . L is l0 + l1 u + l2 v, and |N|^2 is square (1 + 2 (a u + b v) + c u^2 + 2 d u v + e v^2)
    size = math.sqrt(square)
    l0 = dot_product(bend.N, L) / size
    l1, l2 = dot_product(bend.per_x, L) / size, dot_product(bend.per_y, L) / size
    a, b = dot_product(bend.N, bend.per_x) / square, dot_product(bend.N, bend.per_y) / square
    c, d = dot_product(bend.per_x, bend.per_x) / square, dot_product(bend.per_x, bend.per_y) / square
    e = dot_product(bend.per_y, bend.per_y) / square
    T3 = l0 * (1.5 * a * a - 0.5 * c) - l1 * a
    T4 = l0 * (3.0 * a * b - d) - l1 * b - l2 * a
    T5 = l0 * (1.5 * b * b - 0.5 * e) - l2 * b
    return Series(l0, l1 - l0 * a, l2 - l0 * b, T3, T4, T5)


def begun(T: Series, u: float, v: float) -> Differences:
    """The value at a place, and the differences from there along the row."""
    value = T.T0 + (T.T1 + T.T3 * u + T.T4 * v) * u + (T.T2 + T.T5 * v) * v
    return Differences(value, T.T1 + T.T3 * (2.0 * u + 1.0) + T.T4 * v, 2.0 * T.T3)


def onward(at: Differences) -> Differences:
    """The next pixel, by two additions."""
    return Differences(at.value + at.first, at.first + at.second, at.second)
