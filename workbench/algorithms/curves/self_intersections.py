"""Where a plane curve in pieces crosses or touches itself.

The curve is parted where it is level or upright. Each part then goes one way in x and in y, so that it cannot
meet itself, and its box is that of its ends; two parts whose boxes overlap are halved until they are tiny.
Source: Koparkar and Mudur, A new class of algorithms for the processing of parametric curves, 1983.
"""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves.derivatives import derivatives_within
from workbench.algorithms.curves.extrema import meets_itself
from workbench.algorithms.curves.halving import lengths
from workbench.algorithms.curves.one_way_parts import Parts, closed_in, one_way_parts, overlapping
from workbench.algorithms.curves.pieces import Pieces, piece_points, with_length
from workbench.algorithms.curves.refusals import refuse_tolerance

Array = NDArray[np.float64]
Crossing = tuple[float, float, Array]

_AT_ONCE = 512
# Of a piece: crossings nearer to each other than that are one, if they are in one place too
_APART = 0.01
_SLACK = 1e-6


def self_intersections(pieces: Pieces, tolerance: float, most: int = 1000) -> list[Crossing]:
    """Each pair of u < v at which the curve is in one place, within ``tolerance``, and that place (2,).

    In the order of u, and no more than ``most``: as many of them mean that there may be more, as where a
    curve runs along itself. The closing point of a closed curve is none.
    Raises: ValueError for a tolerance that is not above 0.
    """
    refuse_tolerance(tolerance)
    kept = with_length(pieces)
    parts = one_way_parts(kept)
    first, second = overlapping(parts, tolerance)
    found: list[Crossing] = []
    short = float(np.diff(kept.knots).min())
    for k in range(0, len(first), _AT_ONCE):
        some = slice(k, k + _AT_ONCE)
        one, other = closed_in(kept, parts.taken(first[some]), parts.taken(second[some]), tolerance)
        found = _different(found + _refined(kept, one, other, tolerance), tolerance, short)
        if len(found) >= most:
            break
    return found[:most]


def _refined(pieces: Pieces, one: Parts, other: Parts, tolerance: float) -> list[Crossing]:
    """The crossings in pairs of tiny parts, by Newton's steps; those that are none left out."""
    v, w = 0.5 * (one.low + one.high), 0.5 * (other.low + other.high)
    for _step in range(4):
        p, dp = derivatives_within(pieces, one.piece, v, 1)
        q, dq = derivatives_within(pieces, other.piece, w, 1)
        away = q - p
        area = dp[:, 1] * dq[:, 0] - dp[:, 0] * dq[:, 1]
        sure = np.abs(area) > 1e-9 * lengths(dp) * lengths(dq)
        safe = np.where(sure, area, 1.0)
        dv = np.where(sure, (away[:, 1] * dq[:, 0] - away[:, 0] * dq[:, 1]) / safe, 0.0)
        dw = np.where(sure, (dp[:, 0] * away[:, 1] - dp[:, 1] * away[:, 0]) / safe, 0.0)
        v = np.clip(v + dv, np.maximum(one.low - _SLACK, 0.0), np.minimum(one.high + _SLACK, 1.0))
        w = np.clip(w + dw, np.maximum(other.low - _SLACK, 0.0), np.minimum(other.high + _SLACK, 1.0))
    (p,), (q,) = derivatives_within(pieces, one.piece, v, 0), derivatives_within(pieces, other.piece, w, 0)
    u0, u1 = pieces.u_at(one.piece, v), pieces.u_at(other.piece, w)
    points, away = 0.5 * (p + q), lengths(p - q)
    # What only comes near must do so beyond a turn: at a cusp both branches are near each other for a while
    size = float(np.abs(pieces.controls).max())
    far = np.where(away <= 1e-3 * tolerance, 4.0 * tolerance, np.sqrt(tolerance * size) + 4.0 * tolerance)
    kept = (away <= tolerance) & (u0 < u1) & _leaves(pieces, u0, u1, points, far)
    if meets_itself(pieces):
        first, last = (np.full(len(u0), pieces.knots[end]) for end in (0, -1))
        kept &= _leaves(pieces, first, u0, points, far) | _leaves(pieces, u1, last, points, far)
    return list(zip(u0[kept].tolist(), u1[kept].tolist(), points[kept], strict=True))


def _leaves(pieces: Pieces, u0: Array, u1: Array, points: Array, far: Array) -> NDArray[np.bool_]:
    """Whether the curve from u0 (r,) to u1 (r,) goes farther than that from the points (r, 2)."""
    between = u0[:, None] + (u1 - u0)[:, None] * np.linspace(0.0, 1.0, 9)
    away = lengths(piece_points(pieces, between) - points[:, None])
    return np.asarray(away.max(axis=1) > far)


def _different(found: list[Crossing], tolerance: float, short: float) -> list[Crossing]:
    """The crossings in the order of u, those left out that were found before."""
    kept: list[Crossing] = []
    for u, v, point in sorted(found, key=lambda crossing: crossing[:2]):
        known = False
        for other_u, other_v, other in reversed(kept):
            if u - other_u > _APART * short or known:
                break
            known = abs(v - other_v) <= _APART * short and np.abs(point - other).max() <= 4.0 * tolerance
        if not known:
            kept.append((u, v, point))
    return kept
