"""How far a pixel lies from the ideal curve, and whether two pixels were exactly equally near.

Everything is in the device frame, in pixels. Lines have integer end points, circles and ellipses integer
centres and radii, as the scan conversions get them. A *tie* is decided in integers, never within a tolerance.
Only lines have ties: an ellipse at a whole x stands at half a whole y only if ry w / rx is half an odd number
for a Pythagorean triple (x, w, rx), and the hypotenuse of a primitive one is odd.
"""

from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]
_HALVINGS = 64


def line_offset(x0: int, y0: int, x1: int, y1: int, x: int, y: int) -> Fraction:
    """How far pixel (x, y) lies above the line (right of a steep one), along the axis the line grows less in.

    Exact. A line without length is its one point; the offset is then the larger of the two differences.
    """
    dx, dy = x1 - x0, y1 - y0
    if dx == 0 and dy == 0:
        return Fraction(max(x - x0, y - y0, key=abs))
    if abs(dx) >= abs(dy):
        return Fraction(y - y0) - Fraction(dy * (x - x0), dx)
    return Fraction(x - x0) - Fraction(dx * (y - y0), dy)


def line_tie(x0: int, y0: int, x1: int, y1: int, x: int, y: int) -> bool:
    """Whether the line passes exactly half way between pixel (x, y) and its neighbour across the line."""
    dx, dy = x1 - x0, y1 - y0
    return max(abs(dx), abs(dy)) > 0 and 2 * abs(dx * (y - y0) - dy * (x - x0)) == max(abs(dx), abs(dy))


def line_distance(x0: float, y0: float, x1: float, y1: float, points: Points) -> Points:
    """Distance of each of ``points`` (n, 2) from the straight line, positive above it, to the left when it is
    upright; from the point when the line has no length."""
    dx, dy = x1 - x0, y1 - y0
    offset = points - np.array([x0, y0], np.float64)
    length = float(np.hypot(dx, dy))
    if length == 0.0:
        return np.hypot(offset[:, 0], offset[:, 1])
    upwards = 1.0 if dx > 0 or (dx == 0 and dy > 0) else -1.0
    distance: Points = upwards * (dx * offset[:, 1] - dy * offset[:, 0]) / length
    return distance


def polyline_distance(points: Points, x: float, y: float) -> float:
    """Distance of (x, y) from the polyline through ``points`` (n, 2); infinite without two of them."""
    start, along = points[:-1], np.diff(points, axis=0)
    towards = np.array([x, y]) - start
    square = np.maximum((along**2).sum(axis=1), 1e-300)
    share = np.clip((towards * along).sum(axis=1) / square, 0.0, 1.0)
    away = towards - share[:, None] * along
    return float(np.hypot(away[:, 0], away[:, 1]).min(initial=np.inf))


def circle_distance(xc: float, yc: float, r: float, points: Points) -> Points:
    """Distance of each of ``points`` (n, 2) from the circle, positive outside."""
    distance: Points = np.hypot(points[:, 0] - xc, points[:, 1] - yc) - r
    return distance


def ellipse_distance(xc: float, yc: float, rx: float, ry: float, points: Points) -> Points:
    """Distance of each of ``points`` (n, 2) from the ellipse, positive outside.

    The nearest point in the first quadrant is (a^2 u / (t + a^2), b^2 v / (t + b^2)) for the one t > -b^2 at
    which it lies on the ellipse (a >= b); t is found by halving, which cannot leave its interval.
    Source: D. Eberly, Distance from a Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid.
    """
    u, v = np.abs(points[:, 0] - xc), np.abs(points[:, 1] - yc)
    a, b = float(rx), float(ry)
    if a < b:
        a, b, u, v = b, a, v, u
    if b == 0.0:
        flat: Points = np.hypot(np.maximum(u - a, 0.0), v)
        return flat
    low = b * v - b * b
    high = np.hypot(a * u, b * v) - b * b
    for _halving in range(_HALVINGS):
        t = 0.5 * (low + high)
        with np.errstate(divide="ignore", invalid="ignore"):
            first = np.where(u > 0, a * u / (t + a * a), 0.0)
            second = np.where(v > 0, b * v / (t + b * b), 0.0)
        beyond = first * first + second * second > 1.0
        low, high = np.where(beyond, t, low), np.where(beyond, high, t)
    t = 0.5 * (low + high)
    with np.errstate(divide="ignore", invalid="ignore"):
        near_u = np.where(u > 0, a * a * u / (t + a * a), 0.0)
        near_v = np.where(v > 0, b * b * v / (t + b * b), 0.0)
    # On the long axis, near the centre, the nearest point leaves the axis: t would be -b^2.
    inner = (v == 0) & (a * u < a * a - b * b)
    if a > b:
        near_u = np.where(inner, a * a * u / (a * a - b * b), near_u)
    near_v = np.where(v == 0, 0.0, near_v)
    share = np.clip(1.0 - (near_u / a) ** 2, 0.0, 1.0)
    near_v = np.where(inner | ((v == 0) & (u == 0)), b * np.sqrt(share), near_v)
    distance = np.hypot(u - near_u, v - near_v)
    outside = (u / a) ** 2 + (v / b) ** 2 >= 1.0
    signed: Points = np.where(outside, distance, -distance)
    return signed
