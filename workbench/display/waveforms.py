"""What instruments at a tube show: current, deflection and light over time, in closed form."""

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.display.beam import Beam

Floats = NDArray[np.float64]
Point = tuple[float, float]


class Waveforms(NamedTuple):
    """Samples: seconds from the start, deflection in mm from the middle, current 0 to 1."""

    seconds: Floats
    x_mm: Floats
    y_mm: Floats
    current: Floats


def waveforms(
    beam: Beam, size_mm: tuple[float, float], start: Fraction, length: Fraction, count: int = 160
) -> Waveforms:
    """Deflection and current of a beam at ``count`` instants from ``start``, ``length`` seconds long."""
    states = [beam.state(start + length * i / (count - 1)) for i in range(count)]
    return Waveforms(
        np.linspace(0.0, float(length), count),
        np.array([s.x_mm - size_mm[0] / 2 for s in states]),
        np.array([s.y_mm - size_mm[1] / 2 for s in states]),
        np.array([max(s.currents) for s in states]),
    )


def nearest_pass(
    place: Point,
    pieces: Sequence[tuple[Point, Point, float, float]],
) -> tuple[float, float]:
    """When a beam passes nearest to a place (mm), and how near.

    ``pieces`` are (begin, end, start in seconds, duration). Returns seconds and millimetres, infinite for
    none.
    """
    best = (0.0, math.inf)
    for (x0, y0), (x1, y1), start, duration in pieces:
        dx, dy = x1 - x0, y1 - y0
        square = dx * dx + dy * dy
        share = ((place[0] - x0) * dx + (place[1] - y0) * dy) / square if square > 0.0 else 0.0
        share = min(max(share, 0.0), 1.0)
        distance = math.hypot(place[0] - x0 - share * dx, place[1] - y0 - share * dy)
        if distance < best[1]:
            best = (start + share * duration, distance)
    return best
