"""The four edges of the window: the bit of each in a region code, and where a line crosses one.

code        top, bottom, right, left from the highest bit; a bit is set where the point is beyond that edge
edge        one of these bits
"""

import math

import numpy as np

from workbench.geometry.orientation import side_of

TOP, BOTTOM, RIGHT, LEFT = 8, 4, 2, 1

# An intersection is off by less than its line's ends, halved so many times.
ROUNDING_BITS = 48


def region_code(x: float, y: float, xmin: float, ymin: float, xmax: float, ymax: float) -> int:
    """Which edges the point (x, y) is beyond; 0 inside and on the edge.

    Source: Hearn and Baker, Computer Graphics, C Version, section 6-7.
    """
    code = 0
    if y > ymax:
        code = TOP
    elif y < ymin:
        code = BOTTOM
    if x > xmax:
        code += RIGHT
    elif x < xmin:
        code += LEFT
    return code


def between(value: float, end_0: float, end_1: float) -> float:
    """``value``, or the end that rounding has carried it past."""
    return min(max(value, min(end_0, end_1)), max(end_0, end_1))


def intersection(
    x0: float,
    y0: float,
    x1: float,
    y1: float,
    edge: int,
    xmin: float,
    ymin: float,
    xmax: float,
    ymax: float,
) -> tuple[float, float]:
    """Where the line from (x0, y0) to (x1, y1) crosses ``edge``, which has one end on either side.

    Source: Hearn and Baker, Computer Graphics, C Version, section 6-7.
    """
    # Find the intersection
    if edge in (TOP, BOTTOM):
        y = ymax if edge == TOP else ymin
        x = x0 + (x1 - x0) * (y - y0) / (y1 - y0)
    else:
        x = xmax if edge == RIGHT else xmin
        y = y0 + (y1 - y0) * (x - x0) / (x1 - x0)

    # Let no rounding carry it past a corner or an end
    if edge in (TOP, BOTTOM):
        x = beside_corner(beside_corner(x, xmin, y, x0, y0, x1, y1), xmax, y, x0, y0, x1, y1)
    else:
        y = beside_corner(beside_corner(y, ymin, x, y0, x0, y1, x1), ymax, x, y0, x0, y1, x1)
    return between(x, x0, x1), between(y, y0, y1)


def beside_corner(x: float, corner: float, y: float, x0: float, y0: float, x1: float, y1: float) -> float:
    """``x``, where a line meets row y, on its true side of a corner at (``corner``, y), or in it."""
    if abs(x - corner) > math.ldexp(abs(x0) + abs(x1), -ROUNDING_BITS):
        return x
    side = side_of(x0, y0, x1, y1, corner, y)
    if side == 0.0:
        return corner
    if (side > 0.0) == (y1 > y0):
        return min(x, float(np.nextafter(corner, -math.inf)))
    return max(x, float(np.nextafter(corner, math.inf)))
