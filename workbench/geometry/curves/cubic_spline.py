"""Cubic splines through all points, smooth to the second derivative: natural, clamped and periodic.

The unknowns are the tangents m_i. That the second derivatives agree at point i is the equation
h_i m_{i-1} + 2 (h_{i-1} + h_i) m_i + h_{i-1} m_{i+1} = 3 (h_i s_{i-1} + h_{i-1} s_i), where h_i is the length
of piece i in u and s_i = (P_{i+1} - P_i) / h_i. One equation for each end completes the system.
Source: Hearn and Baker, Computer Graphics, C Version, section 10-7; de Boor, A Practical Guide to Splines,
chapter IV.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse
from workbench.geometry.curves.hermite import hermite_pieces, parameters
from workbench.geometry.curves.pieces import Pieces
from workbench.geometry.curves.tridiagonal import solve_cyclic, solve_tridiagonal

Array = NDArray[np.float64]


def natural_cubic(points: ArrayLike, knots: ArrayLike | None = None) -> Pieces:
    """The cubic spline through points (n, k) whose second derivative is 0 at both ends.

    Args: knots (n,): the parameter at each point, strictly ascending; 0, 1, 2 and so on if none are given.
    Raises: ValueError for fewer than two points, or knots that do not ascend.
    """
    through, t = _checked(points, knots, 2)
    lower, diagonal, upper, right = _inner_equations(through, t)
    slope = np.diff(through, axis=0) / np.diff(t)[:, None]
    diagonal[[0, -1]], upper[0], lower[-1] = 2.0, 1.0, 1.0
    right[0], right[-1] = 3.0 * slope[0], 3.0 * slope[-1]
    return _with_tangents(through, t, solve_tridiagonal(lower, diagonal, upper, right))


def clamped_cubic(
    points: ArrayLike, first: ArrayLike, last: ArrayLike, knots: ArrayLike | None = None
) -> Pieces:
    """As ``natural_cubic``, with given tangents ``first`` and ``last`` (k,) at the ends instead."""
    through, t = _checked(points, knots, 2)
    lower, diagonal, upper, right = _inner_equations(through, t)
    diagonal[[0, -1]], upper[0], lower[-1] = 1.0, 0.0, 0.0
    right[0], right[-1] = np.asarray(first, float), np.asarray(last, float)
    return _with_tangents(through, t, solve_tridiagonal(lower, diagonal, upper, right))


def periodic_cubic(points: ArrayLike, knots: ArrayLike | None = None) -> Pieces:
    """The closed cubic spline through points (n, k), with one more piece back to the first point.

    Args: knots (n+1,): the parameter at each point, and at the first one after going round. Raises:
    ValueError for fewer than three points.
    """
    refuse(faults(points, least=3))
    open_points = np.asarray(points, float)
    through, t = _checked(np.vstack([open_points, open_points[:1]]), knots, 4)
    length = np.diff(t)
    before = np.roll(length, 1)
    slope = np.diff(through, axis=0) / length[:, None]
    right = 3.0 * (length[:, None] * np.roll(slope, 1, axis=0) + before[:, None] * slope)
    tangents = solve_cyclic(length, 2.0 * (before + length), before, right)
    return _with_tangents(through, t, np.vstack([tangents, tangents[:1]]))


def _checked(points: ArrayLike, knots: ArrayLike | None, least: int) -> tuple[Array, Array]:
    refuse(faults(points, least=least))
    through = np.asarray(points, float)
    return through, parameters(len(through), knots, strictly=True)


def _inner_equations(through: Array, t: Array) -> tuple[Array, Array, Array, Array]:
    """The three diagonals and the right sides of the system; the first and last equation are left open."""
    count = len(through)
    length = np.diff(t)
    slope = np.diff(through, axis=0) / length[:, None]
    lower, diagonal, upper, right = np.zeros(count), np.zeros(count), np.zeros(count), np.zeros_like(through)
    lower[1:-1], upper[1:-1] = length[1:], length[:-1]
    diagonal[1:-1] = 2.0 * (length[:-1] + length[1:])
    right[1:-1] = 3.0 * (length[1:, None] * slope[:-1] + length[:-1, None] * slope[1:])
    return lower, diagonal, upper, right


def _with_tangents(through: Array, t: Array, tangents: Array) -> Pieces:
    return hermite_pieces(through, tangents[:-1], tangents[1:], t)
