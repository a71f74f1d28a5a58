"""Light of three channels in one whole number, so that a single addition steps all of them to the next pixel.

Each channel is a field of FIELD bits, red the highest. A field counts steps of light from MARGIN, which keeps
what rounding takes away from borrowing of the next field. As long as the fields keep to their bits, sums and
products of the whole numbers are those of each field.
"""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

Array = NDArray[Any]

FIELD = 21
FULL = (1 << FIELD) - 1
MARGIN = 1 << 13
STEPS = FULL - 2 * MARGIN
"""Steps of light between nothing and the brightest that a field can hold."""

MOST = 2.0**62
"""Beyond it no number of 64 bits is: over a triangle seen from its edge light changes without bound."""


class LightPlane(NamedTuple):
    """One channel over a triangle, in steps: its field at the first corner, and the change per pixel."""

    at: float
    dx: float
    dy: float


class Sides(NamedTuple):
    """Two sides of a triangle from its first corner, in pixels, and the steps for light 1 over its area."""

    ux: float
    uy: float
    vx: float
    vy: float
    share: float


def light_plane(sides: Sides, steps: float, first: float, second: float, third: float) -> LightPlane:
    """The light of a channel over a triangle, from that at its corners; light 1 is so many ``steps``."""
    u, v = second - first, third - first
    dx, dy = u * sides.vy - v * sides.uy, v * sides.ux - u * sides.vx
    return LightPlane(first * steps + MARGIN, dx * sides.share, dy * sides.share)


def packed(red: float, green: float, blue: float) -> int:
    """Three fields, or changes of them, in one number; each rounded."""
    r = math.floor(min(max(red + 0.5, -MOST), MOST))
    g = math.floor(min(max(green + 0.5, -MOST), MOST))
    b = math.floor(min(max(blue + 0.5, -MOST), MOST))
    return (((r << FIELD) + g) << FIELD) + b
