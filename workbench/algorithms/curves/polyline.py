"""Curves as polylines that stay within a tolerance."""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves.pieces import Pieces, piece_points
from workbench.algorithms.curves.rational_polyline import nurbs_to_polyline

Array = NDArray[np.float64]

MOST_CHORDS = 4096


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
    """The corners (n, k) of a chain of chords, nowhere farther from the curve than ``tolerance``."""
    if pieces.weights is not None:
        return nurbs_to_polyline(pieces, tolerance)[0]
    counts = chord_counts(pieces, tolerance)
    begins = np.cumsum(counts) - counts
    share = (np.arange(counts.sum()) - np.repeat(begins, counts)) / np.repeat(counts, counts)
    number = np.repeat(np.arange(len(counts)), counts)
    lengths = np.diff(pieces.knots)
    u = np.append(pieces.knots[number] + share * lengths[number], pieces.knots[-1])
    return piece_points(pieces, u)
