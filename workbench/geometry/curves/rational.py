"""Rational curves as curves of one dimension more: (w x, w y, w), projected back by dividing by w.

Knots are put in, degrees raised and pieces cut in homogeneous points, by what serves plain curves.
Source: Piegl and Tiller, The NURBS Book, sections 4.2 and 7.5.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse

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


def gap_between(points: ArrayLike, others: ArrayLike, rational: bool = False) -> float:
    """How far two curves of points (n, k) over the same knots are apart at most: by hulls, as far as points.

    Those of homogeneous points are ``rational``: |A / w - B / v| is at most
    (|A - B - c (w - v)| + |A / w - c| |w - v|) / v, wherever c is; infinite where a v is not above 0.
    """
    one, other = np.asarray(points, float), np.asarray(others, float)
    if not rational:
        return float(np.linalg.norm(one - other, axis=1).max())
    if other[:, -1].min() <= 0.0:
        return math.inf
    flat, _weights = projected(one)
    centre = flat.mean(axis=0)
    apart = one - other
    aside = np.linalg.norm(apart[:, :-1] - centre * apart[:, -1:], axis=1).max()
    reach = np.linalg.norm(flat - centre, axis=1).max()
    return float((aside + reach * np.abs(apart[:, -1]).max()) / other[:, -1].min())


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
