"""The octree, front to back: space in eight octants, each of them in eight, the nearest drawn first.

waiting     cells that are still to be looked at, the nearest last
few         with so few surfaces in it a cell is drawn: one, or more where there are very many
hidden      whether all pixels of the cell are painted
cell        the one in hand: its lower left pixel, its side, its depths, the surfaces that may be in it
painted     the pixels that have their colour: what lies behind them is hidden
octant      a part of the cell, by three bits, x y z: the upper half along each axis
seen        the surface that a pixel shows, or NOTHING
"""

from collections.abc import Iterator

import numpy as np

from workbench.algorithms.counted import Counted, Kept
from workbench.algorithms.entry import Entry, Law
from workbench.algorithms.visibility.boxes import extents_of
from workbench.algorithms.visibility.octants import (
    EYE_OCTANT,
    all_painted,
    enough,
    front_to_back,
    nearest_in,
    octant_of,
    whole_cell,
)
from workbench.algorithms.visibility.octree_views import COLUMNS, VIEW_FUNCTIONS, VIEWS
from workbench.algorithms.visibility.squares import least_size
from workbench.algorithms.visibility.surface_marks import square_marks
from workbench.algorithms.visibility.surface_scene import ONE_PICTURE, SURFACES, surfaces_at_will
from workbench.algorithms.visibility.surfaces import (
    NOTHING,
    Colours,
    Picture,
    Triangles,
    Vertices,
    surfaces_of,
)


def octree(
    image: Picture, vertices: Vertices, faces: Triangles, colours: Colours
) -> Iterator[tuple[int, int, int]]:
    """Divide space into octants and draw them from front to back.

    Args: image, integers (h, w), written in place; vertices (n, 3) in pixels,
    z; faces (m, 3); colours (m,). Emits: (x, y, surface) of each pixel.
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-9.
    """
    # Begin with a cell that holds everything
    height, width = image.shape
    surfaces = surfaces_of(vertices, faces)
    extents, few = extents_of(surfaces), enough(surfaces)
    painted = np.zeros((height, width), np.bool_)
    waiting = [whole_cell(surfaces, least_size(width, height))]

    while waiting:
        # Take the nearest cell
        cell = waiting.pop()
        hidden = all_painted(painted, cell)
        if hidden or not cell.members:
            continue

        if len(cell.members) > few and cell.size > 1:
            # Divide it: the farthest octants wait longest
            octants = front_to_back(EYE_OCTANT)
            while octants:
                waiting.append(octant_of(cell, octants.pop(), extents))
            continue

        for y in range(cell.y, min(cell.y + cell.size, height)):
            for x in range(cell.x, min(cell.x + cell.size, width)):
                # Paint the pixel unless something nearer has
                seen = NOTHING
                if not painted[y, x]:
                    seen = nearest_in(surfaces, cell, x, y)
                if seen != NOTHING:
                    painted[y, x] = True
                    image[y, x] = int(colours[seen])
                    yield x, y, seen


ENTRY = Entry(
    function=octree,
    topic="visibility",
    title="Octree",
    summary="Divides space into octants as often as needed and draws them front to back, each pixel once.",
    parameters=SURFACES,
    arguments=surfaces_at_will,
    emits="pixels",
    emitted_columns=("x", "y", "surface"),
    source="Hearn and Baker, Computer Graphics, C Version, section 13-9",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        ONE_PICTURE._replace(proof="visibility/test_one_picture.py::test_the_octree_gives_it_too"),
        Law(
            "From octant 5 an eye sees 5 first, then 4, 7 and 1, then 6, 0 and 3, and 2 last.",
            "visibility/test_octree.py::test_the_octants_from_front_to_back",
        ),
    ),
    not_laws=("It needs a comparison of depths between cells: their order alone tells what hides what.",),
    works_in="object and image space",
    questions=(7,),
    labs=("Hidden surfaces: octree",),
    tie="Of equal depths the lower number is taken",
    writes="image",
    marks=square_marks,
    stack="waiting",
    counted={"cells divided": Counted("cell divided", ("Divide",), "divided")},
    keeps={
        "flags": Kept("flag", "image.size"),
        "cells": Kept("cell", "7 * (max(image.shape) - 1).bit_length() + 1"),
    },
)
