"""The digital differential analyser (DDA).

dx, dy                      sides of the line's box, with their signs
steps                       number of unit steps along the longer side
x_increment, y_increment    what is added at each step; one of them is 1 or -1
x, y                        the point reached by adding, not yet rounded
k                           number of the step, from 0
"""

import math
from collections.abc import Iterator

from workbench.algorithms.entry import Entry, View
from workbench.algorithms.lines.drift import beside, drift, exact, others
from workbench.algorithms.lines.ends import END_POINTS, EXTENT


def dda_line(x0: int, y0: int, x1: int, y1: int) -> Iterator[tuple[int, int]]:
    """Emit one pixel for each step along the longer side, by adding a constant and rounding.

    Args: end points in device pixels. Emits: (x, y), both ends included. Rounding is floor(v + 0.5).
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-2.
    """
    # Count the steps along the longer side
    dx = x1 - x0
    dy = y1 - y0
    steps = max(abs(dx), abs(dy))

    # Divide the sides into that many increments
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
    summary="Adds the same increment at each step and rounds; the smallest errors of the sum add up too.",
    parameters=END_POINTS,
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-2",
    columns=("k", "x_{k+1}", "y_{k+1}", "pixel", "exact", "drift"),
    view_functions=(beside, drift, exact, others),
    views=(
        View(
            block="Divide the sides into that many increments",
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
        "One pixel for each step along the longer side, both ends included.",
        "Neighbouring pixels touch along a side or at a corner.",
        "Each pixel is the nearest to the point reached by adding; only a point exactly halfway, or nearer "
        "to halfway than the drift, may be rounded to the other side.",
    ),
    not_laws=(
        "The pixels are the nearest to the true line: the sum drifts, in 64 bits very little.",
        "The mirror image of a line is the line of the mirror image: halves are rounded upwards.",
    ),
    questions=(11,),
    labs=("Line drawing: DDA",),
    next_rung="dda_line_single",
    tie="floor(v + 0.5): halves go up",
    extent=EXTENT,
)
