"""Bresenham's line from both ends at once: one decision serves two pixels, which mirror each other.

x, y            the pixel reached from the first end; on a steep line the axes are swapped
x_back, y_back  the pixel reached from the second end
dx, dy          sides of the line's box, never negative
p               decision parameter: its sign tells which of two rows is nearer to the line
k               number of the step, from 0
"""

from collections.abc import Iterator

from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.lines.axes import LONGER, SHORTER, neighbours, pixel, starts
from workbench.algorithms.lines.ends import DRAWS, END_POINTS, EXTENT


def bresenham_line_two_ends(x0: int, y0: int, x1: int, y1: int) -> Iterator[tuple[int, int]]:
    """Emit two pixels for each step, one from either end, until they meet in the middle.

    Args: end points in device pixels. Emits: (x, y), first end, second end, and so on towards the middle.
    Source: Gardner, Modifications of Bresenham's algorithm for displays, 1975.
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

    # Plot both end points
    x, y = x0, y0
    x_back, y_back = x1, y1
    p = two_dy - dx
    if steep:
        yield y, x
    else:
        yield x, y
    if x != x_back:
        if steep:
            yield y_back, x_back
        else:
            yield x_back, y_back

    for k in range(dx // 2):
        # Choose the nearer row, for both
        if p < 0:
            p += two_dy
        else:
            y += step_y
            y_back -= step_y
            p += two_dy_minus_dx

        # Plot the pixels, in the middle only one
        x += step_x
        x_back -= step_x
        if steep:
            yield y, x
        else:
            yield x, y
        if x != x_back:
            if steep:
                yield y_back, x_back
            else:
                yield x_back, y_back


def both(x: int, y: int, x_back: int, y_back: int, steep: bool) -> tuple[tuple[int, int], ...]:
    """The pixels of one step: one from either end, in the middle that of the first end."""
    first = pixel(x, y, steep)
    return (first,) if x == x_back else (first, pixel(x_back, y_back, steep))


_STRAIGHT = "both(x + step_x, before.y, x_back - step_x, before.y_back, steep)"
_DIAGONAL = "both(x + step_x, before.y + step_y, x_back - step_x, before.y_back - step_y, steep)"
_CANDIDATES = (
    "both(x + step_x, y, x_back - step_x, y_back, steep) "
    "+ both(x + step_x, y + step_y, x_back - step_x, y_back - step_y, steep)"
)
_MET = "x + step_x == x_back - step_x"
_ROW = f"(k, before.p, pixel(x + step_x, y, steep), '' if {_MET} else pixel(x_back - step_x, y_back, steep))"
_TAKEN = "{pixel(x + step_x, y, steep)}"
_MIRRORED = (
    "{'the two meet there' if x + step_x == x_back - step_x else 'so is its mirror image from the other end'}"
)

ENTRY = Entry(
    function=bresenham_line_two_ends,
    topic="lines",
    title="Bresenham from both ends",
    summary="Each decision serves two pixels that mirror each other: half the steps, other pixels at ties.",
    parameters=END_POINTS,
    draws=DRAWS,
    emits="pixels",
    source="Gardner, Modifications of Bresenham's algorithm for displays, IBM Technical Disclosure, 1975",
    columns=("k", "p_k", "(x_{k+1}, y_{k+1})", "from the other end"),
    view_functions=(both, neighbours, pixel),
    views=(
        *starts(
            block="Plot both end points",
            chosen="both(x, y, x_back, y_back, steep)",
            sentence="Start at {pixel(x, y, steep)} and {pixel(x_back, y_back, steep)}. The first p is "
            f"2{SHORTER} − {LONGER} = {{two_dy}} − {{dx}} = {{p}}.",
        ),
        View(
            block="Choose the nearer row, for both",
            when="before.p < 0",
            candidates=_CANDIDATES,
            chosen=_STRAIGHT,
            rejected=_DIAGONAL,
            row=_ROW,
            sentence=f"p = {{before.p}} is negative: {_TAKEN}, straight on, is nearer to the line; "
            f"{_MIRRORED}. Next p = {{before.p}} + 2{SHORTER} = {{p}}.",
        ),
        View(
            block="Choose the nearer row, for both",
            when="before.p == 0",
            candidates=_CANDIDATES,
            chosen=_DIAGONAL,
            rejected=_STRAIGHT,
            row=_ROW,
            sentence=f"p = {{before.p}}: the line passes exactly halfway, and the diagonal is taken, "
            f"{_TAKEN}; {_MIRRORED}. Next p = {{before.p}} + 2{SHORTER} − 2{LONGER} = {{p}}.",
        ),
        View(
            block="Choose the nearer row, for both",
            candidates=_CANDIDATES,
            chosen=_DIAGONAL,
            rejected=_STRAIGHT,
            row=_ROW,
            sentence=f"p = {{before.p}} is positive: {_TAKEN}, the diagonal, is nearer to the line; "
            f"{_MIRRORED}. Next p = {{before.p}} + 2{SHORTER} − 2{LONGER} = {{p}}.",
        ),
    ),
    laws=(
        Law(
            "There is one pixel for each step along the longer side, both ends included; none comes twice.",
            "lines/test_two_ends.py::test_each_pixel_comes_once_and_the_ends_come_first",
        ),
        Law(
            "Each pixel is a nearest one to the true line; exactly halfway, the one farther from the end "
            "that it is reached from.",
            "lines/test_two_ends.py::test_each_half_is_the_nearest_and_on_a_tie_farther_from_its_end",
        ),
        Law(
            "The two pixels of a step mirror each other at the middle of the line.",
            "lines/test_two_ends.py::test_the_two_pixels_of_a_step_mirror_each_other",
        ),
        Law(
            "Drawn backwards it has the same pixels, but for the one in the middle where the line passes "
            "exactly halfway.",
            "lines/test_two_ends.py::test_drawn_backwards_only_a_tie_in_the_middle_differs",
        ),
        Law(
            "Mirrored end points give the mirrored pixels.", "lines/test_two_ends.py::test_it_mirrors_exactly"
        ),
    ),
    not_laws=(
        "It is Bresenham's line drawn in half the steps: beyond the middle it takes ties the other way.",
    ),
    questions=(11,),
    labs=("Line drawing: Bresenham",),
    next_rung="midpoint_line",
    tie="p >= 0 takes the diagonal, as seen from the nearer end",
    extent=EXTENT,
)
