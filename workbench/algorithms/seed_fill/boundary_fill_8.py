"""The boundary fill with a stack, 8-connected.

stack       pixels that are coloured and whose neighbours are still to be looked at
colour      what the neighbour is now; beyond the edge of the picture counts as boundary
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.seed_fill.example import BOUNDED, picture_seed_and_boundary
from workbench.algorithms.seed_fill.neighbours import EIGHT_STEPS
from workbench.algorithms.seed_fill.pixels import get_pixel, is_in
from workbench.algorithms.seed_fill.regions import bounded_8
from workbench.algorithms.seed_fill.stack_views import BOUNDARY_VIEWS, COLUMNS
from workbench.algorithms.seed_fill.waiting_marks import stack_marks


def boundary_fill_8(
    image: NDArray[Any], x: int, y: int, fill: int, boundary: int
) -> Iterator[tuple[int, int]]:
    """Colour everything that can be reached from a seed by steps to all eight neighbours, up to a boundary.

    A pixel is tested before it is pushed, so it is coloured once and pushed once.

    Args: image, integers (h, w), written in place; the seed; the colour to fill with; the colour that
    stops it. Emits: (x, y) of each pixel coloured. A seed outside the picture, on the boundary or filled
    colours nothing. Source: Hearn and Baker, Computer Graphics, C Version, section 3-11, with a stack for
    its recursion.
    """
    # Test the seed
    colour = get_pixel(image, x, y, boundary)
    if colour in (boundary, fill):
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
            colour = get_pixel(image, next_x, next_y, boundary)

            # Colour it and push it, unless it is boundary or filled
            if colour != boundary and colour != fill:
                image[next_y, next_x] = fill
                stack.append((next_x, next_y))
                yield next_x, next_y


ENTRY = Entry(
    function=boundary_fill_8,
    topic="seed_fill",
    title="Boundary fill, 8-connected",
    summary="Goes to the corners too: it reaches more, and leaks through a boundary that is thin there.",
    parameters=BOUNDED,
    arguments=picture_seed_and_boundary,
    draws=("seed_fill",),
    at_once=bounded_8,
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    columns=COLUMNS,
    views=BOUNDARY_VIEWS,
    view_functions=(is_in,),
    laws=(
        Law(
            "What is coloured is the 8-connected region of the seed among all that is neither boundary "
            "nor filled.",
            "seed_fill/test_regions.py::test_boundary_fills_colour_the_region_of_the_seed",
        ),
        Law(
            "All that the 4-connected fill colours is coloured.",
            "seed_fill/test_regions.py::test_all_that_four_ways_reach_eight_do",
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
    not_laws=("Any closed line of pixels holds it: where they touch only at corners, it leaks.",),
    questions=(3,),
    labs=("Boundary fill",),
    next_rung="flood_fill_4",
    writes="image",
    marks=stack_marks,
    stack="stack",
)
