"""Gouraud shading in colour, fast: the depth buffer finds the triangle of each pixel, which then is lit."""

from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.display.exposure import srgb_encoded
from workbench.engine.stopping import Stop
from workbench.rendering.triangles import drawn, in_bands

Array = NDArray[Any]

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
    levels = _levels()

    def light(low: int, high: int) -> None:
        band = image[low:high]
        paint(spread_light, band, 0, band, low, vertices, faces, lights, levels)

    in_bands(size[1], light, stop)
    return image, depth


@cache
def _levels() -> NDArray[np.int64]:
    """What a screen is sent for light from 0 to 1, 0 to 255."""
    return np.floor(srgb_encoded(np.arange(LEVELS) / (LEVELS - 1)) * 255 + 0.5).astype(np.int64)


def spread_light(
    image: Array, low_row: int, vertices: Array, faces: Array, lights: Array, levels: Array
) -> Iterator[tuple[int, int]]:
    """Give each pixel the light of its triangle, linear between the corners.

    Args: image, integers (h, w), written in place: numbers of triangles from 1, 0 for none; its lowest row;
    levels (k,): the coded value of light from 0 to 1. Emits: (x, y) of each pixel lit.
    """
    height, width = image.shape
    top = len(levels) - 1
    last = 0
    x0, y0, r0, g0, b0 = 0.0, 0.0, 0.0, 0.0, 0.0
    r_x, r_y, g_x, g_y, b_x, b_y = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for y in range(height):
        for x in range(width):
            number = int(image[y, x])
            if number == 0:
                continue
            if number != last:
                last = number
                i, j, k = faces[number - 1, 0], faces[number - 1, 1], faces[number - 1, 2]
                x0, y0 = vertices[i, 0], vertices[i, 1] - low_row
                ux, uy = vertices[j, 0] - x0, vertices[j, 1] - low_row - y0
                vx, vy = vertices[k, 0] - x0, vertices[k, 1] - low_row - y0
                each = 1.0 / (ux * vy - vx * uy)
                ux, uy, vx, vy = ux * each, uy * each, vx * each, vy * each
                r0, g0, b0 = lights[i, 0], lights[i, 1], lights[i, 2]
                along, across = lights[j, 0] - r0, lights[k, 0] - r0
                r_x, r_y = along * vy - across * uy, across * ux - along * vx
                along, across = lights[j, 1] - g0, lights[k, 1] - g0
                g_x, g_y = along * vy - across * uy, across * ux - along * vx
                along, across = lights[j, 2] - b0, lights[k, 2] - b0
                b_x, b_y = along * vy - across * uy, across * ux - along * vx
            right, up = x - x0, y - y0
            red = min(max(int((r0 + right * r_x + up * r_y) * top + 0.5), 0), top)
            green = min(max(int((g0 + right * g_x + up * g_y) * top + 0.5), 0), top)
            blue = min(max(int((b0 + right * b_x + up * b_y) * top + 0.5), 0), top)
            image[y, x] = (levels[red] << 16) + (levels[green] << 8) + levels[blue]
            yield x, y
