"""Rational pieces of degree 2, which are arcs of conics, as cubics of the sixth order.

The cubic touches the arc at both ends and in the middle. In the barycentric coordinates t0, t1, t2 of the
triangle of the control points the arc is t1^2 = 4 w^2 t0 t2, and for the cubic the difference of both sides
is a constant times u^2 (1-u)^2 (1-2u)^2. Moved towards the middle control point, the difference changes at
least at the rate 2 min(1, w^2), which bounds how far the arc is away in that direction.
Source: Floater, An O(h^2n) Hermite approximation for conic sections, 1997.
"""

import math

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.bernstein import bernstein
from workbench.geometry.curves.halving import lengths

Array = NDArray[np.float64]

_WORST = 0.5 - 0.5 / math.sqrt(3.0)  # where u (1-u) is 1/6, and the difference is largest


def conic_cubics(whole: Array) -> tuple[Array, Array]:
    """The cubics (m, 4, k) of balanced pieces (m, 3, k+1), and how far at most (m,) each is from its arc."""
    points, w = whole[..., :-1] / whole[..., -1:], whole[:, 1, -1]
    first, middle, last = points[:, 0], points[:, 1], points[:, 2]
    share = 4.0 * w / (3.0 * (1.0 + w))
    leaving, arriving = (end + share[:, None] * (middle - end) for end in (first, last))
    b0, b1, b2, b3 = bernstein(3, _WORST)
    t0, t1, t2 = b0 + (1.0 - share) * b1, share * (b1 + b2), b3 + (1.0 - share) * b2
    differs = np.abs(t1 * t1 - 4.0 * w * w * t0 * t2)
    away = differs / (2.0 * np.minimum(1.0, w * w)) * lengths(middle - 0.5 * (first + last))
    return np.stack([first, leaving, arriving, last], axis=1), away
