"""The octree, front to back: space in eight octants, each of them in eight, the nearest drawn first.

waiting     cells that are still to be looked at, the nearest last
cell        the one in hand: its lower left pixel, its side, its depths, the surfaces that may be in it
painted     the pixels that have their colour: what lies behind them is hidden
octant      a part of the cell, by three bits, x y z: the upper half along each axis
seen        the surface that a pixel shows, or NOTHING
"""

from collections.abc import Iterator

import numpy as np

from workbench.algorithms.visibility.octants import (
    EYE_OCTANT,
    all_painted,
    front_to_back,
    nearest_in,
    octant_of,
    whole_cell,
)
from workbench.algorithms.visibility.squares import least_size
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
) -> Iterator[tuple[int, int]]:
    """Divide space into octants and draw them from front to back.

    Args: image, integers (h, w), written in place; vertices (n, 3) in pixels,
    z; faces (m, 3); colours (m,). Emits: (x, y) of each pixel that shows one.
    Source: Hearn and Baker, Computer Graphics, C Version, section 13-9.
    """
    # Begin with a cell that holds all
    height, width = image.shape
    surfaces = surfaces_of(vertices, faces)
    painted = np.zeros((height, width), np.bool_)
    waiting = [whole_cell(surfaces, least_size(width, height))]

    while waiting:
        # Take the nearest cell
        cell = waiting.pop()
        if not cell.members or all_painted(painted, cell):
            continue

        if len(cell.members) > 1 and cell.size > 1:
            # Divide it: the farthest octants wait longest
            octants = front_to_back(EYE_OCTANT)
            while octants:
                waiting.append(octant_of(cell, octants.pop(), surfaces))
            continue

        for y in range(cell.y, min(cell.y + cell.size, height)):
            for x in range(cell.x, min(cell.x + cell.size, width)):
                # Paint the pixel unless something nearer has
                seen = nearest_in(surfaces, cell, x, y)
                if seen != NOTHING and not painted[y, x]:
                    painted[y, x] = True
                    image[y, x] = int(colours[seen])
                    yield x, y
