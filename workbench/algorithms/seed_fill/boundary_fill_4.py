"""The boundary fill with a stack, 4-connected.

stack       pixels that are coloured and whose neighbours are still to be looked at
colour      what the neighbour is now; beyond the edge of the picture counts as boundary
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Parameter, View
from workbench.algorithms.seed_fill.example import RING


def boundary_fill_4(
    image: NDArray[Any], x: int, y: int, fill: int, boundary: int
) -> Iterator[tuple[int, int]]:
    """Colour everything that can be reached from a seed by steps along rows and columns, up to a boundary.

    A pixel is tested before it is pushed, so it is coloured once and pushed once.

    Args: image, integers (h, w), written in place; the seed; the colour to fill with; the colour that
    stops it. Emits: (x, y) of each pixel coloured. A seed outside the picture, on the boundary or filled
    colours nothing. Source: Hearn and Baker, Computer Graphics, C Version, section 3-11, with a stack for
    its recursion.
    """
    # Test the seed
    height, width = image.shape
    colour = np.int64(boundary)
    if 0 <= x < width and 0 <= y < height:
        colour = np.int64(image[y, x])
    if colour in (boundary, fill):
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
            colour = np.int64(boundary)
            if 0 <= next_x < width and 0 <= next_y < height:
                colour = np.int64(image[next_y, next_x])

            # Colour it and push it, unless it is boundary or filled
            if colour != boundary and colour != fill:
                image[next_y, next_x] = fill
                stack.append((next_x, next_y))
                yield next_x, next_y


_PIXEL = "((next_x, next_y),)"
_STACK = {"Stack": ("stack", ("x", "y"))}
_DECIDE = "Colour it and push it, unless it is boundary or filled"

ENTRY = Entry(
    function=boundary_fill_4,
    topic="seed_fill",
    title="Boundary fill, 4-connected",
    summary="Colours outwards from a seed until the boundary stops it, with its own stack for the recursion.",
    parameters=(
        Parameter("image", "image", "image", RING, meaning="the picture, filled in place"),
        Parameter("x", "x", "int", 5, 0, 32767, "px", "seed, column"),
        Parameter("y", "y", "int", 5, 0, 32767, "px", "seed, row"),
        Parameter("fill", "fill", "colour", 2, 0, 0xFFFFFF, meaning="colour to fill with"),
        Parameter("boundary", "boundary", "colour", 1, 0, 0xFFFFFF, meaning="colour that stops the fill"),
    ),
    emits="pixels",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    columns=("pixel", "neighbour", "its colour", "pushed", "stack"),
    views=(
        View(
            block="Test the seed",
            when="colour == boundary or colour == fill",
            rejected="((x, y),)",
            considers="(x, y)",
            sentence="The seed {(x, y)} has colour {colour}, so there is nothing to fill.",
        ),
        View(
            block="Test the seed", considers="(x, y)", sentence="The seed {(x, y)} has colour {colour}: go."
        ),
        View(block="Colour the seed and push it", chosen="((x, y),)", tables=_STACK),
        View(
            block="Take a pixel from the stack",
            tables=_STACK,
            sentence="Take {(x, y)} from the stack; {len(stack)} are left.",
        ),
        View(
            block=_DECIDE,
            when="colour == boundary",
            candidates=_PIXEL,
            rejected=_PIXEL,
            row="((x, y), (next_x, next_y), colour, 0, len(stack))",
            tables=_STACK,
            considers="(next_x, next_y)",
            sentence="{(next_x, next_y)} beside {(x, y)} is boundary: leave it.",
        ),
        View(
            block=_DECIDE,
            when="colour == fill",
            candidates=_PIXEL,
            rejected=_PIXEL,
            row="((x, y), (next_x, next_y), colour, 0, len(stack))",
            tables=_STACK,
            considers="(next_x, next_y)",
            sentence="{(next_x, next_y)} beside {(x, y)} has been filled already: leave it.",
        ),
        View(
            block=_DECIDE,
            candidates=_PIXEL,
            chosen=_PIXEL,
            row="((x, y), (next_x, next_y), colour, 1, len(stack))",
            tables=_STACK,
            considers="(next_x, next_y)",
            sentence="{(next_x, next_y)} beside {(x, y)} has colour {colour}, neither boundary nor "
            "filled: colour it and push it, {len(stack)} on the stack.",
        ),
    ),
    laws=(
        "What is coloured is the 4-connected region of the seed among all that is neither boundary nor "
        "filled.",
        "Each pixel is coloured once.",
        "Nothing is read or written outside the picture.",
    ),
    not_laws=(
        "It finds its way through a boundary of pixels that touch only at corners: 8-connected it would.",
    ),
    questions=(3,),
    labs=("Boundary fill",),
    writes="image",
)
