"""What the combination of two octrees shows of its blocks."""

from collections.abc import Iterator, Mapping
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.entry import View
from workbench.algorithms.marks import Ink, Mark
from workbench.algorithms.solids.implicit import EMPTY, FULL
from workbench.algorithms.solids.octree_pairs import GO_IN, Pair
from workbench.algorithms.solids.octree_views import STATES, cube_marks, element, name_of, whole_marks

COLUMNS = ("at", "size", "first", "second", "so", "full", "partial", "empty", "volume at least", "at most")
_SIGNS = ("∪", "∩", "−")


def sign(operation: int) -> str:
    """An operation by its sign."""
    return _SIGNS[operation]


def pair_marks(pair: Pair, state: int) -> tuple[Mark, ...]:
    """The cube in hand, by what it is."""
    ink: Ink = "muted" if state == EMPTY else "accent" if state == FULL else "data2"
    pattern: Any = "dot" if state == EMPTY else "dash" if state == GO_IN else "solid"
    return cube_marks(pair.x, pair.y, pair.z, pair.size, ink, "bold", pattern)


def pair_rows(pairs: list[Pair]) -> list[tuple[object, ...]]:
    """The octants that wait."""
    return [(each.x, each.y, each.z, each.size, element(each.one), element(each.other)) for each in pairs]


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The whole cube, and the cells so far that are not empty."""
    *_octrees, corner, size = arguments
    yield from whole_marks(corner, size, emitted)


VIEW_FUNCTIONS = (element, name_of, pair_marks, pair_rows, sign)

_AT = "(pair.x, pair.y, pair.z)"
_ROW = (
    f"({_AT}, pair.size, element(pair.one), element(pair.other), {{}}, counts[1], counts[2], counts[0], "
    "least, most)"
)
_WAITING = {
    "Octants that wait, the next one last": (
        "pair_rows(pairs)",
        ("x", "y", "z", "size", "first", "second"),
    )
}
_BOTH = "{element(pair.one)} {sign(operation)} {element(pair.other)}"
_OPTIONS = repr((*STATES, "go in"))

VIEWS = (
    View(
        block="Begin with the octants of the whole cube",
        tables=_WAITING,
        sentence="Both octrees divide the cube of {size} at {tuple(corner.tolist())}.",
    ),
    View(
        block="Combine what both have of the octant",
        tables=_WAITING,
        marks="pair_marks(pair, state)",
        sentence=f"The cube of {{pair.size}} at {{{_AT}}}: {_BOTH}.",
    ),
    View(
        block="Go on to the octants of it",
        row=_ROW.format("'go in'"),
        tables=_WAITING,
        marks="pair_marks(pair, state)",
        options=_OPTIONS,
        answer="'go in'",
        sentence=f"{_BOTH} is decided by neither: the octants of the cube are looked at.",
    ),
    View(
        block="Keep what it is",
        when="not pairs",
        row=_ROW.format("name_of(state)"),
        tables=_WAITING,
        marks="pair_marks(pair, state)",
        options=_OPTIONS,
        answer="name_of(state)",
        sentence=f"{_BOTH} is {{name_of(state)}}, the last cell: {{counts[1]}} are full, {{counts[2]}} "
        "partial, {counts[0]} empty, and the volume is from {least} to {most}.",
    ),
    View(
        block="Keep what it is",
        row=_ROW.format("name_of(state)"),
        tables=_WAITING,
        marks="pair_marks(pair, state)",
        options=_OPTIONS,
        answer="name_of(state)",
        sentence=f"{_BOTH} is {{name_of(state)}}: a cell of {{pair.size}} at {{{_AT}}}.",
    ),
)
