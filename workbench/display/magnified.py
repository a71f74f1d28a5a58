"""A small part of a picture as its tube shows it, so near that spot and scan lines are seen.

The part is drawn by a tube of its own, on which everything is larger: pixels, lines, and the spot.
"""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.display.driver import TubeDriver
from workbench.display.exposure import Screen
from workbench.display.setup import (
    VECTOR_SPOT_MM,
    TubeSetup,
    face_mm,
    raster_tube,
    vector_beam,
)
from workbench.display.tube import Tube

Pixels = NDArray[np.uint32]


def part_of(
    picture_px: tuple[int, int], place: tuple[float, float], power: float
) -> tuple[int, int, int, int]:
    """The part around a place (pixels) that a glass of so much power shows: x, y of its lower left pixel,
    width and height; square, and an odd number of pixels.
    """
    side = max(2 * round(min(picture_px) / power / 2) + 1, 3)
    return round(place[0]) - side // 2, round(place[1]) - side // 2, side, side


def magnified_raster(
    image: NDArray[np.uint32], setup: TubeSetup, place: tuple[float, float], power: float, size: int
) -> Pixels:
    """The part of a frame buffer as 0xFFRRGGBB (size, size), top row first; beyond its edges it is dark."""
    height, width = image.shape
    x, y, across, up = part_of((width, height), place, power)
    part = np.zeros((up, across), np.uint32)
    left, right = max(x, 0), min(x + across, width)
    low, high = max(y, 0), min(y + up, height)
    if left < right and low < high:
        part[low - y : high - y, left - x : right - x] = image[low:high, left:right]
    tube, beam = raster_tube(part, (size, size), setup)
    return _seen(tube, beam)


def magnified_vector(
    strokes: NDArray[np.float64],
    setup: TubeSetup,
    picture_px: tuple[int, int],
    place: tuple[float, float],
    power: float,
    size: int,
) -> Pixels:
    """The part of what strokes (n, 5) draw, likewise: x0, y0, x1, y1 in pixels, and the colour."""
    x, y, across, up = part_of(picture_px, place, power)
    low, high = np.minimum(strokes[:, 0:2], strokes[:, 2:4]), np.maximum(strokes[:, 0:2], strokes[:, 2:4])
    near = ((high >= (x - 2, y - 2)) & (low <= (x + across + 1, y + up + 1))).all(axis=1)
    part = strokes[near] - (x, y, x, y, 0)
    scale = picture_px[0] / across
    tube = Tube(
        (size, size), face_mm((across, up)), setup.guns(), spot_mm=VECTOR_SPOT_MM * scale, reach=4.0,
        precision=np.float32,
    )  # fmt: skip
    return _seen(tube, vector_beam(tube, part, (across, up), replace(setup, refresh_hz=60.0)))


def _seen(tube: Tube, beam: Any) -> Pixels:
    driver = TubeDriver(tube, beam)
    screen = Screen(tube.size_px, [rgb for gun in tube.guns for _name, rgb in gun.colours])
    return screen.picture(driver.lights)
