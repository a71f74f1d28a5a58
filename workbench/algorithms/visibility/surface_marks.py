"""What is drawn of the methods for hidden surfaces: outlines of surfaces and pieces, squares, scan lines."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import MOST_SPOTS, Ink, Mark, Region, Stroke, Weight, closed
from workbench.algorithms.visibility.device_plane import Corner
from workbench.algorithms.visibility.pieces import Piece
from workbench.algorithms.visibility.surfaces import Surface


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], _emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """Outlines of the triangles."""
    _image, vertices, faces, *_colours = arguments
    for face in faces[:MOST_SPOTS]:
        yield Stroke(closed(np.array(vertices[face, :2], np.float64)), "muted", "hair")


def square_marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """Outlines of the triangles, and the squares that wait."""
    yield from marks(arguments, now, emitted, ended)
    for square in now.get("waiting", ())[-MOST_SPOTS:]:
        yield square_mark(square, "data4", "hair")


def square_mark(square: Any, ink: Ink = "accent", weight: Weight = "medium") -> Mark:
    """The outline of a square of pixels, or of a cell as the eye sees it."""
    left, low = square.x - 0.5, square.y - 0.5
    right, high = left + square.size, low + square.size
    return Stroke(closed(np.array([[left, low], [right, low], [right, high], [left, high]])), ink, weight)


def surface_mark(surface: Surface, ink: Ink = "accent") -> Mark:
    """The outline of a surface."""
    return outline((surface.low, surface.middle, surface.high), ink)


def outline(corners: Sequence[Corner], ink: Ink = "accent") -> Mark:
    """The outline of a polygon."""
    return Stroke(closed(np.array([corner[:2] for corner in corners], np.float64)), ink, "medium")


def piece_marks(piece: Piece, ink: Ink = "accent") -> tuple[Mark, ...]:
    """A piece: its outline, and its inside tinted."""
    points = np.array([corner[:2] for corner in piece.corners], np.float64)
    return Region(points, ink), outline(piece.corners, ink)
