"""The midpoint ellipse.

x, y                point of the quarter from the top to the right, seen from the centre
rx2, ry2            squares of the two radii
px, py              2 ry2 x and 2 rx2 y; where px reaches py the slope is -1 and region 2 begins
k                   number of the step of region 2, from 0
p                   decision parameter: the ellipse's function at the midpoint, in quarters, never rounded
"""

from collections.abc import Iterator

from workbench.algorithms.circles.ellipse_views import COLUMNS, PARAMETERS, VIEWS
from workbench.algorithms.entry import Entry, Law


def four_points(xc: int, yc: int, x: int, y: int) -> Iterator[tuple[int, int]]:
    """Emit the mirror images of (x, y) about the centre, each pixel once."""
    # Drop the duplicates on the axes
    half_turn = x > 0 or y > 0
    reflections = x > 0 and y > 0

    # Plot the point and its mirror images
    yield xc + x, yc + y
    if half_turn:
        yield xc - x, yc - y
    if reflections:
        yield xc - x, yc + y
        yield xc + x, yc - y


def midpoint_ellipse(xc: int, yc: int, rx: int, ry: int) -> Iterator[tuple[int, int]]:
    """Emit an ellipse, walking a quarter of it, in columns while it is flat and in rows where it is steep.

    Args: centre and radii (0 or more) in device pixels. Emits: (x, y), each pixel once. A radius of 0 gives a
    segment, and a very flat ellipse ends in one.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-6; there p is rounded to a whole number.
    """
    # Set up the constants
    rx2 = rx * rx
    ry2 = ry * ry

    # Start region 1 at the top
    x = 0
    y = ry
    px = 0
    py = 2 * rx2 * y
    p = ry2 - rx2 * ry + rx2 / 4
    yield from four_points(xc, yc, x, y)

    while px < py:
        # Region 1: choose E or SE
        x += 1
        px += 2 * ry2
        if p < 0:
            p += ry2 + px
        else:
            y -= 1
            py -= 2 * rx2
            p += ry2 + px - py
        yield from four_points(xc, yc, x, y)

    # Change to region 2
    # where (x + 1/2)^2 = x (x + 1) + 1/4
    p = ry2 * x * (x + 1) + rx2 * (y - 1) * (y - 1) - rx2 * ry2 + ry2 / 4

    for k in range(y):
        # Region 2: choose S or SE
        y -= 1
        py -= 2 * rx2
        if p > 0:
            p += rx2 - py
        else:
            x += 1
            px += 2 * ry2
            p += rx2 - py + px
        yield from four_points(xc, yc, x, y)

    while x < rx:
        # Finish the tip of a flat ellipse
        x += 1
        yield from four_points(xc, yc, x, y)


ENTRY = Entry(
    function=midpoint_ellipse,
    topic="circles",
    title="Midpoint ellipse",
    summary="Walks a quarter of the ellipse in two regions, each in steps along its longer direction.",
    parameters=PARAMETERS,
    draws=("ellipse",),
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-6",
    columns=COLUMNS,
    views=VIEWS,
    laws=(
        Law(
            "Each pixel comes once.",
            "circles/test_circles.py::test_the_ellipse_chooses_by_the_exact_sign_each_pixel_once",
        ),
        Law(
            "The four mirror images of every pixel are there, and the four ends of the axes.",
            "circles/test_circles.py::test_the_ellipse_chooses_by_the_exact_sign_each_pixel_once",
        ),
        Law(
            "Every choice agrees with the sign of the ellipse's function at the midpoint, computed exactly.",
            "circles/test_circles.py::test_the_ellipse_chooses_by_the_exact_sign_each_pixel_once",
        ),
        Law(
            "Neighbouring pixels touch along a side or at a corner.",
            "circles/test_circles.py::test_neighbours_on_the_ellipse_touch",
        ),
        Law(
            "With equal radii the pixels are those of the midpoint circle.",
            "circles/test_circles.py::test_with_equal_radii_the_ellipse_is_the_circle",
        ),
    ),
    not_laws=(
        "Every pixel is the nearest to the ellipse: at the ends of a very flat one they need not be.",
        "Turned by a quarter it is the ellipse with its radii swapped: about the slope −1 the two choose by "
        "other midpoints. Of radii up to 90 every 17th pair differs, among them 2 and 3.",
    ),
    labs=("Ellipse drawing: midpoint",),
    tie="Hearn and Baker: region 1 takes SE on p >= 0, region 2 takes S on p > 0",
    extent="xc - rx, yc - ry, xc + rx, yc + ry",
)
