"""The midpoint line.

F(x, y) = a x + b y + c     zero on the line, positive below it, negative above it
x, y                        the pixel reached so far; on a steep line the axes are swapped
a, b                        coefficients of F: dy and -dx
p                           decision parameter: 2 F at the midpoint between the next two candidates
k                           number of the step, from 0
"""

from collections.abc import Iterator

from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.lines.axes import neighbours, pixel, starts
from workbench.algorithms.lines.ends import DRAWS, END_POINTS, EXTENT


def midpoint_line(x0: int, y0: int, x1: int, y1: int) -> Iterator[tuple[int, int]]:
    """Emit one pixel for each step along the longer side, deciding by the side on which a midpoint lies.

    Args: end points in device pixels. Emits: (x, y), both ends included.
    Source: Foley, van Dam, Feiner and Hughes, Computer Graphics, section 3.2.2; ties as Hearn and Baker.
    """
    # Swap the axes of a steep line
    steep = abs(y1 - y0) > abs(x1 - x0)
    if steep:
        x0, y0, x1, y1 = y0, x0, y1, x1

    # Find the implicit function
    a = abs(y1 - y0)
    b = -abs(x1 - x0)
    step_x = 1 if x0 < x1 else -1
    step_y = 1 if y0 < y1 else -1

    # Plot the first end point
    x = x0
    y = y0
    p = 2 * a + b
    if steep:
        yield y, x
    else:
        yield x, y

    for k in range(-b):
        # Ask on which side the midpoint lies
        if p < 0:
            p += 2 * a
        else:
            y += step_y
            p += 2 * (a + b)

        # Plot the pixel
        x += step_x
        if steep:
            yield y, x
        else:
            yield x, y


_ROW = "(k, before.p / 2, pixel(x + step_x, y, steep))"
_CANDIDATES = "neighbours(x, y, step_x, step_y, steep)"
_CHOSEN = "(pixel(x + step_x, y, steep),)"
_STRAIGHT = "(pixel(x + step_x, before.y, steep),)"

ENTRY = Entry(
    function=midpoint_line,
    topic="lines",
    title="Midpoint line",
    summary="Asks on which side of the line the midpoint of two candidates lies; the pixels are Bresenham's.",
    parameters=END_POINTS,
    draws=DRAWS,
    emits="pixels",
    source="Foley, van Dam, Feiner and Hughes, Computer Graphics, section 3.2.2",
    columns=("k", "F(M_k)", "(x_{k+1}, y_{k+1})"),
    view_functions=(neighbours, pixel),
    views=(
        *starts(
            block="Plot the first end point",
            chosen="(pixel(x, y, steep),)",
            sentence="Start at {pixel(x, y, steep)}. F is a = {a} times {'y' if steep else 'x'} and b = {b} "
            "times {'x' if steep else 'y'}; at the first midpoint p = 2F = 2a + b = {p}.",
        ),
        View(
            block="Ask on which side the midpoint lies",
            when="before.p < 0",
            candidates=_CANDIDATES,
            chosen=_CHOSEN,
            rejected="(pixel(x + step_x, y + step_y, steep),)",
            row=_ROW,
            sentence="p = {before.p} is negative: the midpoint is beyond the line, so the line is nearer to "
            "{pixel(x + step_x, y, steep)}. Next p = {before.p} + 2a = {p}.",
        ),
        View(
            block="Ask on which side the midpoint lies",
            when="before.p == 0",
            candidates=_CANDIDATES,
            chosen=_CHOSEN,
            rejected=_STRAIGHT,
            row=_ROW,
            sentence="p = {before.p}: the midpoint is on the line; as in Bresenham's, the diagonal is "
            "taken, {pixel(x + step_x, y, steep)}. Next p = {before.p} + 2(a + b) = {p}.",
        ),
        View(
            block="Ask on which side the midpoint lies",
            candidates=_CANDIDATES,
            chosen=_CHOSEN,
            rejected=_STRAIGHT,
            row=_ROW,
            sentence="p = {before.p} is positive: the midpoint is short of the line, so the line is nearer "
            "to {pixel(x + step_x, y, steep)}. Next p = {before.p} + 2(a + b) = {p}.",
        ),
    ),
    laws=(
        Law(
            "The pixels are those of Bresenham's line, in the same order.",
            "lines/test_lines.py::test_the_midpoint_line_is_bresenhams",
        ),
        Law(
            "p is twice F at the midpoint, at every step.",
            "lines/test_lines.py::test_the_midpoint_line_decides_by_its_function_at_the_midpoint",
        ),
    ),
    not_laws=("The line drawn backwards has the same pixels: where it passes exactly halfway, it may not.",),
    questions=(11,),
    labs=("Line drawing: midpoint",),
    next_rung="wu_line",
    tie="Hearn and Baker: p >= 0 takes the diagonal",
    extent=EXTENT,
)
