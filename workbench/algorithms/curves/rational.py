"""Rational curves as curves of one dimension more: (w x, w y, w), projected back by dividing by w.

Knots are put in, degrees raised and pieces cut in homogeneous points, by what serves plain curves.
Source: Piegl and Tiller, The NURBS Book, sections 4.2 and 7.5.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.algorithms.curves.conditions import faults, refuse

Array = NDArray[np.float64]


class Nurbs(NamedTuple):
    """A rational B-spline: points (n, k), weights (n,), knots (n + degree + 1,), degree."""

    points: Array
    weights: Array
    knots: Array
    degree: int


def homogeneous(points: ArrayLike, weights: ArrayLike) -> Array:
    """The points (n, k+1) of the curve before projection. Raises: ValueError for weights not above 0."""
    refuse(faults(points, weights=weights, least=1))
    pulls = np.asarray(weights, float)[:, None]
    return np.hstack([np.asarray(points, float) * pulls, pulls])


def projected(points: ArrayLike) -> tuple[Array, Array]:
    """Points (..., k) and weights (...,) from homogeneous ones (..., k+1)."""
    whole = np.asarray(points, float)
    return whole[..., :-1] / whole[..., -1:], whole[..., -1].copy()


def circle(x: float, y: float, radius: float) -> Nurbs:
    """A whole circle, exact, as four quarters of degree 2 around their square.

    Raises: ValueError for a radius that is not above 0.
    """
    if not (radius > 0 and math.isfinite(x + y + radius)):
        raise ValueError(f"The radius is {radius:g}; choose a finite one above 0.")
    round_it = np.array([[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]], float)
    weights = np.array([1.0, math.sqrt(0.5)] * 4 + [1.0])
    knots = np.array([0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], float)
    return Nurbs(np.array([x, y]) + radius * round_it, weights, knots, 2)
