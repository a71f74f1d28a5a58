"""Curvature of plane curves in pieces: how much the direction turns along a length, and what shows it.

Counter-clockwise turns are positive. Where a curve stands still, at a cusp or with control points in one
place, it has no curvature, and nan says so.
Source: Farin, Curves and Surfaces for CAGD, chapter 10.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.derivatives import local_derivatives
from workbench.geometry.curves.pieces import Pieces, located, with_length

Array = NDArray[np.float64]

# Of the largest coordinate: what rounding alone may make of a speed that is 0
_STILL = 2.0**-48


def curvature(pieces: Pieces, u: ArrayLike) -> Array:
    """The signed curvature at each u (...,), of pieces in the plane; nan where the curve stands still."""
    return _bend_at(pieces, u)[2]


def curvature_comb(pieces: Pieces, per_piece: int = 16, scale: float = 1.0) -> Array:
    """The teeth of the comb, (m, per_piece + 1, 2, 2): for each piece with a length the begin and the end of
    each tooth, both of its own ends among them, at equal steps of u.

    A tooth stands across the curve, away from the centre of curvature, ``scale`` times the curvature long. It
    has no length where the curve stands still. Raises: ValueError for fewer than one tooth a piece.
    """
    if per_piece < 1:
        raise ValueError(f"There are {per_piece} teeth for each piece; ask for 1 or more.")
    _knots, controls, weights = with_length(pieces)
    v = np.linspace(0.0, 1.0, per_piece + 1)
    pulls = None if weights is None else weights[:, None]
    points, direction, bend = _bend(controls[:, None], pulls, v)
    across = np.stack([direction[..., 1], -direction[..., 0]], axis=-1)
    teeth = np.where(np.isfinite(bend), bend, 0.0)[..., None] * across * scale
    return np.stack([points, points + teeth], axis=-2)


def osculating_circle(pieces: Pieces, u: float) -> tuple[Array, float]:
    """Centre (2,) and radius of the circle that touches the curve most closely at u.

    A straight place has no centre (nan) and an infinite radius; a place where the curve stands still has
    neither (nan).
    """
    point, direction, bend = _bend_at(pieces, u)
    if not np.abs(bend) > 0.0:
        return np.full(2, np.nan), float("inf") if bend == 0.0 else float("nan")
    radius = 1.0 / float(bend)
    return point + radius * np.array([-direction[1], direction[0]]), abs(radius)


def _bend_at(pieces: Pieces, u: ArrayLike) -> tuple[Array, Array, Array]:
    """As ``_bend``, at each u (...,)."""
    number, v, _length = located(pieces.knots, u)
    weights = None if pieces.weights is None else pieces.weights[number]
    return _bend(pieces.controls[number], weights, v)


def _bend(controls: Array, weights: Array | None, v: Array) -> tuple[Array, Array, Array]:
    """Points (..., 2), unit tangents (..., 2) and signed curvatures (...,), nan where there are none."""
    point, first, second = local_derivatives(controls, weights, v, 2)
    speed = np.hypot(first[..., 0], first[..., 1])
    still = speed <= _STILL * np.abs(controls).max(axis=(-2, -1))
    safe = np.where(still, 1.0, speed)[..., None]
    direction = np.where(still[..., None], 0.0, first / safe)
    turn = direction[..., 0] * second[..., 1] - direction[..., 1] * second[..., 0]
    return point, direction, np.where(still, np.nan, turn / safe[..., 0] ** 2)
