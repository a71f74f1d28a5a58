"""The scan-line polygon fill as it is first explained: every row is crossed with every edge anew.

edges       the edges that count on a row: both ends of each, its first and last row, and the way it goes
crossings   what of the edges is on the row: from x to x_end, and the way it goes; 0 lies along it
winding     how the edges crossed so far go round the point; 0 is outside
left        first pixel of the span that is open
covered     last pixel of the row up to the last crossing, that one's own under closed
"""

import math
from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import DrawnBy, Entry, Law
from workbench.algorithms.polygons.crossing_views import VIEW_FUNCTIONS, VIEWS, marks
from workbench.algorithms.polygons.exactness import is_on_quarters
from workbench.algorithms.polygons.parameters import CLOSED, NONZERO, POLYGON, polygon_and_rules
from workbench.algorithms.polygons.row_crossings import (
    FAR_LEFT,
    Crossing,
    corner,
    last_pixel,
    rows_of,
    sort_by_x,
)
from workbench.algorithms.polygons.scan_line_words import COLUMNS
from workbench.algorithms.polygons.sides import sides


def scan_line_crossings(
    vertices: NDArray[Any], ring_ends: NDArray[Any], closed: bool, nonzero: bool
) -> Iterator[tuple[int, int, int]]:
    """Fill a polygon row by row: find all crossings with its edges, sort them, fill between pairs of them.

    A pixel belongs to it by its centre: half_open has y_low <= y < y_high and x_left <= x < x_right; closed
    has all that is inside or on an edge. A vertex where the polygon turns back counts twice, one where it
    goes on counts once: an edge ends a row earlier where the next goes on upwards, under half_open always.

    Args: vertices (n, 2) in pixels, within 2^20; ring_ends (m,): one past each ring's last vertex; closed or
    half_open; inside where the winding number is not zero or is odd (even_odd).
    Emits: (y, x_left, x_right), both ends included, bottom to top, left to right, each pixel once.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-11.
    """
    # Find the lowest and the highest row
    lowest, highest = rows_of(vertices)
    edges = sides(vertices, ring_ends, closed)

    for y in range(lowest, highest + 1):
        # Find all crossings of the row with the edges
        crossings: list[Crossing] = []
        for edge in edges:
            if edge.y_start <= y <= edge.y_end:
                x0, y0 = corner(vertices, edge.low)
                x1, y1 = corner(vertices, edge.high)
                if y0 == y1:
                    crossings.append(Crossing(min(x0, x1), max(x0, x1), 0))
                else:
                    x = x0 + (y - y0) * (x1 - x0) / (y1 - y0)
                    crossings.append(Crossing(x, x, edge.winding))

        # Sort the crossings from left to right
        sort_by_x(crossings)

        # Fill between each pair of crossings
        winding = left = 0
        covered = FAR_LEFT
        for crossing in crossings:
            if winding == 0:
                left = max(math.ceil(crossing.x), covered + 1)
            covered = max(covered, last_pixel(crossing, closed))
            winding += crossing.winding
            if not nonzero:
                winding %= 2
            if winding == 0 and left <= covered:
                yield y, left, covered


_AS_EXACT = Law(
    "Between vertices on whole pixels or quarters, within 2¹⁴, each crossing decides as the exact one does.",
    "polygons/test_scan_line_crossings.py::test_on_quarters_pixels_are_those_of_exact_fractions",
)

ENTRY = Entry(
    function=scan_line_crossings,
    topic="polygons",
    title="Scan-line fill by crossings",
    summary="Finds where each row crosses the edges, sorts the crossings, and fills between pairs of them.",
    parameters=(*POLYGON, CLOSED, NONZERO),
    arguments=polygon_and_rules,
    draws=("polygon",),
    drawn_by=DrawnBy("scan_line_exact", _AS_EXACT, is_on_quarters),
    emits="spans",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        _AS_EXACT,
        Law(
            "Each pixel comes once, bottom to top and left to right.",
            "polygons/test_scan_line_crossings.py::test_pixels_come_once_bottom_to_top_and_left_to_right",
        ),
        Law(
            "A vertex counts twice where the polygon turns back and once where it goes on.",
            "polygons/test_scan_line_crossings.py::test_a_vertex_counts_as_on_the_other_rungs",
        ),
    ),
    not_laws=(
        "Its work grows as the edges alone: each row asks every edge, also those that it does not meet.",
        "The crossings are exact: the quotient is rounded, and beside a pixel's centre that may decide it.",
    ),
    questions=(3,),
    labs=("Polygon fill",),
    next_rung="scan_line_fill",
    marks=marks,
)
