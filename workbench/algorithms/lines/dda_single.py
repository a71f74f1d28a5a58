"""The digital differential analyser in 32-bit floating point, as graphics hardware adds.

dx, dy                      sides of the line's box, with their signs
steps                       number of unit steps along the longer side
x_increment, y_increment    what is added at each step, to 24 binary digits
x, y                        the point reached by adding, to 24 binary digits
k                           number of the step, from 0
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from workbench.algorithms.entry import DrawnBy, Entry, Law, View
from workbench.algorithms.lines.drift import beside, drift, drift_in, others
from workbench.algorithms.lines.ends import DRAWS, END_POINTS


def dda_line_single(x0: int, y0: int, x1: int, y1: int) -> Iterator[tuple[int, int]]:
    """Emit one pixel for each step along the longer side, adding in single precision.

    Args: end points in device pixels. Emits: (x, y). The last pixel of a long line may miss its end point.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-2, with float as in its listing.
    """
    # Count the steps along the longer side
    dx = x1 - x0
    dy = y1 - y0
    steps = max(abs(dx), abs(dy))

    # Divide both sides by the number of steps
    x_increment = np.float32(dx) / np.float32(max(steps, 1))
    y_increment = np.float32(dy) / np.float32(max(steps, 1))

    # Plot the first end point
    x = np.float32(x0)
    y = np.float32(y0)
    yield math.floor(x + np.float32(0.5)), math.floor(y + np.float32(0.5))

    for k in range(steps):
        # Add the increments
        x += x_increment
        y += y_increment

        # Plot the nearest pixel
        yield math.floor(x + np.float32(0.5)), math.floor(y + np.float32(0.5))


NEAR = 255


def near_and_nowhere_halfway(x0: Any, y0: Any, x1: Any, y1: Any) -> Any:
    """Whether a line, or each of many (n,), has its ends from 0 to NEAR and passes halfway between no pixels.

    It passes halfway where the steps, divided by what they share with the shorter side, are even in number.
    Elsewhere it stays 1/510 away, and 255 sums are off by less: 255 times 2^-25 + 2^-17, and 2^-17 more.
    """
    lowest = np.minimum(np.minimum(x0, y0), np.minimum(x1, y1))
    highest = np.maximum(np.maximum(x0, y0), np.maximum(x1, y1))
    dx, dy = np.abs(x1 - x0), np.abs(y1 - y0)
    shared = np.maximum(np.gcd(dx, dy), 1)
    return (lowest >= 0) & (highest <= NEAR) & (np.maximum(dx, dy) // shared % 2 == 1)


_AS_IN_64_BITS = Law(
    "With both ends in the columns and rows 0 to 255, and with no step exactly halfway between two pixels, "
    "the pixels are those of the DDA line in 64 bits.",
    "lines/test_lines.py::test_32_bits_take_the_pixels_of_64_near_the_origin_but_for_ties",
)

_ENDS = "(x0, y0, x1, y1)"
_PIXEL = "(math.floor(x + np.float32(0.5)), math.floor(y + np.float32(0.5)))"
_DRIFT = f"drift((x, y), {_ENDS}, k + 1)"
_DRIFT_64 = f"drift_in({_ENDS}, k + 1, 'float64')"

ENTRY = Entry(
    function=dda_line_single,
    topic="lines",
    title="DDA line in 32 bits",
    summary="The same sum with 24 binary digits: over a few thousand steps the drift becomes visible.",
    parameters=END_POINTS,
    draws=DRAWS,
    drawn_by=DrawnBy("dda_line", _AS_IN_64_BITS, near_and_nowhere_halfway),
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-2",
    columns=("k", "x_{k+1}", "y_{k+1}", "pixel", "drift", "drift in 64 bits"),
    view_functions=(beside, drift, drift_in, others),
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
            row=f"(k, x, y, {_PIXEL}, {_DRIFT}, {_DRIFT_64})",
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
        _AS_IN_64_BITS,
    ),
    not_laws=(
        "The last pixel is the end point: on a long line it need not be.",
        "The pixels are the nearest to the true line.",
    ),
    questions=(11,),
    labs=("Line drawing: DDA",),
    next_rung="dda_line_fixed",
    tie="floor(v + 0.5): halves go up",
)
