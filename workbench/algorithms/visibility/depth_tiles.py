"""The depth buffer for whole pictures: what ``depth_buffer`` draws, sooner.

The ends of all rows of a triangle are found before its first pixel, so that they are not waited for row by
row. A tall triangle leaves out each tile of the picture that lies in front of it: a tile is ROWS x COLUMNS
pixels, and as soon as one triangle fills it nothing in it is farther than that triangle's farthest corner
there. z changes one way along rows and columns, also when rounded, so that a triangle's nearest and farthest
pixel in a tile are at its corners, and what is left out would have lost each comparison.

With light at the corners, as in Gouraud shading, what is kept is the light of each pixel: a whole number for
all three channels, so that the next pixel and the next row are an addition away. It begins anew in each part
of a triangle, lest the steps drift.
Source: Greene, Kass and Miller, Hierarchical Z-Buffer Visibility, 1993.
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.visibility.device_plane import Corner, corners_of, plane, row_ends
from workbench.algorithms.visibility.packed_light import Sides, light_plane, packed

Array = NDArray[Any]

ROWS, COLUMNS = 8, 16
TALL = 24
"""Triangles of fewer rows are drawn without a look at the tiles: they fill too few of them."""

WIDE = 128
"""Wider ones are cut into parts of at most so many columns, lest the steps of light drift."""

EXAMPLE = (
    np.zeros((4, 4), np.uint32),
    np.ones((4, 4)),
    np.array([[0.0, 0, 0.5], [4, 0, 0.5], [0, 4, 0.5]]),
    np.array([[0, 1, 2]]),
    np.array([1]),
    None,
    0.0,
    0,
)
LIT_EXAMPLE = (np.zeros((4, 4), np.int64), *EXAMPLE[1:5], np.ones((3, 3)), 1.0, 0)


def depth_buffer_tiles(
    image: Array,
    depth: Array,
    vertices: Array,
    faces: Array,
    colours: Array,
    lights: Array | None,
    steps: float,
    low_row: int,
) -> Iterator[tuple[int, int]]:
    """Draw triangles as ``depth_buffer`` does, on the rows of a picture from ``low_row`` on.

    Args: as of ``depth_buffer``; image and depth (h, w) hold rows low_row to low_row + h - 1; lights (n, 3),
    linear red, green and blue of each vertex, or None. With lights the image, int64, gets ``packed_light`` in
    place of colours, ``steps`` of it for light 1. Emits: the number of each triangle that is on a pixel of
    these rows, and how many rows it reaches.
    """
    height, width = image.shape
    starts, ends = np.zeros(height, np.int64), np.zeros(height, np.int64)
    farthest = np.full((height // ROWS + 1, width // COLUMNS + 1), np.inf)
    parts = np.zeros((1 + farthest.size, 4), np.int64)
    for face in range(len(faces)):
        i, j, k = faces[face, 0], faces[face, 1], faces[face, 2]
        y_i, y_j, y_k = float(vertices[i, 1]), float(vertices[j, 1]), float(vertices[k, 1])
        # Before the corners are put in order, which costs most where the triangle is in another band
        if max(y_i, y_j, y_k) <= low_row or min(y_i, y_j, y_k) > low_row + height - 1:
            continue
        low, middle, high = corners_of(vertices, faces, face)
        first, end = max(math.ceil(low.y) - low_row, 0), min(math.ceil(high.y) - low_row, height)
        if first >= end:
            continue
        A, B, C, _D = plane(low, middle, high)
        if C == 0.0:
            continue
        dz_dx, dz_dy = -A / C, -B / C
        widest = 0
        for row in range(max(first, 0), min(end, height)):
            x_left, x_right = row_ends(low, middle, high, low_row + row)
            start, stop = max(math.ceil(x_left), 0), min(math.ceil(x_right), width)
            starts[row], ends[row] = start, stop
            widest = max(widest, stop - start)
        if widest == 0:
            continue

        parts[0, 0], parts[0, 1], parts[0, 2], parts[0, 3] = first, end, 0, width
        count = 1
        if end - first >= TALL or max(low.x, middle.x, high.x) - min(low.x, middle.x, high.x) > WIDE:
            count = parts_in_sight(
                parts, farthest, starts, ends, low_row, first, end, width, low, dz_dx, dz_dy
            )
        shade, shade_dx, shade_dy = int(colours[face]), 0, 0
        if lights is not None:
            x_i = float(vertices[i, 0])
            ux, vx = float(vertices[j, 0]) - x_i, float(vertices[k, 0]) - x_i
            area = ux * (y_k - y_i) - vx * (y_j - y_i)
            share = 0.0
            if area != 0.0:
                share = steps / area
            sides = Sides(ux, y_j - y_i, vx, y_k - y_i, share)
            red = light_plane(sides, steps, lights[i, 0], lights[j, 0], lights[k, 0])
            green = light_plane(sides, steps, lights[i, 1], lights[j, 1], lights[k, 1])
            blue = light_plane(sides, steps, lights[i, 2], lights[j, 2], lights[k, 2])
            shade_dx, shade_dy = packed(red.dx, green.dx, blue.dx), packed(red.dy, green.dy, blue.dy)
        for part in range(count):
            bottom, left, right = parts[part, 0], parts[part, 2], parts[part, 3]
            x_first = max(min(starts[bottom], right), left)
            if lights is not None:
                x, y = x_first - x_i, low_row + bottom - y_i
                shade = packed(
                    red.at + x * red.dx + y * red.dy,
                    green.at + x * green.dx + y * green.dy,
                    blue.at + x * blue.dx + y * blue.dy,
                )
            for row in range(max(bottom, 0), min(parts[part, 1], height)):
                z_row = low.z + (low_row + row - low.y) * dz_dy
                start = max(starts[row], left, 0)
                value = shade + (row - bottom) * shade_dy + (start - x_first) * shade_dx
                for column in range(max(start, 0), min(min(ends[row], right), width)):
                    z = z_row + (column - low.x) * dz_dx
                    if z < depth[row, column]:
                        depth[row, column] = z
                        image[row, column] = value
                    value += shade_dx
        yield face, end - first


def parts_in_sight(
    parts: Array,
    farthest: Array,
    starts: Array,
    ends: Array,
    low_row: int,
    first_row: int,
    end_row: int,
    width: int,
    low: Corner,
    dz_dx: float,
    dz_dy: float,
) -> int:
    """Where a triangle may be in sight; how many parts of the picture that are.

    Args: parts (n, 4), written: first row, end, first column, end of each; farthest: no pixel of a tile is
    farther, written; starts and ends: of each row of the triangle, which reaches from first_row to end_row.
    """
    count = 0
    for strip in range(first_row // ROWS, (end_row + ROWS - 1) // ROWS):
        first, end = max(first_row, ROWS * strip), min(end_row, ROWS * (strip + 1))
        left, right = width, 0
        all_from, all_to = 0, width
        for row in range(max(first, 0), end):
            left, right = min(left, starts[row]), max(right, ends[row])
            all_from, all_to = max(all_from, starts[row]), min(all_to, ends[row])
        if end - first < ROWS:
            all_to = 0
        y_near, y_far = low_row + first, low_row + end - 1
        if dz_dy < 0.0:
            y_near, y_far = y_far, y_near
        z_near = low.z + (y_near - low.y) * dz_dy
        z_far = low.z + (y_far - low.y) * dz_dy
        reached = -1
        for tile in range(left // COLUMNS, (right + COLUMNS - 1) // COLUMNS):
            start, stop = COLUMNS * tile, COLUMNS * (tile + 1)
            x_near, x_far = max(left, start), min(right, stop) - 1
            if dz_dx < 0.0:
                x_near, x_far = x_far, x_near
            if z_near + (x_near - low.x) * dz_dx < farthest[strip, tile]:
                if reached != start or stop - parts[count - 1, 2] > WIDE:
                    parts[count, 0], parts[count, 1], parts[count, 2] = first, end, start
                    count += 1
                parts[count - 1, 3] = stop
                reached = stop
            if all_from <= start and stop <= all_to:
                farthest[strip, tile] = min(farthest[strip, tile], z_far + (x_far - low.x) * dz_dx)
    return count
