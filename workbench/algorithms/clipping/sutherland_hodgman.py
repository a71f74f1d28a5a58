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

from workbench.algorithms.clipping.edges import BOTTOM, LEFT, RIGHT, TOP, intersection, region_code
from workbench.algorithms.clipping.window import WINDOW
from workbench.algorithms.entry import Entry, Parameter


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
_FORK = np.array(
    [[38.0, 2.0], [-6.0, 4.0], [6.0, 8.0], [35.0, 9.0], [35.0, 11.0], [8.0, 12.0], [12.0, 24.0], [38.0, 18.0]]
)

ENTRY = Entry(
    function=sutherland_hodgman,
    topic="clipping",
    title="Sutherland-Hodgman",
    summary="Clips the whole polygon at one edge, hands the list of vertices on, and clips it at the next.",
    parameters=(Parameter("vertices", "P_i", "points", _FORK, meaning="the polygon"), *WINDOW),
    emits="points",
    source="Hearn and Baker, Computer Graphics, C Version, section 6-8",
)
