"""The scan-line polygon fill.

edges       the edge table: every edge with the row it begins on, lowest first
active      the active edge table: the edges that cross row y, from left to right
waiting     number of the first edge that has not become active yet
winding     how the edges crossed so far on a row go round the point; 0 is outside
covered     last pixel of the row that has been filled or passed
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry
from workbench.algorithms.polygons.edges import Edge, crossing, edge_table
from workbench.algorithms.polygons.parameters import CLOSED, NONZERO, POLYGON


def put_in_order(active: list[Edge], place: int, edge: Edge) -> None:
    """Put an edge among the first ``place`` ones of the active list, moving up those that are right of it."""
    while place > 0 and (active[place - 1].left, active[place - 1].right) > (edge.left, edge.right):
        active[place] = active[place - 1]
        place -= 1
    active[place] = edge


def fill_row(y: int, active: list[Edge], nonzero: bool) -> Iterator[tuple[int, int, int]]:
    """Fill one row between the crossings that enter the interior and those that leave it."""
    winding = 0
    left = 0
    covered = active[0].left - 1 if len(active) > 0 else 0
    for edge in active:
        # Note where a span can begin
        if winding == 0:
            left = max(edge.left, covered + 1)
        covered = max(covered, edge.right)

        # Count the crossing
        if nonzero or winding == 0:
            winding += edge.winding
        elif edge.winding != 0:
            winding = 0

        # Fill the span that ends here
        if winding == 0 and left <= covered:
            yield y, left, covered


def scan_line_fill(
    vertices: NDArray[Any], ring_ends: NDArray[Any], closed: bool, nonzero: bool
) -> Iterator[tuple[int, int, int]]:
    """Fill a polygon row by row between its edges, whose crossings move by 1/m from row to row.

    A pixel belongs to it by its centre: half_open has y_low <= y < y_high and x_left <= x < x_right, so that
    polygons side by side neither overlap nor leave a gap; closed has all that is inside or on an edge.

    Args: vertices (n, 2), finite, in pixels, within 2^20; ring_ends (m,): one past each ring's last vertex;
    closed or half_open; interior where the winding number is not zero, or where it is odd (even_odd).
    Emits: (y, x_left, x_right), both ends included, bottom to top, left to right, each pixel once.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-11.
    """
    # Make the edge table
    edges = edge_table(vertices, ring_ends, closed)
    active = edges[:0]
    waiting = 0
    y = edges[0].y_start if len(edges) > 0 else 0

    while waiting < len(edges) or len(active) > 0:
        # Let in the edges that begin on this row
        while waiting < len(edges) and edges[waiting].y_start == y:
            active.append(edges[waiting])
            put_in_order(active, len(active) - 1, edges[waiting])
            waiting += 1

        # Fill between the crossings
        yield from fill_row(y, active, nonzero)

        # Go up a row: the edges that ended leave, the others step by 1/m
        y += 1
        kept = 0
        for edge in active:
            if edge.y_end >= y:
                put_in_order(active, kept, crossing(vertices, closed, edge, y, edge.x + edge.slope))
                kept += 1
        while len(active) > kept:
            active.pop()


ENTRY = Entry(
    function=scan_line_fill,
    topic="polygons",
    title="Scan-line polygon fill",
    summary="Fills row by row between the edges, whose crossings move by 1/m from one row to the next.",
    parameters=(*POLYGON, CLOSED, NONZERO),
    emits="spans",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    questions=(3,),
    labs=("Polygon fill",),
)
