"""Gouraud shading in colour, fast: the depth buffer keeps the light of each pixel, coded at the end."""

import math
from collections.abc import Callable, Iterable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.shading.coded_light import coded_light
from workbench.algorithms.visibility.depth_tiles import depth_buffer_tiles
from workbench.algorithms.visibility.packed_light import FIELD, MARGIN, STEPS
from workbench.display.exposure import srgb_encoded
from workbench.engine.compiled import Stop, paint
from workbench.rendering.triangles import FARTHEST, bands_for, in_bands

BITS = 14
"""So many bits of light from 0 to 1 tell what the screen is sent."""

LitShare = tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]
"""Vertices (n, 3), x and y in pixels, z 0 to 1; faces (m, 3); lights (n, 3): linear red, green and blue of
each vertex, 0 or more."""


def gouraud_drawn(
    shares: Callable[[], Iterable[LitShare]], size: tuple[int, int], stop: Stop | None = None
) -> tuple[NDArray[np.uint32], NDArray[np.float64]]:
    """Triangles whose light is linear between their corners; at each pixel the nearest wins.

    Each channel is that of ``gouraud``, coded for the screen, to one step of 255 for light up to 4.

    Args: what gives all triangles, one share after the other, from the beginning each time, as it begins anew
    where a later share is so bright that its light has no room; size (width, height). Returns: the picture
    (h, w), 0xRRGGBB, row 0 at the bottom, 0 where nothing is, and the depth there, 1 where nothing is.
    Raises: Stopped.
    """
    width, height = size
    image, depth = np.empty((height, width), np.uint32), np.empty((height, width))
    light = np.empty((height, width), np.int64)
    doublings, too_bright = 0, True
    while too_bright:
        too_bright, count = False, 0
        light.fill(0)
        depth.fill(FARTHEST)
        for share in shares():
            needed = math.ceil(math.log2(share[2].max(initial=1.0)))
            if needed > doublings:
                doublings, too_bright = needed, count > 0
            if too_bright:
                break
            _draw(share, light, depth, STEPS / 2.0**doublings, stop)
            count += len(share[1])
    below = max(FIELD - BITS - doublings, 0)
    levels = _levels(doublings, below)

    def code(low_row: int, end_row: int) -> None:
        band = image[low_row:end_row]
        paint(coded_light, band, 0, band, light[low_row:end_row], levels, below)

    in_bands(height, code, stop)
    return image, depth


def _draw(
    share: LitShare, light: NDArray[np.int64], depth: NDArray[np.float64], steps: float, stop: Stop | None
) -> None:
    vertices, faces, lights = share
    unlit = np.zeros(len(faces), np.int64)

    def draw(low_row: int, end_row: int) -> None:
        band, nearest = light[low_row:end_row], depth[low_row:end_row]
        paint(depth_buffer_tiles, band, 0, band, nearest, vertices, faces, unlit, lights, steps, low_row)

    in_bands(len(light), draw, stop, bands_for(len(faces)))


@lru_cache(maxsize=4)
def _levels(doublings: int, below: int) -> NDArray[np.uint8]:
    """What a screen is sent for the highest bits of a field: in one row; eight bits stay at hand."""
    middles = (np.arange(1 << (FIELD - below)) + 0.5) * 2.0**below
    coded = srgb_encoded((middles - MARGIN) / STEPS * 2.0**doublings) * 255
    return np.floor(coded + 0.5).astype(np.uint8).reshape(1, -1)
