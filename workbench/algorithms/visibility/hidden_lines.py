"""Hidden lines: each edge is clipped by every surface that lies before it; what is left is drawn.

corners     the corners on the device
edge        number of the edge in hand; start and end are its ends
seen        the parts of it that nothing has hidden yet, t = 0 at its start, 1 at its end
number      the surface that it is compared with
behind      the part that is farther than the surface's plane
hidden      of that, the part that the three sides of the surface enclose
"""

from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter
from workbench.algorithms.visibility.device_plane import Corner
from workbench.algorithms.visibility.edge_parts import (
    Part,
    apart,
    ends_of,
    part_behind,
    part_inside,
    place_at,
    without,
)
from workbench.algorithms.visibility.hidden_line_views import COLUMNS, VIEW_FUNCTIONS, VIEWS, marks
from workbench.algorithms.visibility.pieces import plane_of
from workbench.algorithms.visibility.scene import SCENE
from workbench.algorithms.visibility.surface_scene import surfaces_at_will
from workbench.algorithms.visibility.surfaces import Triangles, Vertices, in_view, surfaces_of

Edges = NDArray[Any]
"""(e, 2): numbers of vertices."""


def hidden_lines(
    vertices: Vertices, faces: Triangles, edges: Edges
) -> Iterator[tuple[float, float, float, float, int]]:
    """Draw a wireframe without the lines that surfaces hide.

    Args: vertices (n, 3): x and y in pixels, z; faces (m, 3) and edges
    (e, 2): numbers of vertices. Emits: (x0, y0, x1, y1, edge) of each
    part of an edge that is seen.
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-12.
    """
    surfaces = surfaces_of(vertices, faces)
    numbers = in_view(surfaces)
    corners = [Corner(float(p[0]), float(p[1]), float(p[2])) for p in vertices]

    for edge in range(len(edges)):
        # Take an edge, all of it seen so far
        start, end = ends_of(corners, edges[edge, 0], edges[edge, 1])
        seen = [Part(0.0, 1.0)]

        for number in numbers:
            if apart(surfaces[number], start, end):
                continue
            # Find the part that is behind the plane of the surface
            behind = part_behind(plane_of(surfaces, number), start, end)
            if behind.begin >= behind.end:
                continue
            # Clip it to the sides of the surface: that is hidden
            hidden = part_inside(surfaces[number], start, end, behind)
            if hidden.begin >= hidden.end:
                continue
            # Take the hidden part out of what is seen
            seen = without(seen, hidden)
            if not seen:
                break

        for part in seen:
            # Draw a part that is seen
            a, b = place_at(start, end, part.begin), place_at(start, end, part.end)
            yield a.x, a.y, b.x, b.y, edge


def edges_of_triangles(faces: Triangles) -> Edges:
    """The edges (e, 2) of triangles (m, 3), each once."""
    pairs = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    return np.unique(np.sort(pairs, axis=1), axis=0)


def edges_at_will(chance: Random) -> tuple[Any, ...]:
    """Surfaces as the other methods get them, and all their edges."""
    _image, vertices, faces, _colours = surfaces_at_will(chance)
    return vertices, faces, edges_of_triangles(faces)


_EXAMPLE = {parameter.name: parameter for parameter in SCENE}

ENTRY = Entry(
    function=hidden_lines,
    topic="visibility",
    title="Hidden lines",
    summary="Clips each edge by every surface before it; the parts that are left make a wireframe "
    "without hidden lines.",
    parameters=(
        _EXAMPLE["vertices"],
        _EXAMPLE["faces"],
        Parameter(
            "edges",
            "edges",
            "ints",
            edges_of_triangles(_EXAMPLE["faces"].example),
            meaning="both ends of each edge",
        ),
    ),
    arguments=edges_at_will,
    emits="segments",
    emitted_columns=("x0", "y0", "x1", "y1", "edge"),
    source="Hearn and Baker, Computer Graphics, C Version, section 13-12; Roberts, Machine Perception of "
    "Three-Dimensional Solids, 1963",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        Law(
            "A point of an edge is drawn where a ray to it meets no surface before it, also where surfaces "
            "pierce one another.",
            "visibility/test_hidden_lines.py::test_a_point_of_an_edge_is_drawn_where_no_ray_is_stopped",
        ),
        Law(
            "The order of the surfaces does not matter.",
            "visibility/test_hidden_lines.py::test_the_order_of_surfaces_does_not_matter",
        ),
    ),
    not_laws=(
        "Where two surfaces pierce one another a line is drawn: only edges are, and none runs there.",
        "An edge is seen whole or not at all: a surface may hide its middle and leave both ends visible.",
    ),
    works_in="object space",
    questions=(7,),
    labs=("Hidden lines",),
    tie="What lies in a surface's plane is seen; what runs exactly behind its side is hidden",
    marks=marks,
)
