"""Warnock's area subdivision: a square that is too hard to decide is divided into four.

waiting     squares that are still to be decided
square      the one in hand: its lower left pixel, its size, the surfaces that may be in it
seen        the surfaces that are not outside of it, and how each lies to it
SURROUNDING, OVERLAPPING, INSIDE, OUTSIDE   the four relations of a surface to a square
number      the surface that decides a square
"""

from collections.abc import Iterator

from workbench.algorithms.counted import Counted, Kept
from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.visibility.squares import (
    OUTSIDE,
    Seen,
    Square,
    hiding,
    least_size,
    nearest_at,
    paint_in,
    relation,
)
from workbench.algorithms.visibility.subdivision_views import COLUMNS, VIEW_FUNCTIONS, VIEWS
from workbench.algorithms.visibility.surface_marks import square_marks
from workbench.algorithms.visibility.surface_scene import ONE_PICTURE, SURFACES, surfaces_at_will
from workbench.algorithms.visibility.surfaces import (
    NOTHING,
    Colours,
    Picture,
    Triangles,
    Vertices,
    in_view,
    surfaces_of,
)


def area_subdivision(
    image: Picture, vertices: Vertices, faces: Triangles, colours: Colours
) -> Iterator[tuple[int, int, int, int]]:
    """Divide the picture into squares until each is easy to decide.

    Args: image, integers (h, w), written in place; vertices (n, 3) in pixels,
    z; faces (m, 3); colours (m,). Emits: (y, x_left, x_right, surface).
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-8.
    """
    # Begin with a square that holds the whole picture
    height, width = image.shape
    surfaces = surfaces_of(vertices, faces)
    waiting = [Square(0, 0, least_size(width, height), in_view(surfaces))]

    while waiting:
        # Take a square
        square = waiting.pop()
        x, y, size, members = square
        if x >= width or y >= height:
            continue

        # Find the relation of each surface to the square
        lying = [Seen(k, relation(surfaces[k], square)) for k in members]
        seen = [one for one in lying if one.relation != OUTSIDE]

        # Rule 1: all surfaces are outside
        if not seen:
            continue
        # Rule 2: only one surface is not
        number = seen[0].number
        if len(seen) == 1:
            yield from paint_in(square, image, surfaces, number, colours)
            continue
        # Rule 3: a surrounding surface hides all others
        number = hiding(surfaces, seen, square)
        if number != NOTHING:
            yield from paint_in(square, image, surfaces, number, colours)
            continue

        # At the size of a pixel its centre decides
        if size == 1:
            number = nearest_at(surfaces, seen, x, y)
            if number != NOTHING:
                image[y, x] = int(colours[number])
                yield y, x, x, number
            continue

        # Divide the square into four
        half, members = size // 2, [one.number for one in seen]
        waiting.append(Square(x + half, y, half, members))
        waiting.append(Square(x, y, half, members))
        waiting.append(Square(x + half, y + half, half, members))
        waiting.append(Square(x, y + half, half, members))


ENTRY = Entry(
    function=area_subdivision,
    topic="visibility",
    title="Area subdivision",
    summary="Divides the picture into squares until each is easy: empty, of one surface, or hidden by one.",
    parameters=SURFACES,
    arguments=surfaces_at_will,
    emits="spans",
    emitted_columns=("y", "x_left", "x_right", "surface"),
    source="Warnock, A Hidden Surface Algorithm for Computer Generated Halftone Pictures, 1969; Hearn and "
    "Baker, Computer Graphics, C Version, section 13-8",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        ONE_PICTURE,
        Law(
            "No pixel is painted twice, and every pixel that a surface covers is painted.",
            "visibility/test_squares.py::test_each_pixel_is_painted_once",
        ),
    ),
    not_laws=(
        "A square of one pixel can always be decided by the three rules: there the nearest at its centre is "
        "taken, whatever else is in it.",
    ),
    works_in="image space",
    questions=(7,),
    labs=("Hidden surfaces: area subdivision",),
    tie="Of equal depths the lower number is taken",
    writes="image",
    marks=square_marks,
    stack="waiting",
    counted={"squares divided": Counted("square divided", ("Divide",), "divided")},
    keeps={"squares": Kept("square", "3 * (max(image.shape) - 1).bit_length() + 1")},
)
