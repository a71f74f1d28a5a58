"""What the beam of a raster still draws while it flies back, when brightness is turned up.

Every line ends in a flight to the left; behind the last one the beam runs up again, over several lines, in a
zigzag across the whole face. The energy of each line's flight falls as one hit in its middle, and so does
that of the whole way of each line of the vertical retrace.
"""

import math
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.display.beam import BeamState
from workbench.display.raster_beam import RasterBeam
from workbench.display.spot import along_row, narrowed, stroke_energy
from workbench.display.timings import RasterTiming
from workbench.display.tube import Tube

Floats = NDArray[np.floating[Any]]

_JUST_BEFORE = Fraction(1, 10**6)


class _Flight(NamedTuple):
    """What a stretch of a line leaves on a box of the face, one unit for each of its clocks."""

    rows: slice
    columns: slice
    energy: Floats


class RetracingBeam(RasterBeam):
    """A raster's beam that is not quite dark while it is blanked: ``blanked`` is its current then, 0 to 1."""

    def __init__(
        self,
        tube: Tube,
        timing: RasterTiming,
        drive: Floats,
        area_mm: tuple[float, float, float, float],
        power: float = 1.0,
        blanked: float = 0.0,
    ) -> None:
        super().__init__(tube, timing, drive, area_mm, power)
        self.blanked = blanked
        self._kind = tube.stored[0].dtype
        rows = [timing.row_of_line(line) for line in range(timing.v_total)]
        active = np.array([line for line, row in enumerate(rows) if row is not None])
        blank = np.array([line for line, row in enumerate(rows) if row is None])
        self._flown = np.array([timing.v_active - 1 - row for row in rows if row is not None])
        middle = (timing.h_active + timing.h_total) / 2.0
        self._clocks = active * timing.h_total + middle, (blank + 0.5) * timing.h_total
        self._profile = self._flight_profile(tube)
        self._zigzag = [self._way(tube, int(line)) for line in blank]
        self._retrace = self._flights(np.ones(len(active)), np.ones(len(blank)))

    # Where it flies

    def _turns(self) -> list[tuple[int, int]]:
        """The stretches of a line, in clocks, on which the beam keeps its pace across; the first is lit."""
        timing = self.timing
        sync = timing.h_active + timing.h_front_porch
        marks = (0, timing.h_active, sync, sync + timing.h_sync, timing.h_total)
        return [(a, b) for a, b in pairwise(marks) if b > a]

    def _places(self, line: int, start: int, end: int) -> tuple[tuple[float, float], tuple[float, float]]:
        """Where the beam is at the start and at the end of a stretch of a line."""
        first = Fraction(line * self.timing.h_total)
        states = [
            super(RetracingBeam, self).state((first + clock) * self.timing.pixel_s)
            for clock in (Fraction(start), end - _JUST_BEFORE)
        ]
        return (states[0].x_mm, states[0].y_mm), (states[1].x_mm, states[1].y_mm)

    def _flight_profile(self, tube: Tube) -> Floats:
        """What the flight of a lit line leaves on each column of the face."""
        edges = np.linspace(0.0, tube.size_mm[0], tube.size_px[0] + 1)
        total = np.zeros(tube.size_px[0])
        for start, end in self._turns()[1:]:
            (x0, _y0), (x1, _y1) = self._places(0, start, end)
            total += along_row(np.array(sorted((x0, x1))), edges, tube.spot_mm)[:, 0] * (end - start)
        return narrowed(total, self._kind)

    def _way(self, tube: Tube, line: int) -> list[_Flight]:
        """What a whole line of the vertical retrace leaves."""
        flights = []
        for start, end in self._turns():
            places = self._places(line, start, end)
            patch = stroke_energy(
                tube.size_px, tube.size_mm, *places, tube.spot_mm, float(end - start), tube.reach
            )
            flights.append(_Flight(patch.rows, patch.columns, narrowed(patch.values, self._kind)))
        return flights

    def _flights(self, lit: Floats, blank: Sequence[float] | Floats) -> Floats:
        """The energy of the flights of all lit and blank lines, each times its weight."""
        hit = self._hit * self.blanked
        along_rows = self._across[:, self._flown] @ (lit * hit).astype(self._kind)
        total: Floats = np.outer(along_rows, self._profile)
        for weight, way in zip(blank, self._zigzag, strict=True):
            for flight in way:
                total[flight.rows, flight.columns] += flight.energy * self._kind.type(weight * hit)
        return total

    # What it leaves

    def show(self, drive: Floats) -> None:
        """Scan another picture of the same size from now on; raises ValueError for another size."""
        self._whole: dict[int, Floats] = {}
        super().show(drive)

    def energy_per_frame(self, gun: int = 0) -> Floats:
        """What one whole frame deposits, (face rows, face columns); read-only."""
        if gun not in self._whole:
            self._whole[gun] = super().energy_per_frame(gun) + self._retrace
            self._whole[gun].setflags(write=False)
        return self._whole[gun]

    def play(self, tube: Tube, ticks: int | Fraction) -> None:
        """Let time pass on the tube while the beam scans, and flies back."""
        t0 = tube.seconds
        super().play(tube, ticks)
        fallen = [self._passed(clocks, t0, tube.seconds) for clocks in self._clocks]
        if not any(counts.any() for counts, _ages in fallen):
            return
        for gun, phosphor in enumerate(tube.guns):
            energy = self._flights(*(counts for counts, _ages in fallen))
            left = [
                self._flights(*(self._left(counts, ages, term.tau_s) for counts, ages in fallen))
                for term in phosphor.terms
            ]
            tube.deposit_aged(energy, left, gun)

    def _passed(self, clocks: Floats, t0: Fraction, t1: Fraction) -> tuple[Floats, Floats]:
        """How often each hit fell in (t0, t1], and how many seconds ago it last did."""
        rate, frame = self.timing.pixel_clock_hz, self.timing.clocks_per_frame
        span = float((t1 - t0) * rate)
        ahead = (clocks - float(t0 * rate % frame)) % frame
        ahead = np.where(ahead == 0.0, float(frame), ahead)
        counts = np.maximum(np.floor((span - ahead) / frame) + 1.0, 0.0)
        ages = np.where(counts > 0.0, span - ahead - (counts - 1.0) * frame, 0.0)
        return counts, ages * float(self.timing.pixel_s)

    def _left(self, counts: Floats, ages: Floats, tau_s: float) -> Floats:
        """The sum of exp(-age / tau) over so many hits a frame apart, the youngest of this age."""
        frame = float(self.frame_s) / tau_s
        kept: Floats = np.exp(-ages / tau_s) * np.expm1(-counts * frame) / math.expm1(-frame)
        return kept

    def settle(self, tube: Tube) -> None:
        """Bring the tube to the state it would have, had this picture always been scanned until now."""
        super().settle(tube)
        frame, pixel = self.timing.clocks_per_frame, float(self.timing.pixel_s)
        clock = float(tube.seconds * self.timing.pixel_clock_hz % frame)
        ages = [((clock - clocks) % frame) * pixel for clocks in self._clocks]
        for gun, phosphor in enumerate(tube.guns):
            luminances = []
            for k, (term, share) in enumerate(zip(phosphor.terms, phosphor.energy_fractions, strict=True)):
                forever = -math.expm1(-float(self.frame_s) / term.tau_s)
                flights = self._flights(*(np.exp(-age / term.tau_s) / forever for age in ages))
                luminances.append(tube.stored[gun][k] + flights * (share / term.tau_s))
            tube.settle(luminances, gun)

    def state(self, seconds: Fraction) -> BeamState:
        """Where the beam is and what it does at a time; blanked it has its rest of a current."""
        state = super().state(seconds)
        if state.lit:
            return state
        return state._replace(currents=tuple(self.blanked for _gun in state.currents))
