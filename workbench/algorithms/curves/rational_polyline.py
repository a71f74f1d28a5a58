"""Curves of any kind, rational ones too, as polylines with the error stated."""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves.cubic_pieces import MOST_HALVINGS, MOST_PARTS, NEAREST, refuse_tolerance
from workbench.algorithms.curves.halving import balanced, halves, lengths, lifted
from workbench.algorithms.curves.pieces import Pieces, with_ends, with_length

Array = NDArray[np.float64]


def nurbs_to_polyline(pieces: Pieces, tolerance: float) -> tuple[Array, float]:
    """Corners (n, k) on the curve, and how far the curve is from the lines between them at most.

    A piece is halved until its control points are as near to its chord as ``tolerance``: the curve lies
    between them, whatever its weights above 0. The error exceeds the tolerance only where that is below
    1e-13 of the curve's size, or takes more than 100,000 lines. Raises: ValueError for a tolerance that is
    not above 0.
    """
    refuse_tolerance(tolerance)
    kept = with_length(pieces)
    waiting, order = lifted(kept), np.arange(len(kept.controls), dtype=float)
    least = max(tolerance, NEAREST * float(np.abs(pieces.controls).max()))
    most = max(MOST_PARTS, 8 * len(waiting))
    found: list[tuple[Array, Array, Array]] = []
    for halving in range(MOST_HALVINGS + 1):
        waiting = balanced(waiting)
        points = waiting[..., :-1] / waiting[..., -1:]
        off = _from_chords(points)
        done = (off <= least) | (halving == MOST_HALVINGS) | (len(waiting) > most)
        found.append((order[done], points[done, 0], off[done]))
        waiting, order = halves(waiting[~done]), order[~done]
        if not len(waiting):
            break
        order = np.stack([order, order + 0.5 ** (halving + 1)], axis=1).ravel()
    places, corners, errors = (np.concatenate(parts) for parts in zip(*found, strict=True))
    ends = np.cumsum(np.bincount(places.astype(int)))
    return with_ends(kept, corners[np.argsort(places)], ends), float(errors.max())


def _from_chords(points: Array) -> Array:
    """The largest distance (m,) of control points (m, n+1, k) from the segment between the outer two."""
    begin = points[:, :1]
    chord = points[:, -1:] - begin
    length = (chord * chord).sum(axis=-1, keepdims=True)
    along = ((points - begin) * chord).sum(axis=-1, keepdims=True)
    share = np.clip(np.divide(along, length, out=np.zeros_like(along), where=length > 0), 0.0, 1.0)
    found: Array = lengths(points - begin - share * chord).max(axis=1)
    return found
