"""Gouraud shading of whole pictures in colour: each triangle's light as a function of the place, and its use.

Where the nearest triangle of each pixel is known, its light is needed only there. Linear between the corners,
it is a + b x + c y over the picture, found once for each triangle and channel.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

PLANES_EXAMPLE = (
    np.zeros((1, 3, 3)),
    np.array([[0.0, 0, 0.5], [4, 0, 0.5], [0, 4, 0.5]]),
    np.array([[0, 1, 2]]),
    np.zeros((3, 3)),
    1.0,
)
LIGHT_EXAMPLE = (np.zeros((4, 4), np.uint32), 0, np.zeros((1, 3, 3)), np.zeros((1, 2), np.uint8))


def light_planes(
    planes: Array, vertices: Array, faces: Array, lights: Array, top: float
) -> Iterator[tuple[int, float]]:
    """Find a, b and c of each triangle and channel, of the light times ``top`` and half a step.

    Args: planes (m, 3, 3), floats, written in place: triangle, channel, a to c; vertices (n, 3), x and y in
    pixels; faces (m, 3); lights (n, 3), from 0 to 1, of each vertex. Emits: (triangle, its area times two).
    """
    for face in range(len(faces)):
        i, j, k = faces[face, 0], faces[face, 1], faces[face, 2]
        x, y = vertices[i, 0], vertices[i, 1]
        ux, uy = vertices[j, 0] - x, vertices[j, 1] - y
        vx, vy = vertices[k, 0] - x, vertices[k, 1] - y
        area = ux * vy - vx * uy
        if area == 0.0:
            continue
        for channel in range(3):
            light = lights[i, channel]
            along, across = lights[j, channel] - light, lights[k, channel] - light
            dx = (along * vy - across * uy) / area * top
            dy = (across * ux - along * vx) / area * top
            planes[face, channel, 0] = light * top + 0.5 - x * dx - y * dy
            planes[face, channel, 1] = dx
            planes[face, channel, 2] = dy
        yield face, area


def spread_light(image: Array, low_row: int, planes: Array, levels: Array) -> Iterator[tuple[int, int]]:
    """Give each pixel the light of its triangle.

    Args: image, integers (h, w), written in place: numbers of triangles from 1, 0 for none, then 0xRRGGBB;
    its lowest row; planes of ``light_planes``; levels (1, top + 1), what a screen is sent for light from
    0 to 1. Emits: (x, y) of each pixel lit.
    """
    height, width = image.shape
    top = float(levels.shape[1] - 1)
    for row in range(height):
        y = float(low_row + row)
        last = 0
        red, green, blue, red_x, green_x, blue_x = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for x in range(width):
            number = int(image[row, x])
            if number == 0:
                continue
            if number != last:
                last = number
                red = planes[number - 1, 0, 0] + y * planes[number - 1, 0, 2]
                red_x = planes[number - 1, 0, 1]
                green = planes[number - 1, 1, 0] + y * planes[number - 1, 1, 2]
                green_x = planes[number - 1, 1, 1]
                blue = planes[number - 1, 2, 0] + y * planes[number - 1, 2, 2]
                blue_x = planes[number - 1, 2, 1]
            r = int(min(max(red + x * red_x, 0.0), top))
            g = int(min(max(green + x * green_x, 0.0), top))
            b = int(min(max(blue + x * blue_x, 0.0), top))
            image[row, x] = (int(levels[0, r]) << 16) + (int(levels[0, g]) << 8) + int(levels[0, b])
            yield x, low_row + row
