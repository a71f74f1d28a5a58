"""The digital differential analyser (DDA).

dx, dy                      sides of the line's box, with their signs
steps                       number of unit steps along the longer side
x_increment, y_increment    what is added at each step; one of them is 1 or -1
x, y                        the point reached by adding, not yet rounded
k                           number of the step, from 0
"""

import math
from collections.abc import Iterator

from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.lines.drift import beside, drift, exact, others
from workbench.algorithms.lines.ends import DRAWS, END_POINTS, EXTENT


def dda_line(x0: int, y0: int, x1: int, y1: int) -> Iterator[tuple[int, int]]:
    """Emit one pixel for each step along the longer side, by adding a constant and rounding.

    Args: end points in device pixels. Emits: (x, y), both ends included. Rounding is floor(v + 0.5).
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-2.
    """
    # Count the steps along the longer side
    dx = x1 - x0
    dy = y1 - y0
    steps = max(abs(dx), abs(dy))

    # Divide both sides by the number of steps
    x_increment = dx / max(steps, 1)
    y_increment = dy / max(steps, 1)

    # Plot the first end point
    x = float(x0)
    y = float(y0)
    yield math.floor(x + 0.5), math.floor(y + 0.5)

    for k in range(steps):
        # Add the increments
        x += x_increment
        y += y_increment

        # Plot the nearest pixel
        yield math.floor(x + 0.5), math.floor(y + 0.5)


_ENDS = "(x0, y0, x1, y1)"
_PIXEL = "(math.floor(x + 0.5), math.floor(y + 0.5))"
_DRIFT = f"drift((x, y), {_ENDS}, k + 1)"

ENTRY = Entry(
    function=dda_line,
    topic="lines",
    title="DDA line",
    summary="Adds the same increment at each step and rounds; the tiny rounding errors of the sum "
    "add up too.",
    parameters=END_POINTS,
    draws=DRAWS,
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-2",
    columns=("k", "x_{k+1}", "y_{k+1}", "pixel", "exact", "drift"),
    view_functions=(beside, drift, exact, others),
    views=(
        View(
            block="Divide both sides by the number of steps",
            sentence="{steps} steps: x grows by {dx}/{steps} = {x_increment}, "
            "y by {dy}/{steps} = {y_increment}.",
        ),
        View(block="Plot the first end point", chosen=f"({_PIXEL},)", sentence=f"Start at {{{_PIXEL}}}."),
        View(
            block="Add the increments",
            candidates=f"beside(x + x_increment, y + y_increment, {_ENDS})",
            chosen=f"({_PIXEL},)",
            rejected=f"others(x, y, {_ENDS}, {_PIXEL})",
            row=f"(k, x, y, {_PIXEL}, exact({_ENDS}, k + 1), {_DRIFT})",
            sentence="x = {before.x} + {x_increment} = {x}, y = {before.y} + {y_increment} = {y}; "
            f"rounded, {{{_PIXEL}}}. Drift so far: {{{_DRIFT}}}.",
        ),
    ),
    laws=(
        Law(
            "There is one pixel for each step along the longer side.",
            "lines/test_lines.py::test_one_connected_pixel_for_each_step",
        ),
        Law(
            "Neighbouring pixels touch along a side or at a corner.",
            "lines/test_lines.py::test_one_connected_pixel_for_each_step",
        ),
        Law(
            "The first and the last pixel are the end points.",
            "lines/test_lines.py::test_both_ends_are_included",
        ),
        Law(
            "Each pixel is a nearest one to the true line: in 64 bits the drift is so small that it "
            "decides only exactly halfway.",
            "lines/test_lines.py::test_dda_in_64_bits_is_nearest_but_for_ties",
        ),
    ),
    not_laws=(
        "Exactly halfway the pixel above is taken: the sum drifts, and falls to either side of a tie.",
        "The mirror image of a line is the line of the mirror image: halves are rounded upwards.",
    ),
    questions=(11,),
    labs=("Line drawing: DDA",),
    next_rung="dda_line_single",
    tie="floor(v + 0.5): halves go up",
    extent=EXTENT,
)
