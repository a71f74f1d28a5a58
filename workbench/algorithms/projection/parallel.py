"""Parallel projections of view coordinates: x right, y up, z into the picture, the view plane at z = 0.

x and y of the result are those of the projected point. z stays as it was, since hidden surfaces are found by
it; the picture takes no notice of it.

alpha       angle between the projectors and the view plane
phi         direction in which receding lines run in the picture, from its x axis
L1          how long a receding line one unit deep is in the picture: 1 / tan alpha
"""

import math

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]


def orthographic() -> Matrix:
    """Projectors perpendicular to the view plane: x and y stay as they are.

    Returns: (4, 4), homogeneous, for points as columns. Source: Hearn and Baker, section 12-3.
    """
    return np.eye(4)


def oblique(alpha: float, phi: float) -> Matrix:
    """Parallel projectors at an angle of ``alpha`` to the view plane: x + z L1 cos phi, y + z L1 sin phi.

    Args: radians; at alpha = pi/2 it is the orthographic one. Returns: (4, 4), homogeneous, for points as
    columns. Raises: ValueError unless 0 < alpha < pi. Source: Hearn and Baker, section 12-3.
    """
    if not (math.isfinite(phi) and 0.0 < alpha < math.pi):
        raise ValueError(
            f"The projectors' angle is {math.degrees(alpha):g} degrees; it must lie between 0 and 180."
        )
    return _receding(math.cos(alpha) / math.sin(alpha), phi)


def cavalier(phi: float) -> Matrix:
    """The oblique projection with tan alpha = 1: receding lines keep their full length.

    Args: phi in radians, commonly 30 or 45 degrees. Returns: (4, 4), homogeneous, for points as columns.
    """
    return _receding(1.0, phi)


def cabinet(phi: float) -> Matrix:
    """The oblique projection with tan alpha = 2: receding lines keep half of their length.

    Args: phi in radians, commonly 30 or 45 degrees. Returns: (4, 4), homogeneous, for points as columns.
    """
    return _receding(0.5, phi)


def parallel_depth(near: float, far: float) -> Matrix:
    """What stands left of a parallel projection to draw with a depth buffer: z from 0 at ``near`` to 1.

    Args: depths in view coordinates. Returns: (4, 4), homogeneous, x and y kept. Raises: ValueError unless
    near < far.
    """
    if not (math.isfinite(near) and math.isfinite(far) and near < far):
        raise ValueError(f"The near plane is at {near:g} and the far plane at {far:g}; give near < far.")
    matrix = np.eye(4)
    matrix[2] = 0.0, 0.0, 1.0 / (far - near), -near / (far - near)
    return matrix


def _receding(L1: float, phi: float) -> Matrix:
    matrix = np.eye(4)
    matrix[0, 2] = L1 * math.cos(phi)
    matrix[1, 2] = L1 * math.sin(phi)
    return matrix
