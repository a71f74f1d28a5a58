"""A raster beam on a float32 tube by compiled texts: what ``RasterBeam`` does in NumPy, in one pass.

Both give the same light to the accuracy of float32.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.display import face_kernels
from workbench.display.face_kernels import gather_rows, refresh_face, run, spread_rows
from workbench.display.phosphor import Phosphor
from workbench.display.spot import ends
from workbench.display.tube import Tube

Array = NDArray[np.float32]
Drive = NDArray[np.floating[Any]]

_LOWEST = np.array([[face_kernels.LOWEST]])


class PartOfARow(NamedTuple):
    """Some pixels of a row, and for each age (0 all energy, then one for each term) what is left of each of
    its pixels (ages, columns); ``face`` are the rows of the face that it reaches.
    """

    row: int
    kept: Array
    face: slice


class Spread(NamedTuple):
    """A gun's picture along the face: rows for all energy, then for each term (ages * rows, face columns).

    ``sums`` are those of the first rows, ``ends`` (rows, 2) where these are not dark.
    """

    rows: Array
    sums: Array
    ends: NDArray[np.int64]


class RasterRefresh:
    """``along`` (columns, face columns) and ``across`` (face rows, rows) are the shares of the spot."""

    def __init__(self, along: Array, across: Array, guns: Sequence[Phosphor], pixel_s: float) -> None:
        self._along, self._across = along, across
        self._reach, self._bands = ends(along), ends(across)
        self._column_sums = across.sum(axis=0, dtype=np.float64)
        clocks = np.arange(len(along) - 1, -1, -1)
        self._aging = [
            np.stack(
                [np.ones(len(along)), *(np.exp(-clocks * (pixel_s / term.tau_s)) for term in phosphor.terms)]
            ).astype(np.float32)
            for phosphor in guns
        ]

    def spread(self, drive: Drive, gun: int) -> Spread:
        """A gun's picture (rows, columns) along the face."""
        begins = np.concatenate(([True], (drive[1:] != drive[:-1]).any(axis=1)))
        given = np.ascontiguousarray(drive[begins], np.float32)
        aging = self._aging[gun]
        made = np.empty((len(aging) * len(given), self._along.shape[1]), np.float32)
        run(spread_rows, made, given, aging, self._along, self._reach)
        which = np.cumsum(begins) - 1  # rows alike that follow each other are spread once
        block: Array = made[(np.arange(len(aging))[:, None] * len(given) + which).ravel()]
        energy = block[: len(drive)]
        return Spread(block, energy.sum(axis=1), ends(energy))

    def energy(self, spread: Spread, hit: float) -> Array:
        """What a whole frame leaves, (face rows, face columns)."""
        kept = np.full((1, self._across.shape[1]), hit, np.float32)
        face = np.empty((len(self._across), spread.rows.shape[1]), np.float32)
        return self._gathered(face, spread, 0, kept)

    def _gathered(self, face: Array, spread: Spread, age: int, kept: Array) -> Array:
        run(gather_rows, face, spread.rows, age, kept, self._across, self._bands)
        return face

    def play(
        self,
        tube: Tube,
        gun: int,
        dt: float,
        spread: Spread,
        kept: Array,
        parts: Sequence[PartOfARow],
        drive: Drive,
    ) -> None:
        """Let ``dt`` seconds pass for one gun; ``kept`` (1 + terms, rows): what fell and is left of rows."""
        stored, light = tube.blocks(gun)
        factors, layers, shares = tube.factors(gun, dt)
        run(
            refresh_face,
            stored,
            light,
            spread.rows,
            kept,
            self._across,
            self._bands,
            factors,
            layers,
            shares,
            spread.ends,
            _LOWEST,
        )
        tube.count(float((spread.sums * kept[0]) @ self._column_sums))
        for part in parts:
            across = self._across[part.face, part.row]
            given, *left = (np.outer(across, share) for share in self._part(part, drive))
            tube.deposit_aged(given, left, gun, (part.face, slice(None)))

    def settle(
        self, tube: Tube, gun: int, spread: Spread, kept: Array, parts: Sequence[PartOfARow], drive: Drive
    ) -> None:
        """Bring one gun to the luminances that ``kept`` (1 + terms, rows) of each row make."""
        stored, _light = tube.blocks(gun)
        factors, _layers, _shares = tube.factors(gun, 0.0)
        rows = len(self._across)
        for term, over in enumerate(factors[:, 2]):
            face = stored[term * rows : (term + 1) * rows]
            self._gathered(face, spread, term + 1, kept[term + 1 : term + 2] * over)
            for part in parts:
                share = self._part(part, drive)[term + 1]
                face[part.face] += np.outer(self._across[part.face, part.row], share * over)

    def _part(self, part: PartOfARow, drive: Drive) -> Array:
        """Some pixels of a row along the face, (ages, face columns)."""
        along = np.empty((len(part.kept), self._along.shape[1]), np.float32)
        one = np.ascontiguousarray(drive[part.row][None], np.float32)
        run(spread_rows, along, one, part.kept, self._along, self._reach)
        return along
