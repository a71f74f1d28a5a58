"""The octree of a solid: a cube is divided into octants, each of them again, while it is filled in part.

nodes       the octree: of each node eight elements, a state or minus the number of the octant's own node
waiting     cells that are still to be looked at, the next one last
cell        the one in hand: its lowest corner, size and level, and its place in the table
state       whether it is EMPTY, FULL or PARTIAL
counts      how many cells of each state there are
least       the volume of the full cells
most        the same with the partial ones: the volume of the solid is between both
"""

from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.counted import Counted, Kept
from workbench.algorithms.entry import Entry, Law, Parameter
from workbench.algorithms.solids.implicit import (
    BLOBS,
    BLOCK,
    CONE,
    CYLINDER,
    ELLIPSOID,
    EMPTY,
    FULL,
    HALF_SPACE,
    PARTIAL,
    TORUS,
    state_of,
)
from workbench.algorithms.solids.octree_cells import corner_of, octants_of
from workbench.algorithms.solids.octree_views import COLUMNS, VIEW_FUNCTIONS, VIEWS, marks

Array = NDArray[Any]


def octree_of_solid(
    shape: int, numbers: Array, inverse: Array, corner: Array, size: float, depth: int
) -> Iterator[tuple[float, float, float, float, int]]:
    """Divide a cube into octants where a solid fills it in part.

    Args: shape, a number of ``implicit``; numbers (k,), its measures; inverse
    (3, 4), from the world into its own coordinates; corner (3,) and size of
    the cube; depth: how often it is divided. Emits: (x, y, z, size, state).
    Source: Hearn and Baker, Computer Graphics, C Version, section 10-16.
    """
    # Divide the whole cube into eight octants
    nodes = [[EMPTY] * 8]
    counts, least, most = [0, 0, 0], 0.0, 0.0
    waiting = octants_of(float(corner[0]), float(corner[1]), float(corner[2]), size, 0, 1)

    while waiting:
        # Compare the next octant with the solid
        cell = waiting.pop()
        state = state_of(shape, numbers, inverse, corner_of(cell), cell.size)

        if state == PARTIAL and cell.level < depth:
            # Divide it: it gets a node of its own
            nodes.append([EMPTY] * 8)
            nodes[cell.node - 1][cell.octant] = -len(nodes)
            waiting.extend(octants_of(cell.x, cell.y, cell.z, cell.size, cell.level, len(nodes)))
            continue

        # Keep what it is in the table
        nodes[cell.node - 1][cell.octant] = state
        counts[state] += 1
        if state == FULL:
            least += cell.size * cell.size * cell.size
        if state != EMPTY:
            most += cell.size * cell.size * cell.size
        yield cell.x, cell.y, cell.z, cell.size, state


def solid_at_will(chance: Random) -> tuple[Any, ...]:
    """Any shape, moved, stretched or turned by a quarter, in a cube that it need not fit into."""
    shape = chance.randint(ELLIPSOID, HALF_SPACE)
    sizes = [chance.randint(1, 8) / 4 for _number in range(3)]
    numbers = {
        ELLIPSOID: sizes,
        TORUS: [sizes[0] + sizes[1], sizes[1] / 2],
        CYLINDER: sizes[:2],
        CONE: sizes[:2],
        BLOCK: sizes,
        BLOBS: [1.0, 0.5, *sizes, *(-each for each in sizes)],
        HALF_SPACE: [*(chance.randint(-2, 2) / 2 for _number in range(3)), sizes[0] - 1.0],
    }[shape]
    inverse = np.roll(np.eye(3), chance.randint(0, 2), axis=0) * chance.choice((1.0, 2.0, -0.5))
    inverse = np.column_stack([inverse, [chance.randint(-4, 4) / 4 for _axis in range(3)]])
    corner = np.array([chance.randint(-8, 0) / 4 for _axis in range(3)])
    return shape, np.array(numbers), inverse, corner, chance.randint(4, 16) / 4, chance.randint(1, 3)


ENTRY = Entry(
    function=octree_of_solid,
    topic="solids",
    title="Octree of a solid",
    summary="Divides a cube into octants, and again those that the solid fills in part, down to a depth.",
    parameters=(
        Parameter("shape", "shape", "int", ELLIPSOID, 0, 6, meaning="which equation its surface has"),
        Parameter("numbers", "numbers", "floats", np.ones(3), meaning="the measures in the equation"),
        Parameter(
            "inverse",
            "inverse",
            "matrix",
            np.eye(3, 4),
            meaning="from the world into the coordinates of the solid",
        ),
        Parameter("corner", "corner", "floats", -np.ones(3), meaning="lowest corner of the cube"),
        Parameter("size", "size", "float", 2.0, 1e-6, 1e9, "world", "side of the cube"),
        Parameter("depth", "depth", "int", 2, 1, 6, meaning="how often the cube is divided at most"),
    ),
    arguments=solid_at_will,
    emits="cubes",
    source="Hearn and Baker, Computer Graphics, C Version, section 10-16; Meagher, Geometric Modeling Using "
    "Octree Encoding, 1982",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        Law(
            "The cells fill the cube, and each point of the solid is in a full cell or in a partial one.",
            "solids/test_octree_of_solid.py::test_cells_fill_the_cube_and_hold_the_solid",
        ),
        Law(
            "The volume of the solid is between that of the full cells and that of all that are not empty.",
            "solids/test_octree_of_solid.py::test_the_volume_is_between_the_bounds",
        ),
        Law(
            "Divided once more, the least volume does not fall and the most does not rise.",
            "solids/test_octree_of_solid.py::test_deeper_the_bounds_come_nearer",
        ),
    ),
    not_laws=(
        "Twice as fine takes eight times the cells: only those at the surface are divided, about four times.",
        "A cell that is called partial holds some of the surface: of blobs and turned solids a bound can be "
        "too wide, and the cell may be full or empty.",
    ),
    labs=("Octrees of solids",),
    marks=marks,
    frame="world",
    stack="waiting",
    counted={"cells divided": Counted("cell divided", ("Divide it",), "divided")},
    keeps={"nodes": Kept("node", "1 + counted['cells divided']")},
)
