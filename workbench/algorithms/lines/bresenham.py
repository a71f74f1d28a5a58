"""Bresenham's line.

x, y            the pixel reached so far; on a steep line the axes are swapped
dx, dy          sides of the line's box, never negative
p               decision parameter: its sign tells which of two rows is nearer to the line
k               number of the step, from 0
"""

from collections.abc import Iterator

from workbench.algorithms.entry import Entry, Parameter, View


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
