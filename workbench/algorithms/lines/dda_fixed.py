"""The digital differential analyser in fixed point: whole numbers that count small parts of a pixel.

one                         a pixel, counted in parts: 2 to the power of fraction_bits
dx, dy                      sides of the line's box, with their signs
steps                       number of unit steps along the longer side
x_increment, y_increment    what is added at each step, in parts, rounded to a whole number
x, y                        the point reached by adding, in parts
k                           number of the step, from 0
"""

from collections.abc import Iterator

from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.lines.drift import beside, drift, drift_in, others
from workbench.algorithms.lines.ends import DRAWS, END_POINTS


def dda_line_fixed(x0: int, y0: int, x1: int, y1: int, fraction_bits: int = 8) -> Iterator[tuple[int, int]]:
    """Emit one pixel for each step along the longer side, adding whole numbers of parts of a pixel.

    Args: end points in device pixels; binary digits after the point, 1 to 24. Emits: (x, y).
    The increment is off by up to half a part, so after n steps the line is off by up to n/2 parts.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-2, on round-off error.
    """
    # Choose the size of the parts
    one = 1 << fraction_bits
    half = one >> 1

    # Count the steps along the longer side
    dx = x1 - x0
    dy = y1 - y0
    steps = max(abs(dx), abs(dy))

    # Round the increments to whole parts
    x_increment = (2 * dx * one + steps) // max(2 * steps, 1)
    y_increment = (2 * dy * one + steps) // max(2 * steps, 1)

    # Plot the first end point
    x = x0 * one
    y = y0 * one
    yield (x + half) >> fraction_bits, (y + half) >> fraction_bits

    for k in range(steps):
        # Add the increments
        x += x_increment
        y += y_increment

        # Plot the nearest pixel
        yield (x + half) >> fraction_bits, (y + half) >> fraction_bits


_ENDS = "(x0, y0, x1, y1)"
_PIXEL = "((x + half) >> fraction_bits, (y + half) >> fraction_bits)"
_DRIFT = f"drift((x, y), {_ENDS}, k + 1, one)"

ENTRY = Entry(
    function=dda_line_fixed,
    topic="lines",
    title="DDA line in fixed point",
    summary="The same sum in whole parts of a pixel: the rounded increment makes the line drift steadily.",
    parameters=(
        *END_POINTS,
        Parameter("fraction_bits", "bits", "int", 8, 1, 24, meaning="binary digits after the point"),
    ),
    draws=DRAWS,
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-2",
    columns=("k", "x_{k+1}", "y_{k+1}", "pixel", "drift", "in 32 bits", "in 64 bits"),
    view_functions=(beside, drift, drift_in, others),
    views=(
        View(
            block="Round the increments to whole parts",
            sentence="{steps} steps, {one} parts to a pixel: x grows by {x_increment} parts, "
            "y by {y_increment}.",
        ),
        View(block="Plot the first end point", chosen=f"({_PIXEL},)", sentence=f"Start at {{{_PIXEL}}}."),
        View(
            block="Add the increments",
            candidates=f"beside((x + x_increment) / one, (y + y_increment) / one, {_ENDS})",
            chosen=f"({_PIXEL},)",
            rejected=f"others(x / one, y / one, {_ENDS}, {_PIXEL})",
            row=f"(k, x / one, y / one, {_PIXEL}, {_DRIFT}, drift_in({_ENDS}, k + 1, 'float32'), "
            f"drift_in({_ENDS}, k + 1, 'float64'))",
            sentence="x = {before.x} + {x_increment} = {x} parts, y = {before.y} + {y_increment} = {y} "
            f"parts; rounded, {{{_PIXEL}}}. Drift so far: {{{_DRIFT}}} pixels.",
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
            "After n steps the sum is off by at most n times half a part.",
            "lines/test_lines.py::test_fixed_point_is_off_by_at_most_half_a_part_for_each_step",
        ),
        Law(
            "With 24 binary digits each pixel of a line of up to 4000 steps is a nearest one to the "
            "true line.",
            "lines/test_lines.py::test_fixed_point_with_24_bits_is_nearest_but_for_ties",
        ),
    ),
    not_laws=(
        "The last pixel is the end point: with 8 binary digits a line of a few hundred steps may miss it.",
        "The pixels are the nearest to the true line.",
    ),
    questions=(11,),
    labs=("Line drawing: DDA",),
    next_rung="bresenham_line",
    tie="floor(v + 0.5): halves go up",
)
