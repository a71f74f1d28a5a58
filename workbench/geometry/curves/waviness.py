"""What a curve does that its points did not ask for: how far it overshoots them, and how much it wiggles."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse
from workbench.geometry.curves.derivatives import derivatives_within
from workbench.geometry.curves.extrema import bounding_box, meets_itself, piece_boxes
from workbench.geometry.curves.inflections import bend_polynomial, inflections
from workbench.geometry.curves.pieces import Pieces, with_length
from workbench.geometry.curves.polynomials import derivative_numerator
from workbench.geometry.curves.roots import parted, roots

Array = NDArray[np.float64]

_ASIDE = 1e-7
_SAME = 1e-9


class Overshoot(NamedTuple):
    """How far a curve leaves the box around all points, and, between two neighbours, the box of these two.

    The second is nan for a curve that does not go from each point to the next.
    """

    box: float
    between: float


class Wiggle(NamedTuple):
    """How much the direction of a curve turns in all, radians, how much that of its polygon does, and how
    often the curve changes the side to which it bends."""

    turning: float
    polygon: float
    inflections: int


def overshoot(pieces: Pieces, points: ArrayLike) -> Overshoot:
    """How far the curve goes beyond its points (n, k), 0 if it does not. Raises: ValueError for no points."""
    refuse(faults(points, least=1))
    given, kept = np.asarray(points, float), with_length(pieces)
    low, high = bounding_box(kept)
    box = max(0.0, float((given.min(axis=0) - low).max()), float((high - given.max(axis=0)).max()))
    legs = _legs(kept, given)
    if legs is None:
        return Overshoot(box, float("nan"))
    low, high = piece_boxes(kept)
    beyond = np.maximum(legs.min(axis=1) - low, high - legs.max(axis=1))
    return Overshoot(box, max(0.0, float(beyond.max())))


def wiggle(pieces: Pieces, points: ArrayLike) -> Wiggle:
    """How much the curve turns, corners and cusps included, beside the polygon of its points (n, 2).

    If the curve ends where it began, both go on from the end to the begin.
    Raises: ValueError for no points.
    """
    refuse(faults(points, least=1))
    kept, given = with_length(pieces), np.asarray(points, float)
    closed = meets_itself(kept)
    legs = np.diff(np.vstack([given, given[:1]]) if closed else given, axis=0)
    return Wiggle(_turned(_directions(kept), closed), _turned(legs, closed), len(inflections(kept)))


def _legs(pieces: Pieces, points: Array) -> Array | None:
    """The two points (m, 2, k) that each piece goes between; None if it does not."""
    ends = pieces.controls[:, [0, -1]]
    nothing = _SAME * max(float(np.abs(points).max()), float(np.abs(ends).max()))
    around = np.vstack([points, points[:1]])
    legs = np.stack([around[:-1], around[1:]], axis=1)
    legs = legs[np.abs(legs[:, 1] - legs[:, 0]).max(axis=1) > nothing]
    for skipped in (0, 1):
        fitting = legs[skipped : skipped + len(ends)]
        if fitting.shape == ends.shape and np.abs(fitting - ends).max() <= nothing:
            return np.asarray(fitting)
    return None


def _directions(pieces: Pieces) -> Array:
    """Derivatives (r, 2) along the curve, so many that between two of them it turns one way, at most 90
    degrees: beside both ends of each stretch without a level, an upright or an unbent place."""
    _knots, controls, weights = pieces
    tops, sizes = derivative_numerator(controls, weights)
    turning = [roots(tops[:, 0], sizes[:, 0]), roots(tops[:, 1], sizes[:, 1])]
    if pieces.degree > 1:
        turning.append(roots(*bend_polynomial(pieces)))
    rows, begin, end = parted(len(controls), *turning)
    length = end - begin
    v = np.stack([begin + _ASIDE * length, begin + (1.0 - _ASIDE) * length], axis=1)[length > 0]
    rows = np.repeat(rows[length > 0], 2)
    return np.asarray(derivatives_within(pieces, rows, v.ravel(), 1)[1])


def _turned(directions: Array, closed: bool) -> float:
    """The sum of the angles between vectors (r, 2), those without length left out."""
    kept = directions[(directions != 0.0).any(axis=1)]
    ahead = np.roll(kept, -1, axis=0)
    angles = np.arctan2(
        np.abs(kept[:, 0] * ahead[:, 1] - kept[:, 1] * ahead[:, 0]), (kept * ahead).sum(axis=1)
    )
    return float(angles.sum() if closed else angles[:-1].sum())
