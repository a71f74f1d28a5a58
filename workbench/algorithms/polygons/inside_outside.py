"""The inside-outside test of one point.

after           for each vertex, the number of the next one round its ring
crossings       how many edges the ray from the point to the right has crossed so far
winding         those that go up less those that go down: how often the polygon goes round the point
side            negative where the point is left of the edge, 0 where it is on the edge's line
on_boundary     whether the point is on an edge, which closed takes in
inside          the verdict of the rule asked for
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter
from workbench.algorithms.polygons.parameters import NONZERO, POLYGON, polygon_and_point
from workbench.algorithms.polygons.ray_marks import marks
from workbench.algorithms.polygons.ray_views import COLUMNS, VIEWS, end_points, nearest_pixel
from workbench.algorithms.polygons.row_crossings import corner, next_vertices
from workbench.geometry.orientation import side_of


def inside_outside(
    vertices: NDArray[Any], ring_ends: NDArray[Any], x: float, y: float, nonzero: bool
) -> Iterator[tuple[float, float, int]]:
    """Count the edges that a ray from the point to the right crosses: an odd number means inside (even_odd).

    An edge is crossed where y_low <= y < y_high, so a vertex counts once when the polygon goes on through its
    row, twice or not at all when it turns back: the vertex rule. Going up counts 1 and going down -1: where
    their sum, the winding number, is not zero, the point is inside by the other rule (nonzero).

    Args: vertices (n, 2), finite, in pixels; ring_ends (m,): one past each ring's last vertex; the point; by
    which rule to decide. Emits: (x, y, 1 or -1) of each crossing, edge by edge.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-11.
    """
    # Start at the point, with nothing crossed
    crossings = winding = 0
    on_boundary = False
    after = next_vertices(vertices, ring_ends)

    for k in range(len(after)):
        # Take the next edge, lower end first
        low, high, direction = k, after[k], 1
        if vertices[high, 1] < vertices[low, 1]:
            low, high, direction = high, low, -1
        x_low, y_low = corner(vertices, low)
        x_high, y_high = corner(vertices, high)

        # Does the ray cross it?
        side = side_of(x_low, y_low, x_high, y_high, x, y)
        crosses = y_low <= y < y_high and side < 0.0
        if crosses:
            crossings += 1
            winding += direction
            yield x_low + (y - y_low) / (y_high - y_low) * (x_high - x_low), y, direction
        if side == 0.0 and y_low <= y <= y_high and min(x_low, x_high) <= x <= max(x_low, x_high):
            on_boundary = True

    # Decide
    inside = winding != 0 if nonzero else crossings % 2 == 1


ENTRY = Entry(
    function=inside_outside,
    topic="polygons",
    title="Inside-outside test",
    summary="Sends a ray from a point to the right and counts the edges that it crosses.",
    parameters=(
        *POLYGON,
        Parameter("x", "x", "float", 4.0, unit="px", meaning="the point"),
        Parameter("y", "y", "float", 4.0, unit="px", meaning="the point"),
        NONZERO,
    ),
    arguments=polygon_and_point,
    emits="points",
    emitted_columns=("x", "y", "direction"),
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=(end_points, nearest_pixel),
    laws=(
        Law(
            "The verdict is that of the exact crossings, also beside vertices and edges, for both interiors.",
            "polygons/test_inside_outside.py::test_the_verdict_is_that_of_the_exact_crossings",
        ),
        Law(
            "It says of every pixel's centre what the scan-line fill under half_open does.",
            "polygons/test_inside_outside.py::test_it_says_of_every_centre_what_the_fill_does",
        ),
        Law(
            "Turning a ring round changes neither verdict.",
            "polygons/test_inside_outside.py::test_a_ring_turned_round_changes_no_verdict",
        ),
    ),
    not_laws=(
        "A point on an edge is inside: under half_open it depends on which side of the polygon that is.",
    ),
    questions=(3,),
    labs=("Polygon fill",),
    next_rung="scan_line_crossings",
    marks=marks,
)
