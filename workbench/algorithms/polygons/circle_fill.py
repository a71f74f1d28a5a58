"""The circle filled by scan lines.

x, y    right end of the row's span, seen from the centre
"""

from collections.abc import Iterator

from workbench.algorithms.circles.midpoint_circle import ENTRY as OUTLINE
from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.polygons.round_views import CIRCLE_COLUMNS, CIRCLE_VIEWS, span_pixels


def reach(x: int, y: int) -> int:
    """What is less than r^2 where pixel (x, y), seen from the centre, is on the midpoint circle or within.

    The circle's midpoint test, squared out: (x - 1/2)^2 + y^2 or x^2 + (y - 1/2)^2, whichever is less, and
    without the quarter that no whole number sees.
    """
    return x * x + y * y - max(x, abs(y))


def circle_fill(xc: int, yc: int, r: int) -> Iterator[tuple[int, int, int]]:
    """Fill a circle row by row, each as far as the midpoint circle's pixels reach.

    Args: centre and radius (0 or more) in device pixels. Emits: (y, x_left, x_right), both ends included,
    bottom to top. Source: Hearn and Baker, Computer Graphics, C Version, sections 3-5 and 3-11.
    """
    # Start on the lowest row
    x = 0
    r2 = r * r

    for y in range(-r, r + 1):
        # Move the end of the span to where the outline is
        while reach(x + 1, y) < r2:
            x += 1
        while x > 0 and reach(x, y) >= r2:
            x -= 1

        # Fill the row
        yield yc + y, xc - x, xc + x


ENTRY = Entry(
    function=circle_fill,
    topic="polygons",
    title="Circle, filled",
    summary="Fills a circle row by row; the end of the span follows the outline from each row to the next.",
    parameters=OUTLINE.parameters,
    draws=("circle",),
    emits="spans",
    source="Hearn and Baker, Computer Graphics, C Version, sections 3-5 and 3-11",
    columns=CIRCLE_COLUMNS,
    views=CIRCLE_VIEWS,
    view_functions=(span_pixels,),
    laws=(
        Law(
            "The pixels are those of the midpoint circle and all that it encloses.",
            "polygons/test_round_areas.py::test_a_filled_circle_is_what_its_outline_encloses",
        ),
        Law(
            "There is one span for each row, bottom to top.",
            "polygons/test_round_areas.py::test_a_filled_circle_is_what_its_outline_encloses",
        ),
        Law(
            "Mirrored at the centre's row, column and diagonals it is the same.",
            "polygons/test_round_areas.py::test_a_filled_circle_is_the_same_in_all_its_mirrors",
        ),
    ),
    not_laws=("Every pixel's centre is within the circle: the outline takes some that are just outside.",),
    questions=(3,),
    labs=("Polygon fill",),
    next_rung="ellipse_fill",
)
