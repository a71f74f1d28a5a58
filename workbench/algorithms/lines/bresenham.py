"""Bresenham's line.

x, y            the pixel reached so far; on a steep line the axes are swapped
dx, dy          sides of the line's box, never negative
p               decision parameter: its sign tells which of two rows is nearer to the line
k               number of the step, from 0
"""

from collections.abc import Iterator

from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.lines.axes import LONGER, SHORTER, neighbours, pixel, starts
from workbench.algorithms.lines.ends import DRAWS, END_POINTS, EXTENT


def bresenham_line(x0: int, y0: int, x1: int, y1: int) -> Iterator[tuple[int, int]]:
    """Emit one pixel for each step along the longer side, deciding by the sign of an integer.

    Args: end points in device pixels. Emits: (x, y), both ends included.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-2.
    """
    # Swap the axes of a steep line
    steep = abs(y1 - y0) > abs(x1 - x0)
    if steep:
        x0, y0, x1, y1 = y0, x0, y1, x1

    # Set up the constants
    dx = abs(x1 - x0)
    dy = abs(y1 - y0)
    two_dy = 2 * dy
    two_dy_minus_dx = 2 * (dy - dx)
    step_x = 1 if x0 < x1 else -1
    step_y = 1 if y0 < y1 else -1

    # Plot the first end point
    x = x0
    y = y0
    p = two_dy - dx
    if steep:
        yield y, x
    else:
        yield x, y

    for k in range(dx):
        # Choose the nearer row
        if p < 0:
            p += two_dy
        else:
            y += step_y
            p += two_dy_minus_dx

        # Plot the pixel
        x += step_x
        if steep:
            yield y, x
        else:
            yield x, y


_ROW = "(k, before.p, pixel(x + step_x, y, steep))"
_CANDIDATES = "neighbours(x, y, step_x, step_y, steep)"
_CHOSEN = "(pixel(x + step_x, y, steep),)"
_STRAIGHT = "(pixel(x + step_x, before.y, steep),)"

ENTRY = Entry(
    function=bresenham_line,
    topic="lines",
    title="Bresenham's line",
    summary="Chooses between two pixels at each step by the sign of an integer; it only adds and compares.",
    parameters=END_POINTS,
    draws=DRAWS,
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-2",
    columns=("k", "p_k", "(x_{k+1}, y_{k+1})"),
    view_functions=(neighbours, pixel),
    views=(
        *starts(
            block="Plot the first end point",
            chosen="(pixel(x, y, steep),)",
            sentence="Start at {pixel(x, y, steep)}. The first p is "
            f"2{SHORTER} − {LONGER} = {{two_dy}} − {{dx}} = {{p}}.",
        ),
        View(
            block="Choose the nearer row",
            when="before.p < 0",
            candidates=_CANDIDATES,
            chosen=_CHOSEN,
            rejected="(pixel(x + step_x, y + step_y, steep),)",
            row=_ROW,
            sentence="p = {before.p} is negative: the line is nearer to {pixel(x + step_x, y, steep)} "
            f"than to {{pixel(x + step_x, y + step_y, steep)}}. Next p = {{before.p}} + 2{SHORTER} = {{p}}.",
        ),
        View(
            block="Choose the nearer row",
            when="before.p == 0",
            candidates=_CANDIDATES,
            chosen=_CHOSEN,
            rejected=_STRAIGHT,
            row=_ROW,
            sentence="p = {before.p}: the line passes exactly halfway, and the book takes the diagonal, "
            f"{{pixel(x + step_x, y, steep)}}. Next p = {{before.p}} + 2{SHORTER} − 2{LONGER} = {{p}}.",
        ),
        View(
            block="Choose the nearer row",
            candidates=_CANDIDATES,
            chosen=_CHOSEN,
            rejected=_STRAIGHT,
            row=_ROW,
            sentence="p = {before.p} is positive: the line is nearer to {pixel(x + step_x, y, steep)} "
            f"than to {{pixel(x + step_x, before.y, steep)}}. Next p = {{before.p}} + 2{SHORTER} − 2{LONGER} "
            "= {p}.",
        ),
    ),
    laws=(
        Law(
            "There is one pixel for each step along the longer side.",
            "lines/test_lines.py::test_one_connected_pixel_for_each_step",
        ),
        Law(
            "The first and the last pixel are the end points.",
            "lines/test_lines.py::test_both_ends_are_included",
        ),
        Law(
            "Each pixel is a nearest one to the true line; exactly halfway, the one farther from the "
            "first end.",
            "lines/test_lines.py::test_bresenham_takes_the_nearest_and_on_a_tie_the_one_farther_from_the_start",
        ),
        Law(
            "Neighbouring pixels touch along a side or at a corner.",
            "lines/test_lines.py::test_one_connected_pixel_for_each_step",
        ),
        Law(
            "Mirrored end points give the mirrored pixels.",
            "lines/test_lines.py::test_bresenham_mirrors_exactly",
        ),
    ),
    not_laws=("The line drawn backwards has the same pixels: where it passes exactly halfway, it may not.",),
    questions=(11,),
    labs=("Line drawing: Bresenham",),
    next_rung="bresenham_line_two_ends",
    tie="Hearn and Baker: p >= 0 takes the diagonal",
    extent=EXTENT,
)
