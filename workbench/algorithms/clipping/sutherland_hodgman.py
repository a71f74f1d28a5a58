"""Sutherland and Hodgman's polygon clipping.

polygon         the vertices that the stage takes, in order
clipped         the vertices that it hands on
edge            the edge of this stage, as its bit in a region code: left, right, bottom, top in turn
i               number of the vertex at which the side ends; side 0 comes from the last vertex
x0, y0, x1, y1  the side, from one vertex to the next
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.clipping.cutting import (
    INTERSECTION_VIEWS,
    INTERSECTIONS,
    edge_name,
    edge_symbol,
    met,
    others,
    output,
    pixels,
)
from workbench.algorithms.clipping.edges import BOTTOM, LEFT, RIGHT, TOP, intersection, region_code
from workbench.algorithms.clipping.sutherland_hodgman_marks import marks
from workbench.algorithms.clipping.window import WINDOW, polygon_and_window
from workbench.algorithms.entry import Entry, Law, Parameter, View


def sutherland_hodgman(
    vertices: NDArray[Any], xmin: float, ymin: float, xmax: float, ymax: float
) -> Iterator[tuple[float, float]]:
    """Emit the vertices of a polygon clipped to the window, one edge after the other.

    Args: (n, 2) vertices of one ring and the window, in device coordinates. Emits: (x, y) of each vertex
    in order, or nothing. Source: Hearn and Baker, Computer Graphics, C Version, section 6-8.
    """
    # Take the whole polygon
    polygon = [(float(vertex[0]), float(vertex[1])) for vertex in vertices]

    for edge in (LEFT, RIGHT, BOTTOM, TOP):
        # Begin an empty list for this edge
        clipped = polygon[:0]

        for i in range(len(polygon)):
            # Clip the side that ends at this vertex
            x0, y0 = polygon[i - 1]
            x1, y1 = polygon[i]
            from_inside = region_code(x0, y0, xmin, ymin, xmax, ymax) & edge == 0
            to_inside = region_code(x1, y1, xmin, ymin, xmax, ymax) & edge == 0
            if from_inside and to_inside:
                clipped.append((x1, y1))
            elif from_inside:
                clipped.append(intersection(x0, y0, x1, y1, edge, xmin, ymin, xmax, ymax))
            elif to_inside:
                clipped.append(intersection(x0, y0, x1, y1, edge, xmin, ymin, xmax, ymax))
                clipped.append((x1, y1))

        # Hand the list on to the next edge
        polygon = clipped

    # Emit the vertices that are left
    for vertex in polygon:
        yield vertex[0], vertex[1]


# A fork whose handle lies right of the window, so that its prongs come apart there
_FORK = np.array([[38.0, 2], [-6, 4], [6, 8], [35, 9], [35, 11], [8, 12], [12, 24], [38, 18]])

_SIDE = "Clip the side that ends at this vertex"
_MET = "met((polygon[i - 1], polygon[i]), edge, (xmin, ymin, xmax, ymax))"
_NEW = "clipped[len(before.clipped):]"
_OPTIONS = "('in → in', 'in → out', 'out → in', 'out → out')"


def _side_view(when: str, case: str, sentence: str) -> View:
    """The view of one of the four cases."""
    return View(
        block=_SIDE,
        when=when,
        candidates=_MET,
        chosen=f"pixels({_NEW})",
        rejected=f"others({_MET}, pixels({_NEW}))",
        row=f"(edge_name(edge), (x0, y0), (x1, y1), {case!r}, output({_NEW}))",
        tables={"Vertices taken": ("polygon", ("x", "y")), "Vertices handed on": ("clipped", ("x", "y"))},
        options=_OPTIONS,
        answer=repr(case),
        sentence=f"{{edge_symbol(edge)}}: {{(x0, y0)}} to {{(x1, y1)}} {sentence}",
    )


ENTRY = Entry(
    function=sutherland_hodgman,
    topic="clipping",
    title="Sutherland-Hodgman",
    summary="Clips the whole polygon at one edge, hands the list of vertices on, and clips it at the next.",
    parameters=(Parameter("vertices", "P_i", "points", _FORK, meaning="the polygon"), *WINDOW),
    arguments=polygon_and_window,
    clips=("polygon",),
    emits="points",
    source="Hearn and Baker, Computer Graphics, C Version, section 6-8",
    columns=("edge", "from", "to", "case", "output"),
    view_functions=(edge_name, edge_symbol, met, others, output, pixels),
    views=(
        View(
            block="Take the whole polygon",
            sentence="The polygon has {len(polygon)} vertices; it is clipped left, right, bottom and top.",
        ),
        _side_view("from_inside and to_inside", "in → in", "stays inside: hand on its end."),
        _side_view("from_inside", "in → out", "goes out: hand on the intersection, {clipped[-1]}."),
        _side_view(
            "to_inside", "out → in", "comes in: hand on the intersection, {clipped[-2]}, and its end."
        ),
        _side_view("True", "out → out", "stays outside: hand on nothing."),
        *INTERSECTION_VIEWS,
        View(
            block="Hand the list on to the next edge",
            sentence="After this edge {len(polygon)} vertices are left.",
        ),
        View(
            block="Emit the vertices that are left",
            when="not polygon",
            sentence="All four edges are done, and nothing is left.",
        ),
        View(
            block="Emit the vertices that are left",
            sentence="All four edges are done: {len(polygon)} vertices are left.",
        ),
    ),
    laws=(
        Law(
            "Every vertex lies in the window, to the last digit; clipped again, the polygon stays as it is.",
            "clipping/test_polygons.py::test_every_vertex_lies_in_the_window_and_clipping_again_changes_nothing",
        ),
        Law(
            "Of a convex polygon exactly what lies in the window is left.",
            "clipping/test_polygons.py::test_of_a_convex_polygon_exactly_what_lies_in_the_window_is_left",
        ),
        Law(
            "The polygon goes round each point in the window as often as before.",
            "clipping/test_polygons.py::test_each_point_in_the_window_is_gone_round_as_often_as_before",
        ),
        Law(
            "The area of a polygon that does not cross itself is left, as far as it is in the window.",
            "clipping/test_polygons.py::test_the_area_in_the_window_is_left",
        ),
        Law(
            "Vertices inside the window stay, in order.",
            "clipping/test_polygons.py::test_vertices_inside_stay_in_order",
        ),
    ),
    not_laws=(
        "A concave polygon that falls apart gives several polygons: it gives one, whose parts hang together "
        "by edges that run back over each other along the window's boundary.",
    ),
    labs=("Clipping: Sutherland-Hodgman",),
    marks=marks,
    counted=INTERSECTIONS,
)
