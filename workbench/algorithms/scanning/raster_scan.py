"""Raster scan: the beam sweeps over the whole frame buffer, line after line.

image       the frame buffer; 0 is dark
line        number of the line, from the top
y           row of the frame buffer that the line shows
clock       pixel clocks since the frame began; it runs on while the beam is off
lit         pixels of this line on which the beam was on
"""

from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View


def raster_scan(image: NDArray[Any], h_blank: int, v_blank: int) -> Iterator[tuple[int, int]]:
    """Emit each lit pixel in the order in which the beam reaches it.

    Args: a frame buffer (h, w); the pixel clocks of a horizontal retrace; the lines of the vertical one.
    Emits: (x, y). Source: Hearn and Baker, Computer Graphics, C Version, section 2-1.
    """
    # Start at the top left
    height, width = image.shape
    clock = 0
    lit = 0

    for line in range(height):
        # Scan the line from left to right
        y = height - 1 - line
        lit = 0
        for x in range(width):
            if image[y, x] != 0:
                lit += 1
                yield x, y
            clock += 1

        # Fly back to the left with the beam off
        clock += h_blank

    # Fly back to the top with the beam off
    clock += v_blank * (width + h_blank)


_PICTURE = np.array(
    [
        [0, 1, 1, 1, 1, 0],
        [0, 1, 0, 0, 1, 0],
        [0, 1, 1, 1, 1, 0],
        [1, 0, 0, 0, 0, 1],
    ]
)


def _small_picture(chance: Random) -> tuple[Any, ...]:
    """A frame buffer of one pixel or more, some of it or all of it dark, with retraces or without."""
    height, width, colours = chance.randint(1, 6), chance.randint(1, 8), chance.randint(0, 2)
    rows = [[chance.randint(0, colours) for _column in range(width)] for _row in range(height)]
    return np.array(rows), chance.randint(0, 5), chance.randint(0, 5)


ENTRY = Entry(
    function=raster_scan,
    topic="scanning",
    title="Raster scan",
    summary="The beam visits every pixel in order, whatever the picture, and flies back dark.",
    parameters=(
        Parameter("image", "image", "image", _PICTURE, meaning="frame buffer; 0 is dark"),
        Parameter("h_blank", "h_blank", "int", 2, 0, 4096, "clocks", "horizontal retrace"),
        Parameter("v_blank", "v_blank", "int", 1, 0, 4096, "lines", "vertical retrace"),
    ),
    arguments=_small_picture,
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 2-1",
    columns=("line", "y", "first clock", "lit"),
    views=(
        View(
            block="Scan the line from left to right",
            row="(line, y, clock - width, lit)",
            sentence="Line {line} shows row {y}: {width} clocks, on {lit} of them the beam is on.",
        ),
        View(
            block="Fly back to the left with the beam off",
            sentence="The beam flies back for {h_blank} clocks and paints nothing.",
        ),
        View(
            block="Fly back to the top with the beam off",
            sentence="The beam flies back to the top for {v_blank} lines; one frame took {clock} clocks.",
        ),
    ),
    laws=(
        Law(
            "Every pixel that is not 0 is emitted once, from top to bottom and from left to right.",
            "scanning/test_scanning.py::test_a_raster_visits_each_lit_pixel_once_in_reading_order",
        ),
        Law(
            "A frame takes (width + h_blank)(height + v_blank) clocks, whatever the picture.",
            "scanning/test_scanning.py::test_each_line_of_a_raster_takes_its_clocks_whatever_the_picture",
        ),
    ),
    questions=(10,),
    labs=("Frame buffer and raster scan",),
    next_rung="random_scan",
)
