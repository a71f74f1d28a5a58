"""The flood fill with a stack, 4-connected.

stack       pixels that are coloured and whose neighbours are still to be looked at
old         the seed's colour, which the fill replaces
colour      what the neighbour is now; beyond the edge of the picture counts as filled
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.seed_fill.example import FLOOD, picture_and_seed
from workbench.algorithms.seed_fill.pixels import get_pixel, is_in
from workbench.algorithms.seed_fill.regions import flooded_4
from workbench.algorithms.seed_fill.stack_views import COLUMNS, FLOOD_VIEWS
from workbench.algorithms.seed_fill.waiting_marks import stack_marks


def flood_fill_4(image: NDArray[Any], x: int, y: int, fill: int) -> Iterator[tuple[int, int]]:
    """Give a new colour to all that has the seed's and can be reached by steps along rows and columns.

    A pixel is tested before it is pushed, so it is coloured once and pushed once.

    Args: image, integers (h, w), written in place; the seed; the colour to fill with. Emits: (x, y) of each
    pixel coloured. A seed outside the picture or of the fill's own colour colours nothing.
    Source: Hearn and Baker, Computer Graphics, C Version, section 3-11, with a stack for its recursion.
    """
    # Test the seed
    old = get_pixel(image, x, y, fill)
    if old == fill:
        return

    # Colour the seed and push it
    image[y, x] = fill
    stack = [(x, y)]
    yield x, y

    while stack:
        # Take a pixel from the stack
        x, y = stack.pop()

        for next_x, next_y in ((x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)):
            # Look at a neighbour
            colour = get_pixel(image, next_x, next_y, fill)

            # Colour it and push it, if it has the seed's old colour
            if colour == old:
                image[next_y, next_x] = fill
                stack.append((next_x, next_y))
                yield next_x, next_y


ENTRY = Entry(
    function=flood_fill_4,
    topic="seed_fill",
    title="Flood fill, 4-connected",
    summary="Replaces the colour of a whole region, whatever colours stand around it.",
    parameters=FLOOD,
    arguments=picture_and_seed,
    draws=("seed_fill",),
    at_once=flooded_4,
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    columns=COLUMNS,
    views=FLOOD_VIEWS,
    view_functions=(is_in,),
    laws=(
        Law(
            "What is coloured is the 4-connected region of the seed among all pixels of its colour.",
            "seed_fill/test_regions.py::test_flood_fills_colour_the_region_of_the_seed_s_colour",
        ),
        Law(
            "Each pixel is coloured once.",
            "seed_fill/test_regions.py::test_flood_fills_colour_the_region_of_the_seed_s_colour",
        ),
        Law(
            "Nothing is read or written outside the picture.",
            "seed_fill/test_regions.py::test_nothing_is_read_or_written_outside_the_picture",
        ),
    ),
    not_laws=(
        "It stops at one colour, the boundary: it stops at every colour but the one that it replaces.",
    ),
    questions=(3,),
    labs=("Flood fill",),
    next_rung="flood_fill_8",
    writes="image",
    marks=stack_marks,
    stack="stack",
)
