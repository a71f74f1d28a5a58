"""The scan-line method for surfaces: row by row, from edge to edge, the nearest open surface is painted.

surfaces    the polygon table: corners, plane and how z changes, of each surface
edges       the edge table: first row and last, ends, and whose each edge is
waiting     the first edge that has not begun yet
active      the edges that cross the scan line, from left to right
flags       of each surface whether the scan line is in it
opened      the surfaces whose flag is on
x_left, end the first pixel of a span and one past its last
seen        the surface that the span shows
"""

import math
from collections.abc import Iterator

from workbench.algorithms.counted import Kept
from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.visibility.surface_edges import (
    Active,
    change_over,
    cross,
    edge_table,
    nearest_of,
)
from workbench.algorithms.visibility.surface_marks import marks
from workbench.algorithms.visibility.surface_row_views import COLUMNS, VIEW_FUNCTIONS, VIEWS
from workbench.algorithms.visibility.surface_scene import SURFACES, surfaces_at_will
from workbench.algorithms.visibility.surfaces import Colours, Picture, Triangles, Vertices, surfaces_of


def scan_line_surfaces(
    image: Picture, vertices: Vertices, faces: Triangles, colours: Colours
) -> Iterator[tuple[int, int, int, int]]:
    """Paint each scan line from edge to edge with the nearest open surface.

    It presumes that no surface pierces another: one comparison decides a span.

    Args: image, integers (h, w), written in place; vertices (n, 3) in pixels,
    z; faces (m, 3); colours (m,). Emits: (y, x_left, x_right, surface).
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-5.
    """
    # Make the polygon table and the edge table
    height, width = image.shape
    surfaces = surfaces_of(vertices, faces)
    edges = edge_table(surfaces)
    active = [Active(0.0, 0, 0) for _edge in edges[:0]]
    flags = [False for _surface in surfaces]
    waiting = 0

    for y in range(height):
        # Let edges end and begin, and put their crossings in order
        waiting = change_over(active, edges, waiting, y)
        cross(active, edges, y)
        opened = [edge.surface for edge in active[:0]]

        for k in range(len(active)):
            # Turn the flag of the surface whose edge this is
            number = active[k].surface
            flags[number] = not flags[number]
            if flags[number]:
                opened.append(number)
            else:
                opened.remove(number)
            if not opened:
                continue

            # Find the pixels up to the next edge
            x_left = max(math.ceil(active[k].x), 0)
            end = min(math.ceil(active[k + 1].x), width)
            if x_left >= end:
                continue

            # Paint them with the nearest of the open surfaces
            seen = nearest_of(surfaces, opened, (x_left + end - 1) / 2, y)
            image[y, x_left:end] = int(colours[seen])
            yield y, x_left, end - 1, seen


ENTRY = Entry(
    function=scan_line_surfaces,
    topic="visibility",
    title="Scan-line method",
    summary="Goes along each scan line from edge to edge; of the surfaces whose flags are on the nearest is "
    "painted.",
    parameters=SURFACES,
    arguments=surfaces_at_will,
    emits="spans",
    emitted_columns=("y", "x_left", "x_right", "surface"),
    source="Hearn and Baker, Computer Graphics, C Version, section 13-5",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        Law(
            "Where no surface pierces another the picture is that of the depth buffer.",
            "visibility/test_one_picture.py::test_the_scan_line_gives_it_where_no_surface_pierces_another",
        ),
    ),
    not_laws=(
        "It holds where surfaces pierce one another: between two edges one surface is nearest all along only "
        "if none changes places there; else a line must be put in where they meet.",
    ),
    works_in="image space",
    questions=(7,),
    labs=("Hidden surfaces: scan-line method",),
    tie="Of equal depths the lower number is taken",
    writes="image",
    keeps={"edges": Kept("edge", "3 * len(faces)")},
    fails_where="surfaces pierce, since one comparison decides all pixels from an edge to the next",
    marks=marks,
)
