"""The ellipse filled by scan lines.

x, y            right end of the upper row's span, seen from the centre
rx2, ry2        squares of the two radii
"""

from collections.abc import Iterator

from workbench.algorithms.circles.midpoint_ellipse import ENTRY as OUTLINE
from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.polygons.round_views import ELLIPSE_COLUMNS, ELLIPSE_VIEWS, two_rows


def position(twice_x: int, twice_y: int, rx2: int, ry2: int) -> int:
    """The ellipse's function times 4 at half of (twice_x, twice_y): negative inside, positive outside."""
    return ry2 * twice_x * twice_x + rx2 * twice_y * twice_y - 4 * rx2 * ry2


def ellipse_fill(xc: int, yc: int, rx: int, ry: int) -> Iterator[tuple[int, int, int]]:
    """Fill an ellipse in pairs of rows, from the ends to the middle, each as far as the outline reaches.

    The outline is the midpoint ellipse: while it is flat (region 1) it goes along the row as long as the
    midpoint beyond is inside; where it is steep (region 2) the midpoint tells whether the next row is longer.

    Args: centre and radii (0 or more) in device pixels. Emits: (y, x_left, x_right), both ends included.
    Source: Hearn and Baker, Computer Graphics, C Version, sections 3-6 and 3-11.
    """
    # Start at the top
    x = 0
    rx2 = rx * rx
    ry2 = ry * ry

    for y in range(ry, -1, -1):
        # Go along the row to where the outline leaves it
        while ry2 * x < rx2 * y and position(2 * x + 2, 2 * y - 1, rx2, ry2) < 0:
            x += 1
        if y == 0:
            x = rx

        # Fill the row and its mirror image
        yield yc + y, xc - x, xc + x
        if y > 0:
            yield yc - y, xc - x, xc + x

        # Find where the outline enters the next row
        if ry2 * x < rx2 * y or position(2 * x + 1, 2 * y - 2, rx2, ry2) <= 0:
            x += 1


ENTRY = Entry(
    function=ellipse_fill,
    topic="polygons",
    title="Ellipse, filled",
    summary="Fills an ellipse in pairs of rows; the end of the span follows the outline from row to row.",
    parameters=OUTLINE.parameters,
    draws=("ellipse",),
    emits="spans",
    source="Hearn and Baker, Computer Graphics, C Version, sections 3-6 and 3-11",
    columns=ELLIPSE_COLUMNS,
    views=ELLIPSE_VIEWS,
    view_functions=(two_rows,),
    laws=(
        Law(
            "The pixels are those of the midpoint ellipse and all that it encloses.",
            "polygons/test_round_areas.py::test_a_filled_ellipse_is_what_its_outline_encloses",
        ),
        Law(
            "There is one span for each row.",
            "polygons/test_round_areas.py::test_a_filled_ellipse_is_what_its_outline_encloses",
        ),
        Law(
            "With equal radii the spans are those of the filled circle.",
            "polygons/test_round_areas.py::test_an_ellipse_of_equal_radii_is_filled_as_the_circle",
        ),
    ),
    not_laws=("Every pixel's centre is within the ellipse: the outline takes some that are just outside.",),
    questions=(3,),
    labs=("Polygon fill",),
)
