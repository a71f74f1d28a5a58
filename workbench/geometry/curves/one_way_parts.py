"""Parts of a plane curve that go one way in x and in y: none meets itself, its box is that of its ends."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.derivatives import derivatives_within
from workbench.geometry.curves.pieces import Pieces
from workbench.geometry.curves.polynomials import derivative_numerator
from workbench.geometry.curves.roots import parted, roots

Array = NDArray[np.float64]


class Parts(NamedTuple):
    """Parts of the curve (r,): their piece, where they begin and end in it, and the points there (r, 2)."""

    piece: NDArray[np.intp]
    low: Array
    high: Array
    begin: Array
    end: Array

    def taken(self, which: NDArray[np.intp] | NDArray[np.bool_]) -> "Parts":
        """Some of them."""
        return Parts(self.piece[which], self.low[which], self.high[which], self.begin[which], self.end[which])


def together(several: Iterable[Parts]) -> Parts:
    """All of them, one after the other."""
    return Parts(*(np.concatenate(columns) for columns in zip(*several, strict=True)))


def one_way_parts(pieces: Pieces) -> Parts:
    """The curve in parts that go one way in x and in y, in order; none for what stays in one place."""
    tops, sizes = derivative_numerator(pieces.controls, pieces.weights)
    turns = [roots(tops[:, axis], sizes[:, axis]) for axis in (0, 1)]
    rows, low, high = parted(len(pieces.controls), *turns)
    begin, end = (derivatives_within(pieces, rows, v, 0)[0] for v in (low, high))
    parts = Parts(rows, low, high, begin, end)
    return parts.taken((begin != end).any(axis=1))


def overlapping(parts: Parts, margin: float) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Numbers of all pairs of parts whose boxes overlap, the earlier part first, in order."""
    left = np.minimum(parts.begin[:, 0], parts.end[:, 0])
    right = np.maximum(parts.begin[:, 0], parts.end[:, 0]) + margin
    order = np.argsort(left, kind="stable")
    counts = np.searchsorted(left[order], right[order], side="right") - np.arange(len(order)) - 1
    one = np.repeat(np.arange(len(order)), counts)
    other = one + 1 + np.arange(len(one)) - np.repeat(np.cumsum(counts) - counts, counts)
    first, second = np.minimum(order[one], order[other]), np.maximum(order[one], order[other])
    near = _boxes_meet(parts.taken(first), parts.taken(second), margin)
    first, second = first[near], second[near]
    ordered = np.lexsort((second, first))
    return first[ordered], second[ordered]


def _boxes_meet(one: Parts, other: Parts, margin: float) -> NDArray[np.bool_]:
    """Whether the boxes of two parts each (r,) are within the margin."""
    low = np.maximum(np.minimum(one.begin, one.end), np.minimum(other.begin, other.end))
    high = np.minimum(np.maximum(one.begin, one.end), np.maximum(other.begin, other.end))
    return np.asarray((low <= high + margin).all(axis=1))


def halved(pieces: Pieces, one: Parts, other: Parts, margin: float) -> tuple[NDArray[np.intp], Parts, Parts]:
    """Of each pair of parts the pairs of halves within the margin: the number of their pair, and both halves.

    Where one part follows on another, the halves at their joint stay.
    """
    both = [(a, b) for a in _halves(pieces, one) for b in _halves(pieces, other)]
    number = np.tile(np.arange(len(one.low)), len(both))
    one, other = (together(side) for side in zip(*both, strict=True))
    apart = (other.piece + other.low) >= (one.piece + one.high)
    near = apart & _boxes_meet(one, other, margin)
    return number[near], one.taken(near), other.taken(near)


def _halves(pieces: Pieces, parts: Parts) -> tuple[Parts, Parts]:
    """The first and the second half of each part."""
    middle = 0.5 * (parts.low + parts.high)
    points = derivatives_within(pieces, parts.piece, middle, 0)[0]
    first = parts._replace(high=middle, end=points)
    return first, parts._replace(low=middle, begin=points)
