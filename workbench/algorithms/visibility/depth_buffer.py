"""The depth buffer, for triangles.

image, depth    the frame buffer and the depth buffer: colour and least z of each pixel so far
low, middle, high   corners of the triangle, by their rows
A, B, C, D      its plane Ax + By + Cz + D = 0 in device coordinates: pixels, pixels, z
dz_dx, dz_dy    change of z from a pixel to the next one: -A/C along a scan line, -B/C across
z, stored       depth of the triangle at this pixel, and what the depth buffer had there
won             1 where the triangle is strictly nearer, else 0
"""

import math
from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.beside import Beside
from workbench.algorithms.counted import Kept
from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.visibility import depth_front_first
from workbench.algorithms.visibility.depth_front_first import depth_buffer_front_first
from workbench.algorithms.visibility.depth_marks import marks
from workbench.algorithms.visibility.depth_tiles import EXAMPLE, depth_buffer_tiles
from workbench.algorithms.visibility.device_plane import corners_of, plane, row_ends
from workbench.algorithms.visibility.scene import SCENE, scene
from workbench.algorithms.visibility.views import VIEW_FUNCTIONS, VIEWS
from workbench.algorithms.visibility.whole_scene import (
    COLOURS_EXAMPLE,
    PLACES_EXAMPLE,
    face_colours,
    places_on_device,
)

Array = NDArray[Any]


def depth_buffer(
    image: Array, depth: Array, vertices: Array, faces: Array, colours: Array
) -> Iterator[tuple[int, int, float, int]]:
    """Draw triangles in any order; at each pixel the nearest one wins.

    A pixel is covered when y_low <= y < y_high and x_left <= x < x_right
    for its centre, so triangles that share an edge neither overlap nor
    leave a gap. On equal depths the first one stays.

    Args: image, integers, and depth, floats, both (h, w), written in place,
    depth beginning at the farthest z; vertices (n, 3), finite: x and y in
    pixels, z; faces (m, 3): numbers of vertices; colours (m,).
    Emits: (x, y, z, won).
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-3.
    """
    height, width = image.shape
    for face in range(len(faces)):
        # Find the plane Ax + By + Cz + D = 0 of the surface
        low, middle, high = corners_of(vertices, faces, face)
        A, B, C, D = plane(low, middle, high)
        if C == 0.0:
            continue
        dz_dx, dz_dy = -A / C, -B / C
        surface_colour = int(colours[face])

        for y in range(max(math.ceil(low.y), 0), min(math.ceil(high.y), height)):
            # Find where the scan line enters and leaves the surface
            x_left, x_right = row_ends(low, middle, high, y)
            z_row = low.z + (y - low.y) * dz_dy

            for x in range(max(math.ceil(x_left), 0), min(math.ceil(x_right), width)):
                # Find the depth of the surface, and the depth stored so far
                z = z_row + (x - low.x) * dz_dx
                stored = float(depth[y, x])

                # Keep the nearer one
                won = 0
                if z < depth[y, x]:
                    depth[y, x] = z
                    image[y, x] = surface_colour
                    won = 1
                yield x, y, z, won


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
    view_functions=VIEW_FUNCTIONS,
    marks=marks,
    beside=(
        Beside(depth_buffer_tiles, EXAMPLE),
        Beside(depth_buffer_front_first, depth_front_first.EXAMPLE),
        Beside(places_on_device, PLACES_EXAMPLE),
        Beside(face_colours, COLOURS_EXAMPLE),
    ),
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
            "visibility/test_depth_buffer.py::test_each_pixel_of_a_mesh_is_painted_once",
        ),
        Law(
            "Along a scan line z changes by −A/C from pixel to pixel, and up an edge by −(A/m + B)/C.",
            "visibility/test_device_plane.py::test_z_changes_along_a_scan_line_and_up_an_edge_as_the_plane_says",
        ),
        Law(
            "Whole pictures are drawn tile by tile and in bands of rows, each pixel and depth the same.",
            "rendering/test_triangles.py::test_in_bands_the_picture_is_that_of_the_text",
        ),
        Law(
            "Fine meshes are drawn front faces first, each pixel and depth the same.",
            "rendering/test_triangles.py::test_front_faces_first_the_picture_is_that_of_the_text",
        ),
    ),
    not_laws=(
        "Surfaces may shine through: a nearer one always hides what is behind it.",
        "z is the distance from the eye: in perspective it is a number that grows with that distance, "
        "and that is linear on the screen.",
    ),
    works_in="image space",
    questions=(2, 7),
    labs=("Hidden surfaces: depth buffer",),
    tie="Strictly nearer wins, so the first drawn stays",
    writes="image",
    keeps={"depths": Kept("depth", "depth.size")},
)
