"""The scan-line polygon fill of the course, with edge table and active edge table.

edges       the edge table: every edge with its rows, its first crossing and 1/m, lowest first
active      the active edge table: the edges on the row and where they cross it, from left to right
waiting     number of the first edge that has not begun
winding     how the edges crossed so far on the row go round the point; 0 is outside
left        first pixel of the span that is open
covered     last pixel of the row up to the last crossing, that one's own under closed
"""

import math
from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import DrawnBy, Entry, Law
from workbench.algorithms.polygons.edge_table import Edge, at, drop_ended, edge_table, last_pixel
from workbench.algorithms.polygons.exactness import has_exact_slopes
from workbench.algorithms.polygons.fill_views import VIEW_FUNCTIONS, fill_views, marks
from workbench.algorithms.polygons.parameters import CLOSED, NONZERO, POLYGON, polygon_and_rules
from workbench.algorithms.polygons.row_crossings import FAR_LEFT, rows_of, sort_by_x
from workbench.algorithms.polygons.scan_line_words import COLUMNS


def scan_line_fill(
    vertices: NDArray[Any], ring_ends: NDArray[Any], closed: bool, nonzero: bool
) -> Iterator[tuple[int, int, int]]:
    """Fill a polygon row by row between the edges of an active edge table, whose x grow by 1/m a row.

    A pixel belongs to it by its centre, as far as 1/m, added up, tells: half_open has x_left <= x < x_right
    and no upper ends; closed has all that is inside or on an edge.

    Args: vertices (n, 2) in pixels, within 2^20; ring_ends (m,): one past each ring's last vertex; closed or
    half_open; inside where the winding number is not zero or is odd (even_odd).
    Emits: (y, x_left, x_right), both ends included, bottom to top, left to right, each pixel once.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-11.
    """
    # Make the edge table
    edges = edge_table(vertices, ring_ends, closed)
    active: list[Edge] = []
    waiting = 0
    lowest, highest = rows_of(vertices)

    for y in range(lowest, highest + 1):
        # Update the active edge table: x += 1/m
        drop_ended(active, y)
        for k in range(len(active)):
            active[k] = at(active[k], active[k].x + active[k].slope)
        while waiting < len(edges) and edges[waiting].y_start == y:
            active.append(edges[waiting])
            waiting += 1
        sort_by_x(active)

        # Fill between each pair of crossings
        winding = left = 0
        covered = FAR_LEFT
        for edge in active:
            if winding == 0:
                left = max(math.ceil(edge.x), covered + 1)
            covered = max(covered, last_pixel(edge, closed))
            winding += edge.winding
            if not nonzero:
                winding %= 2
            if winding == 0 and left <= covered:
                yield y, left, covered


_AS_EXACT = Law(
    "Between vertices on whole pixels or quarters, within 2¹⁴, whose edges all have a 1/m that floats hold "
    "(a multiple of 1/65536), the pixels are those of the exact crossings.",
    "polygons/test_scan_line_fill.py::test_where_floats_hold_each_slope_pixels_are_those_of_exact_fractions",
)

ENTRY = Entry(
    function=scan_line_fill,
    topic="polygons",
    title="Scan-line polygon fill",
    summary="Keeps an edge table and an active edge table; x of each edge grows by 1/m from row to row.",
    parameters=(*POLYGON, CLOSED, NONZERO),
    arguments=polygon_and_rules,
    draws=("polygon",),
    drawn_by=DrawnBy("scan_line_exact", _AS_EXACT, has_exact_slopes),
    emits="spans",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    columns=COLUMNS,
    views=fill_views("scan_line_fill", "vertices", "Update the active edge table: x += 1/m", rounds=True),
    view_functions=VIEW_FUNCTIONS,
    laws=(
        _AS_EXACT,
        Law(
            "Each pixel comes once, bottom to top and left to right.",
            "polygons/test_scan_line_fill.py::test_pixels_come_once_bottom_to_top_and_left_to_right",
        ),
        Law(
            "A vertex counts twice where the polygon turns back and once where it goes on.",
            "polygons/test_scan_line_fill.py::test_a_vertex_counts_once_or_twice",
        ),
    ),
    not_laws=(
        "The pixels are those of the exact crossings: 1/m is rounded, and added up it drifts. 1 and three "
        "times 1/3 are less than 2, so that many triangles of whole corners lose a pixel under closed.",
    ),
    questions=(3,),
    labs=("Polygon fill",),
    next_rung="scan_line_integer",
    marks=marks,
)
