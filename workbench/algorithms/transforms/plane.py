"""The transformations of the plane as matrices.

All are (3, 3) float64, homogeneous, for points as columns: the matrix stands to the left of the point. Angles
are radians, counter-clockwise positive; quarter turns are exact.
"""

import numpy as np

from workbench.algorithms.transforms.chain import Matrix
from workbench.geometry.angles import cosine_and_sine


def translation(tx: float, ty: float) -> Matrix:
    """x' = x + tx, y' = y + ty."""
    return _affine((1, 0, tx), (0, 1, ty))


def rotation(theta: float) -> Matrix:
    """By ``theta`` about the origin."""
    cos, sin = cosine_and_sine(theta)
    return _affine((cos, -sin, 0), (sin, cos, 0))


def rotation_about(theta: float, xp: float, yp: float) -> Matrix:
    """By ``theta`` about the pivot (xp, yp): T(xp, yp) R(theta) T(-xp, -yp), multiplied out."""
    cos, sin = cosine_and_sine(theta)
    return _affine((cos, -sin, xp * (1 - cos) + yp * sin), (sin, cos, yp * (1 - cos) - xp * sin))


def scaling(sx: float, sy: float) -> Matrix:
    """x' = sx x, y' = sy y: the origin stays."""
    return _affine((sx, 0, 0), (0, sy, 0))


def scaling_about(sx: float, sy: float, xp: float, yp: float) -> Matrix:
    """The same with the fixed point (xp, yp): T(xp, yp) S(sx, sy) T(-xp, -yp), multiplied out."""
    return _affine((sx, 0, xp * (1 - sx)), (0, sy, yp * (1 - sy)))


def reflection(x: float, y: float, angle: float) -> Matrix:
    """In the line through (x, y) that makes ``angle`` with the x axis.

    That line turned into the x axis, y turned to -y, and all back, multiplied out.
    """
    cos, sin = cosine_and_sine(2 * angle)
    return _affine((cos, sin, x * (1 - cos) - y * sin), (sin, -cos, y * (1 + cos) - x * sin))


def shear(sh_x: float, sh_y: float, x_ref: float = 0.0, y_ref: float = 0.0) -> Matrix:
    """x' = x + sh_x (y - y_ref), y' = y + sh_y (x - x_ref)."""
    return _affine((1, sh_x, -sh_x * y_ref), (sh_y, 1, -sh_y * x_ref))


def _affine(first: tuple[float, float, float], second: tuple[float, float, float]) -> Matrix:
    """The matrix with these rows and 0 0 1, no zero of it negative."""
    return np.array([first, second, (0, 0, 1)], np.float64) + 0.0
