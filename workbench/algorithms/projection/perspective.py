"""Perspective projections of view coordinates: x right, y up, z into the picture.

d           distance from the centre of projection to the view plane
w           what the division is by; 1 for points on the view plane, 0 in the centre's plane, parallel to it
"""

import math

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]


def perspective(d: float) -> Matrix:
    """The course's matrix: the centre at the origin, the view plane at z = d, w = z/d.

    Every projected point has z = d, so its depth is lost. As d grows without bound w tends to 0: the limit
    divides by zero, and is no parallel projection (``perspective_from_plane`` has one).

    Args: d above 0. Returns: (4, 4), homogeneous, for points as columns. Raises: ValueError unless d > 0.
    Source: Hearn and Baker, Computer Graphics, C Version, section 12-3.
    """
    _check_distance(d)
    return np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1 / d, 0]], np.float64)


def perspective_from_plane(d: float) -> Matrix:
    """The view plane at z = 0, the centre at z = -d, w = 1 + z/d.

    As d grows without bound w tends to 1: the limit is ``orthographic``.

    Args: d above 0. Returns: (4, 4), homogeneous, for points as columns. Raises: ValueError unless d > 0.
    """
    _check_distance(d)
    return np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1 / d, 1]], np.float64)


def perspective_depth(d: float, near: float, far: float) -> Matrix:
    """x and y as in ``perspective``, and a z that grows from 0 at ``near`` to 1 at ``far``.

    That z is linear on the screen: planes stay planes, so it may be stepped by -A/C along a scan line.

    Args: d above 0; depths 0 < near < far. Returns: (4, 4), homogeneous, for points as columns.
    Raises: ValueError for any others. Source: Hearn and Baker, Computer Graphics, C Version, section 12-4.
    """
    _check_distance(d)
    if not (math.isfinite(far) and 0.0 < near < far):
        raise ValueError(f"The near plane is at {near:g} and the far plane at {far:g}; give 0 < near < far.")
    scale = far / ((far - near) * d)
    return np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, scale, -near * scale], [0, 0, 1 / d, 0]], np.float64)


def _check_distance(d: float) -> None:
    if not (math.isfinite(d) and d > 0.0):
        raise ValueError(f"The view plane is {d:g} from the centre of projection; give more than 0.")
