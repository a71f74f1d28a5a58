"""Curves as polylines that stay within a tolerance."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.pieces import Pieces, is_parted, points_within, with_ends, with_length
from workbench.geometry.curves.rational_polyline import nurbs_to_polyline
from workbench.geometry.curves.refusals import refuse_tolerance

Array = NDArray[np.float64]

MOST_CHORDS = 2**15
_AT_ONCE = 2**16  # chords, so that what is kept beside them is a few megabytes
UNEVEN = 128  # chords of a rational piece: it takes more at equal steps when its weights are very unequal


def chord_counts(pieces: Pieces, tolerance: float) -> NDArray[np.int64]:
    """How many chords each piece (m,) needs, at equal steps of u, so that none is farther off.

    A chord over the step h is off by at most h^2 / 8 times the largest second derivative, which is at most
    degree (degree - 1) times the largest second difference of the control points. Of a rational piece, that
    holds for numerator and weight; the chord's weight moves its points by as much times their distance from
    the origin, which is put into the middle of the piece. Source: Wang, 1984; Zheng and Sederberg, Estimating
    tessellation parameter intervals for rational curves and surfaces, 2000.
    """
    degree = pieces.degree
    if pieces.weights is None:
        bends = _largest_bend(pieces.controls)
    else:
        pulls = pieces.weights[..., None] / pieces.weights.min(axis=1)[:, None, None]
        around = pieces.controls - pieces.controls.mean(axis=1, keepdims=True)
        reach = np.sqrt((around * around).sum(axis=-1)).max(axis=1)
        bends = _largest_bend(around * pulls) + reach * _largest_bend(pulls)
    counts = np.ceil(np.sqrt(degree * (degree - 1) * bends / (8.0 * tolerance)))
    whole: NDArray[np.int64] = np.clip(counts, 1, MOST_CHORDS).astype(np.int64)
    return whole


def _largest_bend(controls: Array) -> Array:
    """The length of the largest second difference (m,) of rows of control points (m, n, k)."""
    if controls.shape[1] < 3:
        return np.zeros(len(controls))
    bends = np.diff(controls, n=2, axis=1)
    bend: Array = np.sqrt((bends * bends).sum(axis=-1)).max(axis=1)
    return bend


def polyline(pieces: Pieces, tolerance: float) -> Array:
    """The corners (n, k) of a chain of chords, all on the curve, which is nowhere farther from the chain than
    ``tolerance``; where it is parted, the chain goes straight on.

    A piece has no more than 32768 chords: then it may be farther off, a cubic one by 1e-9 of its size.
    Raises: ValueError for a tolerance that is not above 0.
    """
    refuse_tolerance(tolerance)
    kept = with_length(pieces)
    counts = chord_counts(kept, tolerance)
    if kept.weights is not None and counts.max() > UNEVEN:
        return nurbs_to_polyline(kept, tolerance)[0]
    return _chains(kept, counts, np.array([len(counts)]))[0]


def polylines(curves: Sequence[Pieces], tolerance: float) -> list[Array]:
    """The chains of several curves of one degree and without weights, as ``polyline`` makes each of them.

    Raises: ValueError for a tolerance that is not above 0.
    """
    refuse_tolerance(tolerance)
    if not curves:
        return []
    kept = [with_length(each) for each in curves]
    controls = np.concatenate([each.controls for each in kept])
    counts = chord_counts(Pieces(np.zeros(0), controls), tolerance)
    last = np.cumsum([len(each.controls) for each in kept])
    chains: list[Array] = []
    for some in np.split(last, np.flatnonzero(np.diff(np.cumsum(counts)[last - 1] // _AT_ONCE)) + 1):
        begin = 0 if not chains else int(last[len(chains) - 1])
        part = slice(begin, int(some[-1]))
        chains += _chains(Pieces(np.zeros(0), controls[part]), counts[part], some - begin)
    return chains


def _chains(pieces: Pieces, counts: NDArray[np.int64], last: NDArray[np.int64]) -> list[Array]:
    """The chains of curves whose pieces end before the numbers ``last``, with so many chords (m,) each."""
    ends = np.cumsum(counts)
    number = np.repeat(np.arange(len(counts)), counts)
    share = (np.arange(ends[-1]) - (ends - counts)[number]) / counts[number]
    parted = is_parted(pieces)
    parted[last - 1] = True
    corners = with_ends(pieces, points_within(pieces, number, share), ends, parted)
    if len(last) == 1:
        return [corners]
    after = (ends + np.cumsum(parted))[last - 1].tolist()
    return [corners[begin:end].copy() for begin, end in pairwise((0, *after))]
