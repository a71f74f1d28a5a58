"""The fragments of a depth buffer's run: what came to each pixel, in which order, and what was there."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from workbench.rendering.emissions import emitted
from workbench.rendering.mapping import Call

Index = NDArray[np.int64]
Numbers = NDArray[np.float64]

NOTHING = -1
"""The surface of a pixel that none covers."""


@dataclass(frozen=True, slots=True, eq=False)
class Fragments:
    """All fragments of a run, (n,) each, in the order of the run; step k of the run is fragment k - 1.

    ``surface`` is the number of the triangle, ``z`` its depth there, ``held`` that depth as the buffer can
    hold it, ``stored`` what it held when the fragment came, ``won`` whether the fragment was written.
    """

    x: Index
    y: Index
    z: Numbers
    held: Numbers
    stored: Numbers
    won: NDArray[np.bool_]
    surface: Index

    def __len__(self) -> int:
        return len(self.x)

    def upto(self, count: int) -> "Fragments":
        """The first ``count``."""
        return Fragments(
            self.x[:count],
            self.y[:count],
            self.z[:count],
            self.held[:count],
            self.stored[:count],
            self.won[:count],
            self.surface[:count],
        )

    def at(self, x: int, y: int) -> Index:
        """The numbers of those that came to a pixel."""
        return np.flatnonzero((self.x == x) & (self.y == y))

    def seen(self, size: tuple[int, int]) -> Index:
        """(height, width) the surface that each pixel shows, or NOTHING."""
        nearest = np.full(size[::-1], NOTHING)
        # Of several writes to one pixel NumPy keeps the last.
        nearest[self.y[self.won], self.x[self.won]] = self.surface[self.won]
        return nearest

    def depths(self, size: tuple[int, int], farthest: float) -> Numbers:
        """(height, width) the depth buffer after these."""
        buffer = np.full(size[::-1], farthest)
        buffer[self.y[self.won], self.x[self.won]] = self.held[self.won]
        return buffer

    def tests(self, size: tuple[int, int]) -> Index:
        """(height, width) how often each pixel was compared."""
        return _counted(self.x, self.y, size)

    def writes(self, size: tuple[int, int]) -> Index:
        """(height, width) how often each pixel was written: 2 and more is overdraw."""
        return _counted(self.x[self.won], self.y[self.won], size)

    @property
    def begins(self) -> Index:
        """The numbers of the fragments with which a surface begins."""
        return np.flatnonzero(np.diff(self.surface, prepend=NOTHING))


def _counted(x: Index, y: Index, size: tuple[int, int]) -> Index:
    counts = np.zeros(size[::-1], np.int64)
    np.add.at(counts, (y, x), 1)
    return counts


class _SameCall:
    """A call as a key: the same one, not an equal one."""

    def __init__(self, call: Call) -> None:
        self.call = call

    def __hash__(self) -> int:
        return id(self.call.arguments)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _SameCall) and other.call.arguments is self.call.arguments


def fragments_of(call: Call) -> Fragments:
    """The fragments of a call of ``depth_buffer``; made once for the call."""
    return _fragments(_SameCall(call))


@lru_cache(maxsize=16)
def _fragments(key: _SameCall) -> Fragments:
    call = key.call
    depth = call.arguments[1]
    rows = emitted(call).reshape(-1, 4)
    x, y = rows[:, 0].astype(np.int64), rows[:, 1].astype(np.int64)
    z, won = rows[:, 2].astype(np.float64), rows[:, 3] > 0
    held = np.trunc(z) if depth.dtype.kind in "iu" else z
    stored = _stored(y * depth.shape[1] + x, held, won, depth)
    return Fragments(x, y, z, held, stored, won, np.repeat(*_lengths(call)))


def _lengths(call: Call) -> tuple[Index, Index]:
    """The numbers of the triangles, and how many fragments each has: what the text makes of it alone."""
    image, depth, vertices, faces, colours = call.arguments
    whole, farthest = image.copy(), depth.copy()
    lengths = [
        sum(1 for _fragment in call.entry.function(whole, farthest, vertices, faces[k : k + 1], colours))
        for k in range(len(faces))
    ]
    return np.arange(len(faces)), np.array(lengths, np.int64)


def _stored(pixel: Index, held: Numbers, won: NDArray[np.bool_], depth: NDArray[np.generic]) -> Numbers:
    """(n,) what the depth buffer held at the pixel of each fragment when that came."""
    # Fragments of one pixel lie beside one another: each finds what the last one that won has left there.
    order = np.argsort(pixel, kind="stable")
    together, number = pixel[order], np.arange(len(order))
    winner = np.maximum.accumulate(np.where(won[order], number, NOTHING))
    before = np.append(NOTHING, winner)[: len(order)]
    followed = (before >= 0) & (together[before] == together)
    stored = depth.ravel()[pixel].astype(np.float64)
    stored[order[followed]] = held[order[before[followed]]]
    return stored
