"""The scan-line polygon fill in whole numbers, between whole corners.

corners     the vertices, each on the nearest pixel
edges       the edge table: every edge with its rows, its first crossing and what x gains per row
active      the active edge table: the edges on the row and where they cross it, from left to right
waiting     number of the first edge that has not begun
x, counter  where an edge crosses the row: at x + counter / delta_y
winding     how the edges crossed so far on the row go round the point; 0 is outside
left        first pixel of the span that is open
covered     last pixel of the row up to the last crossing, that one's own under closed
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import DrawnBy, Entry, Law
from workbench.algorithms.polygons.exactness import is_whole
from workbench.algorithms.polygons.fill_views import VIEW_FUNCTIONS, fill_views, marks
from workbench.algorithms.polygons.integer_edges import (
    WholeEdge,
    crossing,
    drop_ended,
    first_pixel,
    last_pixel,
    sort_by_crossing,
    whole_corners,
    whole_edge_table,
)
from workbench.algorithms.polygons.parameters import CLOSED, NONZERO, POLYGON, polygon_and_rules
from workbench.algorithms.polygons.row_crossings import FAR_LEFT, rows_of
from workbench.algorithms.polygons.scan_line_words import COLUMNS


def scan_line_integer(
    vertices: NDArray[Any], ring_ends: NDArray[Any], closed: bool, nonzero: bool
) -> Iterator[tuple[int, int, int]]:
    """Fill a polygon of whole corners row by row; instead of 1/m a counter grows by the rest of its division.

    Where 1/m = step + rest/delta_y, a row further up x is step further, and one more whenever the counter,
    which grows by rest, has reached delta_y. Nothing is rounded, so nothing drifts.

    Args: vertices (n, 2) in pixels, within 2^20, each taken to the nearest pixel; ring_ends (m,): one past
    each ring's last vertex; closed or half_open; inside where the winding number is not zero or is odd
    (even_odd).
    Emits: (y, x_left, x_right), both ends included, bottom to top, left to right, each pixel once.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-11.
    """
    # Make the edge table
    corners = whole_corners(vertices)
    edges = whole_edge_table(corners, ring_ends, closed)
    active: list[WholeEdge] = []
    waiting = 0
    lowest, highest = rows_of(corners)

    for y in range(lowest, highest + 1):
        # Update the active edge table: x and counter
        drop_ended(active, y)
        for k in range(len(active)):
            edge = active[k]
            x = edge.x + edge.step
            counter = edge.counter + edge.rest
            if counter >= edge.delta_y:
                x += 1
                counter -= edge.delta_y
            active[k] = crossing(edge, x, counter)
        while waiting < len(edges) and edges[waiting].y_start == y:
            active.append(edges[waiting])
            waiting += 1
        sort_by_crossing(active)

        # Fill between each pair of crossings
        winding = left = 0
        covered = FAR_LEFT
        for edge in active:
            if winding == 0:
                left = max(first_pixel(edge), covered + 1)
            covered = max(covered, last_pixel(edge, closed))
            winding += edge.winding
            if not nonzero:
                winding %= 2
            if winding == 0 and left <= covered:
                yield y, left, covered


_AS_EXACT = Law(
    "Between whole corners the pixels are those of the exact crossings.",
    "polygons/test_scan_line_integer.py::test_between_whole_corners_pixels_are_those_of_exact_fractions",
)

ENTRY = Entry(
    function=scan_line_integer,
    topic="polygons",
    title="Scan-line fill in integers",
    summary="Keeps each crossing as a whole part and a counter over Δy: it only adds and compares.",
    parameters=(*POLYGON, CLOSED, NONZERO),
    arguments=polygon_and_rules,
    draws=("polygon",),
    drawn_by=DrawnBy("scan_line_exact", _AS_EXACT, is_whole),
    emits="spans",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    columns=COLUMNS,
    views=fill_views(
        "scan_line_integer",
        "whole_corners(vertices)",
        "Update the active edge table: x and counter",
        rounds=False,
    ),
    view_functions=VIEW_FUNCTIONS,
    laws=(
        _AS_EXACT,
        Law(
            "Corners that are not whole are taken to the nearest pixel.",
            "polygons/test_scan_line_integer.py::test_corners_go_to_the_nearest_pixel",
        ),
        Law(
            "Each pixel comes once, bottom to top and left to right.",
            "polygons/test_scan_line_integer.py::test_pixels_come_once_bottom_to_top_and_left_to_right",
        ),
    ),
    not_laws=("A polygon of any corners keeps its shape: half a pixel may be lost or won at each.",),
    questions=(3,),
    labs=("Polygon fill",),
    next_rung="scan_line_exact",
    marks=marks,
)
