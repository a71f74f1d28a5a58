"""Bernstein polynomials, and what Bézier curves are made of with them.

Points are (n+1, k) for a curve of degree n, in any number of coordinates.
Source: Hearn and Baker, Computer Graphics, C Version, section 10-8; Farin, Curves and Surfaces for CAGD.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse

Array = NDArray[np.float64]


def bernstein(degree: int, u: ArrayLike) -> Array:
    """The degree + 1 Bernstein polynomials at each u (...,): (..., degree + 1).

    From 0 to 1 they are not negative, and their sum is 1. Raises: ValueError for a negative degree.
    """
    if degree < 0:
        raise ValueError(f"The degree is {degree}; it must be 0 or more.")
    where = np.asarray(u, float)
    values = np.zeros((*where.shape, degree + 1))
    values[..., 0] = 1.0
    for p in range(1, degree + 1):
        saved = np.zeros(where.shape)
        for j in range(p):
            part = values[..., j].copy()
            values[..., j] = saved + (1.0 - where) * part
            saved = where * part
        values[..., p] = saved
    return values


def bezier_point(points: ArrayLike, u: ArrayLike) -> Array:
    """The points of a Bézier curve at each u: (..., k). Raises: ValueError for fewer than two points."""
    controls = _checked(points)
    there: Array = bernstein(len(controls) - 1, u) @ controls
    return there


def subdivide(points: ArrayLike, u: float) -> tuple[Array, Array]:
    """The control points of the two parts of a curve, before and after u, by de Casteljau's construction."""
    level = _checked(points)
    first, second = [level[0]], [level[-1]]
    while len(level) > 1:
        level = (1.0 - u) * level[:-1] + u * level[1:]
        first.append(level[0])
        second.append(level[-1])
    return np.array(first), np.array(second[::-1])


def elevate_degree(points: ArrayLike) -> Array:
    """The control points of the same curve, one degree higher: one more point."""
    controls = _checked(points)
    share = np.arange(len(controls) + 1)[:, None] / len(controls)
    before = np.vstack([controls[:1], controls])
    after = np.vstack([controls, controls[-1:]])
    elevated: Array = share * before + (1.0 - share) * after
    return elevated


def _checked(points: ArrayLike) -> Array:
    refuse(faults(points))
    return np.asarray(points, float)
