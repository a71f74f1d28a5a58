"""A cathode-ray tube steered by hand: what its parts are set to, and where its beam then is.

Its inputs drive the deflection over time as those of an oscilloscope do. Lengths in mm, times in seconds,
voltages in V, fields in mT; places on the face are from its middle, x to the right and y upwards.
"""

import math
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.scanning.electron_beam import electron_beam
from workbench.algorithms.scanning.electron_optics import (
    FACE_MM,
    FOCUS_SHARE,
    LENS_MM,
    PLATES_MM,
    beam_current,
    coil_sine,
    half_width,
    sharp_spot,
)
from workbench.display.phosphor import Phosphor
from workbench.display.setup import TubeSetup, phosphor_choices
from workbench.language import _

Floats = NDArray[np.float64]
Place = tuple[float, float, float, float]
"""z, x, y and the half width of the beam there, as the text emits them."""

OFF, SINE, SAWTOOTH = "off", "sine", "sawtooth"
WAVES = OFF, SINE, SAWTOOTH
USUAL_PHOSPHOR = "P1"
MOST_CYCLES = 60


@dataclass(frozen=True, slots=True)
class Deflection:
    """One way of deflecting: ``volts`` (or ``field`` of coils) held, or what an input gives over time.

    ``peak`` is in volts, ``peak_field`` in mT, ``phase`` in degrees.
    """

    volts: float = 0.0
    field: float = 0.0
    wave: str = OFF
    peak: float = 240.0
    peak_field: float = 0.8
    rate: float = 150.0
    phase: float = 0.0

    def drive(self, seconds: Floats, coils: bool) -> Floats:
        """Volts, or mT of coils, at these times."""
        if self.wave == OFF:
            return np.full_like(seconds, self.field if coils else self.volts)
        turns = self.rate * seconds + self.phase / 360.0
        shape = np.sin(2.0 * math.pi * turns) if self.wave == SINE else 2.0 * (turns - np.floor(turns)) - 1.0
        return (self.peak_field if coils else self.peak) * shape


