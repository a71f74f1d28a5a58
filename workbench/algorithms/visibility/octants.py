"""The cells of an octree over surfaces, and the order in which an eye sees the eight octants of one."""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.visibility.boxes import X_HIGH, X_LOW, Y_HIGH, Y_LOW, Z_HIGH, Z_LOW
from workbench.algorithms.visibility.surfaces import (
    NEAR_ZERO,
    NOTHING,
    Surface,
    covers,
    depth_at,
    farthest_z,
    in_view,
    nearest_z,
)

Array = NDArray[Any]

X, Y, Z = 4, 2, 1
"""The bits of an octant: the upper half along each axis, z away from the eye."""

EYE_OCTANT = 0

FEW, MANY = 4, 64
"""Where there are MANY surfaces, cells with FEW of them are drawn: to part these would cost more."""
_TURNS = (0, Z, Y, X, Y + Z, X + Z, X + Y, X + Y + Z)


class Cell(NamedTuple):
    """A cell: its lower left pixel, its side in pixels, the depths that it reaches from and to, and the
    surfaces that may be in it."""

    x: int
    y: int
    size: int
    z_near: float
    z_far: float
    members: list[int]


def front_to_back(eye_octant: int) -> list[int]:
    """The octants as seen from one of them: itself, the three beside it, those beyond these, the last."""
    return [eye_octant ^ turn for turn in _TURNS]


def whole_cell(surfaces: list[Surface], size: int) -> Cell:
    """One cell that holds all surfaces."""
    members = in_view(surfaces)
    z_near, z_far = 1.0, 0.0
    for number in members:
        z_near = min(z_near, nearest_z(surfaces[number]))
        z_far = max(z_far, farthest_z(surfaces[number]))
    return Cell(0, 0, size, z_near - NEAR_ZERO, z_far + NEAR_ZERO, members)


def enough(surfaces: list[Surface]) -> int:
    """With no more surfaces than this a cell is drawn."""
    return 1 if len(surfaces) < MANY else FEW


def octant_of(cell: Cell, octant: int, extents: Array) -> Cell:
    """One of the eight parts of a cell, with the surfaces whose extents (m, 6) reach into it."""
    half, middle = cell.size // 2, (cell.z_near + cell.z_far) / 2
    x = cell.x + half if octant & X else cell.x
    y = cell.y + half if octant & Y else cell.y
    z_near, z_far = (middle, cell.z_far) if octant & Z else (cell.z_near, middle)
    members = cell.members[:0]
    for number in cell.members:
        if reaches_into(extents, number, x, y, half, z_near, z_far):
            members.append(number)
    return Cell(x, y, half, z_near, z_far, members)


def reaches_into(extents: Array, number: int, x: int, y: int, size: int, z_near: float, z_far: float) -> bool:
    """Whether the box around a surface reaches into a cell."""
    if extents[number, X_HIGH] < x or x + size - 1 < extents[number, X_LOW]:
        return False
    if extents[number, Y_HIGH] < y or y + size - 1 < extents[number, Y_LOW]:
        return False
    return bool(extents[number, Z_LOW] < z_far and z_near <= extents[number, Z_HIGH])


def nearest_in(surfaces: list[Surface], cell: Cell, x: int, y: int) -> int:
    """The nearest of a cell's surfaces at the centre of a pixel, at the cell's own depths, or NOTHING."""
    nearest, seen = math.inf, NOTHING
    for number in cell.members:
        if covers(surfaces[number], x, y):
            z = depth_at(surfaces[number], x, y)
            if cell.z_near <= z < cell.z_far and z < nearest:
                nearest, seen = z, number
    return seen


def all_painted(painted: Array, cell: Cell) -> bool:
    """Whether no pixel of a cell is left."""
    height, width = painted.shape
    for y in range(cell.y, min(cell.y + cell.size, height)):
        for x in range(cell.x, min(cell.x + cell.size, width)):
            if not painted[y, x]:
                return False
    return True
