"""The boundary fill by spans, 4-connected.

stack                       (row, first and last pixel of the span it is looked at from, direction)
span_left, span_right       that span, which is filled already
left, right                 a run of free pixels on the row, to be filled
step                        1 when the row is above that span, -1 when it is below
"""

from collections.abc import Iterator
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.recorded import is_recorded
from workbench.algorithms.seed_fill.example import BOUNDED, picture_seed_and_boundary
from workbench.algorithms.seed_fill.pixels import get_pixel, is_in
from workbench.algorithms.seed_fill.regions import bounded_4
from workbench.algorithms.seed_fill.span_views import COLUMNS, VIEWS, run_text, tested_pixels
from workbench.algorithms.seed_fill.waiting_marks import span_marks


def run_left(row: NDArray[Any], x: int, fill: int, boundary: int) -> int:
    """The first pixel of the run of free pixels that ends at x; x + 1 when x is boundary or filled."""
    while x >= 0 and row[x] != boundary and row[x] != fill:
        x -= 1
    return x + 1


def run_right(row: NDArray[Any], x: int, fill: int, boundary: int) -> int:
    """The last pixel of the run of free pixels that begins at x; x - 1 when x is boundary or filled."""
    while x < len(row) and row[x] != boundary and row[x] != fill:
        x += 1
    return x - 1


def boundary_fill_spans(
    image: NDArray[Any], x: int, y: int, fill: int, boundary: int
) -> Iterator[tuple[int, int, int]]:
    """Colour what the 4-connected boundary fill colours, a whole run of a row at a time.

    Each run looks at the row beyond it, and back only where it reaches further than the span it came from.

    Args: image, integers (h, w), written in place; the seed; the colour to fill with; the colour that stops
    it. Emits: (y, x_left, x_right) of each run coloured, both ends included. A seed outside the picture, on
    the boundary or filled colours nothing. Sources: Hearn and Baker, Computer Graphics, C Version, section
    3-11; Heckbert, A Seed Fill Algorithm, Graphics Gems, 1990.
    """
    # Fill the seed's run and look from it both ways
    stack: list[tuple[int, int, int, int]] = []
    colour = get_pixel(image, x, y, boundary)
    if colour != boundary and colour != fill:
        left = run_left(image[y], x, fill, boundary)
        right = run_right(image[y], x, fill, boundary)
        image[y, left : right + 1] = fill
        yield y, left, right
        stack.append((y - 1, left, right, -1))
        stack.append((y + 1, left, right, 1))

    while stack:
        # Take a span and a direction from the stack
        y, span_left, span_right, step = stack.pop()
        if not 0 <= y < len(image):
            continue
        row = image[y]

        # Look back where the first run reaches further left than the span
        left = run_left(row, span_left, fill, boundary)
        if left < span_left - 1:
            stack.append((y - step, left, span_left - 2, -step))

        while left <= span_right:
            # Find the end of the run that begins here
            right = run_right(row, left, fill, boundary)

            # Fill the run, if there is one, and push it
            if left <= right:
                row[left : right + 1] = fill
                yield y, left, right
                stack.append((y + step, left, right, step))
                if right > span_right + 1:
                    stack.append((y - step, span_right + 2, right, -step))
            left = right + 2


ENTRY = Entry(
    function=boundary_fill_spans,
    topic="seed_fill",
    title="Boundary fill by spans",
    summary="Colours a whole run of a row at a time: most pixels are tested once, and the stack stays small.",
    parameters=BOUNDED,
    arguments=picture_seed_and_boundary,
    draws=("seed_fill",),
    at_once=bounded_4,
    emits="spans",
    source="Hearn and Baker, Computer Graphics, C Version, section 3-11",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=(is_in, is_recorded, run_text, tested_pixels),
    tests_in=(run_left, run_right),
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
    questions=(3,),
    labs=("Boundary fill",),
    writes="image",
    marks=span_marks,
    stack="stack",
)
