"""A direct-view storage tube: what was written is kept on the face by flood guns until all of it is erased.

The writing beam charges the target where its energy in one pass is above a threshold; there the flood guns
light the phosphor from then on. Below it the flood guns drive the charge back: nothing is kept, and nothing
adds up from pass to pass. Erasing charges the whole target, which flashes, and then takes all of it away.
Figures: Tektronix 613 (erase 0.9 s), 4010 (background some 8 % of full). How fast contrast is lost is an
assumption.
"""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.display.phosphor import Phosphor
from workbench.display.spot import stroke_energy

Floats = NDArray[np.floating[Any]]
Point = tuple[float, float]

ERASE_S = 0.9
_RISE_S = 0.1
"""Of an erasure, the time in which the whole face is bright."""

BACKGROUND = 0.08
STORED = 0.55
"""Luminance of the unwritten and of the written face, 1 for the writing beam's own trace."""

FADE_S = 900.0
"""Time constant in which what is stored loses its contrast: minutes, to an hour at most."""

THROUGH = 0.35
"""Share of its full current that the beam has when it writes through, without storing."""


BAUD, BITS_PER_BYTE, BYTES_PER_VECTOR = 9600, 10, 4
"""Of the line to a Tektronix 4010, which sets the pace; how many bytes a vector takes is uncertain."""


def transfer_s(strokes: int) -> float:
    """How long the line takes to bring so many strokes, in seconds."""
    return strokes * BYTES_PER_VECTOR * BITS_PER_BYTE / BAUD


STORAGE_PHOSPHOR = "P1"
"""What a storage tube is coated with."""


class StorageTube:
    """A face of ``size_px`` (columns, rows) and ``size_mm``. ``threshold`` is the energy of a pass per pixel,
    in shares of that of a stroke at the tube's writing speed, from which on it is kept. Time is in seconds.
    """

    def __init__(
        self,
        size_px: tuple[int, int],
        size_mm: tuple[float, float],
        spot_mm: float = 0.5,
        threshold: float = 0.5,
    ) -> None:
        self.size_px, self.size_mm, self.spot_mm = size_px, size_mm, spot_mm
        self.threshold = threshold
        columns, rows = size_px
        self.stored = np.zeros((rows, columns), np.bool_)
        self._trace = np.zeros((rows, columns), np.float32)
        self._since_written = 0.0
        self._erasing = -1.0
        self._phosphor = Phosphor.named(STORAGE_PHOSPHOR)

    def continue_from(self, before: "StorageTube") -> None:
        """Be as old as a tube of another size, and as far in an erasure, so that neither begins anew."""
        self._since_written, self._erasing = before._since_written, before._erasing

    @property
    def erasing(self) -> bool:
        """Whether it is being erased; nothing can be written meanwhile."""
        return self._erasing >= 0.0

    @property
    def still(self) -> bool:
        """Whether it looks the same a moment later."""
        return not self.erasing and not self._trace.any()

    def _energy(self, begin: Point, end: Point, slowness: float) -> tuple[tuple[slice, slice], Floats]:
        """Energy of one pass on a box of the face: 1 in the middle of a stroke at writing speed."""
        length = math.hypot(end[0] - begin[0], end[1] - begin[1])
        pixel = self.size_mm[0] / self.size_px[0] * self.size_mm[1] / self.size_px[1]
        across = math.sqrt(2.0 * math.pi) * self.spot_mm / pixel
        # A point gets what a stroke as long as the spot is wide would get
        whole = max(length, self.spot_mm) * slowness * across
        patch = stroke_energy(self.size_px, self.size_mm, begin, end, self.spot_mm, whole, 4.0)
        return (patch.rows, patch.columns), patch.values

    def write(self, strokes: Sequence[tuple[Point, Point, float]], slowness: float = 1.0) -> int:
        """Draw strokes (begin, end in mm, current 0 to 1) once; twice as slow is twice the energy.

        Returns how many more pixels are stored; while it is erased nothing is written.
        """
        if self.erasing:
            return 0
        before = self.stored.copy()
        for begin, end, current in strokes:
            box, energy = self._energy(begin, end, slowness * current)
            self.stored[box] |= energy >= self.threshold
            np.maximum(self._trace[box], energy, out=self._trace[box])
        self._since_written = 0.0
        return int((self.stored & ~before).sum())

    def write_through(self, strokes: Sequence[tuple[Point, Point, float]]) -> None:
        """Show strokes by a beam too weak to store: they are seen as long as they are drawn again."""
        for begin, end, current in strokes:
            box, energy = self._energy(begin, end, THROUGH * self.threshold * current)
            np.maximum(self._trace[box], 2.0 * energy, out=self._trace[box])

    def erase(self) -> None:
        """Begin to erase all of it: there is no way to erase a part."""
        self._erasing = 0.0

    def advance(self, seconds: float) -> None:
        """Let time pass."""
        self._since_written += seconds
        self._trace *= np.float32(self._phosphor.intensity(seconds))
        self._trace[self._trace < 1.0 / 512.0] = 0.0
        if self.erasing:
            self._erasing += seconds
            if self._erasing >= _RISE_S:
                self.stored[...] = False
                self._trace[...] = 0.0
            if self._erasing >= ERASE_S:
                self._erasing = -1.0

    def light(self, flashes: bool = True) -> Floats:
        """Luminance of the face (rows, columns); without ``flashes`` an erasure is dark from its start."""
        kept = math.exp(-self._since_written / FADE_S)
        glow = np.full(self.stored.shape, BACKGROUND, np.float32)
        if self.erasing:
            if self._erasing < _RISE_S and flashes:
                return np.full_like(glow, 1.0)
            share = min(max((self._erasing - _RISE_S) / (ERASE_S - _RISE_S), 0.0), 1.0)
            return glow * np.float32(share)
        glow[self.stored] = BACKGROUND + (STORED - BACKGROUND) * kept
        return glow + self._trace
