"""Where values lie on a curve editor."""

import math
from typing import NamedTuple

_MARGIN = 0.14
_LEAST_PX = 40.0
_LARGEST_SPAN, _LEAST_SPAN = 1e12, 1e-9


class ValueScale(NamedTuple):
    """``middle`` is the value at ``centre`` (y, pixels, downwards), ``by_pixel`` how much a pixel is."""

    middle: float
    by_pixel: float
    centre: float

    def y(self, value: float) -> float:
        """Where a value is, as far as one can paint."""
        return min(max(self.centre - (value - self.middle) / self.by_pixel, -1e6), 1e6)

    def value(self, y: float) -> float:
        """The value at y."""
        return self.middle - (y - self.centre) * self.by_pixel

    @property
    def rounding(self) -> float:
        """The power of ten to which a hand can tell values apart."""
        return 10.0 ** math.floor(math.log10(self.by_pixel))


def fitting_values(low: float, high: float, top: float, bottom: float) -> ValueScale:
    """All values from low to high between two heights; a single one in the middle."""
    span = (high - low) or 2.0 * max(abs(low), 1.0)
    room = max((bottom - top) * (1.0 - 2.0 * _MARGIN), _LEAST_PX)
    return ValueScale((low + high) / 2.0, span / room, (top + bottom) / 2.0)


def zoomed_values(scale: ValueScale, factor: float, y: float) -> ValueScale:
    """A scale on which values are ``factor`` times as far apart, and the one at ``y`` stays there."""
    by_pixel = min(max(scale.by_pixel / factor, _LEAST_SPAN), _LARGEST_SPAN)
    kept = scale.value(y)
    return scale._replace(middle=kept + (y - scale.centre) * by_pixel, by_pixel=by_pixel)