@dataclass(frozen=True, slots=True)
class Gun:
    """What a tube is set to; ``moment`` is the time in milliseconds at which it is looked at."""

    grid: float = -18.0
    cut_off: float = -60.0
    current: float = 100.0
    gamma: float = 2.4
    focus: float = 420.0
    anode: float = 2000.0
    coils: bool = False
    x: Deflection = field(default_factory=lambda: Deflection(185.0, 0.4, OFF, 320.0, 1.0, 100.0))
    y: Deflection = field(default_factory=lambda: Deflection(192.0, 0.5))
    moment: float = 0.0
    length: float = 40.0
    gap: float = 16.0
    reach_x: float = 150.0
    reach_y: float = 200.0
    phosphor: str = USUAL_PHOSPHOR
    refresh: float = 60.0

    # The text, and what the page paints without it

    def arguments(self, seconds: float | None = None) -> tuple[Any, ...]:
        """What the text is given, at the moment or at a time."""
        tube = self.cut_off, self.current, self.gamma, self.length, self.gap, self.reach_x, self.reach_y
        at = np.array([self.moment * 1e-3 if seconds is None else seconds])
        drive = np.array([float(way.drive(at, self.coils)[0]) for way in (self.x, self.y)])
        terms = np.array([(t.weight, t.tau_s * 1e3) for gun in self.phosphors for t in gun.terms])
        terms[:, 0] /= len(self.phosphors)
        return self.grid, self.focus, self.anode, self.coils, drive, np.array(tube), terms, self.refresh

    def way(self, seconds: float | None = None) -> tuple[Place, ...]:
        """The beam's way as far as it gets, as the text emits it."""
        return tuple(electron_beam(*self.arguments(seconds)))

    def landing(self, seconds: Floats) -> tuple[Floats, Floats, NDArray[np.bool_]]:
        """x and y (mm from the middle) of the beam at these times, and whether it reaches the face there."""
        x, y = (way.drive(seconds, self.coils) for way in (self.x, self.y))
        if self.coils:
            field_mt = np.sqrt(x * x + y * y)
            sine = coil_sine(1.0, 0.0, self.anode, self.length) * field_mt
            out = sine < 1.0
            sine = np.where(out, sine, 0.0)
            fall = self.reach_y * sine / np.sqrt(1.0 - sine * sine) / np.maximum(field_mt, 1e-300)
            x, y = fall * x, fall * y
        else:
            out = np.maximum(np.abs(x), np.abs(y)) <= self.limit
            x, y = x * self.sensitivity(self.reach_x), y * self.sensitivity(self.reach_y)
        return x, y, out & (np.abs(x) <= FACE_MM[0] / 2.0) & (np.abs(y) <= FACE_MM[1] / 2.0)

    # Its numbers

    @property
    def phosphors(self) -> tuple[Phosphor, ...]:
        """What the face is coated with, three of a colour tube; the usual one where the name is unknown."""
        return _phosphors(self.phosphor)

    @property
    def beam_current(self) -> float:
        """What the grid passes, in microamperes."""
        return beam_current(self.grid, self.cut_off, self.current, self.gamma)

    @property
    def limit(self) -> float:
        """The voltage between the plates beyond which they catch the beam: 2 d² V_a / l²."""
        return 2.0 * self.gap * self.gap * self.anode / (self.length * self.length)

    def sensitivity(self, reach: float) -> float:
        """Millimetres on the face for a volt between plates ``reach`` mm before it: l D / (2 d V_a)."""
        return self.length * reach / (2.0 * self.gap * self.anode)

    @property
    def screen(self) -> float:
        """Where the face is, from the cathode."""
        return PLATES_MM + self.length / 2.0 + self.reach_y

    @property
    def best_focus(self) -> float:
        """The focusing voltage that brings the beam together at the screen."""
        return FOCUS_SHARE * self.anode

    @property
    def spot(self) -> float:
        """Half the width of the spot: the standard deviation of the Gaussian."""
        crossing = (self.screen - LENS_MM) * self.focus / self.best_focus
        return half_width(self.screen, crossing, sharp_spot(self.beam_current))

    def drive_to(self, x: float, y: float) -> tuple[float, float]:
        """The voltages, or fields, that send the beam to a place of the face."""
        if not self.coils:
            return x / self.sensitivity(self.reach_x), y / self.sensitivity(self.reach_y)
        away = math.hypot(x, y)
        if away == 0.0:
            return 0.0, 0.0
        sine = away / math.hypot(away, self.reach_y)
        strength = sine / coil_sine(1.0, 0.0, self.anode, self.length)
        return strength * x / away, strength * y / away

    # Its inputs

    @property
    def swings(self) -> bool:
        """Whether an input drives the deflection."""
        return self.x.wave != OFF or self.y.wave != OFF

    @property
    def period(self) -> Fraction:
        """Seconds until both inputs begin anew; that of the refresh where there are none."""
        rates = [Fraction(str(way.rate)) for way in (self.x, self.y) if way.wave != OFF]
        if not rates:
            return 1 / Fraction(str(self.refresh))
        common = rates[0]
        for rate in rates[1:]:
            common = Fraction(
                math.gcd(common.numerator * rate.denominator, rate.numerator * common.denominator),
                common.denominator * rate.denominator,
            )
        return 1 / common

    @property
    def cycles(self) -> int:
        """How many times the faster input swings in a period."""
        rates = [Fraction(str(way.rate)) for way in (self.x, self.y) if way.wave != OFF]
        return max((int(rate * self.period) for rate in rates), default=1)

    def fault(self) -> str:
        """Why such a tube cannot be, or cannot be shown; empty where it can."""
        if not self.coils and self.reach_y - self.reach_x < self.length:
            return _(
                "The two pairs of plates would overlap: D_y must be l longer than D_x, at least {least:g} mm."
            ).format(least=self.reach_x + self.length)
        shortest = self.reach_y if self.coils else self.reach_x
        if shortest <= self.length / 2.0:
            return _(
                "The screen would be inside the plates: D must be more than half of l, {half:g} mm."
            ).format(half=self.length / 2.0)
        if self.cycles > MOST_CYCLES:
            return _(
                "The inputs at {x:g} and {y:g} Hz begin anew only after {cycles:,} swings; choose rates "
                "with a simpler ratio, such as 100 and 150 Hz."
            ).format(x=self.x.rate, y=self.y.rate, cycles=self.cycles)
        return ""


@cache
def _phosphors(name: str) -> tuple[Phosphor, ...]:
    return TubeSetup(phosphor=name if name in phosphor_choices() else USUAL_PHOSPHOR).guns()
