"""A degree taken away from a curve, with the error stated.

Source: Lutterkort, Peters and Reif, Polynomial degree reduction in the L2-norm equals best Euclidean
approximation of Bézier coefficients, 1999; here with both ends kept.
"""

from math import comb

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.basis_functions import basis_table
from workbench.geometry.curves.bernstein import elevate_degree
from workbench.geometry.curves.blossom import b_spline_to_bezier
from workbench.geometry.curves.conditions import faults, refuse
from workbench.geometry.curves.halving import halves, lengths, product

Array = NDArray[np.float64]

_HALVINGS = 5  # the control points of pieces a 32nd as long are off by a thousandth of that


def lower_degree(points: ArrayLike) -> tuple[Array, float]:
    """Control points (n, k) of the curve one degree lower that keeps the ends, for a Bézier curve (n+1, k).

    Of all such curves, the one whose control points, raised again, are nearest to the given ones. Returns
    with it a bound on the distance at any u: at most a thousandth too large, 0 but for rounding if the curve
    was of the lower degree. Raises: ValueError for fewer than three points.
    """
    controls = np.asarray(points, float)
    refuse(faults(controls, least=3))
    degree = len(controls) - 1
    # Only the last difference keeps it from the lower degree; it is spread over the inner points.
    signs = np.array([(-1.0) ** i * comb(degree, i) for i in range(degree + 1)])
    inner = np.where((np.arange(degree + 1) % degree) > 0, signs, 0.0)
    near = controls - np.outer(inner / (inner @ inner), signs @ controls)
    lowered = _unraised(near)
    return lowered, _largest((controls - elevate_degree(lowered))[None])


def lower_b_spline(points: ArrayLike, knots: ArrayLike, degree: int) -> tuple[Array, Array, float]:
    """Points, knots and error of the B-spline one degree lower over the same part of the parameter.

    Each knot between the ends is repeated once less, but stays; so of a curve that was raised nothing is
    lost. The points are the best in the sense of least squares, with ends that are reached kept. The error
    is a bound on the distance at any u. Raises: ValueError, also for degree 1.
    """
    controls, t = np.asarray(points, float), np.asarray(knots, float)
    refuse(faults(controls, t, degree))
    if degree < 2:
        raise ValueError("The curve has degree 1, the lowest; it stays as it is.")
    fewer, lower = _fewer_knots(t, degree), degree - 1
    pieces = b_spline_to_bezier(controls, t, degree)
    nodes = 0.5 - 0.5 * np.cos(np.pi * np.arange(2 * degree + 1) / (2 * degree))
    us = (pieces.knots[:-1, None] + np.diff(pieces.knots)[:, None] * nodes).ravel()
    us = np.minimum(us, pieces.knots[-1])
    basis = basis_table(fewer, lower, us)
    sampled = basis_table(t, degree, us) @ controls
    free = np.ones(basis.shape[1], bool)
    found = np.zeros((basis.shape[1], controls.shape[1]))
    for end, at in ((0, 0), (-1, -1)):
        if np.isclose(basis[at, end], 1.0, rtol=0, atol=1e-12):
            found[end], free[end] = sampled[at], False
    if free.any():
        rest = sampled - basis[:, ~free] @ found[~free]
        found[free] = np.linalg.lstsq(basis[:, free], rest, rcond=None)[0]
    lowered = b_spline_to_bezier(found, fewer, lower)
    apart = pieces.controls - product(lowered.controls, np.ones((len(lowered.controls), 2, 1)))
    return found, fewer, _largest(apart)


def _fewer_knots(knots: Array, degree: int) -> Array:
    """The knots without the outer two, each between the ends of the curve once less, but once at least."""
    values, counts = np.unique(knots[1:-1], return_counts=True)
    inside = (values > knots[degree]) & (values < knots[len(knots) - degree - 1])
    repeated: Array = np.repeat(values, np.where(inside, np.maximum(counts - 1, 1), counts))
    return repeated


def _unraised(raised: Array) -> Array:
    """What ``elevate_degree`` makes ``raised`` of; from both ends to the middle: rounding grows least."""
    degree = len(raised) - 1
    lowered = np.empty((degree, raised.shape[1]))
    lowered[0], lowered[-1] = raised[0], raised[-1]
    for i in range(1, (degree + 1) // 2):
        lowered[i] = (degree * raised[i] - i * lowered[i - 1]) / (degree - i)
    for i in range(degree - 1, (degree + 1) // 2, -1):
        lowered[i - 1] = (degree * raised[i] - (degree - i) * lowered[i]) / i
    return lowered


def _largest(pieces: Array) -> float:
    """A bound on how far curves with control points (m, n+1, k) get from 0."""
    for _halving in range(_HALVINGS):
        pieces = halves(pieces)
    return float(lengths(pieces).max())
