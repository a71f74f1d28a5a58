"""The beam of a raster tube: a function of time, and what it leaves on the face.

The video signal gives one sample per pixel clock. Its energy falls as one hit in the middle of its clock,
spread by the spot along the pixel's width and across its row. A hit belongs to exactly one stretch of time,
however time is cut. Since the spot separates into a factor per row and one per column, and decay into one
per line and one per clock, whole frames are products of narrow matrices. They stand for the text
``raster_scan``; the law: ``scanning/test_scanning.py::test_the_raster_tube_scans_in_the_order_of_the_text``.
"""

import math
from copy import copy
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.display.beam import BeamState
from workbench.display.face_kernels import at_hand
from workbench.display.phosphor import Phosphor
from workbench.display.raster_refresh import PartOfARow, RasterRefresh, Spread
from workbench.display.spot import NEAR, across_rows, along_row, narrowed
from workbench.display.timings import RasterTiming
from workbench.display.tube import Tube

Floats = NDArray[np.floating[Any]]


_BLOCK = 16
"""Rows deposited together: a spot reaches few lines, so the product of all rows would be mostly zeros."""


@dataclass(frozen=True, slots=True)
class _Rows:
    """The lines scanned in full in a stretch of time: rows, how often, age of their last pixel."""

    rows: NDArray[np.int64]
    counts: NDArray[np.int64]
    ages_clocks: NDArray[np.float64]


Part = tuple[int, int, int, int]
"""Row, first column, column after the last, clock of column 0."""


