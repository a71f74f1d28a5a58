"""The basis functions of B-splines, and the points of B-splines and NURBS that they add up to.

A knot span i is t_i <= u < t_{i+1}; at the end of the curve the last span that is not empty is taken.
Every function here takes one u or an array of them. Points may have any number of coordinates.
Source: Piegl and Tiller, The NURBS Book, algorithms A2.1, A2.2 and A4.1; Cox, de Boor, 1972.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse

Array = NDArray[np.float64]


def knot_spans(knots: ArrayLike, degree: int, u: ArrayLike) -> NDArray[np.int64]:
    """The knot span of each u (...,), between ``degree`` and the last one, never an empty one.

    Raises: ValueError when a u lies outside the curve.
    """
    t, where = np.asarray(knots, float), np.asarray(u, float)
    count = len(t) - degree - 1
    inside = (where >= t[degree]) & (where <= t[count])
    if not inside.all():
        sentence = f"u = {where[~inside].flat[0]:g} is outside the curve, {t[degree]:g} to {t[count]:g}"
        raise ValueError(f"{sentence}; choose it inside.")
    last = int(np.searchsorted(t, t[count], side="left")) - 1
    spans: NDArray[np.int64] = np.minimum(np.searchsorted(t, where, side="right") - 1, last)
    return spans


def basis_functions(
    knots: ArrayLike, degree: int, u: ArrayLike, weights: ArrayLike | None = None
) -> tuple[NDArray[np.int64], Array]:
    """The knot span of each u, and the values of the degree + 1 basis functions that are not 0 there.

    Args: knots (m,), degree, u of any shape (...,); ``weights`` (m - degree - 1,) above 0 make the functions
    rational. Returns: spans (...,) and values (..., degree + 1), those of N_{span - degree} to N_{span}. They
    are never negative, and their sum is 1. Raises: ValueError.
    """
    t, where = np.asarray(knots, float), np.asarray(u, float)
    refuse(faults(np.zeros((max(t.size - degree - 1, 0), 1)), t, degree, weights))
    spans = knot_spans(t, degree, where)
    values = np.zeros((*where.shape, degree + 1))
    values[..., 0] = 1.0
    for p in range(1, degree + 1):
        saved = np.zeros(where.shape)
        for j in range(p):
            right = t[spans + j + 1]
            left = t[spans + j + 1 - p]
            part = values[..., j] / (right - left)
            values[..., j] = saved + (right - where) * part
            saved = (where - left) * part
        values[..., p] = saved
    if weights is not None:
        values *= np.asarray(weights, float)[_numbers(spans, degree)]
        values /= values.sum(axis=-1, keepdims=True)
    return spans, values


def _numbers(spans: NDArray[np.int64], degree: int) -> NDArray[np.int64]:
    """The numbers (..., degree + 1) of the points that matter in each span."""
    return spans[..., None] + np.arange(-degree, 1)


def basis_table(knots: ArrayLike, degree: int, u: ArrayLike, weights: ArrayLike | None = None) -> Array:
    """Every basis function at each u, for plotting: (..., number of points)."""
    spans, values = basis_functions(knots, degree, u, weights)
    table = np.zeros((*spans.shape, np.size(knots) - degree - 1))
    np.put_along_axis(table, _numbers(spans, degree), values, axis=-1)
    return table


def b_spline_point(points: ArrayLike, knots: ArrayLike, degree: int, u: ArrayLike) -> Array:
    """The points of a B-spline at each u: (..., k) for points (n, k). Raises: ValueError."""
    return _point(points, knots, degree, u, None)


def nurbs_point(points: ArrayLike, weights: ArrayLike, knots: ArrayLike, degree: int, u: ArrayLike) -> Array:
    """The points of a rational B-spline at each u: every control point pulls as much as its weight says.

    Args: points (n, k), weights (n,) above 0, knots (n + degree + 1,), u (...,). Returns: (..., k).
    Raises: ValueError for a weight that is not positive, knots that decrease, too few points.
    """
    return _point(points, knots, degree, u, weights)


def _point(
    points: ArrayLike, knots: ArrayLike, degree: int, u: ArrayLike, weights: ArrayLike | None
) -> Array:
    """What the control points add up to, each times its basis function."""
    controls = np.asarray(points, float)
    refuse(faults(controls, knots, degree, weights))
    spans, values = basis_functions(knots, degree, u, weights)
    total: Array = (values[..., None] * controls[_numbers(spans, degree)]).sum(axis=-2)
    return total
