"""The axis of a curve's parameter: its place in every plot, round numbers on it, and numbers as text."""

import math

import numpy as np
from numpy.typing import NDArray

from workbench.widgets.look.tokens import CAPTION_PX

Array = NDArray[np.float64]

# The same in every plot, so that those above one another stand on one axis.
LEFT_PX, RIGHT_PX = 40, 16
ROW_PX = CAPTION_PX + 5
TICKS_PX = 60
NUDGES = 100
GRAB_PX = 6
_EDGE = 1e-6


def number_text(value: float, digits: int = 3) -> str:
    """A number to about so many digits, with a real minus sign; an en dash where there is none."""
    if math.isnan(value):
        return "\N{EN DASH}"
    if math.isinf(value):
        said = "\N{INFINITY}" if value > 0 else "-\N{INFINITY}"
    elif value and not 1e-4 <= abs(value) < 1e6:
        said = f"{value:.{max(digits - 2, 0)}e}".replace("e-0", "e-").replace("e+0", "e").replace("e+", "e")
    else:
        before = math.floor(math.log10(abs(value))) + 1 if value else 1
        said = f"{value + 0.0:.{max(digits - before, 0)}f}"
        said = said.rstrip("0").rstrip(".") if "." in said else said
    return said.replace("-", "\N{MINUS SIGN}")


def same(one: Array, other: Array) -> bool:
    """Whether two arrays hold the same; nan is the same as nan."""
    return one is other or np.array_equal(one, other, equal_nan=True)


def tick_text(value: float) -> str:
    """A round number on an axis."""
    return number_text(value, 6)


def ticks(low: float, high: float, most: int) -> list[float]:
    """At most ``most`` round numbers from low to high, 1, 2 or 5 times a power of ten apart."""
    if not high > low:
        return [low]
    power = 10.0 ** math.floor(math.log10((high - low) / max(most, 1)))
    places = range(0)
    step = power
    for factor in (1, 2, 5, 10, 20):
        step = factor * power
        places = range(math.ceil(low / step - _EDGE), math.floor(high / step + _EDGE) + 1)
        if len(places) <= most:
            break
    return [k * step for k in places]
