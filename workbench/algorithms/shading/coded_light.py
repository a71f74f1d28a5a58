"""Gouraud shading of whole pictures in colour: what the depth buffer left at each pixel, for the screen."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.visibility.packed_light import FIELD, FULL

Array = NDArray[Any]

EXAMPLE = (np.zeros((4, 4), np.uint32), np.zeros((4, 4), np.int64), np.zeros((1, 2), np.uint8), FIELD - 1)


def coded_light(image: Array, light: Array, levels: Array, below: int) -> Iterator[tuple[int, int]]:
    """Code the light of each pixel for a screen.

    Args: image, integers (h, w), written in place: 0xRRGGBB; light, integers (h, w) as ``packed_light`` has
    them; levels (1, 2**(FIELD - below)): what a screen is sent for the highest bits of a field. Emits: the
    number of each row, and how many pixels it has.
    """
    height, width = image.shape
    for row in range(height):
        for x in range(width):
            fields = int(light[row, x])
            red, green, blue = (fields >> (2 * FIELD)) & FULL, (fields >> FIELD) & FULL, fields & FULL
            r, g, b = levels[0, red >> below], levels[0, green >> below], levels[0, blue >> below]
            image[row, x] = (int(r) << 16) + (int(g) << 8) + int(b)
        yield row, width
