"""Corners of a triangle with places and normals, and both along an edge and along a scan line."""

from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.shading.directions import between
from workbench.algorithms.visibility.back_faces import SpaceVector, vector_of
from workbench.algorithms.visibility.device_plane import crossing

Array = NDArray[Any]


class NormalCorner(NamedTuple):
    """A corner on the device, where it is in the world, and the normal there."""

    x: float
    y: float
    z: float
    place: SpaceVector
    normal: SpaceVector


class NormalPlace(NamedTuple):
    """Where an edge crosses a scan line, or a pixel of it: its place in the world, and the normal there."""

    x: float
    place: SpaceVector
    normal: SpaceVector


def normal_corner(vertices: Array, places: Array, normals: Array, k: int) -> NormalCorner:
    """Vertex k, of arrays (n, 3)."""
    device = vector_of(vertices, k)
    return NormalCorner(device.x, device.y, device.z, vector_of(places, k), vector_of(normals, k))


def normal_corners_of(
    vertices: Array, faces: Array, places: Array, normals: Array, face: int
) -> tuple[NormalCorner, NormalCorner, NormalCorner]:
    """The corners of a triangle in the order of their rows, the lowest first."""
    low = normal_corner(vertices, places, normals, faces[face, 0])
    middle = normal_corner(vertices, places, normals, faces[face, 1])
    high = normal_corner(vertices, places, normals, faces[face, 2])
    if middle.y < low.y:
        low, middle = middle, low
    if high.y < middle.y:
        middle, high = high, middle
    if middle.y < low.y:
        low, middle = middle, low
    return low, middle, high


def normal_on_edge(low: NormalCorner, high: NormalCorner, y: int) -> NormalPlace:
    """Where an edge crosses row y, for low.y <= y < high.y; place and normal by the share of the way."""
    share = (y - low.y) / (high.y - low.y)
    x = crossing(low.x, low.y, high.x, high.y, y)
    return NormalPlace(x, between(low.place, high.place, share), between(low.normal, high.normal, share))


def normal_row_ends(
    low: NormalCorner, middle: NormalCorner, high: NormalCorner, y: int
) -> tuple[NormalPlace, NormalPlace]:
    """Where row y enters and leaves the triangle, with place and normal at both."""
    long_edge = normal_on_edge(low, high, y)
    if y < middle.y:
        short_edge = normal_on_edge(low, middle, y)
    else:
        short_edge = normal_on_edge(middle, high, y)
    if long_edge.x <= short_edge.x:
        return long_edge, short_edge
    return short_edge, long_edge


def normal_on_row(start: NormalPlace, end: NormalPlace, x: int) -> NormalPlace:
    """The pixel at x of a scan line, start.x <= x < end.x."""
    share = (x - start.x) / (end.x - start.x)
    place, normal = between(start.place, end.place, share), between(start.normal, end.normal, share)
    return NormalPlace(float(x), place, normal)
