"""The depth buffer, for triangles.

x, y            pixel; y goes up the rows that the triangle covers
A, B, C         normal of the triangle's plane Ax + By + Cz + D = 0
dz_dx, dz_dy    change of z from a pixel to the next one: -A/C along a row, -B/C from row to row
z_here, stored  depth of the triangle at this pixel, and the nearest depth found there so far
won             1 where the triangle is strictly nearer, else 0
"""

import math
from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.visibility.scene import SCENE, scene
from workbench.algorithms.visibility.views import VIEWS

Array = NDArray[Any]


def crossing(x0: float, y0: float, x1: float, y1: float, y: int) -> float:
    """Where the edge from (x0, y0) up to (x1, y1) crosses row y.

    Always reckoned from the lower end, so that two triangles find the same place on the edge they share.
    """
    return x0 + (y - y0) * (x1 - x0) / (y1 - y0)


def depth_row(
    image_here: Array,
    depth_here: Array,
    y: int,
    left: int,
    z: float,
    dz_dx: float,
    colour: int,
) -> Iterator[tuple[int, int, float, int]]:
    """Test a row of fragments against the depths stored there, and keep those that are strictly nearer.

    Args: the covered part of one row of the picture and of the depth buffer, both written in place;
    its number and first column; z there. Emits: (x, y, z, won).
    """
    for k in range(len(depth_here)):
        # Find the depth: -A/C per pixel, as a product, since adding it up would drift
        z_here = z + k * dz_dx
        stored = float(depth_here[k])

        # Compare with the stored depth
        won = 0
        if z_here < stored:
            depth_here[k] = z_here
            image_here[k] = colour
            won = 1
        yield left + k, y, z_here, won


def depth_buffer(
    image: Array, depth: Array, vertices: Array, faces: Array, colours: Array, low_row: int, high_row: int
) -> Iterator[tuple[int, int, float, int]]:
    """Draw triangles in any order; at each pixel the nearest one wins, and on equal depths the first.

    A pixel is covered when y_low <= y < y_high and x_left <= x < x_right for its centre (half_open),
    so triangles that share an edge neither overlap nor leave a gap.

    Args: image, integers, and depth, floats, both (h, w), written in place, depth beginning at the
    farthest z; vertices (n, 3), finite: x and y in pixels, z; faces (m, 3): indices of vertices, turning
    either way; colours (m,); the rows from low_row up to, not including, high_row.
    Emits: (x, y, z, won). Source: Hearn and Baker, Computer Graphics, C Version, section 13-3.
    """
    # Measure the picture
    height, width = image.shape

    for face in range(len(faces)):
        # Find the rows that the triangle covers
        a, b, c = int(faces[face, 0]), int(faces[face, 1]), int(faces[face, 2])
        y_low = float(min(vertices[a, 1], vertices[b, 1], vertices[c, 1]))
        y_high = float(max(vertices[a, 1], vertices[b, 1], vertices[c, 1]))
        first_row = max(math.ceil(y_low), low_row, 0)
        row_end = min(math.ceil(y_high), high_row, height)
        if first_row >= row_end:
            continue

        # Take the corners, lowest first
        if vertices[b, 1] < vertices[a, 1]:
            a, b = b, a
        if vertices[c, 1] < vertices[b, 1]:
            b, c = c, b
        if vertices[b, 1] < vertices[a, 1]:
            a, b = b, a
        x0, y0, z0 = float(vertices[a, 0]), float(vertices[a, 1]), float(vertices[a, 2])
        x1, y1, z1 = float(vertices[b, 0]), float(vertices[b, 1]), float(vertices[b, 2])
        x2, y2, z2 = float(vertices[c, 0]), float(vertices[c, 1]), float(vertices[c, 2])
        colour = int(colours[face])

        # Find the plane's normal
        A = (y1 - y0) * (z2 - z0) - (y2 - y0) * (z1 - z0)
        B = (z1 - z0) * (x2 - x0) - (z2 - z0) * (x1 - x0)
        C = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
        if C == 0.0:
            continue
        dz_dx, dz_dy = -A / C, -B / C

        for y in range(first_row, row_end):
            # Find where the row enters and leaves the triangle
            x_left = crossing(x0, y0, x2, y2, y)
            x_right = crossing(x0, y0, x1, y1, y) if y < y1 else crossing(x1, y1, x2, y2, y)
            if x_right < x_left:
                x_left, x_right = x_right, x_left
            left = max(math.ceil(x_left), 0)
            right = min(math.ceil(x_right), width)

            # Test the fragments of the row
            if left < right:
                z = z0 + dz_dx * (left - x0) + dz_dy * (y - y0)
                image_here, depth_here = image[y, left:right], depth[y, left:right]
                yield from depth_row(image_here, depth_here, y, left, z, dz_dx, colour)


ENTRY = Entry(
    function=depth_buffer,
    topic="visibility",
    title="Depth buffer",
    summary="Keeps for each pixel the depth of the nearest surface so far; a nearer fragment replaces it.",
    parameters=SCENE,
    arguments=scene,
    emits="fragments",
    source="Hearn and Baker, Computer Graphics, C Version, section 13-3",
    columns=("x", "y", "z", "stored z", "won"),
    views=VIEWS,
    laws=(
        Law(
            "At every covered pixel the triangle with the least z wins.",
            "visibility/test_depth_buffer.py::test_at_each_pixel_the_exactly_nearest_wins",
        ),
        Law(
            "On equal z the triangle drawn first stays.",
            "visibility/test_depth_buffer.py::test_on_equal_depth_the_first_stays",
        ),
        Law(
            "The order of the triangles does not matter where no two depths are equal.",
            "visibility/test_depth_buffer.py::test_the_order_matters_only_where_depths_are_equal",
        ),
        Law(
            "Triangles that share an edge neither overlap nor leave a gap.",
            "visibility/test_depth_buffer.py::test_a_fan_of_triangles_has_neither_overlap_nor_gap",
        ),
        Law(
            "Drawing in bands of rows gives the same picture.",
            "visibility/test_depth_buffer.py::test_bands_of_rows_give_the_same_picture",
        ),
    ),
    not_laws=("Surfaces may shine through: a nearer one always hides what is behind it.",),
    questions=(2, 7),
    labs=("Hidden surfaces: depth buffer",),
    tie="Strictly nearer wins, so the first drawn stays",
    writes="image",
)
