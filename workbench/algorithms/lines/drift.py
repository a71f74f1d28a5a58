"""How far a sum of increments has drifted from the true line, computed exactly. For the views of the DDA.

``ends`` is (x0, y0, x1, y1), ``k`` the number of steps taken of the max(|dx|, |dy|) there are.
"""

import math
from typing import SupportsFloat

import numpy as np

Ends = tuple[int, int, int, int]
Pixel = tuple[int, int]
Point = tuple[SupportsFloat, SupportsFloat]


def exact(ends: Ends, k: int) -> tuple[float, float]:
    """Where the true line is after k steps; each coordinate rounded once."""
    x0, y0, x1, y1 = ends
    steps = max(abs(x1 - x0), abs(y1 - y0), 1)
    return (x0 * steps + k * (x1 - x0)) / steps, (y0 * steps + k * (y1 - y0)) / steps


def drift(point: Point, ends: Ends, k: int, one: int = 1) -> float:
    """How far ``point``, counted in 1/one, is from the true line along its shorter side; rounded once."""
    x0, y0, x1, y1 = ends
    flat = abs(x1 - x0) >= abs(y1 - y0)
    value, start, end = (point[1], y0, y1) if flat else (point[0], x0, x1)
    steps = max(abs(x1 - x0), abs(y1 - y0), 1)
    numerator, denominator = float(value).as_integer_ratio()
    denominator *= one
    true = start * steps + k * (end - start)
    return (numerator * steps - true * denominator) / (denominator * steps)


def drift_in(ends: Ends, k: int, name: str) -> float:
    """The drift of the DDA after k steps in floating-point numbers of the kind that NumPy gives this name."""
    x0, y0, x1, y1 = ends
    kind = np.dtype(name).type
    steps = kind(max(abs(x1 - x0), abs(y1 - y0), 1))

    def added_up(start: int, end: int) -> float:
        terms = np.full(k + 1, kind(end - start) / steps, kind)
        terms[0] = start
        return float(np.add.accumulate(terms)[-1])

    return drift((added_up(x0, x1), added_up(y0, y1)), ends, k)


def beside(x: SupportsFloat, y: SupportsFloat, ends: Ends) -> tuple[Pixel, ...]:
    """The pixels on either side of a point of the line: one above the other on a flat line."""
    x0, y0, x1, y1 = ends
    x, y = float(x), float(y)
    if abs(x1 - x0) >= abs(y1 - y0):
        column = math.floor(x + 0.5)
        return (column, math.floor(y)), (column, math.floor(y) + 1)
    row = math.floor(y + 0.5)
    return (math.floor(x), row), (math.floor(x) + 1, row)


def others(x: SupportsFloat, y: SupportsFloat, ends: Ends, taken: Pixel) -> tuple[Pixel, ...]:
    """Of the pixels beside a point of the line, those that were not taken."""
    return tuple(place for place in beside(x, y, ends) if place != taken)
