"""The transformations of the plane as matrices.

All are (3, 3) float64, homogeneous, for points as columns: the matrix stands to the left of the point. Angles
are radians, counter-clockwise positive; quarter turns are exact. Of arrays (n,) instead of numbers each makes
the n matrices (n, 3, 3).
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.transforms.chain import Matrix
from workbench.geometry.angles import cosine_and_sine, cosines_and_sines

Numbers = float | NDArray[np.float64]


def translation(tx: Numbers, ty: Numbers) -> Matrix:
    """x' = x + tx, y' = y + ty."""
    return _affine((1, 0, tx), (0, 1, ty))


def rotation(theta: Numbers) -> Matrix:
    """By ``theta`` about the origin."""
    cos, sin = _cosine_and_sine(theta)
    return _affine((cos, -sin, 0), (sin, cos, 0))


def rotation_about(theta: Numbers, xp: Numbers, yp: Numbers) -> Matrix:
    """By ``theta`` about the pivot (xp, yp): T(xp, yp) R(theta) T(-xp, -yp), multiplied out."""
    cos, sin = _cosine_and_sine(theta)
    return _affine((cos, -sin, xp * (1 - cos) + yp * sin), (sin, cos, yp * (1 - cos) - xp * sin))


def scaling(sx: Numbers, sy: Numbers) -> Matrix:
    """x' = sx x, y' = sy y: the origin stays."""
    return _affine((sx, 0, 0), (0, sy, 0))


def scaling_about(sx: Numbers, sy: Numbers, xp: Numbers, yp: Numbers) -> Matrix:
    """The same with the fixed point (xp, yp): T(xp, yp) S(sx, sy) T(-xp, -yp), multiplied out."""
    return _affine((sx, 0, xp * (1 - sx)), (0, sy, yp * (1 - sy)))


def reflection(x: Numbers, y: Numbers, angle: Numbers) -> Matrix:
    """In the line through (x, y) that makes ``angle`` with the x axis.

    That line turned into the x axis, y turned to -y, and all back, multiplied out.
    """
    cos, sin = _cosine_and_sine(2 * angle)
    return _affine((cos, sin, x * (1 - cos) - y * sin), (sin, -cos, y * (1 + cos) - x * sin))


def shear(sh_x: Numbers, sh_y: Numbers, x_ref: Numbers = 0.0, y_ref: Numbers = 0.0) -> Matrix:
    """x' = x + sh_x (y - y_ref), y' = y + sh_y (x - x_ref)."""
    return _affine((1, sh_x, -sh_x * y_ref), (sh_y, 1, -sh_y * x_ref))


def _cosine_and_sine(theta: Numbers) -> tuple[Any, Any]:
    return cosines_and_sines(theta) if isinstance(theta, np.ndarray) else cosine_and_sine(theta)


def _affine(first: tuple[Any, Any, Any], second: tuple[Any, Any, Any]) -> Matrix:
    """The matrix, or matrices, with these rows and 0 0 1, no zero of it negative."""
    many = next((entry for entry in (*first, *second) if isinstance(entry, np.ndarray)), None)
    if many is None:
        return np.array([first, second, (0, 0, 1)], np.float64) + 0.0
    matrices = np.zeros((len(many), 3, 3))
    for row, entries in enumerate((first, second)):
        for column, entry in enumerate(entries):
            matrices[:, row, column] = entry
    matrices[:, 2, 2] = 1.0
    return matrices + 0.0
