"""Gouraud shading in colour, fast: the depth buffer finds the triangle of each pixel, which then is lit."""

from functools import cache

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.shading.light_planes import light_planes, spread_light
from workbench.display.exposure import srgb_encoded
from workbench.engine.stopping import Stop
from workbench.rendering.triangles import drawn, in_bands

LEVELS = 1 << 14
"""Light is coded for the screen by a table with so many entries."""


def gouraud_drawn(
    vertices: NDArray[np.float64],
    faces: NDArray[np.int64],
    lights: NDArray[np.float64],
    size: tuple[int, int],
    stop: Stop | None = None,
) -> tuple[NDArray[np.uint32], NDArray[np.float64]]:
    """Triangles whose light is linear between their corners; at each pixel the nearest wins.

    Each channel is that of ``gouraud``, coded for the screen, to one step of 255.

    Args: vertices (n, 3), x and y in pixels, z 0 to 1; faces (m, 3); lights (n, 3): linear red, green and
    blue of each vertex; size (width, height). Returns: the picture (h, w), 0xRRGGBB, row 0 at the bottom, 0
    where nothing is, and the depth there, 1 where nothing is. Raises: Stopped.
    """
    from workbench.engine.compiled import paint

    image, depth = drawn(vertices, faces, np.arange(1, len(faces) + 1), size, stop)
    planes = np.empty((len(faces), 3, 3))

    def find(first: int, end: int) -> None:
        paint(light_planes, planes, 0, planes[first:end], vertices, faces[first:end], lights, LEVELS - 1.0)

    def light(low: int, high: int) -> None:
        band = image[low:high]
        paint(spread_light, band, 0, band, low, planes, _levels())

    in_bands(len(faces), find, stop)
    in_bands(size[1], light, stop)
    return image, depth


@cache
def _levels() -> NDArray[np.uint8]:
    """What a screen is sent for light from 0 to 1, 0 to 255, in one row: eight bits stay at hand."""
    coded = srgb_encoded(np.arange(LEVELS) / (LEVELS - 1)) * 255
    return np.floor(coded + 0.5).astype(np.uint8).reshape(1, -1)
