"""Curves as polylines that stay within a tolerance."""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves.cubic_pieces import refuse_tolerance
from workbench.algorithms.curves.derivatives import local_derivatives
from workbench.algorithms.curves.pieces import Pieces, with_ends, with_length
from workbench.algorithms.curves.rational_polyline import nurbs_to_polyline

Array = NDArray[np.float64]

MOST_CHORDS = 2**15


def chord_counts(pieces: Pieces, tolerance: float) -> NDArray[np.int64]:
    """How many chords each piece (m,), not rational, needs, at equal steps of u, so that none is farther off.

    A chord over the step h is off by at most h^2 / 8 times the largest second derivative, which is at most
    degree (degree - 1) times the largest second difference of the control points. Source: Wang, 1984.
    """
    degree = pieces.degree
    bends = np.diff(pieces.controls, n=2, axis=1) if degree > 1 else np.zeros((len(pieces.controls), 1, 2))
    largest = np.sqrt((bends * bends).sum(axis=-1)).max(axis=1)
    counts = np.ceil(np.sqrt(degree * (degree - 1) * largest / (8.0 * tolerance)))
    whole: NDArray[np.int64] = np.clip(counts, 1, MOST_CHORDS).astype(np.int64)
    return whole


def polyline(pieces: Pieces, tolerance: float) -> Array:
    """The corners (n, k) of a chain of chords, all on the curve, which is nowhere farther from the chain than
    ``tolerance``; where it is parted, the chain goes straight on.

    A piece has no more than 32768 chords: then it may be farther off, a cubic one by 1e-9 of its size.
    Raises: ValueError for a tolerance that is not above 0.
    """
    if pieces.weights is not None:
        return nurbs_to_polyline(pieces, tolerance)[0]
    refuse_tolerance(tolerance)
    kept = with_length(pieces)
    counts = chord_counts(kept, tolerance)
    ends = np.cumsum(counts)
    number = np.repeat(np.arange(len(counts)), counts)
    share = (np.arange(ends[-1]) - (ends - counts)[number]) / counts[number]
    corners = local_derivatives(kept.controls[number], None, share, 0)[0]
    return with_ends(kept, corners, ends)
