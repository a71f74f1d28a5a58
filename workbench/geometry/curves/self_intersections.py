"""Where a plane curve in pieces crosses, touches or runs along itself.

The curve is parted where it is level or upright. Each part then goes one way in x and in y, so that it cannot
meet itself, and its box is that of its ends; two parts whose boxes overlap are halved until they are small,
and Newton's steps find the rest of the way. Two parts that stay near each other along many halves are asked
whether they share a stretch, and are then not searched.
Source: Koparkar and Mudur, A new class of algorithms for the processing of parametric curves, 1983.
"""

import numpy as np

from workbench.geometry.curves.different_crossings import different_crossings
from workbench.geometry.curves.newton_crossings import Crossing, newton_crossings
from workbench.geometry.curves.one_way_parts import Parts, halved, one_way_parts, overlapping, together
from workbench.geometry.curves.pieces import Pieces, with_length
from workbench.geometry.curves.refusals import refuse_tolerance
from workbench.geometry.curves.shared_stretches import (
    Stretch,
    beside_stretches,
    each_once,
    joined_stretches,
    stretches_of,
)

_AT_ONCE = 128
_HALVINGS = 44
_MOST_PAIRS = 2**13
_SMALL = 2.0**-10  # of the curve's size: from there Newton's steps find the way
# Pairs of halves of one pair of parts: two parts that cross have fewer, and at more they are small enough
_MANY = 48
_ENOUGH = 96
# Of the shortest piece: what begins nearer to where another ends goes on from it
_APART = 0.01


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
    parts, stretches = each_once(kept, one_way_parts(kept), tolerance)
    first, second = overlapping(parts, tolerance)
    crossings: list[Crossing] = []
    alone = len(stretches)
    short = float(np.diff(kept.knots).min())
    for k in range(0, len(first), _AT_ONCE):
        some = slice(k, k + _AT_ONCE)
        one, other, shared = _closed_in(kept, parts.taken(first[some]), parts.taken(second[some]), tolerance)
        stretches += shared
        crossings = different_crossings(
            kept, crossings + newton_crossings(kept, one, other, tolerance), tolerance, short
        )
        crossings = beside_stretches(crossings, stretches, _APART * short)
        if len(crossings) + len(stretches) - alone >= most:
            break
    return crossings[:most], joined_stretches(stretches, _APART * short)[:most]


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
            along, shared = stretches_of(pieces, *both, tolerance)
            stretches += shared
            left = ~np.isin(pair, many[along])
            pair, one, other = pair[left], one.taken(left), other.taken(left)
        enough = np.bincount(pair, minlength=len(asked))[pair] > _ENOUGH
        done.append((one.taken(enough), other.taken(enough)))
        pair, one, other = pair[~enough], one.taken(~enough), other.taken(~enough)
    one, other = (together(side) for side in zip(*done, (one, other), strict=True))
    return one, other, stretches
