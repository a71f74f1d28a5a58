"""The nodes of a BSP tree, and which piece divides best."""

from typing import NamedTuple

from workbench.algorithms.visibility.pieces import (
    CUT_THROUGH,
    Piece,
    plane_of,
    side_of_box,
    side_of_corners,
)
from workbench.algorithms.visibility.surfaces import Surface

NONE = -1
CANDIDATES, SAMPLES = 5, 100


class Node(NamedTuple):
    """The number of the surface whose plane divides, the pieces in that plane in the order to paint them, and
    the nodes in front of it and behind it, or NONE."""

    surface: int
    pieces: list[int]
    front: int
    back: int


class Half(NamedTuple):
    """Pieces that wait to be divided by the node that is theirs."""

    node: int
    members: list[int]


def dividing(pieces: list[Piece], surfaces: list[Surface], members: list[int]) -> int:
    """Of up to five members the one whose plane splits fewest others, then parts them most evenly."""
    best, least = members[0], -1
    for k in range(0, len(members), stride(len(members), CANDIDATES)):
        plane = plane_of(surfaces, pieces[members[k]].number)
        splits, balance = 0, 0
        for m in range(0, len(members), stride(len(members), SAMPLES)):
            # As side_of, but no piece is held: of its lists only that of corners, where the box cannot tell
            side = side_of_box(plane, pieces[members[m]].box)
            if side == CUT_THROUGH:
                side = side_of_corners(plane, pieces[members[m]].corners)
            if side == CUT_THROUGH:
                splits += 1
                if 0 <= least <= 8 * splits:
                    break
            else:
                balance += side
        cost = 8 * splits + abs(balance)
        if least < 0 or cost < least:
            best, least = members[k], cost
    return best


def stride(count: int, most: int) -> int:
    """The step that takes no more than ``most`` of ``count``, evenly."""
    return (count + most - 1) // most


def add_half(nodes: list[Node], work: list[Half], pieces: list[Piece], members: list[int]) -> int:
    """Give half of a space a node; returns that, or NONE where nothing is in it.

    It waits to be divided, unless one piece is alone in it.
    """
    if not members:
        return NONE
    node = len(nodes)
    if len(members) == 1:
        nodes.append(Node(pieces[members[0]].number, members, NONE, NONE))
        return node
    nodes.append(Node(NONE, members[:0], NONE, NONE))
    work.append(Half(node, members))
    return node


def put_in_plane(pieces: list[Piece], same: list[int], member: int) -> None:
    """Put a piece among those of its plane: the lowest number last, so that it is painted over the others."""
    place = 0
    while place < len(same) and pieces[same[place]].number > pieces[member].number:
        place += 1
    same.insert(place, member)
