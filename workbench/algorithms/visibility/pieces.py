"""Pieces of surfaces: convex polygons, and how one is cut by a plane."""

from typing import NamedTuple

from workbench.algorithms.visibility.device_plane import Corner
from workbench.algorithms.visibility.surfaces import NEAR_ZERO, Surface

UPRIGHT = -1
"""In place of a surface's number: a plane through an edge and the eye."""

CUT_THROUGH = 2

MOST_PIECES = 40_000


class Plane(NamedTuple):
    """Ax + By + Cz + D = 0: that of the surface with this number, or one through an edge and the eye."""

    A: float
    B: float
    C: float
    D: float
    number: int


class Cut(NamedTuple):
    """A plane that a piece was cut by, and on which side of it the piece is: 1 in front, -1 behind."""

    plane: Plane
    side: int


class Box(NamedTuple):
    """The least and the greatest of each coordinate."""

    x_low: float
    x_high: float
    y_low: float
    y_high: float
    z_near: float
    z_far: float


def box_of(corners: list[Corner]) -> Box:
    """The box around a polygon."""
    x_low, y_low, z_near = corners[0]
    x_high, y_high, z_far = corners[0]
    for x, y, z in corners:
        x_low, x_high = min(x_low, x), max(x_high, x)
        y_low, y_high = min(y_low, y), max(y_high, y)
        z_near, z_far = min(z_near, z), max(z_far, z)
    return Box(x_low, x_high, y_low, y_high, z_near, z_far)


class Piece(NamedTuple):
    """What of a surface is left on one side of every cut, and the box around it."""

    corners: list[Corner]
    number: int
    cuts: list[Cut]
    box: Box


def plane_of(surfaces: list[Surface], number: int) -> Plane:
    """The plane of a surface."""
    surface = surfaces[number]
    return Plane(surface.A, surface.B, surface.C, surface.D, number)


def whole(surfaces: list[Surface], number: int) -> Piece:
    """A surface as one piece."""
    surface = surfaces[number]
    cuts = [Cut(Plane(0.0, 0.0, 0.0, 0.0, UPRIGHT), 0)]
    cuts.pop()
    corners = [surface.low, surface.middle, surface.high]
    return Piece(corners, number, cuts, box_of(corners))


def offset(plane: Plane, corner: Corner) -> float:
    """Ax + By + Cz + D, which is positive in front of the plane; 0 where it is but a rounding error."""
    a, b, c = plane.A * corner.x, plane.B * corner.y, plane.C * corner.z
    value = a + b + c + plane.D
    if abs(value) <= NEAR_ZERO * (abs(a) + abs(b) + abs(c) + abs(plane.D)):
        return 0.0
    return value


def side_of(plane: Plane, piece: Piece) -> int:
    """1 where all corners are in front of the plane or in it, -1 behind, 0 all in it, or CUT_THROUGH."""
    side = side_of_box(plane, piece.box)
    return side_of_corners(plane, piece.corners) if side == CUT_THROUGH else side


def side_of_corners(plane: Plane, corners: list[Corner]) -> int:
    """As ``side_of``, by every corner."""
    in_front, behind = False, False
    for corner in corners:
        value = offset(plane, corner)
        if value > 0.0:
            in_front = True
        elif value < 0.0:
            behind = True
        if in_front and behind:
            return CUT_THROUGH
    if in_front:
        return 1
    return -1 if behind else 0


def side_of_box(plane: Plane, box: Box) -> int:
    """1 where a box is surely in front of a plane, -1 surely behind it, else CUT_THROUGH."""
    x, y, z = plane.A * (box.x_low + box.x_high), plane.B * (box.y_low + box.y_high), plane.C
    z *= box.z_near + box.z_far
    reach = abs(plane.A) * (box.x_high - box.x_low) + abs(plane.B) * (box.y_high - box.y_low)
    reach += abs(plane.C) * (box.z_far - box.z_near)
    twice_D = 2.0 * plane.D
    value = x + y + z + twice_D
    reach += 2.0 * NEAR_ZERO * (abs(x) + abs(y) + abs(z) + abs(twice_D) + reach)
    if value > reach:
        return 1
    return -1 if value < -reach else CUT_THROUGH


def part_of(plane: Plane, piece: Piece, side: int) -> Piece:
    """The part of a piece in front of a plane (1) or behind it (-1).

    Where an edge is cut is always computed from its end behind the plane, so that both parts have one point.
    """
    corners = piece.corners[:0]
    start = piece.corners[len(piece.corners) - 1]
    from_start = offset(plane, start)
    for end in piece.corners:
        from_end = offset(plane, end)
        if from_start < 0.0 < from_end:
            corners.append(between(start, end, from_start / (from_start - from_end)))
        elif from_end < 0.0 < from_start:
            corners.append(between(end, start, from_end / (from_end - from_start)))
        if from_end * side >= 0.0:
            corners.append(end)
        start, from_start = end, from_end
    cuts = piece.cuts[:]
    cuts.append(Cut(plane, side))
    return Piece(corners, piece.number, cuts, box_of(corners))


def between(start: Corner, end: Corner, share: float) -> Corner:
    """The point that lies this share of the way from one corner to another."""
    x, y = start.x + share * (end.x - start.x), start.y + share * (end.y - start.y)
    return Corner(x, y, start.z + share * (end.z - start.z))


def add_piece(pieces: list[Piece], piece: Piece) -> int:
    """Put a piece to the others; returns its number. Raises ValueError: there are too many."""
    if len(pieces) >= MOST_PIECES:
        raise ValueError("The surfaces cut one another into more than 40,000 pieces.")
    pieces.append(piece)
    return len(pieces) - 1
