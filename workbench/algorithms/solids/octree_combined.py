"""Two octrees of one cube made into one: what both hold, what either holds, what only the first holds.

pairs       octants of both that are still to be looked at, the next one last
pair        the one in hand: its cube, and the element of either octree: a state, or minus a node
state       what it is in the result, or GO_IN where that is found further down
counts      how many cells of each state there are
least, most     the volume of the full cells, and with the partial ones
"""

from collections.abc import Iterator
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.counted import Counted
from workbench.algorithms.entry import Entry, Law, Parameter
from workbench.algorithms.solids.combined_views import COLUMNS, VIEW_FUNCTIONS, VIEWS, marks
from workbench.algorithms.solids.implicit import ELLIPSOID, EMPTY, FULL, HALF_SPACE
from workbench.algorithms.solids.octree_cells import nodes_of
from workbench.algorithms.solids.octree_of_solid import octree_of_solid, solid_at_will
from workbench.algorithms.solids.octree_pairs import (
    DIFFERENCE,
    GO_IN,
    INTERSECTION,
    UNION,
    WHOLE,
    combined,
    pairs_of,
)

Array = NDArray[Any]


def octree_combined(
    first: Array, second: Array, operation: int, corner: Array, size: float
) -> Iterator[tuple[float, float, float, float, int]]:
    """Combine two octrees by going into both at once.

    Args: first and second (n, 8): octrees of one cube, of each octant a
    state, or minus the number of its own node; operation: 0 union, 1
    intersection, 2 difference; corner (3,) and size of the cube.
    Emits: (x, y, z, size, state).
    Source: Hearn and Baker, Computer Graphics, C Version, section 10-16.
    """
    # Begin with the octants of the whole cube
    counts, least, most = [0, 0, 0], 0.0, 0.0
    x, y, z = float(corner[0]), float(corner[1]), float(corner[2])
    pairs = pairs_of(first, second, WHOLE, WHOLE, x, y, z, size)

    while pairs:
        # Combine what both have of the octant
        pair = pairs.pop()
        state = combined(pair.one, pair.other, operation)

        if state == GO_IN:
            # Go on to the octants of it
            pairs.extend(pairs_of(first, second, pair.one, pair.other, pair.x, pair.y, pair.z, pair.size))
            continue

        # Keep what it is
        counts[state] += 1
        if state == FULL:
            least += pair.size * pair.size * pair.size
        if state != EMPTY:
            most += pair.size * pair.size * pair.size
        yield pair.x, pair.y, pair.z, pair.size, state


def two_octrees(chance: Random) -> tuple[Any, ...]:
    """Those of two solids at will in one cube, and an operation."""
    *_solid, corner, size, _depth = solid_at_will(chance)
    octrees = []
    for _which in range(2):
        shape, numbers, inverse, *_cube = solid_at_will(chance)
        rows = np.array(list(octree_of_solid(shape, numbers, inverse, corner, size, chance.randint(1, 2))))
        octrees.append(nodes_of(rows, corner, size))
    return octrees[0], octrees[1], chance.randint(UNION, DIFFERENCE), corner, size


def _example() -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """A ball, and the half of space below y = 0."""
    corner, size = -np.ones(3), 2.0
    solids = (ELLIPSOID, np.ones(3)), (HALF_SPACE, np.array([0.0, 1.0, 0.0, 0.0]))
    one, other = (
        nodes_of(np.array(list(octree_of_solid(shape, numbers, np.eye(3, 4), corner, size, 2))), corner, size)
        for shape, numbers in solids
    )
    return one, other


_FIRST, _SECOND = _example()

ENTRY = Entry(
    function=octree_combined,
    topic="solids",
    title="Two octrees combined",
    summary="Goes into the octrees of two solids at once and makes that of their union, intersection or "
    "difference; a half-space cuts a solid.",
    parameters=(
        Parameter("first", "first", "ints", _FIRST, meaning="octree of the first solid"),
        Parameter("second", "second", "ints", _SECOND, meaning="octree of the second"),
        Parameter(
            "operation",
            "operation",
            "int",
            INTERSECTION,
            UNION,
            DIFFERENCE,
            meaning="0 union, 1 intersection, 2 difference",
        ),
        Parameter("corner", "corner", "floats", -np.ones(3), meaning="lowest corner of the cube"),
        Parameter("size", "size", "float", 2.0, 1e-6, 1e9, "world", "side of the cube"),
    ),
    arguments=two_octrees,
    emits="cubes",
    source="Hearn and Baker, Computer Graphics, C Version, section 10-16",
    columns=COLUMNS,
    views=VIEWS,
    view_functions=VIEW_FUNCTIONS,
    laws=(
        Law(
            "A full cell lies in the solid asked for, an empty one outside, and the cells fill the cube.",
            "solids/test_octree_combined.py::test_cells_are_those_of_the_sets",
        ),
        Law(
            "Union and intersection do not depend on the order of the two; and the volumes of both together "
            "are those of union and intersection together.",
            "solids/test_octree_combined.py::test_union_and_intersection",
        ),
    ),
    not_laws=(
        "A partial cell of both is one of the intersection: the two parts in it may not meet, and only a "
        "deeper octree would tell.",
    ),
    labs=("Octrees of solids",),
    marks=marks,
    frame="world",
    stack="pairs",
    counted={"octants gone into": Counted("octant gone into", ("Go on",))},
)
