"""The midpoint circle.

x, y    point of the octant from the top to the diagonal, seen from the centre
p       decision parameter: r^2 times the circle's function at the midpoint, less a quarter that no sign sees
new     how many of the eight mirror images of (x, y) have not been plotted before
"""

from collections.abc import Iterator

from workbench.algorithms.entry import Entry, Law, Parameter, View


def new_images(x: int, y: int) -> int:
    """How many of the eight mirror images of (x, y) are new: 8, or fewer where mirrors coincide."""
    if x > y:
        return 0  # past the diagonal: the swap of the point before
    if y == 0:
        return 1  # the centre itself
    if x == 0 or x == y:
        return 4  # on an axis or a diagonal
    return 8


def eight_points(xc: int, yc: int, x: int, y: int) -> Iterator[tuple[int, int]]:
    """Emit the mirror images of (x, y) about the centre, each pixel once."""
    # Drop the duplicates
    new = new_images(x, y)

    # Plot the point and its quarter turns
    if new >= 1:
        yield xc + x, yc + y
    if new >= 4:
        yield xc - y, yc + x
        yield xc - x, yc - y
        yield xc + y, yc - x

    # Plot their reflections
    if new == 8:
        yield xc + y, yc + x
        yield xc - x, yc + y
        yield xc - y, yc - x
        yield xc + x, yc - y


def midpoint_circle(xc: int, yc: int, r: int) -> Iterator[tuple[int, int]]:
    """Emit a circle, walking one octant and plotting eight points at each step.

    Args: centre and radius (0 or more) in device pixels. Emits: (x, y), each pixel once.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-5.
    """
    # Start at the top of the circle
    x = 0
    y = r
    p = 1 - r
    yield from eight_points(xc, yc, x, y)

    while x < y:
        # Choose E or SE
        x += 1
        if p < 0:
            p += 2 * x + 1
        else:
            y -= 1
            p += 2 * (x - y) + 1

        # Plot the eight points
        yield from eight_points(xc, yc, x, y)


_ROW = "(x - 1, before.p, (x, y), 2 * x, 2 * y, new_images(x, y))"
_CANDIDATES = "((xc + x + 1, yc + y), (xc + x + 1, yc + y - 1))"
_CHOSEN = "((xc + x, yc + y),)"

ENTRY = Entry(
    function=midpoint_circle,
    topic="circles",
    title="Midpoint circle",
    summary="Walks one eighth of the circle by the sign of an integer; mirroring gives the other seven.",
    parameters=(
        Parameter("xc", "x_c", "int", 0, -32768, 32767, "px", "centre, column"),
        Parameter("yc", "y_c", "int", 0, -32768, 32767, "px", "centre, row"),
        Parameter("r", "r", "int", 10, 0, 32767, "px", "radius"),
    ),
    draws=("circle",),
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-5",
    columns=("k", "p_k", "(x_{k+1}, y_{k+1})", "2x_{k+1}", "2y_{k+1}", "new pixels"),
    views=(
        View(
            block="Start at the top of the circle",
            chosen=_CHOSEN,
            sentence="Start at (0, {r}) from the centre. The first p is 1 − r = {p}.",
        ),
        View(
            block="Drop the duplicates",
            when="new == 0",
            sentence="None of the eight mirror images of ({x}, {y}) is new: past the diagonal they have been "
            "plotted already.",
        ),
        View(
            block="Drop the duplicates",
            when="new < 8",
            sentence="Of the eight mirror images of ({x}, {y}) only {new} {'is' if new == 1 else 'are'} new: "
            "on an axis and on the diagonal mirror images coincide.",
        ),
        View(
            block="Choose E or SE",
            when="before.p < 0",
            candidates=_CANDIDATES,
            chosen=_CHOSEN,
            rejected="((xc + x, yc + y - 1),)",
            row=_ROW,
            sentence="p = {before.p} is negative: the midpoint is inside the circle, so take E, ({x}, "
            "{y}) from the centre. Next p = {before.p} + 2·{x} + 1 = {p}.",
        ),
        View(
            block="Choose E or SE",
            candidates=_CANDIDATES,
            chosen=_CHOSEN,
            rejected="((xc + x, yc + before.y),)",
            row=_ROW,
            sentence="p = {before.p} is not negative: the midpoint is not inside the circle, so take SE, "
            "({x}, {y}) from the centre. Next p = {before.p} + 2({x} − {y}) + 1 = {p}.",
        ),
    ),
    laws=(
        Law(
            "Each pixel comes once.",
            "circles/test_circles.py::test_the_circle_is_the_nearest_in_each_column_each_pixel_once",
        ),
        Law(
            "The eight mirror images of every pixel are there.",
            "circles/test_circles.py::test_the_eight_mirror_images_of_each_pixel_are_there",
        ),
        Law(
            "In the octant from the top to the diagonal each column has the pixel nearest to the circle.",
            "circles/test_circles.py::test_the_circle_is_the_nearest_in_each_column_each_pixel_once",
        ),
        Law(
            "Neighbouring pixels touch along a side or at a corner.",
            "circles/test_circles.py::test_neighbours_on_the_circle_touch",
        ),
    ),
    not_laws=(
        "The pixels are those whose squared distance to the centre is nearest to r²: another measure.",
    ),
    labs=("Circle drawing: midpoint",),
    next_rung="midpoint_ellipse",
    tie="Hearn and Baker: p >= 0 takes SE; the circle of whole radius never meets a midpoint exactly",
    extent="xc - r, yc - r, xc + r, yc + r",
)
