"""The beam of a tube that is steered by its deflection voltages alone, as an oscilloscope's is.

Its way over one period of the inputs is cut into equal stretches of time; the energy of each falls as one hit
in its middle, a Gaussian spot. A hit belongs to exactly one stretch of time, however time is cut; as a spot
separates into a factor per row and one per column, many of them are one product of two matrices.
"""

import math
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.scanning.electron_optics import FACE_MM, sharp_spot
from workbench.display.beam import BeamState
from workbench.display.gun import Gun
from workbench.display.spot import NEAR, across_rows
from workbench.display.tube import Tube

Floats = NDArray[np.floating[Any]]

EXPOSED_UA = 45.0
"""The picture is exposed so that a sharp trace of this current is well seen."""

_PEAK, _DOT = 1.5, 6.0
_FEWEST, _MOST = 16, 3000
_PROBES = 512


class SteeredBeam:
    """Draws what the inputs of ``gun`` make of its beam on a face of ``FACE_MM``, over and over."""

    def __init__(self, tube: Tube, gun: Gun) -> None:
        self.gun = gun
        self._kind = tube.stored[0].dtype
        self._guns = len(tube.guns)
        period = float(gun.period)
        length, count = self._length_and_count(period)
        self._step = gun.period / count
        times = (np.arange(count, dtype=np.float64) + 0.5) * (period / count)
        x, y, reached = gun.landing(times)
        pitch_x, pitch_y = tube.pitch_mm
        self._along, self._across = (
            (across_rows(hits + side / 2, pitch * np.arange(cells + 1), gun.spot, NEAR[0]) * reached).astype(
                self._kind
            )
            for hits, side, pitch, cells in zip((x, y), FACE_MM, tube.pitch_mm, tube.size_px, strict=True)
        )
        pixel = pitch_x * pitch_y
        wide = math.sqrt(2.0 * math.pi) * sharp_spot(EXPOSED_UA)
        self.power = _PEAK * wide * (length + _DOT * wide) / pixel * gun.beam_current / EXPOSED_UA
        self._frames: Floats | None = None

    def _length_and_count(self, period: float) -> tuple[float, int]:
        """How far the spot runs in a period (mm), and into how many hits that is cut."""
        if not self.gun.swings:
            return 0.0, _FEWEST
        probes = np.linspace(0.0, period, _PROBES * min(self.gun.cycles, 8) // 2 + 1)
        x, y, reached = self.gun.landing(probes)
        steps = np.hypot(np.diff(x), np.diff(y))
        lit = steps[reached[:-1] & reached[1:] & (steps < FACE_MM[0] / 2)]
        length = float(lit.sum())
        return length, min(max(math.ceil(length / self.gun.spot), _FEWEST), _MOST)

    @property
    def frame_s(self) -> Fraction:
        """Seconds from one picture to the next."""
        return self.gun.period

    @property
    def count(self) -> int:
        """Hits in a period."""
        return len(self._along.T)

    def _map(self, weights: Floats, hits: slice | NDArray[np.int64]) -> Floats:
        """The energy of these hits of one period, each times its weight."""
        energy = self.power * float(self._step)
        if not self.gun.swings:  # all fall in one place
            whole = self._kind.type(energy * float(weights.sum()))
            return np.outer(self._across[:, 0] * whole, self._along[:, 0])
        spread: Floats = (self._across[:, hits] * (weights * energy).astype(self._kind)) @ self._along[
            :, hits
        ].T
        return spread

    def energy_per_frame(self, gun: int = 0) -> Floats:
        """What one whole period deposits, (face rows, face columns); read-only."""
        if self._frames is None:
            self._frames = self._map(np.ones(self.count), slice(None))
            self._frames.setflags(write=False)
        return self._frames

    def _hits_before(self, seconds: Fraction) -> int:
        """How many hits fell since the start, up to and including a time."""
        return math.floor(seconds / self._step + Fraction(1, 2))

    def _age(self, hit: NDArray[np.int64], seconds: Fraction) -> Floats:
        """Seconds since these hits."""
        whole = math.floor(seconds / self._step)
        rest = float(seconds / self._step - whole)
        ages: Floats = ((whole - hit) + (rest - 0.5)) * float(self._step)
        return ages

    def play(self, tube: Tube, ticks: int | Fraction) -> None:
        """Let time pass on the tube while the beam runs."""
        first = self._hits_before(tube.seconds)
        tube.advance(ticks)
        end = self._hits_before(tube.seconds)
        latest = np.arange(max(first, end - self.count), end)
        if not len(latest):
            return
        fallen = (latest - first) // self.count + 1
        ages, places = self._age(latest, tube.seconds), latest % self.count
        for gun, phosphor in enumerate(tube.guns):
            energy = self._map(fallen.astype(np.float64), places)
            left = [self._map(self._kept(ages, fallen, term.tau_s), places) for term in phosphor.terms]
            tube.deposit_aged(energy, left, gun)

    def _kept(self, ages: Floats, counts: NDArray[np.int64], tau_s: float) -> Floats:
        """Sum of exp(-age / tau) over ``counts`` hits, a period apart; the youngest is of this age."""
        period = float(self.frame_s) / tau_s
        kept: Floats = np.exp(-ages / tau_s) * np.expm1(-counts * period) / math.expm1(-period)
        return kept

    def settle(self, tube: Tube) -> None:
        """Bring the tube to the state it would have, had the inputs always been so."""
        end = self._hits_before(tube.seconds)
        latest = np.arange(end - self.count, end)
        ages, places = self._age(latest, tube.seconds), latest % self.count
        for gun, phosphor in enumerate(tube.guns):
            luminances = []
            for term, share in zip(phosphor.terms, phosphor.energy_fractions, strict=True):
                kept = np.exp(-ages / term.tau_s) / -math.expm1(-float(self.frame_s) / term.tau_s)
                luminances.append(self._map(kept, places) * (share / term.tau_s))
            tube.settle(luminances, gun)

    def state(self, seconds: Fraction) -> BeamState:
        """Where the beam is and what it does at a time; as current its share of that at 0 V of the grid."""
        frame, within = divmod(seconds, self.frame_s)
        x, y, reached = self.gun.landing(np.array([float(within)]))
        current = self.gun.beam_current / self.gun.current if self.gun.current > 0.0 else 0.0
        lit = bool(reached[0]) and current > 0.0
        place = (float(x[0]) + FACE_MM[0] / 2, float(y[0]) + FACE_MM[1] / 2)
        currents = (current if lit else 0.0,) * self._guns
        return BeamState(*place, currents, lit, 0, int(within / self._step), int(frame))


def steered_tube(gun: Gun, size_px: tuple[int, int], precision: Any = np.float32) -> tuple[Tube, SteeredBeam]:
    """A tube with a face of so many pixels, and the beam that its settings make."""
    tube = Tube(size_px, FACE_MM, gun.phosphors, spot_mm=gun.spot, precision=precision)
    return tube, SteeredBeam(tube, gun)
