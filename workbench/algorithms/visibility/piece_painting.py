"""How a piece of a surface is painted.

It is painted as its surface's own pixels on its side of every cut, not as a polygon of its own: so no seam
shows, and the depths that decide are those of the depth buffer.
"""

import math
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.visibility.painting import Spans
from workbench.algorithms.visibility.pieces import UPRIGHT, Piece
from workbench.algorithms.visibility.surfaces import Surface, depth_at, end_row, first_row, span_on

Array = NDArray[Any]

TIE = 1e-12
"""Depths that differ by less than this share of them are equal."""


def on_its_side(surfaces: list[Surface], piece: Piece, x: int, y: int) -> bool:
    """Whether a pixel of the piece's surface is on the piece's side of every cut."""
    for cut in piece.cuts:
        plane = cut.plane
        if plane.number == UPRIGHT:
            in_front = turned(plane.A * x + plane.B * y + plane.D, plane.A, plane.B) > 0.0
        else:
            ahead = lead(surfaces[piece.number], surfaces[plane.number], x, y)
            in_front = (ahead > 0.0) == (plane.C < 0.0)
        if in_front != (cut.side == 1):
            return False
    return True


def lead(surface: Surface, other: Surface, x: int, y: int) -> float:
    """Positive where a surface is nearer than another's plane at a pixel."""
    z, z_other = depth_at(surface, x, y), depth_at(other, x, y)
    ahead = z_other - z
    if abs(ahead) <= TIE * (abs(z) + abs(z_other)):
        ahead = 0.0
    along, up = other.dz_dx - surface.dz_dx, other.dz_dy - surface.dz_dy
    if abs(along) <= TIE * (abs(surface.dz_dx) + abs(other.dz_dx)):
        along = 0.0
    return turned(ahead, along, up)


def turned(value: float, along: float, up: float) -> float:
    """A value at a pixel; where it is 0 its sign a trifle further right, and where that is 0 further up.

    So it is in or out on a cut as half_open has it on an edge: no pixel is on both sides.
    """
    if value != 0.0:
        return value
    return along if along != 0.0 else up


def paint_piece(image: Array, surfaces: list[Surface], piece: Piece, colours: Array) -> Spans:
    """Paint the pixels of a piece. Emits: (y, x_left, x_right, surface), both ends included."""
    height, width = image.shape
    surface, box = surfaces[piece.number], piece.box
    # Beyond the piece's own rows and columns only a rounding error could be
    first = max(first_row(surface), math.floor(box.y_low))
    for y in range(first, min(end_row(surface, height), math.ceil(box.y_high) + 1)):
        left, end = span_on(surface, y, width)
        left, end = max(left, math.floor(box.x_low)), min(end, math.ceil(box.x_high) + 1)
        while left < end and not on_its_side(surfaces, piece, left, y):
            left += 1
        while left < end and not on_its_side(surfaces, piece, end - 1, y):
            end -= 1
        if left < end:
            image[y, left:end] = int(colours[piece.number])
            yield y, left, end - 1, piece.number
