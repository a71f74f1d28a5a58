"""A tube that is kept running: which stretch of tube time a stretch of ours is, and what light comes of it.

Averaged, every instant is shown as the mean over a whole picture, so that nothing flickers and the
phosphor's persistence still shows; otherwise the beam is where it is. A picture that has become steady is
computed in closed form.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.display.beam import Beam, BeamState
from workbench.display.tube import PICOSECOND, Tube

Light = NDArray[np.float32]

VISIBLE = 1.0 / 500.0
"""A change of luminance below this share of white is not seen."""

INSTANT = Fraction(1000)
"""So few ticks that the light does not change meanwhile."""

SAFE_HZ = 3.0
"""Full-screen changes faster than this can harm; they are averaged unless asked for."""


class TubeDriver:
    """One tube and its beam. ``lights``: luminances of the last stretch of time, one per gun and layer."""

    def __init__(self, tube: Tube, beam: Beam) -> None:
        self.tube = tube
        self.beam = beam
        self.lights: list[Light] = self._steady()
        self._spare: list[Light] = []
        self._own = False
        self.change = 0.0
        self._averaged_before = True
        self._settled = False

    def show(self, beam: Beam) -> None:
        """Drive the tube with another beam from now on; what was on the face fades."""
        if self._averaged_before and self._settled:
            self._begin_averaged(self.lights_of(self.beam))
        self.beam = beam
        self._settled = False

    def settle(self) -> None:
        """Jump to the picture that the beam makes when it has run for long."""
        self._show_steady()
        self.change = 0.0
        self._settled = self._averaged_before = True

    def _show_steady(self) -> None:
        self.lights, self._own = self._steady(), False

    @property
    def steady(self) -> bool:
        """Whether an averaged picture no longer changes visibly."""
        return self._settled

    @property
    def averages(self) -> bool:
        """Whether the light is that of whole pictures; to find the beam's own takes long at first."""
        return self._averaged_before

    def lights_of(self, beam: Beam) -> list[Light]:
        """Mean luminance per gun of a beam that has run for long."""
        rate = 1.0 / float(beam.frame_s)
        return [(beam.energy_per_frame(gun) * rate).astype(np.float32) for gun in range(len(self.tube.guns))]

    def _steady(self) -> list[Light]:
        lights: list[Light] = []
        for phosphor, mean in zip(self.tube.guns, self.lights_of(self.beam), strict=True):
            shares = [0.0] * len(phosphor.colours)
            layers = [name for name, _ in phosphor.colours]
            for term, share in zip(phosphor.terms, phosphor.energy_fractions, strict=True):
                shares[layers.index(term.layer)] += share
            lights.extend(mean * np.float32(share) for share in shares)
        return lights

    def _begin_averaged(self, powers: Sequence[NDArray[Any]]) -> None:
        for gun, phosphor in enumerate(self.tube.guns):
            self.tube.settle([powers[gun] * np.float32(share) for share in phosphor.energy_fractions], gun)

    def advance(self, ticks: Fraction, averaged: bool) -> None:
        """Let tube time pass and collect the light it gives."""
        if ticks <= 0:
            return
        if averaged and self._settled and self._averaged_before:
            self.tube.skip(ticks)
            return
        if averaged:
            for gun, power in enumerate(self.lights_of(self.beam)):
                self.tube.sustain(power, ticks, gun)
        else:
            if self._averaged_before:
                self.beam.settle(self.tube)
                self.tube.exposure()
            self.beam.play(self.tube, ticks)
        self._collect(float(ticks * self.tube.tick), averaged)
        self._settled = averaged and self._near_steady()
        if self._settled:
            self._show_steady()
        self._averaged_before = averaged

    def hold_at(self, phase: Fraction) -> None:
        """Go on to a time since the start of a picture, as if this one had always been shown.

        The light is that of this instant.
        """
        self.tube.skip((phase - self.tube.seconds) % self.beam.frame_s / self.tube.tick)
        self._averaged_before = True
        self.advance(INSTANT, False)

    def _collect(self, seconds: float, averaged: bool) -> None:
        """Take the light of the time just passed, and, averaged, how much it has changed."""
        before = self.lights
        self._spare, self.lights = before if self._own else [], self._spare or _like(before)
        self.tube.collect(self.lights, 1.0 / seconds)
        self._own = True
        if averaged:
            pairs = zip(self.lights, before, strict=True)
            self.change = max(float(np.abs(new - old).max()) for new, old in pairs)

    def _near_steady(self) -> bool:
        if self.change > VISIBLE:
            return False
        return all(
            float(np.abs(light - goal).max()) < VISIBLE
            for light, goal in zip(self.lights, self._steady(), strict=True)
        )

    def state(self) -> BeamState:
        """The beam now."""
        return self.beam.state(self.tube.seconds)


def driven(
    make: Callable[[], tuple[Tube, Beam]],
    seconds: Fraction,
    slow_motion: float,
    calm: bool,
    held_at: Fraction | None = None,
) -> TubeDriver:
    """The driver of a new tube and its beam after so many seconds, as if they had run for long; ``held_at``
    is the time since the start of a picture at which it stands."""
    tube, beam = make()
    tube.skip(seconds / PICOSECOND)
    driver = TubeDriver(tube, beam)
    driver.settle()
    if held_at is not None or not must_average(1.0 / float(beam.frame_s), slow_motion, calm):
        driver.hold_at(seconds if held_at is None else held_at)
    return driver


def _like(lights: Sequence[Light]) -> list[Light]:
    return [np.empty_like(light) for light in lights]


def must_average(refresh_hz: float, slow_motion: float, calm: bool) -> bool:
    """Whether a picture repeated this often and slowed this much is averaged: when calm and too fast."""
    return calm and refresh_hz / slow_motion > SAFE_HZ
