"""Where two parts of a curve that go one way in x and in y run along each other.

What two such parts share begins and ends at ends of theirs, as polynomials that agree on a stretch agree
everywhere; so the ends and a few places between them tell.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.halving import lengths
from workbench.geometry.curves.newton_crossings import Crossing
from workbench.geometry.curves.one_way_parts import Parts
from workbench.geometry.curves.pieces import Pieces, piece_points, points_within

Array = NDArray[np.float64]

_BISECTIONS = 48
_SHARES = np.arange(1, 8)[:, None] / 8.0


class Stretch(NamedTuple):
    """From u[0] to u[1] the curve is where it is from v[0] to v[1], which may run down."""

    u: tuple[float, float]
    v: tuple[float, float]


def stretches_of(
    pieces: Pieces, one: Parts, other: Parts, tolerance: float
) -> tuple[NDArray[np.bool_], list[Stretch]]:
    """Which pairs of parts (r,) share a stretch, and these."""
    shared = shared_stretches(pieces, one, other, tolerance)
    along = ~np.isnan(shared[:, 0])
    rows = np.stack([one.piece, one.piece, other.piece, other.piece], axis=1)[along]
    ends = pieces.u_at(rows, shared[along])
    return along, [Stretch((u0, u1), (v0, v1)) for u0, u1, v0, v1 in ends.tolist()]


def each_once(pieces: Pieces, parts: Parts, tolerance: float) -> tuple[Parts, list[Stretch]]:
    """The parts without those that lie whole on an earlier one, and the stretches on which they do."""
    middle = piece_points(pieces, pieces.u_at(parts.piece, 0.5 * (parts.low + parts.high)))
    turned = (parts.begin[:, 0] > parts.end[:, 0]) | (
        (parts.begin[:, 0] == parts.end[:, 0]) & (parts.begin[:, 1] > parts.end[:, 1])
    )
    ends = np.where(turned[:, None], np.hstack([parts.end, parts.begin]), np.hstack([parts.begin, parts.end]))
    key = np.round(np.hstack([ends, middle]) / (8.0 * tolerance))
    _keys, first, group = np.unique(key, axis=0, return_index=True, return_inverse=True)
    again = np.flatnonzero(first[group.ravel()] != np.arange(len(key)))
    along, stretches = stretches_of(
        pieces, parts.taken(first[group.ravel()[again]]), parts.taken(again), tolerance
    )
    return parts.taken(~np.isin(np.arange(len(key)), again[along])), stretches


def joined_stretches(stretches: list[Stretch], apart: float) -> list[Stretch]:
    """The stretches in the order of u, those in one that go on from each other."""
    kept: list[Stretch] = []
    for each in sorted(stretches):
        for k, other in enumerate(kept):
            onward = (other.v[0] < other.v[1]) == (each.v[0] < each.v[1])
            if onward and max(abs(other.u[1] - each.u[0]), abs(other.v[1] - each.v[0])) <= apart:
                kept[k] = Stretch((other.u[0], each.u[1]), (other.v[0], each.v[1]))
                break
        else:
            kept.append(each)
    return kept


def beside_stretches(crossings: list[Crossing], stretches: list[Stretch], slack: float) -> list[Crossing]:
    """The crossings that are no part of a stretch of two parts, nor its end; those meet nowhere else."""
    if not crossings or not stretches:
        return crossings
    at = np.array([crossing[:2] for crossing in crossings])[:, None]
    along = np.sort(np.array(stretches), axis=-1)
    inside = (along[..., 0] - slack <= at) & (at <= along[..., 1] + slack)
    beside = ~inside.all(axis=-1).any(axis=-1)
    return [crossings[k] for k in np.flatnonzero(beside)]


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
