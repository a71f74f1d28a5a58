"""The depth buffer for fine meshes: what ``depth_buffer`` draws, the faces towards the eye first.

Half of the faces of a solid look away from the eye, and lie behind those that do not. They wait until the
others are drawn; then most are left out unseen, as the farthest pixel of their tiles of the picture is nearer
than they are. z changes one way along rows and columns, also when rounded, so that a triangle is nowhere
nearer than at one corner of the box of pixels around it.

In another order the picture is the same, except where depths are equal: there the first one stays. Where a
face that waited is just as deep as what is there, this is told, and all has to be drawn in order.
Source: Greene, Kass and Miller, Hierarchical Z-Buffer Visibility, 1993.
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.visibility.depth_tiles import COLUMNS, ROWS
from workbench.algorithms.visibility.device_plane import corners_of, plane, row_ends

Array = NDArray[Any]

_ROUNDING = 1e-6  # pixels; by less than that the end of a row may lie outside of the triangle

EXAMPLE = (
    np.zeros((4, 4), np.uint32),
    np.ones((4, 4)),
    np.zeros(1, np.int64),
    np.array([[0.0, 0, 0.5], [4, 0, 0.5], [0, 4, 0.5]]),
    np.array([[0, 1, 2]]),
    np.array([1]),
    0,
)


def depth_buffer_front_first(
    image: Array, depth: Array, ties: Array, vertices: Array, faces: Array, colours: Array, low_row: int
) -> Iterator[tuple[int, int]]:
    """Draw triangles as ``depth_buffer`` does, on the rows of a picture from ``low_row`` on.

    Args: as of ``depth_buffer``; image and depth (h, w) hold rows low_row to low_row + h - 1; ties (1,),
    written: 1 where the order matters, and the picture may be another one. Emits: the number of each
    triangle that is drawn, and how many rows it reaches.
    """
    height, width = image.shape
    across = width // COLUMNS + 2
    starts, ends = np.zeros(height, np.int64), np.zeros(height, np.int64)
    farthest = np.zeros((height // ROWS + 2) * across)
    waiting, tiles = np.empty(len(faces), np.int64), np.empty(len(faces), np.int64)
    nearest, away = np.empty(len(faces)), 0
    for place in range(2 * len(faces)):
        face = place
        if place >= len(faces):
            turn = place - len(faces)
            if turn >= away:
                break
            if turn == 0:
                look_up(depth, farthest, across)
            if nearest[turn] > farthest[tiles[turn]]:
                continue
            face = waiting[turn]
        i, j, k = faces[face, 0], faces[face, 1], faces[face, 2]
        y_i, y_j, y_k = float(vertices[i, 1]), float(vertices[j, 1]), float(vertices[k, 1])
        if max(y_i, y_j, y_k) <= low_row or min(y_i, y_j, y_k) > low_row + height - 1:
            continue
        x_i, x_j, x_k = float(vertices[i, 0]), float(vertices[j, 0]), float(vertices[k, 0])
        low, middle, high = corners_of(vertices, faces, face)
        first, end = max(math.ceil(low.y) - low_row, 0), min(math.ceil(high.y) - low_row, height)
        left = max(math.floor(min(x_i, x_j, x_k)), 0)
        right = min(math.ceil(max(x_i, x_j, x_k) + _ROUNDING), width)
        if first >= end or left >= right:
            continue
        A, B, C, _D = plane(low, middle, high)
        if C == 0.0:
            continue
        dz_dx, dz_dy = -A / C, -B / C
        x_near, y_near = left, low_row + first
        if dz_dx < 0.0:
            x_near = right - 1
        if dz_dy < 0.0:
            y_near = low_row + end - 1
        z_near = low.z + (y_near - low.y) * dz_dy + (x_near - low.x) * dz_dx
        small = end - first <= ROWS and right - left <= COLUMNS
        if place < len(faces) and (x_j - x_i) * (y_k - y_i) < (x_k - x_i) * (y_j - y_i):
            waiting[away], nearest[away] = face, z_near
            tiles[away] = first // ROWS * across + left // COLUMNS
            if not small:
                nearest[away] = -np.inf
            away += 1
            continue
        if small and is_covered(depth, first, end, left, right, z_near):
            continue
        for row in range(max(first, 0), end):
            x_left, x_right = row_ends(low, middle, high, low_row + row)
            starts[row], ends[row] = math.ceil(x_left), math.ceil(x_right)
        for row in range(max(first, 0), end):
            z_row = low.z + (low_row + row - low.y) * dz_dy
            for column in range(max(starts[row], 0), min(ends[row], width)):
                z = z_row + (column - low.x) * dz_dx
                if z < depth[row, column]:
                    depth[row, column] = z
                    image[row, column] = colours[face]
                elif place >= len(faces) and z == depth[row, column]:
                    ties[0] = 1
        yield face, end - first


def look_up(depth: Array, farthest: Array, across: int) -> None:
    """Write the depth of the farthest pixel in each tile, the next one, and the two above them.

    Args: farthest, of all tiles, ``across`` in a strip of ROWS rows, and beyond the last of each direction.
    """
    height, width = depth.shape
    for tile in range(len(farthest)):
        farthest[tile] = -np.inf
    of_column = np.zeros(width)
    for strip in range(height // ROWS + 1):
        for column in range(width):
            of_column[column] = -np.inf
        for row in range(ROWS * strip, min(ROWS * (strip + 1), height)):
            for column in range(width):
                of_column[column] = max(of_column[column], depth[row, column])
        for column in range(width):
            tile = strip * across + column // COLUMNS
            farthest[tile] = max(farthest[tile], of_column[column])
    for tile in range(len(farthest) - across - 1):
        beside = max(farthest[tile], farthest[tile + 1])
        farthest[tile] = max(beside, farthest[tile + across], farthest[tile + across + 1])


def is_covered(depth: Array, first: int, end: int, left: int, right: int, z: float) -> bool:
    """Whether all pixels of a box are nearer than z."""
    for row in range(max(first, 0), end):
        for column in range(max(left, 0), right):
            if not depth[row, column] < z:
                return False
    return True
