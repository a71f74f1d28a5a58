"""The tests of the depth sort on two pieces, and where one is cut when no order helps."""

from typing import NamedTuple

from workbench.algorithms.visibility.device_plane import Corner
from workbench.algorithms.visibility.pieces import (
    CUT_THROUGH,
    UPRIGHT,
    Box,
    Piece,
    Plane,
    add_piece,
    part_of,
    plane_of,
    side_of,
    side_of_corners,
)
from workbench.algorithms.visibility.surfaces import Surface

NONE = -1


class Waiting(NamedTuple):
    """A piece that is not painted yet, by its number, and its greatest depth."""

    z_far: float
    piece: int


def eye_side(plane: Plane) -> int:
    """The side of a plane that the eye is on."""
    return 1 if plane.C < 0.0 else -1


def boxes_apart(p: Box, q: Box) -> bool:
    """Whether the boxes of two pieces do not overlap in x, or not in y."""
    return p.x_high <= q.x_low or q.x_high <= p.x_low or p.y_high <= q.y_low or q.y_high <= p.y_low


def is_behind(surfaces: list[Surface], P: Piece, Q: Piece) -> bool:
    """Whether P is wholly on the far side of Q's plane; in that plane, whether its number is higher."""
    plane = plane_of(surfaces, Q.number)
    side = side_of(plane, P)
    return side == -eye_side(plane) or (side == 0 and P.number >= Q.number)


def is_in_front(surfaces: list[Surface], Q: Piece, P: Piece) -> bool:
    """Whether Q is wholly on the eye's side of P's plane; in that plane, whether its number is lower."""
    plane = plane_of(surfaces, P.number)
    side = side_of(plane, Q)
    return side == eye_side(plane) or (side == 0 and Q.number <= P.number)


def pass_exchanged(surfaces: list[Surface], P: Piece, Q: Piece) -> bool:
    """Whether test 2 or 3 is passed with P and Q exchanged."""
    return is_behind(surfaces, Q, P) or is_in_front(surfaces, P, Q)


def edge_plane(start: Corner, end: Corner) -> Plane:
    """The plane through an edge and the eye: upright on the picture."""
    A, B = end.y - start.y, start.x - end.x
    return Plane(A, B, 0.0, -(A * start.x + B * start.y), UPRIGHT)


def parted_by_edge(P: Piece, Q: Piece) -> bool:
    """Whether an edge of P has all of P on one side and all of Q on the other, as the eye sees them."""
    start = P.corners[len(P.corners) - 1]
    for end in P.corners:
        plane = edge_plane(start, end)
        other = side_of(plane, Q)
        if other != CUT_THROUGH:
            own = side_of_corners(plane, P.corners)
            if own not in (0, other):
                return True
        start = end
    return False


def projections_apart(P: Piece, Q: Piece) -> bool:
    """Whether two pieces, as the eye sees them, do not overlap: an edge of one of them parts them."""
    return parted_by_edge(P, Q) or parted_by_edge(Q, P)


def edge_through(P: Piece, Q: Piece) -> Plane:
    """The plane through the eye and an edge of P that cuts Q; all 0 where none does."""
    start = P.corners[len(P.corners) - 1]
    for end in P.corners:
        plane = edge_plane(start, end)
        if side_of(plane, Q) == CUT_THROUGH:
            return plane
        start = end
    return Plane(0.0, 0.0, 0.0, 0.0, UPRIGHT)


def cut_between(surfaces: list[Surface], pieces: list[Piece], p: int, q: int) -> tuple[int, Plane]:
    """Which of two pieces to split and by what plane; NONE where they have one outline and do not pierce.

    By the plane of the other, or, where a cycle of several lets no plane cut, along an edge of the other.
    """
    P, Q = pieces[p], pieces[q]
    plane = plane_of(surfaces, Q.number)
    if side_of(plane, P) == CUT_THROUGH:
        return p, plane
    plane = plane_of(surfaces, P.number)
    if side_of(plane, Q) == CUT_THROUGH:
        return q, plane
    plane = edge_through(Q, P)
    if side_of(plane, P) == CUT_THROUGH:
        return p, plane
    plane = edge_through(P, Q)
    if side_of(plane, Q) == CUT_THROUGH:
        return q, plane
    return NONE, plane


def split_in_two(pieces: list[Piece], boxes: list[Box], plane: Plane, k: int) -> tuple[int, int]:
    """Add the parts of a piece in front of a plane and behind it; returns their numbers."""
    front = add_piece(pieces, part_of(plane, pieces[k], 1))
    behind = add_piece(pieces, part_of(plane, pieces[k], -1))
    boxes.append(pieces[front].box)
    boxes.append(pieces[behind].box)
    return front, behind


def put_by_depth(order: list[Waiting], pieces: list[Piece], k: int) -> None:
    """Put a piece into the order by its greatest depth, the farthest last; of equals the higher number."""
    waiting = Waiting(pieces[k].box.z_far, k)
    order.append(waiting)
    place = len(order) - 1
    while place > 0:
        z_far, other = order[place - 1]
        if z_far < waiting.z_far or (z_far == waiting.z_far and pieces[other].number <= pieces[k].number):
            break
        order[place] = order[place - 1]
        place -= 1
    order[place] = waiting
