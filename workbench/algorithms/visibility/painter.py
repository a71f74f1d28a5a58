"""The painter's algorithm: from back to front, each surface over what is there.

surfaces    the triangles on the device
order       their numbers, the one with the greatest depth first
rank        place in that order
number      the surface that is painted
"""

from collections.abc import Iterator

from workbench.algorithms.counted import Kept
from workbench.algorithms.entry import Entry, Law, View
from workbench.algorithms.visibility.painting import farthest_first, paint_surface
from workbench.algorithms.visibility.surface_marks import marks, surface_mark
from workbench.algorithms.visibility.surface_scene import SURFACES, surfaces_at_will
from workbench.algorithms.visibility.surface_words import listed
from workbench.algorithms.visibility.surfaces import (
    Colours,
    Picture,
    Surface,
    Triangles,
    Vertices,
    farthest_z,
    nearest_z,
    surfaces_of,
)


def painter(
    image: Picture, vertices: Vertices, faces: Triangles, colours: Colours
) -> Iterator[tuple[int, int, int, int]]:
    """Paint from the farthest surface to the nearest, as one paints in oil.

    The order is that of their greatest depths, whole surfaces at a time.

    Args: image, integers (h, w), written in place; vertices (n, 3): x and y
    in pixels, z; faces (m, 3): numbers of vertices; colours (m,).
    Emits: (y, x_left, x_right, surface).
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-6.
    """
    # Sort the surfaces by their greatest depth
    surfaces = surfaces_of(vertices, faces)
    order = farthest_first(surfaces)

    for rank in range(len(order)):
        # Paint the next one over what is there
        number = order[rank]
        yield from paint_surface(image, surfaces, number, colours)


def overlapped(surfaces: list[Surface], order: list[int], rank: int) -> list[int]:
    """The surfaces painted before whose depths overlap those of the one with this rank."""
    here = surfaces[order[rank]]
    return [number for number in order[:rank] if nearest_z(surfaces[number]) < farthest_z(here)]


def order_rows(surfaces: list[Surface], order: list[int]) -> list[tuple[int, float, float]]:
    """The order: surface, least and greatest depth."""
    return [(n, nearest_z(surfaces[n]), farthest_z(surfaces[n])) for n in order]


_PAINT = "Paint the next one over what is there"


def _paint_view(when: str, sentence: str) -> View:
    return View(
        block=_PAINT,
        when=when,
        row="(rank + 1, number, nearest_z(surfaces[number]), farthest_z(surfaces[number]), "
        "listed(overlapped(surfaces, order, rank)))",
        tables={"Order": ("order_rows(surfaces, order)", ("surface", "least z", "greatest z"))},
        options="tuple(sorted(order[rank : rank + 5]))",
        answer="number",
        marks="(surface_mark(surfaces[number]),)",
        sentence=sentence,
    )


ENTRY = Entry(
    function=painter,
    topic="visibility",
    title="Painter's algorithm",
    summary="Sorts whole surfaces by their greatest depth, and paints them from back to front.",
    parameters=SURFACES,
    arguments=surfaces_at_will,
    emits="spans",
    emitted_columns=("y", "x_left", "x_right", "surface"),
    source="Hearn and Baker, Computer Graphics, C Version, section 13-6",
    columns=("rank", "surface", "least z", "greatest z", "depths overlap those of"),
    view_functions=(order_rows, overlapped, surface_mark, nearest_z, farthest_z, listed),
    views=(
        View(
            block="Sort the surfaces by their greatest depth",
            sentence="{len(order)} surfaces in order of their greatest depths, the farthest first.",
        ),
        _paint_view(
            "rank == 0",
            "Surface {number} reaches farthest, to z = {farthest_z(surfaces[number])}: it is painted first.",
        ),
        _paint_view(
            "not overlapped(surfaces, order, rank)",
            "Surface {number} is next, z = {farthest_z(surfaces[number])} at its farthest: in front of all "
            "that is painted, so it may cover any of it.",
        ),
        _paint_view(
            "True",
            "Surface {number} is next, z = {farthest_z(surfaces[number])} at its farthest. Its depths "
            "overlap those of {listed(overlapped(surfaces, order, rank))}: nothing proves that this order is "
            "right.",
        ),
    ),
    laws=(
        Law(
            "Each pixel shows, of the surfaces that cover it, the one whose greatest depth is least.",
            "visibility/test_painters.py::test_the_painter_shows_the_surface_whose_greatest_depth_is_least",
        ),
        Law(
            "Where no two surfaces overlap in depth it paints the picture of the depth buffer.",
            "visibility/test_painters.py::test_layers_are_painted_as_by_the_depth_buffer",
        ),
    ),
    not_laws=(
        "What is farther at its farthest corner is farther everywhere: surfaces that pierce one another, or "
        "overlap in a cycle, have no order at all.",
    ),
    works_in="object and image space",
    questions=(7,),
    labs=("Hidden surfaces: painter's algorithm",),
    next_rung="depth_sort",
    tie="Of equal depths the lower number is painted last, and stays",
    writes="image",
    keeps={"surfaces": Kept("surface", "len(faces)")},
    fails_where="the depths of surfaces overlap, so that their farthest corners do not tell which is nearer",
    marks=marks,
)
