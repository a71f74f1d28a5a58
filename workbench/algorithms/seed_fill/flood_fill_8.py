"""The flood fill with a stack, 8-connected.

stack       pixels that are coloured and whose neighbours are still to be looked at
old         the seed's colour, which the fill replaces
colour      what the neighbour is now; beyond the edge of the picture counts as filled
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.seed_fill.example import FLOOD, picture_and_seed
from workbench.algorithms.seed_fill.neighbours import EIGHT_STEPS
from workbench.algorithms.seed_fill.pixels import get_pixel, is_in
from workbench.algorithms.seed_fill.regions import flooded_8
from workbench.algorithms.seed_fill.stack_views import COLUMNS, FLOOD_VIEWS
from workbench.algorithms.seed_fill.waiting_marks import stack_marks


def flood_fill_8(image: NDArray[Any], x: int, y: int, fill: int) -> Iterator[tuple[int, int]]:
    """Give a new colour to all that has the seed's and can be reached by steps to all eight neighbours.

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

        for step_x, step_y in EIGHT_STEPS:
            # Look at a neighbour
            next_x = x + step_x
            next_y = y + step_y
            colour = get_pixel(image, next_x, next_y, fill)

            # Colour it and push it, if it has the seed's old colour
            if colour == old:
                image[next_y, next_x] = fill
                stack.append((next_x, next_y))
                yield next_x, next_y


ENTRY = Entry(
    function=flood_fill_8,
    topic="seed_fill",
    title="Flood fill, 8-connected",
    summary="Replaces the colour of a region, going to the corners too.",
    parameters=FLOOD,
    arguments=picture_and_seed,
    draws=("seed_fill",),
    at_once=flooded_8,
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    columns=COLUMNS,
    views=FLOOD_VIEWS,
    view_functions=(is_in,),
    laws=(
        Law(
            "What is coloured is the 8-connected region of the seed among all pixels of its colour.",
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
    not_laws=("A region of one colour ends where its pixels touch only at corners: 4-connected it would.",),
    questions=(3,),
    labs=("Flood fill",),
    next_rung="boundary_fill_spans",
    writes="image",
    marks=stack_marks,
    stack="stack",
)
