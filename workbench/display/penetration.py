"""The beam-penetration tube: two layers of phosphor, and a colour that is chosen by the accelerating voltage.

The beam meets a red layer first and a green one behind it. A slow electron stops in the red layer; a fast one
passes and spends the rest in the green. By the law of Thomson and Whiddington the square of an electron's
energy falls evenly with the depth, so that after a layer that only just stops electrons of V_c volts those of
V volts have sqrt(V^2 - V_c^2) left. Share of the energy in the red layer: 1 - sqrt(1 - (V_c / V)^2).

Source: Hearn and Baker, Computer Graphics, C Version, section 2-1, for the two layers and the four colours;
the voltages are of the usual order and uncertain.
"""

import math
from typing import NamedTuple

STOPPED_KV = 6.0
"""V_c: up to here all energy stays in the red layer."""

LEAST_KV, MOST_KV = 4.0, 14.0

RED_LAYER, GREEN_LAYER = "P22R", "P22G"
"""What the layers are made of here; real screens had mixtures of their own."""


class Named(NamedTuple):
    """A colour of the books, and the voltage that gives it here."""

    name: str
    kilovolts: float


_HUES = {"red": 0.0, "orange": 30.0, "yellow": 60.0, "green": 120.0}
_LEAST_SATURATION = 0.2

COLOURS = (Named("red", 6.0), Named("orange", 6.3), Named("yellow", 7.0), Named("green", 12.0))


def energy_left_kv(kilovolts: float) -> float:
    """What an electron has left behind the red layer, in keV. Raises ValueError unless above 0 kV."""
    if not kilovolts > 0.0:
        raise ValueError("The accelerating voltage must be above 0 kV, else no beam reaches the screen.")
    return math.sqrt(max(kilovolts * kilovolts - STOPPED_KV * STOPPED_KV, 0.0))


def shares(kilovolts: float) -> tuple[float, float]:
    """Shares of the beam's energy in the red and in the green layer; their sum is 1.

    Raises ValueError unless above 0 kV.
    """
    green = energy_left_kv(kilovolts) / kilovolts
    return 1.0 - green, green


def power(kilovolts: float) -> float:
    """Power of the beam at a given current, of what it is at the voltage of green."""
    return kilovolts / COLOURS[-1].kilovolts


def coded_layers(kilovolts: float, gamma: float) -> int:
    """0xRRGGBB whose red and green channels drive two guns as the two layers glow, blue none.

    ``gamma`` is the exponent of the guns. Raises ValueError unless above 0 kV.
    """
    red, green = (
        int((min(share * power(kilovolts), 1.0)) ** (1.0 / gamma) * 255.0 + 0.5)
        for share in shares(kilovolts)
    )
    return red << 16 | green << 8


def nearest_named(hue: float, saturation: float) -> Named:
    """The colour of the tube that is nearest to a hue in degrees; yellow, the palest, for what has none."""
    if saturation < _LEAST_SATURATION:
        return COLOURS[2]
    return min(COLOURS, key=lambda one: abs((hue - _HUES[one.name] + 180.0) % 360.0 - 180.0))