class RasterBeam:
    """Scans ``drive`` (guns, rows, columns), beam currents 0 to 1, row 0 at the bottom, over an area.

    ``area_mm`` is (left, bottom, right, top) on the face. ``power`` is the energy per second of a full
    current. Raises ValueError when the picture does not have the size that the timing scans.
    """

    def __init__(
        self,
        tube: Tube,
        timing: RasterTiming,
        drive: Floats,
        area_mm: tuple[float, float, float, float],
        power: float = 1.0,
    ) -> None:
        self.timing = timing
        self.area_mm = area_mm
        self.power = power
        columns, rows = tube.size_px
        left, bottom, right, top = area_mm
        kind = tube.stored[0].dtype
        near = NEAR[0] if kind == np.float32 else NEAR[1]
        x_edges = np.linspace(0.0, tube.size_mm[0], columns + 1)
        y_edges = np.linspace(0.0, tube.size_mm[1], rows + 1)
        cuts = np.linspace(left, right, timing.h_active + 1)
        self._row_pitch = (top - bottom) / timing.v_active
        self._centres = bottom + (np.arange(timing.v_active) + 0.5) * self._row_pitch
        self._along: Floats = narrowed(along_row(cuts, x_edges, tube.spot_mm, near).T, kind)
        self._across: Floats = narrowed(across_rows(self._centres, y_edges, tube.spot_mm, near), kind)
        self._face_pitch = tube.size_mm[1] / rows
        self._margin = (tube.reach + 0.5) * tube.spot_mm
        self._refresh: RasterRefresh | None = None
        lines = [timing.line_of_row(timing.v_active - 1 - row) for row in range(timing.v_active)]
        self._row_clock = np.array(lines, dtype=np.int64) * timing.h_total
        self.show(drive)

    def with_drive(self, drive: Floats) -> "RasterBeam":
        """The same beam with another picture of the same size; raises ValueError for another size."""
        beam = copy(self)
        beam.show(drive)
        return beam

    def show(self, drive: Floats) -> None:
        """Scan another picture of the same size from now on; raises ValueError for another size."""
        expected = self.timing.v_active, self.timing.h_active
        if drive.ndim != 3 or drive.shape[1:] != expected:
            raise ValueError(
                f"The picture has {drive.shape[-1]} x {drive.shape[-2]} pixels, "
                f"the timing scans {expected[1]} x {expected[0]}."
            )
        self.drive = drive.astype(self._along.dtype, copy=False)
        self._spread: dict[tuple[int, float], Floats] = {}
        self._blocks: dict[int, Spread] = {}
        self._frames: dict[int, Floats] = {}

    @property
    def frame_s(self) -> Fraction:
        """Seconds from one picture to the next."""
        return self.timing.frame_s

    def _spread_rows(self, gun: int, tau_s: float) -> Floats:
        """Each row spread along x, its pixels aged to the end of the row: (rows, face columns)."""
        key = gun, tau_s
        if key not in self._spread:
            aged = self.drive[gun]
            if math.isfinite(tau_s):
                clocks = np.arange(self.timing.h_active - 1, -1, -1)
                aged = aged * narrowed(np.exp(-clocks * (float(self.timing.pixel_s) / tau_s)), aged.dtype)
            self._spread[key] = aged @ self._along
        return self._spread[key]

    @property
    def _hit(self) -> float:
        return self.power * float(self.timing.pixel_s)

    def energy_per_frame(self, gun: int = 0) -> Floats:
        """What one whole frame deposits, (face rows, face columns); read-only."""
        if gun not in self._frames and self._refresh is not None:
            self._frames[gun] = self._refresh.energy(self._block(gun), self._hit)
            self._frames[gun].setflags(write=False)
        if gun not in self._frames:
            self._frames[gun] = self._across @ self._spread_rows(gun, math.inf) * self._hit
            self._frames[gun].setflags(write=False)
        return self._frames[gun]

    def hits_before(self, seconds: Fraction) -> int:
        """Pixel clocks whose middle lies before or at a time."""
        return math.floor(seconds * self.timing.pixel_clock_hz + Fraction(1, 2))

    def _full_rows(self, first: int, end: int, now_clocks: Fraction) -> _Rows:
        frame = self.timing.clocks_per_frame
        base, width = self._row_clock, self.timing.h_active
        earliest = -((base - first) // frame)
        latest = (end - width - base) // frame
        counts = np.maximum(latest - earliest + 1, 0)
        rows = np.flatnonzero(counts)
        last_clock = base[rows] + latest[rows] * frame + width - 1
        whole = math.floor(now_clocks)
        ages = (whole - last_clock) + (float(now_clocks - whole) - 0.5)
        return _Rows(rows, counts[rows], ages.astype(np.float64))

    def _partial_rows(self, first: int, end: int) -> list[tuple[int, int, int, int]]:
        """Rows scanned in part as (row, first column, column after the last, clock of column 0)."""
        found: dict[tuple[int, int], tuple[int, int, int, int]] = {}
        for clock in (first, end - 1):
            line_start = clock - clock % self.timing.h_total
            row_from_top = self.timing.row_of_line(line_start // self.timing.h_total % self.timing.v_total)
            if row_from_top is None:
                continue
            low = max(first - line_start, 0)
            high = min(end - line_start, self.timing.h_active)
            if low < high and (low > 0 or high < self.timing.h_active):
                row = self.timing.v_active - 1 - row_from_top
                found[row, line_start] = (row, low, high, line_start)
        return list(found.values())

    def _face_rows(self, first_row: int, last_row: int) -> slice:
        low = (self._centres[first_row] - self._margin) / self._face_pitch
        high = (self._centres[last_row] + self._margin) / self._face_pitch
        return slice(max(math.floor(low), 0), min(math.ceil(high), len(self._across)))

    def _compiled(self, tube: Tube) -> RasterRefresh | None:
        """The compiled way, where the tube is for looking at and the texts are at hand."""
        if self._refresh is None and self._along.dtype == np.float32 and at_hand():
            self._refresh = RasterRefresh(self._along, self._across, tube.guns, float(self.timing.pixel_s))
        return self._refresh

    def _block(self, gun: int) -> Spread:
        """The rows of a gun spread along the face, as ``RasterRefresh`` takes them."""
        assert self._refresh is not None
        if gun not in self._blocks:
            self._blocks[gun] = self._refresh.spread(self.drive[gun], gun)
        return self._blocks[gun]

    def _parts(self, gun: Phosphor, parts: list[Part], now_clocks: Fraction) -> list[PartOfARow]:
        """Rows scanned in part, with what is left of their pixels."""
        made = []
        for row, low, high, line_start in parts:
            age = float(now_clocks - line_start - Fraction(1, 2)) - np.arange(low, high)
            kept = np.zeros((1 + len(gun.terms), self.timing.h_active), np.float32)
            for k, tau in enumerate((math.inf, *(term.tau_s for term in gun.terms))):
                kept[k, low:high] = np.exp(-age * (float(self.timing.pixel_s) / tau)) * self._hit
            made.append(PartOfARow(row, kept, self._face_rows(row, row)))
        return made

    def _kept_of(self, gun: Phosphor, full: _Rows, for_ever: bool) -> NDArray[np.float32]:
        """What fell of each row, and what is left of each term of it, (1 + terms, rows)."""
        kept = np.zeros((1 + len(gun.terms), self.timing.v_active), np.float32)
        kept[0, full.rows] = full.counts * self._hit
        for k, term in enumerate(gun.terms, 1):
            counts = None if for_ever else full.counts
            kept[k, full.rows] = self._kept(full.ages_clocks, counts, term.tau_s) * self._hit
        return kept

    def _play_fast(self, refresh: RasterRefresh, tube: Tube, ticks: int | Fraction) -> None:
        start = tube.seconds
        tube.skip(ticks)
        first, end = self.hits_before(start), self.hits_before(tube.seconds)
        now = tube.seconds * self.timing.pixel_clock_hz
        full = self._full_rows(first, end, now)
        partial = self._partial_rows(first, end) if end > first else []
        for gun, phosphor in enumerate(tube.guns):
            kept, parts = self._kept_of(phosphor, full, False), self._parts(phosphor, partial, now)
            seconds = float(ticks * tube.tick)
            refresh.play(tube, gun, seconds, self._block(gun), kept, parts, self.drive[gun])

    def play(self, tube: Tube, ticks: int | Fraction) -> None:
        """Let time pass on the tube while the beam scans."""
        refresh = self._compiled(tube)
        if refresh is not None and ticks > 0:
            self._play_fast(refresh, tube, ticks)
            return
        start = tube.seconds
        tube.advance(ticks)
        first, end = self.hits_before(start), self.hits_before(tube.seconds)
        if end <= first:
            return
        now = tube.seconds * self.timing.pixel_clock_hz
        full = self._full_rows(first, end, now)
        for gun, phosphor in enumerate(tube.guns):
            taus = [term.tau_s for term in phosphor.terms]
            if len(full.rows):
                self._deposit_rows(tube, gun, full, taus)
            for part in self._partial_rows(first, end):
                self._deposit_part(tube, gun, part, taus, now)

    def _deposit_rows(self, tube: Tube, gun: int, full: _Rows, taus: list[float]) -> None:
        counts = full.counts.astype(self._across.dtype)
        kept = [counts, *(self._kept(full.ages_clocks, full.counts, tau) for tau in taus)]
        for first in range(0, len(full.rows), _BLOCK):
            block = slice(first, first + _BLOCK)
            rows = full.rows[block]
            face = self._face_rows(int(rows.min()), int(rows.max()))
            across = self._across[face][:, rows] * self._hit
            energy, *remainders = (
                across @ (share[block, None] * self._take(gun, tau, rows))
                for tau, share in zip((math.inf, *taus), kept, strict=True)
            )
            tube.deposit_aged(energy, remainders, gun, (face, slice(None)))

    def _take(self, gun: int, tau_s: float, rows: NDArray[np.int64]) -> Floats:
        return self._spread_rows(gun, tau_s)[rows]

    def _kept(self, ages_clocks: Floats, counts: NDArray[np.int64] | None, tau_s: float) -> Floats:
        """Sum of exp(-age/tau) over the hits of each row, one frame apart; counts None means for ever."""
        clock, frame = float(self.timing.pixel_s), float(self.timing.frame_s)
        youngest = np.exp(-ages_clocks * (clock / tau_s))
        together = 1.0 if counts is None else -np.expm1(-counts * (frame / tau_s))
        kept: Floats = youngest * together / -math.expm1(-frame / tau_s)
        return narrowed(kept, self._across.dtype)

    def _deposit_part(
        self, tube: Tube, gun: int, part: tuple[int, int, int, int], taus: list[float], now_clocks: Fraction
    ) -> None:
        face = self._face_rows(part[0], part[0])
        energy, *remainders = (self._part(gun, part, tau, now_clocks) for tau in (math.inf, *taus))
        tube.deposit_aged(energy, remainders, gun, (face, slice(None)))

    def _part(self, gun: int, part: tuple[int, int, int, int], tau_s: float, now_clocks: Fraction) -> Floats:
        """What some pixels of one row have left on the rows of the face near it, decayed until now."""
        row, low, high, line_start = part
        across = self._across[self._face_rows(row, row), row] * self._hit
        age = float(now_clocks - line_start - Fraction(1, 2)) - np.arange(low, high)
        current = self.drive[gun, row, low:high]
        kept = narrowed(np.exp(-age * (float(self.timing.pixel_s) / tau_s)), current.dtype)
        return np.outer(across, (current * kept) @ self._along[low:high])

    def settle(self, tube: Tube) -> None:
        """Bring the tube to the state it would have, had this picture always been scanned until now."""
        now = tube.seconds * self.timing.pixel_clock_hz
        end = self.hits_before(tube.seconds)
        full = self._full_rows(end - 2 * self.timing.clocks_per_frame, end, now)
        begun = self._partial_rows((end - 1) // self.timing.h_total * self.timing.h_total, end)
        before, refresh = tube.stored_energy(), self._compiled(tube)
        for gun, phosphor in enumerate(tube.guns):
            if refresh is not None:
                kept, parts = self._kept_of(phosphor, full, True), self._parts(phosphor, begun, now)
                refresh.settle(tube, gun, self._block(gun), kept, parts, self.drive[gun])
                continue
            luminances = []
            for term, share in zip(phosphor.terms, phosphor.energy_fractions, strict=True):
                kept = self._kept(full.ages_clocks, None, term.tau_s)
                rows = kept[:, None] * self._take(gun, term.tau_s, full.rows)
                left = self._across[:, full.rows] @ rows * self._hit
                for part in begun:
                    left[self._face_rows(part[0], part[0])] += self._part(gun, part, term.tau_s, now)
                luminances.append(left * (share / term.tau_s))
            tube.settle(luminances, gun)
        if refresh is not None:
            tube.count(tube.stored_energy() - before)

    def state(self, seconds: Fraction) -> BeamState:
        """Where the beam is and what it does at a time."""
        clocks = seconds * self.timing.pixel_clock_hz
        clock = math.floor(clocks)
        line, column = divmod(clock % self.timing.clocks_per_frame, self.timing.h_total)
        along = float(clocks - clock) + column
        row_from_top = self.timing.row_of_line(line)
        lit = row_from_top is not None and column < self.timing.h_active
        down = self._vertical(line, column)
        left, bottom, right, top = self.area_mm
        x = left + (right - left) * self._horizontal(along) / self.timing.h_active
        y = top - (top - bottom) * down / self.timing.v_active
        currents: tuple[float, ...] = (0.0,) * len(self.drive)
        if lit and row_from_top is not None:
            currents = tuple(
                float(gun[self.timing.v_active - 1 - row_from_top, column]) for gun in self.drive
            )
        return BeamState(x, y, currents, lit, line, column, clock // self.timing.clocks_per_frame)

    def _horizontal(self, along: float) -> float:
        """The sawtooth of the line, in pixels from the left edge; it flies back during sync."""
        t = self.timing
        sync = t.h_active + t.h_front_porch
        if along < sync:
            return along
        if along < sync + t.h_sync:
            return sync - (sync + t.h_back_porch) * (along - sync) / t.h_sync
        return along - t.h_total

    def _vertical(self, line: int, column: int) -> float:
        """The sawtooth of the frame, in rows from the top edge; it flies back during sync."""
        t = self.timing
        row = t.row_of_line(line)
        if row is not None:
            return row + 0.5
        fields = 2 if t.interlaced else 1
        within = (line + column / t.h_total) % float(t.lines_per_field)
        bottom = t.v_active / fields
        back = (t.v_front_porch + t.v_sync) / fields + bottom
        if within < bottom + t.v_front_porch / fields:
            return float(t.v_active)
        if within < back:
            share = (within - bottom - t.v_front_porch / fields) / (t.v_sync / fields)
            return t.v_active * (1.0 - share)
        return 0.0
