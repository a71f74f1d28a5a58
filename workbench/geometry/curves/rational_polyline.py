"""Curves of any kind, rational ones too, as polylines with the error stated."""

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.halving import halved_until_near, lengths
from workbench.geometry.curves.pieces import Pieces, is_parted, with_ends, with_length
from workbench.geometry.curves.refusals import refuse_tolerance

Array = NDArray[np.float64]


def nurbs_to_polyline(pieces: Pieces, tolerance: float) -> tuple[Array, float]:
    """Corners (n, k) on the curve, and how far the curve is from the lines between them at most.

    A piece is halved until its control points are as near to its chord as ``tolerance``: the curve lies
    between them, whatever its weights above 0. The error exceeds the tolerance only where that is below
    1e-13 of the curve's size, or more than 50,000 parts wait to be halved. Raises: ValueError
    for a tolerance that is not above 0.
    """
    refuse_tolerance(tolerance)
    kept = with_length(pieces)
    starts, corners, errors = halved_until_near(kept, tolerance, _chords)
    ends = np.cumsum(np.bincount(starts.astype(np.intp)))
    return with_ends(kept, corners, ends, is_parted(kept)), float(errors.max())


def _chords(whole: Array) -> tuple[Array, Array]:
    """Where the chords of pieces (m, n+1, k+1) begin (m, k), and the largest distance (m,) of their control
    points from them."""
    points = whole[..., :-1] / whole[..., -1:]
    begin = points[:, :1]
    chord = points[:, -1:] - begin
    length = (chord * chord).sum(axis=-1, keepdims=True)
    along = ((points - begin) * chord).sum(axis=-1, keepdims=True)
    share = np.clip(np.divide(along, length, out=np.zeros_like(along), where=length > 0), 0.0, 1.0)
    return points[:, 0], lengths(points - begin - share * chord).max(axis=1)
