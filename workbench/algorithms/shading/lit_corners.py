"""Corners of a triangle with their light, and the light along an edge and along a scan line."""

from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.visibility.device_plane import crossing

Array = NDArray[Any]


class LitCorner(NamedTuple):
    """A corner on the device, and its light."""

    x: float
    y: float
    z: float
    light: float


class LitPlace(NamedTuple):
    """Where an edge crosses a scan line, and the light there."""

    x: float
    light: float


def lit_corner(vertices: Array, intensities: Array, k: int) -> LitCorner:
    """Vertex k, (n, 3), with its intensity, (n,)."""
    x, y, z = vertices[k, 0], vertices[k, 1], vertices[k, 2]
    return LitCorner(float(x), float(y), float(z), float(intensities[k]))


def lit_corners_of(
    vertices: Array, faces: Array, intensities: Array, face: int
) -> tuple[LitCorner, LitCorner, LitCorner]:
    """The corners of a triangle in the order of their rows, the lowest first."""
    low = lit_corner(vertices, intensities, faces[face, 0])
    middle = lit_corner(vertices, intensities, faces[face, 1])
    high = lit_corner(vertices, intensities, faces[face, 2])
    if middle.y < low.y:
        low, middle = middle, low
    if high.y < middle.y:
        middle, high = high, middle
    if middle.y < low.y:
        low, middle = middle, low
    return low, middle, high


def on_edge(low: LitCorner, high: LitCorner, y: int) -> LitPlace:
    """Where an edge crosses row y, for low.y <= y < high.y, and the light there: each end by its share."""
    share = (y - low.y) / (high.y - low.y)
    light = low.light + share * (high.light - low.light)
    return LitPlace(crossing(low.x, low.y, high.x, high.y, y), light)


def lit_row_ends(low: LitCorner, middle: LitCorner, high: LitCorner, y: int) -> tuple[LitPlace, LitPlace]:
    """Where row y enters and leaves the triangle, and the light at both places."""
    long_edge = on_edge(low, high, y)
    if y < middle.y:
        short_edge = on_edge(low, middle, y)
    else:
        short_edge = on_edge(middle, high, y)
    if long_edge.x <= short_edge.x:
        return long_edge, short_edge
    return short_edge, long_edge
