"""The plane of a triangle in device coordinates: pixels, pixels, and z from 0 (near) to 1 (far).

A, B, C, D  of the plane Ax + By + Cz + D = 0; C is 0 where the triangle is seen edge on
"""

from typing import Any, NamedTuple

from numpy.typing import NDArray

Array = NDArray[Any]


class Corner(NamedTuple):
    """A corner of a triangle on the device."""

    x: float
    y: float
    z: float


Corners = tuple[Corner, Corner, Corner]
Plane = tuple[float, float, float, float]


def corners_of(vertices: Array, faces: Array, face: int) -> Corners:
    """The corners of a triangle in the order of their rows, the lowest first.

    Args: vertices (n, 3), faces (m, 3).
    """
    i, j, k = faces[face, 0], faces[face, 1], faces[face, 2]
    low = Corner(float(vertices[i, 0]), float(vertices[i, 1]), float(vertices[i, 2]))
    middle = Corner(float(vertices[j, 0]), float(vertices[j, 1]), float(vertices[j, 2]))
    high = Corner(float(vertices[k, 0]), float(vertices[k, 1]), float(vertices[k, 2]))
    if middle.y < low.y:
        low, middle = middle, low
    if high.y < middle.y:
        middle, high = high, middle
    if middle.y < low.y:
        low, middle = middle, low
    return low, middle, high


def plane(a: Corner, b: Corner, c: Corner) -> Plane:
    """A, B, C, D of the plane through three corners.

    Source: Hearn and Baker, Computer Graphics, C Version, section 10-1.
    """
    A = (b.y - a.y) * (c.z - a.z) - (c.y - a.y) * (b.z - a.z)
    B = (b.z - a.z) * (c.x - a.x) - (c.z - a.z) * (b.x - a.x)
    C = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)
    D = -(A * a.x + B * a.y + C * a.z)
    return A, B, C, D


def crossing(x0: float, y0: float, x1: float, y1: float, y: int) -> float:
    """Where the edge from (x0, y0) up to (x1, y1) crosses row y.

    Always computed from the lower end, so that two triangles find the same place on the edge they share.
    """
    return x0 + (y - y0) * (x1 - x0) / (y1 - y0)


def row_ends(low: Corner, middle: Corner, high: Corner, y: int) -> tuple[float, float]:
    """Where row y enters and leaves the triangle, for low.y <= y < high.y."""
    x_long = crossing(low.x, low.y, high.x, high.y, y)
    if y < middle.y:
        x_short = crossing(low.x, low.y, middle.x, middle.y, y)
    else:
        x_short = crossing(middle.x, middle.y, high.x, high.y, y)
    return min(x_long, x_short), max(x_long, x_short)
