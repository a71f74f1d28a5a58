"""The scan-line polygon fill.

edges       the edge table: every edge with the row that it begins on, lowest first
active      the active edge table: the edges on the row and where they cross it, from left to right
waiting     number of the first edge that has not begun
until       the next row on which an edge begins or ends
winding     how the edges crossed so far on the row go round the point; 0 is outside
left        first pixel of the span that is open
covered     last pixel of the row up to the last crossing, that one's own under closed
whole       whether 1/m can be added up as it is, since crossings are on a pixel or well beside it
slack       how far from a pixel's centre a crossing is still on it
reach       slack, or less it: a span ends with the pixel that its last crossing is on, or before it
"""

import math
from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.polygons.active_edges import (
    Crossing,
    change_over,
    end_of_level,
    next_change,
    put_in_order,
    settle,
)
from workbench.algorithms.polygons.edges import NUDGE, SLACK, all_whole, edge_table
from workbench.algorithms.polygons.grid_fill import fill_on_grid
from workbench.algorithms.polygons.parameters import CLOSED, NONZERO, POLYGON, polygon_and_rules
from workbench.algorithms.polygons.scan_line_marks import marks
from workbench.algorithms.polygons.scan_line_views import VIEW_FUNCTIONS, VIEWS
from workbench.algorithms.polygons.scan_line_words import COLUMNS

FAR_LEFT = -(1 << 40)


def scan_line_exact(
    vertices: NDArray[Any], ring_ends: NDArray[Any], closed: bool, nonzero: bool
) -> Iterator[tuple[int, int, int]]:
    """Fill a polygon row by row between its edges, whose crossings move by 1/m from row to row.

    A pixel belongs to it by its centre: half_open has y_low <= y < y_high and x_left <= x < x_right, so that
    polygons side by side neither overlap nor leave a gap; closed has all that is inside or on an edge.

    Args: vertices (n, 2) in pixels, within 2^20 (and 0, or not below 1e-60); ring_ends (m,): one past each
    ring's last vertex; closed or half_open; inside where the winding number is not zero or is odd (even_odd).
    Emits: (y, x_left, x_right), both ends included, bottom to top, left to right, each pixel once.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-11.
    """
    # Make the edge table
    edges = edge_table(vertices, ring_ends, closed)
    active = [Crossing(0.0, 0.0, 0, 0, 0) for _edge in edges[:0]]
    whole = all_whole(vertices)
    slack = SLACK if whole else NUDGE / 2
    reach = slack if closed else -slack
    waiting = until = 0

    while waiting < len(edges) or len(active) > 0:
        # Drop the edges that have ended and let in those that begin
        y = until if len(active) > 0 else edges[waiting].y_start
        waiting = change_over(active, edges, waiting, y)
        until = next_change(active, edges, waiting, y)

        for row in range(y, until):
            # Fill between the crossings
            winding = left = 0
            covered = FAR_LEFT
            for k in range(len(active)):
                crossing = active[k]
                first = math.ceil(crossing.x - slack)
                if winding == 0:
                    left = max(first, covered + 1)
                if crossing.slope == math.inf:
                    covered = max(covered, end_of_level(vertices, edges[crossing.edge]))
                else:
                    covered = max(covered, math.floor(crossing.x + reach))
                if nonzero or winding == 0:
                    winding += crossing.winding
                elif crossing.winding != 0:
                    winding = 0
                if winding == 0 and left <= covered:
                    yield row, left, covered

            # Move each crossing by 1/m to the next row
            farthest = -math.inf
            for k in range(len(active)):
                crossing = active[k]
                x = crossing.x + crossing.slope
                moved = Crossing(x, crossing.slope, crossing.winding, crossing.y_top, crossing.edge)
                if x < farthest:
                    put_in_order(active, k, moved)
                else:
                    active[k] = moved
                    farthest = x
            if not whole:
                settle(active, edges, vertices, row + 1)


ENTRY = Entry(
    function=scan_line_exact,
    topic="polygons",
    title="Scan-line fill, exact",
    summary="Adds up 1/m as the course does, and puts x right wherever its rounding could decide a pixel.",
    parameters=(*POLYGON, CLOSED, NONZERO),
    arguments=polygon_and_rules,
    draws=("polygon",),
    painter=fill_on_grid,
    emits="spans",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        Law(
            "Under closed it fills each pixel whose centre is inside or on an edge; under half_open "
            "each one that is inside, or would be if it lay a trifle further right and, by less still, "
            "further up.",
            "polygons/test_scan_line_exact.py::test_pixels_are_those_whose_centre_belongs_to_it_by_exact_fractions",
        ),
        Law(
            "Polygons side by side fill each pixel once under half_open, with no gap.",
            "polygons/test_scan_line_exact.py::test_triangles_side_by_side_fill_each_pixel_once_and_leave_no_gap",
        ),
        Law(
            "Each pixel comes once, bottom to top and left to right.",
            "polygons/test_scan_line_exact.py::test_pixels_come_once_bottom_to_top_and_left_to_right",
        ),
        Law(
            "Shifted by whole pixels it is the same.",
            "polygons/test_scan_line_exact.py::test_shifted_by_whole_pixels_it_is_the_same",
        ),
        Law(
            "Mirrored it is the same under closed.",
            "polygons/test_scan_line_exact.py::test_mirrored_it_is_the_same_under_closed",
        ),
        Law(
            "The pixels are those of exact crossings, for any vertices within 2²⁰: 1/m's error never "
            "decides.",
            "polygons/test_scan_line_exact.py::test_far_vertices_have_their_exact_crossings",
        ),
        Law(
            "Pictures are painted with crossings in whole numbers, on a grid of 1/4096 px: the same pixels.",
            "polygons/test_grid_fill.py::test_it_paints_the_pixels_of_the_text",
        ),
    ),
    not_laws=(
        "Mirrored it is the same under half_open: left and lower edges are in, right and upper ones out.",
        "The crossings are exact: x, added up by 1/m, is rounded, and put right only where it decides.",
    ),
    questions=(3,),
    labs=("Polygon fill",),
    next_rung="circle_fill",
    marks=marks,
)
