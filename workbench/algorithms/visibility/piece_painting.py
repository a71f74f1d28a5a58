"""How a piece of a surface is painted.

It is painted as its surface's own pixels on its side of every cut, not as a polygon of its own: so no seam
shows, and the depths that decide are those of the depth buffer.
"""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.visibility.device_plane import Corner
from workbench.algorithms.visibility.painting import Spans
from workbench.algorithms.visibility.pieces import UPRIGHT, Cut, Piece
from workbench.algorithms.visibility.surfaces import (
    NEAR_ZERO,
    Surface,
    depth_at,
    end_row,
    first_row,
    span_on,
)

Array = NDArray[Any]

TIE = 1e-12
"""Depths that differ by less than this share of them are equal."""

BESIDE = 1e4
"""A line so many times farther from every corner than it is unsure is no side of a piece."""


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


class CutLine(NamedTuple):
    """A cut as the eye sees it: at + along (x - x0) + up (y - y0), which is positive on the piece's side.

    ``unsure`` is how near to 0 a rounding error may reach: there the pixel itself is looked at.
    """

    x0: float
    y0: float
    at: float
    along: float
    up: float
    unsure: float


def cut_line(surfaces: list[Surface], piece: Piece, cut: Cut) -> CutLine:
    """The line that a cut makes on the picture, about the lower left corner of the piece's box."""
    x0, y0, plane = piece.box.x_low, piece.box.y_low, cut.plane
    if plane.number == UPRIGHT:
        a, b = plane.A * x0, plane.B * y0
        at, along, up = a + b + plane.D, plane.A, plane.B
        terms = abs(a) + abs(b) + abs(plane.D)
        towards = cut.side
    else:
        surface, other = surfaces[piece.number], surfaces[plane.number]
        z, z_other = depth_at(surface, x0, y0), depth_at(other, x0, y0)
        at, along, up = z_other - z, other.dz_dx - surface.dz_dx, other.dz_dy - surface.dz_dy
        terms = abs(z) + abs(z_other) + steepness(surface) + steepness(other)
        towards = cut.side if plane.C < 0.0 else -cut.side
    return CutLine(x0, y0, at * towards, along * towards, up * towards, NEAR_ZERO * terms)


def steepness(surface: Surface) -> float:
    """How much z may change from a pixel to the next."""
    return abs(surface.dz_dx) + abs(surface.dz_dy)


def bounding(surfaces: list[Surface], piece: Piece) -> list[CutLine]:
    """The lines of those cuts that are sides of the piece still: other cuts may have taken the rest."""
    lines = [cut_line(surfaces, piece, cut) for cut in piece.cuts]
    for k in range(len(lines) - 1, -1, -1):
        if not is_side(lines[k], piece.corners):
            lines.pop(k)
    return lines


def is_side(line: CutLine, corners: list[Corner]) -> bool:
    """Whether a line comes near a corner of a piece."""
    near = False
    for corner in corners:
        if value_at(line, corner.x, corner.y) <= BESIDE * line.unsure:
            near = True
    return near


def value_at(line: CutLine, x: float, y: float) -> float:
    """Positive on the piece's side of a line."""
    return line.at + line.along * (x - line.x0) + line.up * (y - line.y0)


def part_within(line: CutLine, left: int, end: int, y: int) -> tuple[int, int]:
    """What of the pixels from left to end is not surely beyond a line."""
    if left >= end:
        return left, end
    value = value_at(line, left, y)
    last = value + line.along * (end - 1 - left)
    if value < -line.unsure:
        if last < -line.unsure:
            return end, end
        left += math.ceil((value + line.unsure) / -line.along)
    elif last < -line.unsure:
        end = left + math.floor((value + line.unsure) / -line.along) + 1
    return left, end


def is_sure(lines: list[CutLine], x: int, y: int) -> bool:
    """Whether a pixel is on the piece's side of all lines beyond any rounding error."""
    sure = True
    for line in lines:
        if value_at(line, x, y) <= line.unsure:
            sure = False
    return sure


def paint_piece(image: Array, surfaces: list[Surface], piece: Piece, colours: Array) -> Spans:
    """Paint the pixels of a piece. Emits: (y, x_left, x_right, surface), both ends included."""
    height, width = image.shape
    surface, box, lines = surfaces[piece.number], piece.box, bounding(surfaces, piece)
    # Beyond the piece's own rows and columns only a rounding error could be
    first = max(first_row(surface), math.floor(box.y_low))
    for y in range(first, min(end_row(surface, height), math.ceil(box.y_high) + 1)):
        left, end = span_on(surface, y, width)
        left, end = max(left, math.floor(box.x_low)), min(end, math.ceil(box.x_high) + 1)
        for line in lines:
            left, end = part_within(line, left, end, y)
        while left < end and not (is_sure(lines, left, y) or on_its_side(surfaces, piece, left, y)):
            left += 1
        while left < end and not (is_sure(lines, end - 1, y) or on_its_side(surfaces, piece, end - 1, y)):
            end -= 1
        if left < end:
            image[y, left:end] = int(colours[piece.number])
            yield y, left, end - 1, piece.number
