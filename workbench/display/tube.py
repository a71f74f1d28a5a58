"""The tube: energy goes in, light comes out, and nothing is lost in between.

Per gun and exponential term one number per pixel of the face: the luminance that comes from that term. A
hit of energy E adds E e_k / tau_k to it, time takes it away, what it emits is collected as exposure. Time
is a count of ticks, an exact rational number; every step is exact for its length, so the way time is cut
does not matter.

What is stepped of one place by the text ``phosphor_decay`` is done here to the whole face at once; the law
that both are equal: ``scanning/test_scanning.py::test_the_tube_fades_as_the_text_says``.

Frame: millimetres on the face, origin at its lower left corner, y upwards; arrays are (rows, columns), row
0 at the bottom. Energy is in any unit; luminance is that unit per second and pixel.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.display.phosphor import Phosphor
from workbench.display.spot import Patch, stroke_energy, stroke_remainder

Floats = NDArray[np.floating[Any]]

PICOSECOND = Fraction(1, 10**12)
_LOWEST = np.float32(1e-6)
WHOLE = slice(None), slice(None)


def _total(values: Floats) -> float:
    """The sum; float32 is summed as it is, which is fast and as accurate as the values are."""
    return float(values.sum())


class Tube:
    """A face of ``size_px`` (columns, rows) and ``size_mm`` (width, height), one phosphor per gun.

    ``tick`` is the length of one tick in seconds. A spot is followed out to ``reach`` of its standard
    deviations (4 lose 1e-4 of the energy, 8 nothing). ``precision`` is the type of the state: float64 for
    measuring, float32 for looking (luminances should then be about 1). Raises ValueError for a face without
    area or without a gun.
    """

    def __init__(
        self,
        size_px: tuple[int, int],
        size_mm: tuple[float, float],
        guns: Sequence[Phosphor],
        *,
        spot_mm: float = 0.3,
        reach: float = 8.0,
        tick: Fraction = PICOSECOND,
        precision: type[np.floating[Any]] = np.float64,
    ) -> None:
        if min(size_px) < 1 or not min(size_mm) > 0.0:
            raise ValueError("A tube needs a face: at least one pixel and more than 0 mm each way.")
        if not guns:
            raise ValueError("A tube needs at least one gun.")
        self.size_px = size_px
        self.size_mm = size_mm
        self.guns = tuple(guns)
        self.spot_mm = spot_mm
        self.reach = reach
        self.tick = tick
        self._ticks = Fraction(0)
        columns, rows = size_px
        shape = rows, columns
        self.stored = [np.zeros((len(gun.terms), *shape), dtype=precision) for gun in self.guns]
        self._light = [np.zeros((len(gun.colours), *shape), dtype=precision) for gun in self.guns]
        self._exact = np.dtype(precision) == np.float64
        self._room = np.empty(shape, dtype=precision)
        self._emitted_before = 0.0
        self._deposited = 0.0
        self._layers = [
            [[name for name, _ in gun.colours].index(term.layer) for term in gun.terms] for gun in self.guns
        ]
        self._shares = [gun.energy_fractions for gun in self.guns]

    @property
    def ticks(self) -> Fraction:
        """Ticks since the tube was switched on, exact."""
        return self._ticks

    @property
    def seconds(self) -> Fraction:
        """Tube time in seconds, exact."""
        return self._ticks * self.tick

    @property
    def pitch_mm(self) -> tuple[float, float]:
        """Width and height of one pixel of the face, in millimetres."""
        return self.size_mm[0] / self.size_px[0], self.size_mm[1] / self.size_px[1]

    def advance(self, ticks: int | Fraction) -> None:
        """Let time pass without a beam. Raises ValueError for a negative number of ticks."""
        if ticks < 0:
            raise ValueError("Time on the tube runs forwards: the number of ticks must not be negative.")
        if ticks == 0:
            return
        self._ticks += ticks
        dt = float(ticks * self.tick)
        for gun, phosphor in enumerate(self.guns):
            for k, term in enumerate(phosphor.terms):
                state = self.stored[gun][k]
                light = self._light[gun][self._layers[gun][k]]
                self._add_scaled(light, state, term.tau_s * -float(np.expm1(-dt / term.tau_s)))
                self._fade(state, float(np.exp(-dt / term.tau_s)))

    def _add_scaled(self, onto: Floats, values: Floats, factor: float) -> None:
        """Add ``factor`` times the values, without an array of its own."""
        np.multiply(values, onto.dtype.type(factor), out=self._room, casting="same_kind")
        onto += self._room

    @staticmethod
    def _fade(state: Floats, factor: float) -> None:
        state *= factor
        if state.dtype == np.float32:
            # Denormal numbers are a hundred times slower; the sum and difference sets them to zero.
            state += _LOWEST
            state -= _LOWEST

    def deposit(self, energy: Floats, gun: int = 0) -> None:
        """Add an energy map (rows, columns) at this instant."""
        self._deposited += float(energy.sum(dtype=np.float64))
        for k, term in enumerate(self.guns[gun].terms):
            self.stored[gun][k] += energy * (self._shares[gun][k] / term.tau_s)

    def deposit_aged(
        self,
        energy: Floats,
        remainders: Sequence[Floats],
        gun: int = 0,
        region: tuple[slice, slice] = WHOLE,
    ) -> None:
        """Add hits that fell during the time just passed, already partly decayed, on a region of the face.

        ``energy`` is all that was deposited; ``remainders[k]`` is what of it would still be stored now,
        were all its light in term k. What is no longer stored has been emitted.
        """
        self._deposited += float(energy.sum(dtype=np.float64))
        for k, term in enumerate(self.guns[gun].terms):
            share = self._shares[gun][k]
            self.stored[gun][k][region] += remainders[k] * (share / term.tau_s)
            self._light[gun][self._layers[gun][k]][region] += (energy - remainders[k]) * share

    def sustain(self, power: Floats, ticks: int | Fraction, gun: int = 0) -> None:
        """Let time pass for one gun under an even stream of energy, (rows, columns) per second.

        What a refreshed picture comes to when its flicker is averaged away. ``ticks`` are counted by gun 0.
        """
        dt = float(ticks * self.tick)
        if gun == 0:
            self._ticks += ticks
        self._deposited += float(power.sum(dtype=np.float64)) * dt
        for k, term in enumerate(self.guns[gun].terms):
            state, share = self.stored[gun][k], self._shares[gun][k]
            fading = -float(np.expm1(-dt / term.tau_s))
            light = self._light[gun][self._layers[gun][k]]
            self._add_scaled(light, state, term.tau_s * fading)
            self._add_scaled(light, power, share * (dt - term.tau_s * fading))
            self._fade(state, 1.0 - fading)
            self._add_scaled(state, power, share * fading)

    def skip(self, ticks: int | Fraction) -> None:
        """Let the clock run while the face stays as it is: a picture that is kept up evenly."""
        self._ticks += ticks

    def settle(self, luminances: Sequence[Floats], gun: int = 0) -> None:
        """Start afresh for one gun with a given luminance per term, as if it had long been so."""
        before = self.stored_energy()
        for k in range(len(self.guns[gun].terms)):
            self.stored[gun][k][...] = luminances[k]
        self._deposited += self.stored_energy() - before

    def deposit_stroke(
        self,
        start_mm: tuple[float, float],
        end_mm: tuple[float, float],
        energy: float,
        ticks: int | Fraction = 0,
        *,
        gun: int = 0,
        spot_mm: float | None = None,
    ) -> None:
        """Sweep the beam from ``start_mm`` to ``end_mm`` at constant speed while ``ticks`` pass.

        ``energy`` is the beam's power times that time; ``spot_mm`` the standard deviation of the spot. With
        0 ticks all of it falls at this instant. The picture is the state when the beam arrives: what was
        hit first has already decayed. Raises ValueError for a spot without width, a negative energy or
        time.
        """
        spot = self.spot_mm if spot_mm is None else spot_mm
        if not spot > 0.0 or not energy >= 0.0:
            raise ValueError("A stroke needs a spot wider than 0 mm and an energy that is not negative.")
        self.advance(ticks)
        patch = stroke_energy(self.size_px, self.size_mm, start_mm, end_mm, spot, energy, self.reach)
        self._deposited += float(patch.values.sum())
        dt = float(ticks * self.tick)
        for k, term in enumerate(self.guns[gun].terms):
            share = self._shares[gun][k]
            if dt > 0.0:
                left = stroke_remainder(patch, dt / term.tau_s)
                self._add(self._light[gun][self._layers[gun][k]], patch, (patch.values - left) * share)
            else:
                left = patch.values
            self._add(self.stored[gun][k], patch, left * (share / term.tau_s))

    @staticmethod
    def _add(onto: Floats, patch: Patch, values: Floats) -> None:
        onto[patch.rows, patch.columns] += values.astype(onto.dtype, copy=False)

    def luminance(self, gun: int = 0) -> Floats:
        """Light given off at this instant, (layers, rows, columns), energy per second and pixel."""
        now = np.zeros_like(self._light[gun])
        for k, layer in enumerate(self._layers[gun]):
            now[layer] += self.stored[gun][k]
        return now

    def exposure(self) -> list[Floats]:
        """Light given off since the last call, per gun (layers, rows, columns), in energy; starts afresh."""
        collected = self._light
        self._emitted_before += self._collected()
        self._light = [np.zeros_like(light) for light in collected]
        return collected

    def collect(self, into: Sequence[Floats], rate: float) -> None:
        """Give the light since the last call times ``rate``, an array (rows, columns) for each gun and layer.

        It starts afresh, as ``exposure`` does, without an array of its own.
        """
        if self._exact:
            self._emitted_before += self._collected()
        layers = (layer for gun in self._light for layer in gun)
        for light, given in zip(layers, into, strict=True):
            np.multiply(light, light.dtype.type(rate), out=given)
            light.fill(0.0)

    def blocks(self, gun: int) -> tuple[Floats, Floats]:
        """What is stored and what was given off by one gun, with the rows of all terms or layers in a row."""
        columns, _rows = self.size_px
        return self.stored[gun].reshape(-1, columns), self._light[gun].reshape(-1, columns)

    def factors(
        self, gun: int, dt: float
    ) -> tuple[NDArray[np.float32], NDArray[np.int64], NDArray[np.float32]]:
        """For each term (terms, 4): what ``dt`` seconds leave, what they give off, luminance for stored
        energy, energy for stored luminance. Its layer (terms,); and the share of each layer (layers, 1).
        """
        rows = []
        shares = np.zeros((len(self.guns[gun].colours), 1), np.float32)
        for k, term in enumerate(self.guns[gun].terms):
            share, fading = self._shares[gun][k], -float(np.expm1(-dt / term.tau_s))
            shares[self._layers[gun][k], 0] += share
            rows.append((1.0 - fading, term.tau_s * fading, share / term.tau_s, term.tau_s))
        return np.array(rows, np.float32), np.array(self._layers[gun], np.int64), shares

    def count(self, energy: float) -> None:
        """So much energy fell on the face, put there by who calls this."""
        self._deposited += energy

    def _collected(self) -> float:
        return sum(_total(light) for light in self._light)

    def deposited_energy(self) -> float:
        """All energy that fell on the face so far."""
        return self._deposited

    def stored_energy(self) -> float:
        """Energy that is still to be emitted."""
        return sum(
            term.tau_s * _total(self.stored[gun][k])
            for gun, phosphor in enumerate(self.guns)
            for k, term in enumerate(phosphor.terms)
        )

    def emitted_energy(self) -> float:
        """Energy emitted as light so far; with the stored energy it makes the deposited one.

        In float64 it is the sum of all light; a float32 tube, which is for looking at, leaves that out.
        """
        if not self._exact:
            return self._deposited - self.stored_energy()
        return self._emitted_before + self._collected()
