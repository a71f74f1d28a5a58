"""The conventions of the whole program, stated once.

A pixel is named by its centre at integer (x, y); y grows upwards, the origin is at the lower left. A picture
of width x height pixels covers [-0.5, width - 0.5] x [-0.5, height - 0.5]. Arrays are indexed ``[y, x]``.
Only what puts a picture on a screen or into an image file turns it upside down (``top_row_first``).

The world frame is float, the device frame is integer pixels. Points are columns, matrices act from the left.
Angles are radians, counter-clockwise positive. Colours are sRGB, packed as 0xRRGGBB.
"""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray


def round_half_up(value: float) -> int:
    """Nearest integer, halves upwards: floor(value + 0.5), the rounding of the course."""
    return math.floor(value + 0.5)


GRID = 4096
"""Corners of areas and faces are on a grid of so many places to a pixel: crossings with rows are exact."""


def snapped(device: NDArray[np.float64]) -> NDArray[np.float64]:
    """Device coordinates, of any shape, at the nearest place of the grid, halves upwards."""
    places: NDArray[np.float64] = np.floor(device * GRID + 0.5) / GRID
    return places


def top_row_first(image: NDArray[Any]) -> NDArray[Any]:
    """A view of ``image`` (h, w) as screens and files want it: row h - 1 first."""
    return np.flipud(image)
