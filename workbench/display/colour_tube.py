"""A colour tube: three beams that scan one picture, each beside its place by its error of convergence.

Each gun has a tube of its own, since each beam lies elsewhere; the mask multiplies the light of each.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from workbench.display.beam import BeamState
from workbench.display.driver import TubeDriver
from workbench.display.exposure import Screen
from workbench.display.mask import Kind, Maps, Window, is_drawn, lit_share, mask_maps
from workbench.display.setup import COLOUR_TUBE, WHITE, TubeSetup, raster_tube
from workbench.display.tube import PICOSECOND

Light = NDArray[np.float32]
Shift = tuple[float, float]


@dataclass(frozen=True, slots=True)
class ColourSetup:
    """The kind of mask, its pitch, and how far each beam lands beside its place, in millimetres."""

    mask: Kind = "delta"
    pitch_mm: float = 0.31
    errors_mm: tuple[Shift, Shift, Shift] = ((0.0, 0.0), (0.0, 0.0), (0.0, 0.0))
    refresh_hz: float = 60.0
    gamma: float = 2.2

    @property
    def tube(self) -> TubeSetup:
        """The same as a tube is set up."""
        return TubeSetup(COLOUR_TUBE, self.refresh_hz, gamma=self.gamma)


class ColourTube:
    """Shows ``image`` (h, w), 0xRRGGBB, row 0 at the bottom, or the part of its face in ``window_mm``.

    ``before`` is the tube that it takes the place of: what is the same of it is kept.
    """

    def __init__(
        self,
        image: NDArray[np.uint32],
        window_mm: Window,
        size_px: tuple[int, int],
        setup: ColourSetup,
        before: "ColourTube | None" = None,
    ) -> None:
        self.window_mm, self.size_px, self.setup = window_mm, size_px, setup
        self.image = image
        kept = before if before is not None and before._scans(image, window_mm, size_px, setup) else None
        self.maps: Maps
        if kept is not None and kept.setup.mask == setup.mask and kept.setup.pitch_mm == setup.pitch_mm:
            self.maps = kept.maps
        else:
            self.maps = mask_maps(setup.mask, setup.pitch_mm, window_mm, size_px)
        self.drivers: list[TubeDriver] = []
        for gun, error in enumerate(setup.errors_mm):
            if kept is not None and error == kept.setup.errors_mm[gun]:
                self.drivers.append(kept.drivers[gun])
                continue
            tube, beam = raster_tube(image, size_px, setup.tube, window_mm=window_mm, gun=gun, shift_mm=error)
            if kept is not None:
                tube.skip(kept.seconds / PICOSECOND)
            self.drivers.append(TubeDriver(tube, beam))
        colours = [rgb for driver in self.drivers for _layer, rgb in driver.tube.guns[0].colours]
        self._screen: Screen = kept._screen if kept is not None else Screen(size_px, colours)
        for driver in self.drivers:
            driver.settle()

    def _scans(
        self, image: NDArray[np.uint32], window_mm: Window, size_px: tuple[int, int], setup: ColourSetup
    ) -> bool:
        """Whether a gun without error scans just this here."""
        same = self.window_mm, self.size_px, self.setup.tube
        return self.image is image and same == (window_mm, size_px, setup.tube)

    @property
    def gain(self) -> float:
        """What the light is multiplied by to be looked at: dots of a white field are then as white is."""
        pixel = (self.window_mm[2] - self.window_mm[0]) / self.size_px[0]
        if not is_drawn(self.setup.mask, self.setup.pitch_mm, pixel):
            return 1.0
        return lit_share(self.setup.mask) / WHITE

    def advance(self, ticks: Fraction, averaged: bool) -> None:
        """Let time pass for all three beams."""
        for driver in self.drivers:
            driver.advance(ticks, averaged)

    @property
    def steady(self) -> bool:
        """Whether an averaged picture no longer changes visibly."""
        return all(driver.steady for driver in self.drivers)

    @property
    def lights(self) -> Sequence[Light]:
        """Luminance of the last stretch of time behind the mask, one (rows, columns) for each gun."""
        return [driver.lights[0] * one for driver, one in zip(self.drivers, self.maps, strict=True)]

    @property
    def seconds(self) -> Fraction:
        """Tube time, exact."""
        return self.drivers[0].tube.seconds

    def picture(self) -> NDArray[np.uint32]:
        """0xFFRRGGBB, (rows, columns), top row first."""
        gain = np.float32(self.gain)
        return self._screen.picture([light * gain for light in self.lights])

    def states(self) -> list[BeamState]:
        """Where each beam is now, in millimetres of the window."""
        return [driver.state() for driver in self.drivers]


def as_levels(packed: int) -> tuple[float, float, float]:
    """Coded red, green and blue, 0 to 1, of 0xRRGGBB."""
    red, green, blue = (((packed >> shift) & 0xFF) / 255.0 for shift in (16, 8, 0))
    return red, green, blue


def packed_levels(levels: Sequence[float]) -> int:
    """0xRRGGBB of coded red, green and blue, 0 to 1."""
    red, green, blue = (int(np.floor(min(max(level, 0.0), 1.0) * 255.0 + 0.5)) for level in levels)
    return red << 16 | green << 8 | blue
