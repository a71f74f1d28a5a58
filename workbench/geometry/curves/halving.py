"""Many Bézier pieces at once, rational or not, in homogeneous points: cut in halves, balanced, multiplied.

Pieces are (m, n+1, k+1): rows of control points (w x, w y, ..., w); the weight of a plain curve is 1.
Source: Farin, Curves and Surfaces for CAGD, sections 12.5 and 13.7.
"""

from collections.abc import Callable
from math import comb

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.pieces import Pieces

Array = NDArray[np.float64]

MOST_HALVINGS = 24
MOST_PARTS = 50_000  # that still wait to be halved
NEAREST = 1e-13  # of the size of the curve: nearer than this rounding errors are all that is left


def lifted(pieces: Pieces) -> Array:
    """The homogeneous points of every piece."""
    if pieces.weights is None:
        return np.concatenate([pieces.controls, np.ones((*pieces.controls.shape[:2], 1))], axis=-1)
    pulls = pieces.weights[..., None]
    return np.concatenate([pieces.controls * pulls, pulls], axis=-1)


def balanced(whole: Array) -> Array:
    """The same curves with weights 1 at both ends: u is replaced by a fraction of linear functions of u.

    Between ends of very unequal weights a curve runs through nearly everything near one of them; balanced,
    half of u is about half of the curve.
    """
    evened: Array = whole * evening(whole[..., -1])[..., None]
    return evened


def evening(weights: Array) -> Array:
    """What the weights (m, n+1) of pieces are multiplied by to balance them: 1 at both ends of each."""
    first, last = weights[:, :1], weights[:, -1:]
    share = np.arange(weights.shape[1]) / max(weights.shape[1] - 1, 1)
    ratio: Array = (first / last) ** share / first
    return ratio


def halves(whole: Array) -> Array:
    """Both halves of each piece, (2 m, n+1, k+1), one after the other."""
    level, firsts, seconds = whole, [whole[:, 0]], [whole[:, -1]]
    while level.shape[1] > 1:
        level = 0.5 * (level[:, :-1] + level[:, 1:])
        firsts.append(level[:, 0])
        seconds.append(level[:, -1])
    both = np.stack([np.stack(firsts, axis=1), np.stack(seconds[::-1], axis=1)], axis=1)
    return both.reshape(-1, *whole.shape[1:])


def halved_until_near(
    pieces: Pieces, tolerance: float, simpler: Callable[[Array], tuple[Array, Array]]
) -> tuple[Array, Array, Array]:
    """Pieces halved until something simpler in the place of each part is near enough.

    ``simpler`` finds for balanced parts (m, n+1, k+1) what may stand for them (m, ...), and how far off at
    most (m,) it is. Returns for each part (r,), in order: the number of its piece plus the share of the piece
    that lies before it; what stands for it (r, ...); how far off that is, more than ``tolerance`` only where
    that is below 1e-13 of the curve's size, or more than 50,000 parts wait to be halved.
    """
    waiting, places = lifted(pieces), np.arange(len(pieces.controls), dtype=float)
    least = max(tolerance, NEAREST * float(np.abs(pieces.controls).max()))
    most = max(MOST_PARTS, 8 * len(waiting))
    found: list[tuple[Array, Array, Array]] = []
    for halving in range(MOST_HALVINGS + 1):
        waiting = balanced(waiting)
        stand_ins, off = simpler(waiting)
        done = (off <= least) | (halving == MOST_HALVINGS) | (len(waiting) > most)
        found.append((places[done], stand_ins[done], off[done]))
        waiting, places = halves(waiting[~done]), places[~done]
        if not len(waiting):
            break
        places = np.stack([places, places + 0.5 ** (halving + 1)], axis=1).ravel()
    starts, made, errors = (np.concatenate(parts) for parts in zip(*found, strict=True))
    order = np.argsort(starts)
    return starts[order], made[order], errors[order]


def product(one: Array, other: Array) -> Array:
    """Control points (m, p+q+1, k) of the products of polynomials (m, p+1, k) and (m, q+1, k or 1)."""
    p, q = one.shape[1] - 1, other.shape[1] - 1
    total = np.zeros((len(one), p + q + 1, max(one.shape[2], other.shape[2])))
    for j in range(q + 1):
        share = np.array([comb(p, i) * comb(q, j) / comb(p + q, i + j) for i in range(p + 1)])[:, None]
        total[:, j : j + p + 1] += share * one * other[:, j : j + 1]
    return total


def lengths(rows: Array) -> Array:
    """The Euclidean length of each row, (..., k) -> (...,)."""
    found: Array = np.sqrt((rows * rows).sum(axis=-1))
    return found
