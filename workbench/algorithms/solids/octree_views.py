"""What the octree of a solid shows of its blocks, and how its cells are drawn."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import View
from workbench.algorithms.marks import MOST_SPOTS, Ink, Mark, Pattern, Stroke, Weight
from workbench.algorithms.solids.implicit import (
    BLOCK,
    CONE,
    CYLINDER,
    ELLIPSOID,
    EMPTY,
    FULL,
    PARTIAL,
    TORUS,
)
from workbench.algorithms.solids.octree_cells import Cell

Array = NDArray[Any]

STATES = ("empty", "full", "partial")
COLUMNS = ("octant", "at", "size", "is", "full", "partial", "empty", "volume at least", "at most")
_DEEP = math.sqrt(0.125)
"""Of a cabinet drawing: half of the depth, receding by 45 degrees."""
_RING = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
_REST = (((0, 1, 1), (0, 0, 1)), ((1, 0, 0), (1, 0, 1)), ((1, 1, 0), (1, 1, 1)), ((0, 1, 0), (0, 1, 1)))


def name_of(state: int) -> str:
    """A state in a word."""
    return STATES[state]


def element(value: int) -> str:
    """An element of a node as the table has it: a state, or the number of a node."""
    return STATES[value] if value >= 0 else f"node {-value}"


def node_rows(nodes: Sequence[Sequence[int]]) -> list[tuple[object, ...]]:
    """The nodes, each with its eight elements."""
    return [(number, *(element(value) for value in node)) for number, node in enumerate(nodes, 1)]


def exact_volume(shape: int, numbers: Array, inverse: Array) -> float | None:
    """The volume of a solid in the world by its formula; None where there is none."""
    a, b, c = (float(numbers[k]) if k < len(numbers) else 0.0 for k in range(3))
    own = {
        ELLIPSOID: 4 / 3 * math.pi * a * b * c,
        TORUS: 2 * math.pi * math.pi * a * b * b,
        CYLINDER: math.pi * a * a * b,
        CONE: math.pi * a * a * b / 3,
        BLOCK: 8 * a * b * c,
    }.get(shape)
    return None if own is None else own / abs(float(np.linalg.det(inverse[:, :3])))


def exactly(shape: int, numbers: Array, inverse: Array) -> str:
    """The exact volume in words."""
    volume = exact_volume(shape, numbers, inverse)
    return "no formula gives it exactly" if volume is None else f"by its formula it is {volume:.6g}"


def cube_marks(
    x: float, y: float, z: float, size: float, ink: Ink, weight: Weight = "hair", pattern: Pattern = "solid"
) -> tuple[Mark, ...]:
    """The edges of a cube in a cabinet drawing of the world: x to the right, y up, z to the viewer."""
    lines = [_RING, *_REST]
    return tuple(Stroke(_cabinet(np.array(line) * size + (x, y, z)), ink, weight, pattern) for line in lines)


def _cabinet(points: Array) -> NDArray[np.float64]:
    flat: NDArray[np.float64] = points[:, :2] - _DEEP * points[:, 2:]
    return flat


def cell_marks(cell: Cell, state: int) -> tuple[Mark, ...]:
    """The cell in hand, by what it is."""
    ink: Ink = "muted" if state == EMPTY else "data2" if state == PARTIAL else "accent"
    return cube_marks(cell.x, cell.y, cell.z, cell.size, ink, "bold", "dot" if state == EMPTY else "solid")


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The whole cube, and the cells so far that are not empty."""
    _shape, _numbers, _inverse, corner, size, _depth = arguments
    yield from whole_marks(corner, size, emitted)


def whole_marks(corner: Array, size: float, emitted: NDArray[Any]) -> Iterator[Mark]:
    """The whole cube, and those of some cells (n, 5) that are not empty."""
    x, y, z = (float(value) for value in corner)
    yield from cube_marks(x, y, z, float(size), "muted")
    for left, low, deep, side, state in emitted[:MOST_SPOTS].tolist():
        if state != EMPTY:
            yield from cube_marks(left, low, deep, side, "accent" if state == FULL else "data2")


VIEW_FUNCTIONS = (name_of, node_rows, exactly, cell_marks)

_KEEP = "Keep what it is in the table"
_DIVIDE = "Divide it: it gets a node of its own"
_NODES = {"Octree": ("node_rows(nodes)", ("node", *(f"octant {k}" for k in range(8))))}
_AT = "(cell.x, cell.y, cell.z)"
_ROW = f"(cell.octant, {_AT}, cell.size, {{}}, counts[1], counts[2], counts[0], least, most)"
_OPTIONS = "('full', 'empty', 'partial')"

VIEWS = (
    View(
        block="Divide the whole cube into eight octants",
        tables=_NODES,
        sentence="The cube of {size} at {tuple(corner.tolist())} is divided into eight octants.",
    ),
    View(
        block="Compare the next octant with the solid",
        marks="cell_marks(cell, state)",
        sentence="Octant {cell.octant} of node {cell.node}, a cube of {cell.size}, is {name_of(state)}.",
    ),
    View(
        block=_DIVIDE,
        row=_ROW.format("'divided'"),
        tables=_NODES,
        marks="cell_marks(cell, state)",
        options=_OPTIONS,
        answer="'partial'",
        sentence=f"The cube of {{cell.size}} at {{{_AT}}} is filled in part: it is divided, and node "
        "{len(nodes)} holds its octants.",
    ),
    View(
        block=_KEEP,
        when="not waiting",
        row=_ROW.format("name_of(state)"),
        tables=_NODES,
        marks="cell_marks(cell, state)",
        options=_OPTIONS,
        answer="name_of(state)",
        sentence="The last cell is {name_of(state)}. {counts[1]} are full, {counts[2]} partial, {counts[0]} "
        "empty: the volume is from {least} to {most}; {exactly(shape, numbers, inverse)}.",
    ),
    View(
        block=_KEEP,
        when="cell.level == depth and state == 2",
        row=_ROW.format("name_of(state)"),
        tables=_NODES,
        marks="cell_marks(cell, state)",
        options=_OPTIONS,
        answer="name_of(state)",
        sentence=f"The cube of {{cell.size}} at {{{_AT}}} is filled in part, and at depth {{depth}} it is "
        "not divided further.",
    ),
    View(
        block=_KEEP,
        row=_ROW.format("name_of(state)"),
        tables=_NODES,
        marks="cell_marks(cell, state)",
        options=_OPTIONS,
        answer="name_of(state)",
        sentence=f"The cube of {{cell.size}} at {{{_AT}}} is {{name_of(state)}}; the volume is at least "
        "{least} so far.",
    ),
)
