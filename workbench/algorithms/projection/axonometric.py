"""Axonometric projections of world coordinates: orthographic ones that show three sides at once.

The object is turned about the y axis, then about the x axis, and seen along the world's -z. The result is in
view coordinates: x right, y up, and z, which the picture takes no notice of, into the picture.

f_x, f_y, f_z   foreshortenings: how long a unit along each world axis is in the picture; the sum of their
                squares is 2
"""

import math

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]

_CRUMB = 1e-12


def axonometric(angle_y: float, angle_x: float) -> Matrix:
    """Turn by ``angle_y`` about the y axis, by ``angle_x`` about the x axis, then look along -z.

    Args: radians, counter-clockwise positive. Returns: (4, 4), homogeneous, from world coordinates, points
    as columns. Source: Rogers and Adams, Mathematical Elements for Computer Graphics, chapter 3.
    """
    cos_y, sin_y = math.cos(angle_y), math.sin(angle_y)
    cos_x, sin_x = math.cos(angle_x), math.sin(angle_x)
    about_y = np.array([[cos_y, 0, sin_y, 0], [0, 1, 0, 0], [-sin_y, 0, cos_y, 0], [0, 0, 0, 1]])
    about_x = np.array([[1, 0, 0, 0], [0, cos_x, -sin_x, 0], [0, sin_x, cos_x, 0], [0, 0, 0, 1]])
    into_picture = np.diag([1.0, 1.0, -1.0, 1.0])
    return np.asarray(into_picture @ about_x @ about_y)


def isometric() -> Matrix:
    """Seen from (1, 1, 1): all three axes are equally foreshortened, to 0.8165, and 120 degrees apart.

    Returns: (4, 4), homogeneous, from world coordinates, points as columns.
    """
    return axonometric(-math.pi / 4, math.atan(math.sqrt(0.5)))


def dimetric(f_z: float) -> Matrix:
    """Two axes, x and y, equally foreshortened, and z to ``f_z``; an engineer's dimetric has f_z = 1/2.

    Args: 0 to 1. Returns: (4, 4), homogeneous, from world coordinates, points as columns. Raises: ValueError
    for any other ``f_z``.
    """
    if not 0.0 <= f_z <= 1.0:
        raise ValueError(f"The z axis cannot be foreshortened to {f_z:g}; give a number from 0 to 1.")
    f_xy = math.sqrt(1.0 - f_z * f_z / 2.0)
    return trimetric(f_xy, f_xy)


def trimetric(f_x: float, f_y: float) -> Matrix:
    """The x and y axes foreshortened as given, seen from the right and from above.

    Args: each more than 0 and at most 1, the sum of their squares 1 to 2; that of all three is 2. Returns:
    (4, 4), homogeneous, from world coordinates, points as columns. Raises: ValueError for any others.
    """
    together = f_x * f_x + f_y * f_y
    if not (0.0 <= f_x <= 1.0 and 0.0 < f_y <= 1.0 and 1.0 - _CRUMB <= together <= 2.0):
        raise ValueError(
            f"No view foreshortens x to {f_x:g} and y to {f_y:g}: "
            "both must be at most 1, and the sum of their squares 1 to 2."
        )
    return axonometric(-math.asin(min(math.sqrt(1.0 - f_x * f_x) / f_y, 1.0)), math.acos(f_y))
