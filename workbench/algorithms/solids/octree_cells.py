"""Cells of an octree: cubes, and their eight octants by three bits, x y z: the upper half along each axis.

An octree is a table of nodes (n, 8), counted from 1, the first the whole: of each octant it holds a state, or
minus the number of the octant's own node.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.solids.implicit import EMPTY

Array = NDArray[Any]
X, Y, Z = 4, 2, 1


class Cell(NamedTuple):
    """The lowest corner of a cube and its side, how often it was divided from the whole, and which octant of
    which node it is."""

    x: float
    y: float
    z: float
    size: float
    level: int
    node: int
    octant: int


def octants_of(x: float, y: float, z: float, size: float, level: int, node: int) -> list[Cell]:
    """The octants of a cube, which has a node; the first of them last, where a stack gives it first."""
    half = size / 2
    octants: list[Cell] = []
    for octant in range(7, -1, -1):
        x_low = x + half if octant & X else x
        y_low = y + half if octant & Y else y
        z_low = z + half if octant & Z else z
        octants.append(Cell(x_low, y_low, z_low, half, level + 1, node, octant))
    return octants


def corner_of(cell: Cell) -> Array:
    """The lowest corner (3,) of a cell."""
    return np.array([cell.x, cell.y, cell.z])


def nodes_of(rows: Array, corner: Array, size: float) -> NDArray[np.int64]:
    """The octree whose cells (n, 5) are x, y, z, size, state: all of a cube with this corner and size."""
    nodes = [[EMPTY] * 8]
    for x, y, z, side, state in np.asarray(rows, np.float64).tolist():
        node, low, half = 1, np.array(corner, float), size / 2
        middle = np.array([x, y, z]) + side / 2
        while True:
            upper = middle > low + half
            octant = int(upper @ (X, Y, Z))
            if half <= side * 1.5:
                break
            if nodes[node - 1][octant] >= 0:
                nodes.append([EMPTY] * 8)
                nodes[node - 1][octant] = -len(nodes)
            node = -nodes[node - 1][octant]
            low, half = low + half * upper, half / 2
        nodes[node - 1][octant] = int(state)
    return np.array(nodes, np.int64)
