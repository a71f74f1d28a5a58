"""Raster scan: the beam sweeps over the whole frame buffer, line after line.

image           the frame buffer: the bits of each pixel
table           the colour table, 0xRRGGBB; without one the bits are the colour itself
line, field     number of the line, from the top, and of the field; interlaced, a frame has two fields
x, y            the x and the y register: the pixel that is fetched
address         of this pixel in the frame buffer; row 0, at the bottom, begins at address 0
bits, colour    what stands there, and the colour that the table has for it
x_mm, y_mm      where the beam is on the tube, from the middle of the picture
clock           pixel clocks since the frame began; it runs on while the beam is off
lit             pixels of this line on which the beam was on
"""

from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.scanning.raster_marks import hexadecimal, places, raster_marks


def raster_scan(
    image: NDArray[Any],
    table: NDArray[Any],
    h_blank: int,
    v_blank: int,
    fields: int,
    width_mm: float,
    height_mm: float,
) -> Iterator[tuple[int, int]]:
    """Emit each lit pixel in the order in which the beam reaches it.

    Args: a frame buffer (h, w); a colour table (n,), 0xRRGGBB; the pixel
    clocks of a horizontal retrace; the lines of the vertical one; the
    fields of a frame, 2 where it is interlaced; the size of the picture on
    the tube. Emits: (x, y).
    Source: Hearn and Baker, Computer Graphics, C Version, section 2-1.
    """
    # Begin a frame at the top left
    height, width = image.shape
    line_clocks = width + h_blank
    clock = 0

    for field in range(fields):
        for line in range(field, height, fields):
            # Set the y register to the row of this line
            y = height - 1 - line
            address = y * width
            y_mm = ((y + 0.5) / height - 0.5) * height_mm
            lit = 0

            for x in range(width):
                # Fetch the bits of the pixel
                address = y * width + x
                bits = np.int64(image[y, x])

                # Look up their colour
                colour = bits
                if bits < len(table):
                    colour = np.int64(table[bits])

                # Send red, green and blue to the beam
                x_mm = ((x + 0.5) / width - 0.5) * width_mm
                red = colour // 65536
                green = colour // 256 % 256
                blue = colour % 256
                if red + green + blue > 0:
                    lit += 1
                    yield x, y
                clock += 1

            # Fly back to the left with the beam off
            clock += h_blank

        # Fly back to the top with the beam off
        lines = (field + 1) * (height + v_blank)
        clock = (lines + fields - 1) // fields * line_clocks


_PICTURE = np.array(
    [
        [0, 1, 1, 1, 1, 0],
        [0, 2, 0, 0, 2, 0],
        [0, 1, 1, 1, 1, 0],
        [3, 0, 0, 0, 0, 3],
    ]
)
_TABLE = np.array([0x000000, 0x00FF00, 0xFF8800, 0xFFFFFF])


def _small_picture(chance: Random) -> tuple[Any, ...]:
    """A frame buffer of one pixel or more, some of it or all of it dark, with retraces or without.

    The table may be empty, too short, or have dark entries.
    """
    height, width, colours = chance.randint(1, 6), chance.randint(1, 8), chance.randint(0, 3)
    rows = [[chance.randint(0, colours) for _column in range(width)] for _row in range(height)]
    table = [chance.choice((0, 1, 0xFF8800, 0xFFFFFF)) for _entry in range(chance.randint(0, 4))]
    blanks = chance.randint(0, 5), chance.randint(0, 5)
    return (
        np.array(rows),
        np.array(table, np.int64),
        *blanks,
        chance.randint(1, 2),
        12.0,
        chance.uniform(1.0, 9.0),
    )


ENTRY = Entry(
    function=raster_scan,
    topic="scanning",
    title="Raster scan",
    summary="The beam visits every pixel in order, whatever the picture, and flies back dark.",
    parameters=(
        Parameter("image", "image", "image", _PICTURE, meaning="frame buffer: the bits of each pixel"),
        Parameter("table", "table", "ints", _TABLE, meaning="colour table, 0xRRGGBB; empty: none"),
        Parameter("h_blank", "h_blank", "int", 2, 0, 4096, "clocks", "horizontal retrace"),
        Parameter("v_blank", "v_blank", "int", 1, 0, 4096, "lines", "vertical retrace"),
        Parameter("fields", "fields", "int", 1, 1, 2, "", "fields of a frame, 2: interlaced"),
        Parameter("width_mm", "width_mm", "float", 60.0, 0.0, 10000.0, "mm", "width on the tube"),
        Parameter("height_mm", "height_mm", "float", 40.0, 0.0, 10000.0, "mm", "height on the tube"),
    ),
    arguments=_small_picture,
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 2-1",
    columns=("field", "line", "y", "first address", "first clock", "y (mm)"),
    views=(
        View(
            block="Set the y register to the row of this line",
            row="(field, line, y, address, clock, y_mm)",
            sentence="Line {line} shows row {y}: addresses {address} to {address + width - 1}, "
            "clocks {clock} to {clock + width - 1}, with the beam at y = {y_mm} mm.",
        ),
        View(
            block="Fetch the bits of the pixel",
            candidates="((x, y),)",
            sentence="Pixel {(x, y)} stands at address {y} * {width} + {x} = {address}; its bits are {bits}.",
        ),
        View(
            block="Look up their colour",
            when="bits < len(table)",
            sentence="Entry {bits} of the colour table is {hexadecimal(colour)}.",
        ),
        View(
            block="Look up their colour",
            sentence="There is no entry {bits} in a colour table, so the bits are the colour: "
            "{hexadecimal(colour)}.",
        ),
        View(
            block="Send red, green and blue to the beam",
            when="red + green + blue > 0",
            sentence="Red {red}, green {green} and blue {blue} drive the beam at {places(x_mm, y_mm)} mm.",
        ),
        View(
            block="Send red, green and blue to the beam",
            sentence="Black leaves the beam off at {places(x_mm, y_mm)} mm.",
        ),
        View(
            block="Fly back to the left with the beam off",
            sentence="The beam was on for {lit} of {width} pixels; it flies back for {h_blank} clocks and "
            "paints nothing.",
        ),
        View(
            block="Fly back to the top with the beam off",
            when="fields == 2 and field == 0",
            sentence="The first field, every second line, ends at clock {clock}; the beam flies back to the "
            "top for the lines between.",
        ),
        View(
            block="Fly back to the top with the beam off",
            sentence="The beam flies back to the top; the frame of {height + v_blank} lines took {clock} "
            "clocks.",
        ),
    ),
    view_functions=(hexadecimal, places),
    marks=raster_marks,
    laws=(
        Law(
            "Every pixel that is not black is emitted once; with one field from top to bottom and from left "
            "to right.",
            "scanning/test_scanning.py::test_a_raster_visits_each_lit_pixel_once_in_reading_order",
        ),
        Law(
            "A frame takes (width + h_blank)(height + v_blank) clocks, whatever the picture.",
            "scanning/test_scanning.py::test_each_line_of_a_raster_takes_its_clocks_whatever_the_picture",
        ),
        Law(
            "Interlaced, a frame shows the lines 0, 2, 4, ... and then 1, 3, 5, ..., each once.",
            "scanning/test_scanning.py::test_two_fields_show_every_second_line_and_then_the_others",
        ),
    ),
    questions=(6, 10),
    labs=("Frame buffer and raster scan",),
    next_rung="random_scan",
)
