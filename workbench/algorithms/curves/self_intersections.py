"""Where a plane curve in pieces crosses, touches or runs along itself.

The curve is parted where it is level or upright. Each part then goes one way in x and in y, so that it cannot
meet itself, and its box is that of its ends; two parts whose boxes overlap are halved until they are small,
and Newton's steps find the rest of the way. Two parts that stay near each other along many halves are asked
whether they share a stretch, and are then not searched.
Source: Koparkar and Mudur, A new class of algorithms for the processing of parametric curves, 1983.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves.derivatives import derivatives_within
from workbench.algorithms.curves.extrema import meets_itself
from workbench.algorithms.curves.halving import lengths
from workbench.algorithms.curves.one_way_parts import Parts, halved, one_way_parts, overlapping, together
from workbench.algorithms.curves.pieces import Pieces, piece_points, with_length
from workbench.algorithms.curves.refusals import refuse_tolerance
from workbench.algorithms.curves.shared_stretches import shared_stretches

Array = NDArray[np.float64]
Crossing = tuple[float, float, Array]

_AT_ONCE = 128
_HALVINGS = 44
_MOST_PAIRS = 2**13
_SMALL = 2.0**-10  # of the curve's size: from there Newton's steps find the way
# Pairs of halves of one pair of parts: two parts that cross have fewer, and at more they are small enough
_MANY = 48
_ENOUGH = 96
_STEPS = 12
# Of a piece: crossings nearer to each other than that are one, if they are in one place too
_APART = 0.01
# The same, if the curve stays in one place with itself from one to the other
_TOUCH = 0.1
_SLACK = 1e-6


class Stretch(NamedTuple):
    """From u[0] to u[1] the curve is where it is from v[0] to v[1], which may run down."""

    u: tuple[float, float]
    v: tuple[float, float]


def self_intersections(pieces: Pieces, tolerance: float, most: int = 1000) -> list[Crossing]:
    """Each pair of u < v at which the curve is in one place, within ``tolerance``, and that place (2,).

    In the order of u, and no more than ``most``: as many of them mean that there may be more. A touch is one,
    the closing point of a closed curve is none, nor is what lies on a stretch of ``self_overlaps``; where the
    curve repeats whole parts of itself, the first of them stands for all.
    Raises: ValueError for a tolerance that is not above 0.
    """
    return self_meetings(pieces, tolerance, most)[0]


def self_overlaps(pieces: Pieces, tolerance: float, most: int = 1000) -> list[Stretch]:
    """The stretches on which the curve runs along itself, within ``tolerance``; as ``self_intersections``."""
    return self_meetings(pieces, tolerance, most)[1]


def self_meetings(pieces: Pieces, tolerance: float, most: int = 1000) -> tuple[list[Crossing], list[Stretch]]:
    """Both at once: the crossings, and the stretches on which the curve runs along itself."""
    refuse_tolerance(tolerance)
    kept = with_length(pieces)
    parts, stretches = _each_once(kept, one_way_parts(kept), tolerance)
    first, second = overlapping(parts, tolerance)
    crossings: list[Crossing] = []
    alone = len(stretches)
    short = float(np.diff(kept.knots).min())
    for k in range(0, len(first), _AT_ONCE):
        some = slice(k, k + _AT_ONCE)
        one, other, shared = _closed_in(kept, parts.taken(first[some]), parts.taken(second[some]), tolerance)
        stretches += shared
        crossings = _different(kept, crossings + _refined(kept, one, other, tolerance), tolerance, short)
        crossings = _beside(crossings, stretches, _APART * short)
        if len(crossings) + len(stretches) - alone >= most:
            break
    return crossings[:most], _joined(stretches, _APART * short)[:most]


def _each_once(pieces: Pieces, parts: Parts, tolerance: float) -> tuple[Parts, list[Stretch]]:
    """The parts without those that lie whole on an earlier one, and the stretches on which they do."""
    middle = piece_points(pieces, pieces.u_at(parts.piece, 0.5 * (parts.low + parts.high)))
    turned = (parts.begin[:, 0] > parts.end[:, 0]) | (
        (parts.begin[:, 0] == parts.end[:, 0]) & (parts.begin[:, 1] > parts.end[:, 1])
    )
    ends = np.where(turned[:, None], np.hstack([parts.end, parts.begin]), np.hstack([parts.begin, parts.end]))
    key = np.round(np.hstack([ends, middle]) / (8.0 * tolerance))
    _keys, first, group = np.unique(key, axis=0, return_index=True, return_inverse=True)
    again = np.flatnonzero(first[group.ravel()] != np.arange(len(key)))
    along, stretches = _shared(
        pieces, parts.taken(first[group.ravel()[again]]), parts.taken(again), tolerance
    )
    return parts.taken(~np.isin(np.arange(len(key)), again[along])), stretches


def _shared(
    pieces: Pieces, one: Parts, other: Parts, tolerance: float
) -> tuple[NDArray[np.bool_], list[Stretch]]:
    """Which pairs of parts (r,) share a stretch, and these."""
    shared = shared_stretches(pieces, one, other, tolerance)
    along = ~np.isnan(shared[:, 0])
    rows = np.stack([one.piece, one.piece, other.piece, other.piece], axis=1)[along]
    ends = pieces.u_at(rows, shared[along])
    return along, [Stretch((u0, u1), (v0, v1)) for u0, u1, v0, v1 in ends.tolist()]


def _closed_in(
    pieces: Pieces, one: Parts, other: Parts, tolerance: float
) -> tuple[Parts, Parts, list[Stretch]]:
    """Pairs of small parts within the tolerance; those that share a stretch are left out, and it is told."""
    small = max(tolerance, _SMALL * float(np.abs(pieces.controls).max()))
    pair, whole, others = np.arange(len(one.low)), one, other
    asked = np.zeros(len(pair), bool)
    stretches: list[Stretch] = []
    done: list[tuple[Parts, Parts]] = []
    for _halving in range(_HALVINGS):
        large = max(np.abs(part.end - part.begin).max(initial=0.0) for part in (one, other))
        if large <= small or len(pair) > _MOST_PAIRS:
            break
        number, one, other = halved(pieces, one, other, 0.25 * tolerance)
        pair = pair[number]
        many = np.flatnonzero((np.bincount(pair, minlength=len(asked)) > _MANY) & ~asked)
        if len(many):
            asked[many] = True
            both = whole.taken(many), others.taken(many)
            along, shared = _shared(pieces, *both, tolerance)
            stretches += shared
            left = ~np.isin(pair, many[along])
            pair, one, other = pair[left], one.taken(left), other.taken(left)
        enough = np.bincount(pair, minlength=len(asked))[pair] > _ENOUGH
        done.append((one.taken(enough), other.taken(enough)))
        pair, one, other = pair[~enough], one.taken(~enough), other.taken(~enough)
    one, other = (together(side) for side in zip(*done, (one, other), strict=True))
    return one, other, stretches


def _refined(pieces: Pieces, one: Parts, other: Parts, tolerance: float) -> list[Crossing]:
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


def _different(pieces: Pieces, crossings: list[Crossing], tolerance: float, short: float) -> list[Crossing]:
    """The crossings in the order of u, each once, and each touch once."""
    ordered = sorted(crossings, key=lambda crossing: crossing[:2])
    kept: list[Crossing] = []
    for k in np.flatnonzero(~_touching(pieces, ordered, ordered[1:], tolerance, short)):
        u, v, point = ordered[k]
        near = [other for other in kept if max(u - other[0], abs(v - other[1])) <= _TOUCH * short]
        known = any(
            max(u - other_u, abs(v - other_v)) <= _APART * short
            and np.abs(point - other).max() <= 4.0 * tolerance
            for other_u, other_v, other in near
        )
        if not near or not (
            known or _touching(pieces, near, [ordered[k]] * len(near), tolerance, short).any()
        ):
            kept.append(ordered[k])
    return kept


def _touching(
    pieces: Pieces, some: list[Crossing], others: list[Crossing], tolerance: float, short: float
) -> NDArray[np.bool_]:
    """Of each crossing, whether the curve is in one place with itself all the way to the other one."""
    to = np.array([crossing[:2] for crossing in others]).reshape(-1, 2)
    at = np.array([crossing[:2] for crossing in some]).reshape(-1, 2)
    way = to - at[: len(to)]
    touching = np.zeros(len(at), bool)
    near = np.flatnonzero(np.abs(way).max(axis=1, initial=0.0) <= _TOUCH * short)
    u, v = (at[near, None] + way[near, None] * np.linspace(0.0, 1.0, 5)[:, None]).transpose(2, 0, 1)
    touching[near] = lengths(piece_points(pieces, u) - piece_points(pieces, v)).max(axis=1) <= tolerance
    return touching


def _joined(stretches: list[Stretch], apart: float) -> list[Stretch]:
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


def _beside(crossings: list[Crossing], stretches: list[Stretch], slack: float) -> list[Crossing]:
    """The crossings that are no part of a stretch of two parts, nor its end; those meet nowhere else."""
    if not crossings or not stretches:
        return crossings
    at = np.array([crossing[:2] for crossing in crossings])[:, None]
    along = np.sort(np.array(stretches), axis=-1)
    inside = (along[..., 0] - slack <= at) & (at <= along[..., 1] + slack)
    beside = ~inside.all(axis=-1).any(axis=-1)
    return [crossings[k] for k in np.flatnonzero(beside)]
