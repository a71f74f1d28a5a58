"""From light to the screen in front of you: glow, tone, sRGB, dither. Everything before is linear.

Luminance 1 is a white field in the middle of its drive. Brighter parts keep their hue and go over into
white, as film does; that happens once, here.
"""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.display.face_kernels import at_hand
from workbench.display.phosphor import Rgb
from workbench.display.printer import Printer
from workbench.display.spot import narrowed

Light = NDArray[np.float32]

_STEPS_PER_UNIT = 224
_CEILING = 16.0
"""Square root of the luminance at which the table ends."""

_TOP_STEP = _CEILING * _STEPS_PER_UNIT

_HALO = 0.045
"""Share of the light that glass and phosphor scatter widely."""


def srgb_encoded(linear: NDArray[Any]) -> NDArray[np.float64]:
    """sRGB values, 0 to 1, of linear ones (IEC 61966-2-1)."""
    value = np.clip(linear, 0.0, 1.0)
    low = value * 12.92
    encoded: NDArray[np.float64] = np.where(value <= 0.0031308, low, 1.055 * value ** (1 / 2.4) - 0.055)
    return encoded


def shoulder(luminance: NDArray[Any]) -> NDArray[np.float64]:
    """Tone curve: straight up to 0.75, then rising ever slower towards 1."""
    knee = 0.75
    above = np.maximum(luminance - knee, 0.0)
    curve: NDArray[np.float64] = np.where(
        luminance <= knee, luminance, knee + (1.0 - knee) * -np.expm1(-above / (2.2 * (1.0 - knee)))
    )
    return curve


def _whiteness(luminance: NDArray[Any]) -> NDArray[np.float64]:
    over = np.log(np.maximum(luminance, 1.0)) / math.log(90.0)
    white: NDArray[np.float64] = np.clip(over, 0.0, 1.0) ** 1.4
    return white


def colour_table(colour: Rgb) -> NDArray[np.uint32]:
    """0xFFRRGGBB for equal steps of the square root of luminance, for one phosphor colour."""
    luminance = _square_steps()
    tone, white = shoulder(luminance), _whiteness(luminance)
    packed = np.full(len(luminance), 0xFF000000, dtype=np.uint32)
    for channel, shift in zip(colour, (16, 8, 0), strict=True):
        linear = tone * channel + (1.0 - channel) * white * 0.92
        packed |= (srgb_encoded(linear) * 255.0 + 0.5).astype(np.uint32) << np.uint32(shift)
    return packed


class Screen:
    """Makes pictures of one size from luminances of one or more colours. Row 0 of the light is at the bottom,
    row 0 of the picture at the top.
    """

    def __init__(self, size_px: tuple[int, int], colours: Sequence[Rgb]) -> None:
        self.size_px = size_px
        self.colours = tuple(colours)
        columns, rows = size_px
        self._tables = [colour_table(colour) for colour in self.colours[:1]]
        self._channel_table = (srgb_encoded(shoulder(_square_steps())) * 255.0 + 0.5).astype(np.uint32)
        random = np.random.default_rng(19680)
        noise = random.random((rows, columns)) + random.random((rows, columns))
        self._noise: Light = (0.5 * noise).astype(np.float32)
        self._printer: Printer | None = None
        self._down_x, self._up_x = _halo_matrices(columns)
        self._down_y, self._up_y = _halo_matrices(rows)

    def glow(self, light: Light) -> Light:
        """The light with its wide, weak halo."""
        small = self._down_y @ light @ self._down_x.T
        spread = np.asarray(self._up_y @ small @ self._up_x.T, dtype=np.float32)
        spread *= np.float32(_HALO)
        spread += light
        return spread

    def picture(self, lights: Sequence[Light]) -> NDArray[np.uint32]:
        """0xFFRRGGBB, (rows, columns), top row first; one luminance (rows, columns) for each colour.

        It is good until the next one is asked for.
        """
        if self._printer is None and len(self.colours) == 1 and at_hand():
            halo = self._down_x, self._down_y, self._up_x * np.float32(_HALO), self._up_y
            self._printer = Printer(self._tables[0], self._noise, halo, (_STEPS_PER_UNIT, _TOP_STEP))
        if self._printer is not None and lights[0].dtype == np.float32:
            return self._printer.picture(lights[0])
        if len(lights) == 1:
            return np.ascontiguousarray(self._tables[0][self._steps(self.glow(lights[0]))][::-1])
        packed = np.full(self.size_px[::-1], 0xFF000000, dtype=np.uint32)
        glowing = [self.glow(light) for light in lights]
        brightest = np.maximum.reduce(glowing)
        spill = np.maximum(brightest - np.float32(1.0), 0.0) * np.float32(0.03)
        for channel, shift in enumerate((16, 8, 0)):
            linear = spill.copy()
            for light, colour in zip(glowing, self.colours, strict=True):
                if colour[channel]:
                    linear += light * np.float32(colour[channel])
            packed |= self._channel_table[self._steps(linear)] << np.uint32(shift)
        return np.ascontiguousarray(packed[::-1])

    def _steps(self, luminance: Light) -> NDArray[np.int32]:
        root = np.sqrt(np.maximum(luminance, 0.0, out=luminance), out=luminance)
        root *= np.float32(_STEPS_PER_UNIT)
        root += self._noise
        np.minimum(root, np.float32(_TOP_STEP), out=root)
        return root.astype(np.int32)


def _square_steps() -> NDArray[np.float64]:
    steps: NDArray[np.float64] = (np.arange(int(_CEILING * _STEPS_PER_UNIT) + 2) / _STEPS_PER_UNIT) ** 2
    return steps


def _halo_matrices(count: int) -> tuple[Light, Light]:
    """Down to an eighth with a wide Gaussian, and smoothly up again; together they keep the sum."""
    few = max(2, -(-count // 8))
    fine = (np.arange(count) + 0.5) / count * few
    coarse = np.arange(few) + 0.5
    down = np.exp(-0.5 * ((fine[None, :] - coarse[:, None]) / 1.1) ** 2)
    down /= down.sum(axis=0, keepdims=True)
    up = np.exp(-0.5 * ((fine[:, None] - coarse[None, :]) / 0.8) ** 2)
    up /= up.sum(axis=1, keepdims=True)
    return narrowed(down, np.float32), narrowed(up * (few / count), np.float32)
