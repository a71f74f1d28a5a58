"""The surfaces of a scene as the methods for hidden surfaces take them: triangles on the device.

A surface covers a pixel, and has a depth there, by the same expressions in every method, so that all methods
give the same picture. z is measured away from the eye, which is far off at z = -infinity.
"""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.visibility.device_plane import Corner, corners_of, plane, row_ends

Array = NDArray[Any]
Picture = NDArray[Any]
"""Integers (h, w)."""
Vertices = NDArray[Any]
"""(n, 3): x and y in pixels, z."""
Triangles = NDArray[Any]
"""(m, 3): numbers of vertices."""
Colours = NDArray[Any]
"""(m,) integers."""

NOTHING = -1
"""In place of the number of a surface."""

NEAR_ZERO = 1e-9
"""Of a sum less than this share of its terms is a rounding error."""


class Surface(NamedTuple):
    """A triangle: its corners from the lowest row up, its plane Ax + By + Cz + D = 0, and how z changes.

    The plane's normal points to the side from which the corners go round counter-clockwise: C is negative
    where that is the eye's side, and 0 where the surface is seen edge on and covers no pixel.
    """

    low: Corner
    middle: Corner
    high: Corner
    A: float
    B: float
    C: float
    D: float
    dz_dx: float
    dz_dy: float


def surface_of(vertices: Array, faces: Array, face: int) -> Surface:
    """A triangle as a surface; vertices (n, 3), faces (m, 3)."""
    low, middle, high = corners_of(vertices, faces, face)
    A, B, C, D = plane(low, middle, high)
    if C == 0.0:
        return Surface(low, middle, high, A, B, C, D, 0.0, 0.0)
    dz_dx, dz_dy = -A / C, -B / C
    i, j, k = faces[face, 0], faces[face, 1], faces[face, 2]
    along = (vertices[j, 0] - vertices[i, 0]) * (vertices[k, 1] - vertices[i, 1])
    counter_clockwise = along > (vertices[k, 0] - vertices[i, 0]) * (vertices[j, 1] - vertices[i, 1])
    if counter_clockwise == (C > 0.0):
        A, B, C, D = -A, -B, -C, -D
    return Surface(low, middle, high, A, B, C, D, dz_dx, dz_dy)


def surfaces_of(vertices: Array, faces: Array) -> list[Surface]:
    """All triangles as surfaces, by their numbers."""
    return [surface_of(vertices, faces, face) for face in range(len(faces))]


def in_view(surfaces: list[Surface]) -> list[int]:
    """The numbers of those that are not seen edge on."""
    return [number for number in range(len(surfaces)) if surfaces[number].C != 0.0]


def depth_at(surface: Surface, x: float, y: float) -> float:
    """z of the surface's plane at a place."""
    return surface.low.z + (y - surface.low.y) * surface.dz_dy + (x - surface.low.x) * surface.dz_dx


def covers(surface: Surface, x: int, y: int) -> bool:
    """Whether the centre of a pixel is in the surface: y_low <= y < y_high and x_left <= x < x_right."""
    if not surface.low.y <= y < surface.high.y:
        return False
    x_left, x_right = row_ends(surface.low, surface.middle, surface.high, y)
    return x_left <= x < x_right


def first_row(surface: Surface) -> int:
    """The lowest row of the picture on which the surface can cover a pixel."""
    return max(math.ceil(surface.low.y), 0)


def end_row(surface: Surface, height: int) -> int:
    """One past the highest."""
    return min(math.ceil(surface.high.y), height)


def span_on(surface: Surface, y: int, width: int) -> tuple[int, int]:
    """The first pixel that the surface covers on a row of the picture, and one past the last."""
    x_left, x_right = row_ends(surface.low, surface.middle, surface.high, y)
    return max(math.ceil(x_left), 0), min(math.ceil(x_right), width)


def nearest_z(surface: Surface) -> float:
    """The least depth of a surface."""
    return min(surface.low.z, surface.middle.z, surface.high.z)


def farthest_z(surface: Surface) -> float:
    """The greatest depth of a surface."""
    return max(surface.low.z, surface.middle.z, surface.high.z)


def nearer(surfaces: list[Surface], number: int, other: int, x: float, y: float) -> bool:
    """Whether a surface is nearer than another at a place; of equal depths the lower number is."""
    z, z_other = depth_at(surfaces[number], x, y), depth_at(surfaces[other], x, y)
    return z < z_other or (z == z_other and number < other)
