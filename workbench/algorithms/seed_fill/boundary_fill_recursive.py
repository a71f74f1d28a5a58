"""The boundary fill as the course writes it: it calls itself for the four neighbours.

current     what the pixel is now; beyond the edge of the picture counts as boundary
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import CALLS, Entry, Law, View
from workbench.algorithms.seed_fill.example import BOUNDED, picture_seed_and_boundary
from workbench.algorithms.seed_fill.pixels import get_pixel, is_in
from workbench.algorithms.seed_fill.waiting_marks import call_marks


def boundary_fill_recursive(
    image: NDArray[Any], x: int, y: int, fill: int, boundary: int
) -> Iterator[tuple[int, int]]:
    """Colour a pixel unless it is boundary or filled, then do the same from its four neighbours.

    The calls nest as deep as the path that the fill takes is long: a large area overflows the call stack.

    Args: image, integers (h, w), written in place; the pixel; the colour to fill with; the colour that stops
    it. Emits: (x, y) of each pixel coloured. Raises RecursionError when the calls nest too deep.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-11.
    """
    # Test the pixel and colour it, unless it is boundary or filled
    current = get_pixel(image, x, y, boundary)
    if current != boundary and current != fill:
        image[y, x] = fill
        yield x, y

        # Call itself for the neighbour on the right
        yield from boundary_fill_recursive(image, x + 1, y, fill, boundary)

        # Call itself for the neighbour on the left
        yield from boundary_fill_recursive(image, x - 1, y, fill, boundary)

        # Call itself for the neighbour above
        yield from boundary_fill_recursive(image, x, y + 1, fill, boundary)

        # Call itself for the neighbour below
        yield from boundary_fill_recursive(image, x, y - 1, fill, boundary)


_PIXEL = "((x, y),)"
_TEST = "Test the pixel and colour it, unless it is boundary or filled"

ENTRY = Entry(
    function=boundary_fill_recursive,
    topic="seed_fill",
    title="Boundary fill, recursive",
    summary="Calls itself for the four neighbours; simple, until the calls nest too deep.",
    parameters=BOUNDED,
    arguments=picture_seed_and_boundary,
    draws=("seed_fill",),
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    columns=("pixel", "its colour", "coloured"),
    view_functions=(is_in,),
    views=(
        View(
            block=_TEST,
            when="not is_in(image, x, y)",
            candidates=_PIXEL,
            rejected=_PIXEL,
            row="((x, y), current, 0)",
            considers="(x, y)",
            sentence="{(x, y)} is outside the picture, which counts as boundary: this call returns at once.",
        ),
        View(
            block=_TEST,
            when="current == boundary",
            candidates=_PIXEL,
            rejected=_PIXEL,
            row="((x, y), current, 0)",
            considers="(x, y)",
            sentence="{(x, y)} is boundary: this call returns at once.",
        ),
        View(
            block=_TEST,
            when="current == fill",
            candidates=_PIXEL,
            rejected=_PIXEL,
            row="((x, y), current, 0)",
            considers="(x, y)",
            sentence="{(x, y)} has been filled already: this call returns at once.",
        ),
        View(
            block=_TEST,
            candidates=_PIXEL,
            chosen=_PIXEL,
            row="((x, y), current, 1)",
            considers="(x, y)",
            sentence="{(x, y)} has colour {current}, neither boundary nor filled: colour it, then call again "
            "for its right, left, upper and lower neighbours.",
        ),
    ),
    laws=(
        Law(
            "The pixels are those of the boundary fill with a stack, 4-connected.",
            "seed_fill/test_regions.py::test_boundary_fills_colour_the_region_of_the_seed",
        ),
        Law(
            "Each pixel is coloured once.",
            "seed_fill/test_regions.py::test_boundary_fills_colour_the_region_of_the_seed",
        ),
        Law(
            "Nothing is read or written outside the picture.",
            "seed_fill/test_regions.py::test_nothing_is_read_or_written_outside_the_picture",
        ),
    ),
    not_laws=("Any area can be filled: the calls nest up to once for each of its pixels.",),
    questions=(3,),
    labs=("Boundary fill",),
    next_rung="boundary_fill_4",
    writes="image",
    marks=call_marks,
    stack=CALLS,
    compiles="It calls itself once for each pixel on its way: compiled, a large area would end the program "
    "instead of showing the overflow, so it is stepped only.",
)
