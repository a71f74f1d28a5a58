"""Wu's antialiased line.

x, y        the pixel at or before the true line; on a steep line the axes are swapped
dx, dy      sides of the line's box, never negative
e           how far the line is past (x, y), in dx-ths of a pixel: 0 <= e < dx
k           number of the step, from 0
"""

from collections.abc import Iterator

from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.lines.axes import pixel, starts
from workbench.algorithms.lines.ends import DRAWS, END_POINTS


def wu_line(x0: int, y0: int, x1: int, y1: int) -> Iterator[tuple[int, int, float]]:
    """Emit at each step the two pixels on either side of the line, each covered by as much as it is near.

    Args: end points in device pixels. Emits: (x, y, coverage), coverage above 0 and up to 1.
    Source: Wu, An efficient antialiasing technique, SIGGRAPH 1991, with a fraction of dx instead of 2^n.
    """
    # Swap the axes of a steep line
    steep = abs(y1 - y0) > abs(x1 - x0)
    if steep:
        x0, y0, x1, y1 = y0, x0, y1, x1

    # Set up the constants
    dx = abs(x1 - x0)
    dy = abs(y1 - y0)
    step_x = 1 if x0 < x1 else -1
    step_y = 1 if y0 < y1 else -1

    # Plot the first end point
    x = x0
    y = y0
    e = 0
    if steep:
        yield y, x, 1.0
    else:
        yield x, y, 1.0

    for k in range(dx):
        # Move along the line
        x += step_x
        e += dy
        if e >= dx:
            e -= dx
            y += step_y

        # Share the light between the two pixels
        near = (dx - e) / dx
        far = e / dx
        if steep:
            yield y, x, near
        else:
            yield x, y, near
        if e > 0:
            if steep:
                yield y + step_y, x, far
            else:
                yield x, y + step_y, far


_NEAR = "pixel(x, y, steep)"
_FAR = "pixel(x, y + step_y, steep)"
_ROW = f"(k, e, {_NEAR}, near, {_FAR}, far)"

ENTRY = Entry(
    function=wu_line,
    topic="lines",
    title="Wu's antialiased line",
    summary="Lights the two pixels on either side of the line, the nearer one more; the staircase "
    "melts away.",
    parameters=END_POINTS,
    draws=DRAWS,
    emits="coverage",
    source="Wu, An efficient antialiasing technique, SIGGRAPH 1991",
    columns=("k", "e_{k+1}", "near", "coverage", "far", "coverage"),
    view_functions=(pixel,),
    views=(
        *starts(
            block="Plot the first end point",
            chosen="(pixel(x, y, steep),)",
            sentence="Start at {pixel(x, y, steep)}, covered in full.",
        ),
        View(
            block="Share the light between the two pixels",
            when="e == 0",
            candidates=f"({_NEAR}, {_FAR})",
            chosen=f"({_NEAR},)",
            rejected=f"({_FAR},)",
            row=_ROW,
            sentence=f"The line passes through {{{_NEAR}}}: it gets all the light.",
        ),
        View(
            block="Share the light between the two pixels",
            candidates=f"({_NEAR}, {_FAR})",
            chosen=f"({_NEAR}, {_FAR})",
            row=_ROW,
            sentence=f"The line is {{e}}/{{dx}} of a pixel past {{{_NEAR}}}: that pixel gets {{near}}, "
            f"{{{_FAR}}} gets {{far}}.",
        ),
    ),
    laws=(
        Law(
            "In each column of a flat line the coverages add up to 1; in each row of a steep one.",
            "lines/test_lines.py::test_wu_shares_the_light_of_each_column_and_its_middle_is_on_the_line",
        ),
        Law(
            "The middle of the light of a column is on the true line.",
            "lines/test_lines.py::test_wu_shares_the_light_of_each_column_and_its_middle_is_on_the_line",
        ),
        Law(
            "The line drawn backwards has the same pixels and coverages.",
            "lines/test_lines.py::test_wu_is_the_same_backwards",
        ),
    ),
    not_laws=("Every pixel is lit or dark.",),
    questions=(11,),
    labs=("Line drawing: antialiasing",),
)
