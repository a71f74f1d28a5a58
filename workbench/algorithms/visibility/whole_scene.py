"""What is found of a whole scene before its triangles are drawn: where its vertices are, its faces' colours.

For pictures that follow a hand: a colour by Lambert's law for each face, as the screen is sent it.
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.conventions import GRID

Array = NDArray[Any]

_AT_ONCE = 4096  # items from one event to the next

FROM_ABOVE = 0.6
"""How high above the viewer a scene without lights has one, in distances from the viewer to what is lit."""

PLACES_EXAMPLE = (np.zeros((1, 3)), np.zeros((1, 3)), np.eye(4), 1.0, 0.0, 1.0, 0.0)
COLOURS_EXAMPLE = (
    np.zeros(1, np.int64),
    0,
    1,
    np.zeros((3, 1)),
    np.zeros(1),
    np.zeros((3, 1)),
    np.ones(4),
    np.zeros((0, 7)),
    np.ones(5),
)


def places_on_device(
    places: Array,
    points: Array,
    matrix: Array,
    scale_x: float,
    origin_x: float,
    scale_y: float,
    origin_y: float,
) -> Iterator[tuple[int, int]]:
    """Take points to the view plane, divide by w, and put them on the grid of the device.

    Args: places (n, 3), floats, written in place: x and y in pixels, z; points (n, 3), or (n, 4) with a w of
    their own; matrix (4, 4), after which every w is greater than 0; from the view plane to pixels, along x
    and y: a scale, and where its origin is. Emits: the first of some points that are done, and their end.
    """
    count = len(points)
    for first in range(0, count, _AT_ONCE):
        end = min(first + _AT_ONCE, count)
        for k in range(max(first, 0), end):
            x, y, z, h = float(points[k, 0]), float(points[k, 1]), float(points[k, 2]), 1.0
            if points.shape[1] == 4:
                h = float(points[k, 3])
            w = matrix[3, 0] * x + matrix[3, 1] * y + matrix[3, 2] * z + matrix[3, 3] * h
            right = (matrix[0, 0] * x + matrix[0, 1] * y + matrix[0, 2] * z + matrix[0, 3] * h) / w
            up = (matrix[1, 0] * x + matrix[1, 1] * y + matrix[1, 2] * z + matrix[1, 3] * h) / w
            places[k, 0] = math.floor((right * scale_x + origin_x) * GRID + 0.5) / GRID
            places[k, 1] = math.floor((up * scale_y + origin_y) * GRID + 0.5) / GRID
            places[k, 2] = (matrix[2, 0] * x + matrix[2, 1] * y + matrix[2, 2] * z + matrix[2, 3] * h) / w
        yield first, end


def cosine(nx: float, ny: float, nz: float, x: float, y: float, z: float) -> float:
    """The cosine of the angle between a unit normal and a way (x, y, z), 0 where the way has no length."""
    length = math.sqrt(x * x + y * y + z * z)
    return (nx * x + ny * y + nz * z) / length if length > 0.0 else 0.0


def face_colours(
    colours: Array,
    first_face: int,
    end_face: int,
    normals: Array,
    distances: Array,
    middles: Array,
    viewer: Array,
    lights: Array,
    material: Array,
) -> Iterator[tuple[int, int]]:
    """Light faces by Lambert's law, on the side that is seen.

    Args: colours (m,), integers, written in place from first_face up to end_face: 0xRRGGBB of each; normals
    (3, m), of length 1, or 0; distances (m,) of the planes from the origin along them; middles (3, m); viewer
    (x, y, z, 1), or (x, y, z, 0) of a direction; lights (l, 7): x, y, z, 1 of a place or 0 of a direction,
    red, green, blue; with none of them one shines from above the viewer; material: ambient, diffuse, and red,
    green, blue. Emits: the first of some faces that are done, and their end.
    """
    view_x, view_y, view_z, view_w = viewer[0], viewer[1], viewer[2], viewer[3]
    ambient, diffuse = material[0], material[1]
    for first in range(first_face, end_face, _AT_ONCE):
        end = min(first + _AT_ONCE, end_face)
        for face in range(max(first, 0), end):
            nx, ny, nz = float(normals[0, face]), float(normals[1, face]), float(normals[2, face])
            x, y, z = float(middles[0, face]), float(middles[1, face]), float(middles[2, face])
            # Seen from in front: N . (eye - P) > 0, or N . direction > 0
            side = 1.0
            if view_x * nx + view_y * ny + view_z * nz <= view_w * distances[face]:
                side = -1.0
            red, green, blue = ambient, ambient, ambient
            if len(lights) == 0:
                to_x, to_y, to_z = view_x - view_w * x, view_y - view_w * y, view_z - view_w * z
                to_y += FROM_ABOVE * math.sqrt(to_x * to_x + to_y * to_y + to_z * to_z)
                light = diffuse * max(side * cosine(nx, ny, nz, to_x, to_y, to_z), 0.0)
                red, green, blue = red + light, green + light, blue + light
            for lamp in range(len(lights)):
                to_x, to_y = lights[lamp, 0] - lights[lamp, 3] * x, lights[lamp, 1] - lights[lamp, 3] * y
                to_z = lights[lamp, 2] - lights[lamp, 3] * z
                light = diffuse * max(side * cosine(nx, ny, nz, to_x, to_y, to_z), 0.0)
                red += light * lights[lamp, 4]
                green += light * lights[lamp, 5]
                blue += light * lights[lamp, 6]
            r = int(min(red * material[2] * 255.0 + 0.5, 255.0))
            g = int(min(green * material[3] * 255.0 + 0.5, 255.0))
            b = int(min(blue * material[4] * 255.0 + 0.5, 255.0))
            colours[face] = (r << 16) + (g << 8) + b
        yield first, end
