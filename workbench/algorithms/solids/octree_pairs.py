"""Octants that two octrees have in common, and what union, intersection and difference make of them."""

from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.solids.implicit import EMPTY, FULL, PARTIAL
from workbench.algorithms.solids.octree_cells import X, Y, Z

Array = NDArray[Any]

UNION, INTERSECTION, DIFFERENCE = 0, 1, 2
GO_IN = 3
WHOLE = -1
"""The element that means the first node."""


class Pair(NamedTuple):
    """A cube, and its element in either octree: a state, or minus a node."""

    x: float
    y: float
    z: float
    size: float
    one: int
    other: int


def combined(one: int, other: int, operation: int) -> int:
    """The state of an octant in the result, or GO_IN where a node of either must be gone into."""
    if operation == DIFFERENCE:
        other = outside(other)
    decides = FULL if operation == UNION else EMPTY
    if one == decides or other == decides:
        return decides
    if one < 0 or other < 0:
        return GO_IN
    return PARTIAL if one == PARTIAL or other == PARTIAL else one


def outside(state: int) -> int:
    """What is left of an octant without the solid; nodes and partial cells stay what they are."""
    if state == FULL:
        return EMPTY
    return FULL if state == EMPTY else state


def pairs_of(
    first: Array, second: Array, one: int, other: int, x: float, y: float, z: float, size: float
) -> list[Pair]:
    """The octants of a cube, the first of them last; ``one`` and ``other`` are its elements.

    A state is that of each octant, too.
    """
    half = size / 2
    pairs: list[Pair] = []
    for octant in range(7, -1, -1):
        x_low = x + half if octant & X else x
        y_low = y + half if octant & Y else y
        z_low = z + half if octant & Z else z
        element, beside = inner(first, one, octant), inner(second, other, octant)
        pairs.append(Pair(x_low, y_low, z_low, half, element, beside))
    return pairs


def inner(nodes: Array, value: int, octant: int) -> int:
    """An octant's element in the node that an element means, or the state itself."""
    return int(nodes[-value - 1, octant]) if value < 0 else value
