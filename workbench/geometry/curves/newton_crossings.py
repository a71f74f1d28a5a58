"""From pairs of small parts of a plane curve to where it crosses or touches itself, by Newton's steps."""

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.derivatives import derivatives_within
from workbench.geometry.curves.extrema import meets_itself
from workbench.geometry.curves.halving import lengths
from workbench.geometry.curves.one_way_parts import Parts
from workbench.geometry.curves.pieces import Pieces, piece_points

Array = NDArray[np.float64]
Crossing = tuple[float, float, Array]

_STEPS = 12
_SLACK = 1e-6


def newton_crossings(pieces: Pieces, one: Parts, other: Parts, tolerance: float) -> list[Crossing]:
    """The crossings in pairs of small parts, by Newton's steps from their middles and their ends; those that
    are none left out."""
    v, w = (np.concatenate([0.5 * (part.low + part.high), part.low, part.high]) for part in (one, other))
    one, other = (part.taken(np.tile(np.arange(len(part.low)), 3)) for part in (one, other))
    best, v_best, w_best = np.full(len(v), np.inf), v, w
    for _step in range(_STEPS):
        p, dp = derivatives_within(pieces, one.piece, v, 1)
        q, dq = derivatives_within(pieces, other.piece, w, 1)
        away = q - p
        nearer = lengths(away) < best
        best = np.where(nearer, lengths(away), best)
        v_best, w_best = np.where(nearer, v, v_best), np.where(nearer, w, w_best)
        area = dp[:, 1] * dq[:, 0] - dp[:, 0] * dq[:, 1]
        sure = np.abs(area) > 1e-9 * lengths(dp) * lengths(dq)
        safe = np.where(sure, area, 1.0)
        dv = np.where(sure, (away[:, 1] * dq[:, 0] - away[:, 0] * dq[:, 1]) / safe, 0.0)
        dw = np.where(sure, (dp[:, 0] * away[:, 1] - dp[:, 1] * away[:, 0]) / safe, 0.0)
        v = np.clip(v + dv, np.maximum(one.low - _SLACK, 0.0), np.minimum(one.high + _SLACK, 1.0))
        w = np.clip(w + dw, np.maximum(other.low - _SLACK, 0.0), np.minimum(other.high + _SLACK, 1.0))
    v, w, away = v_best, w_best, best
    (p,), (q,) = derivatives_within(pieces, one.piece, v, 0), derivatives_within(pieces, other.piece, w, 0)
    u0, u1 = pieces.u_at(one.piece, v), pieces.u_at(other.piece, w)
    points = 0.5 * (p + q)
    # What only comes near must do so beyond a turn: at a cusp both branches are near each other for a while
    size = float(np.abs(pieces.controls).max())
    far = np.where(away <= 1e-3 * tolerance, 4.0 * tolerance, np.sqrt(tolerance * size) + 4.0 * tolerance)
    kept = np.flatnonzero((away <= tolerance) & (u0 < u1))
    kept = kept[_leaves(pieces, u0[kept], u1[kept], points[kept], far[kept])]
    if meets_itself(pieces):
        first, last = (np.full(len(kept), pieces.knots[end]) for end in (0, -1))
        before = _leaves(pieces, first, u0[kept], points[kept], far[kept])
        kept = kept[before | _leaves(pieces, u1[kept], last, points[kept], far[kept])]
    return list(zip(u0[kept].tolist(), u1[kept].tolist(), points[kept], strict=True))


def _leaves(pieces: Pieces, u0: Array, u1: Array, points: Array, far: Array) -> NDArray[np.bool_]:
    """Whether the curve from u0 (r,) to u1 (r,) goes farther than that from the points (r, 2)."""
    between = u0[:, None] + (u1 - u0)[:, None] * np.linspace(0.0, 1.0, 9)
    away = lengths(piece_points(pieces, between) - points[:, None])
    return np.asarray(away.max(axis=1) > far)
