"""Where two parts of a curve that go one way in x and in y run along each other.

What two such parts share begins and ends at ends of theirs, as polynomials that agree on a stretch agree
everywhere; so the ends and a few places between them tell.
"""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves.halving import lengths
from workbench.algorithms.curves.one_way_parts import Parts
from workbench.algorithms.curves.pieces import Pieces, points_within

Array = NDArray[np.float64]

_BISECTIONS = 48
_SHARES = np.arange(1, 8)[:, None] / 8.0


def shared_stretches(pieces: Pieces, one: Parts, other: Parts, tolerance: float) -> Array:
    """For pairs of parts (r,) the stretch on which they are within the tolerance, (r, 4).

    From the first v to the second in the one, from the third to the fourth in the other; NaN where it is no
    longer than a touch.
    """
    on_one = opposite(pieces, one, np.stack([other.begin, other.end]))[0]
    on_other = opposite(pieces, other, np.stack([one.begin, one.end]))[0]
    v, w = np.stack([one.low, one.high, *on_one]), np.stack([*on_other, other.low, other.high])
    here, there = points_within(pieces, one.piece, v), points_within(pieces, other.piece, w)
    near = lengths(here - there) <= tolerance
    pair = np.arange(len(one.low))
    first, last = np.where(near, v, np.inf).argmin(axis=0), np.where(near, v, -np.inf).argmax(axis=0)
    shared = near.any(axis=0) & (lengths(here[last, pair] - here[first, pair]) > 8.0 * tolerance)
    stretches = np.stack([v[first, pair], v[last, pair], w[first, pair], w[last, pair]], axis=1)
    if shared.any():
        between = (1.0 - _SHARES) * stretches[:, 0] + _SHARES * stretches[:, 1]
        off = opposite(pieces, other, points_within(pieces, one.piece, between))[1]
        shared &= (off <= tolerance).all(axis=0)
    return np.where(shared[:, None], stretches, np.nan)


def opposite(pieces: Pieces, parts: Parts, points: Array) -> tuple[Array, Array]:
    """Where each part (r,) passes points (k, r, 2), along the diagonal it goes: v, and how far off (k, r)."""
    way = np.sign(parts.end - parts.begin)
    goal = (way * points).sum(axis=-1)
    low, high = (np.broadcast_to(ends, goal.shape) for ends in (parts.low, parts.high))
    for _step in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        before = (way * points_within(pieces, parts.piece, middle)).sum(axis=-1) < goal
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    return high, lengths(points_within(pieces, parts.piece, high) - points)
