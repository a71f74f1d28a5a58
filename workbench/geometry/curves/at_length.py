"""Places along curves in pieces by their distance along the curve from its begin."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.arc_length import WHOLE, Parts, length_up_to, measured_parts, speeds_of
from workbench.geometry.curves.pieces import Pieces, with_length

Array = NDArray[np.float64]


def at_length(pieces: Pieces, along: ArrayLike) -> Array:
    """The u (...,) at which the curve is as long as ``along`` (...,), from its begin.

    Below 0 that is the begin, beyond the whole length the end.
    """
    kept = with_length(pieces)
    return _at(kept, measured_parts(kept), np.asarray(along, float))


def equal_lengths(pieces: Pieces, count: int) -> Array:
    """The u (count,) of points in equal steps along the curve, both ends among them.

    Raises: ValueError for a count below 2.
    """
    if count < 2:
        raise ValueError(f"{count} points make no step; ask for 2 or more.")
    kept = with_length(pieces)
    parts = measured_parts(kept)
    u = _at(kept, parts, np.linspace(0.0, parts.length.sum(), count))
    u[0], u[-1] = kept.knots[0], kept.knots[-1]
    return u


def _at(pieces: Pieces, parts: Parts, along: Array) -> Array:
    """The u (...,) of lengths (...,) from the begin of a curve that was measured in these parts."""
    ends = np.cumsum(parts.length)
    asked = np.clip(along.ravel(), 0.0, ends[-1])
    number = np.minimum(np.searchsorted(ends, asked), len(ends) - 1)
    rest = np.clip(asked - (ends - parts.length)[number], 0.0, parts.length[number])
    v = parts.low[number] + parts.width[number] * _reached(parts.controls[number], rest)
    piece = parts.piece[number]
    if pieces.weights is not None:
        # What ``balanced`` did to the parameter is undone
        ratio = (pieces.weights[piece, 0] / pieces.weights[piece, -1]) ** (1.0 / max(pieces.degree, 1))
        v = ratio * v / (1.0 - v + ratio * v)
    return pieces.u_at(piece, v).reshape(along.shape)


def _reached(controls: Array, along: Array) -> Array:
    """Where curves (r, n+1, k+1) are as long as ``along`` (r,): Newton's steps, kept between bounds."""
    whole = length_up_to(controls, WHOLE)
    low, high = np.zeros(len(along)), np.ones(len(along))
    at = np.divide(along, whole, out=np.zeros(len(along)), where=whole > 0)
    for _turn in range(60):
        over = length_up_to(controls, at) - along
        low, high = np.where(over < 0, at, low), np.where(over < 0, high, at)
        speed = speeds_of(controls, at[:, None])[:, 0]
        to = at - np.divide(over, speed, out=np.full(len(at), np.inf), where=speed > 0)
        to = np.where((low <= to) & (to <= high), to, 0.5 * (low + high))
        if not (np.abs(over) > 2.0**-50 * whole).any() or (np.abs(to - at) < 2.0**-52).all():
            break
        at = to
    return at
