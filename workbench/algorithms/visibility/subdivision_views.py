"""What the area subdivision shows of its blocks."""

from workbench.algorithms.entry import View
from workbench.algorithms.visibility.squares import (
    INSIDE,
    OVERLAPPING,
    SURROUNDING,
    Seen,
    Square,
    hiding,
)
from workbench.algorithms.visibility.surface_marks import square_mark
from workbench.algorithms.visibility.surface_words import listed
from workbench.algorithms.visibility.surfaces import NOTHING, Surface

COLUMNS = ("square at", "size", "surrounding", "overlapping", "inside", "decided by")

_RULES = ("all outside", "one surface", "a surface that hides all", "the centre", "no rule: divide")


def of_relation(seen: list[Seen], relation: int) -> str:
    """The surfaces that lie so to the square."""
    return listed([one.number for one in seen if one.relation == relation])


def rule(surfaces: list[Surface], seen: list[Seen], square: Square) -> str:
    """What decides a square."""
    if len(seen) < 2:
        return _RULES[len(seen)]
    if hiding(surfaces, seen, square) != NOTHING:
        return _RULES[2]
    return _RULES[3] if square.size == 1 else _RULES[4]


def squares(waiting: list[Square]) -> list[tuple[int, int, int, str]]:
    """The squares that wait, and the surfaces that may be in each."""
    return [(one.x, one.y, one.size, listed(one.members)) for one in waiting]


VIEW_FUNCTIONS = (of_relation, rule, square_mark, squares)

_TABLES = {"Squares that wait, the next one last": ("squares(waiting)", ("x", "y", "size", "surfaces"))}
_SURROUNDING, _OVERLAPPING, _INSIDE = (
    f"of_relation(seen, {one})" for one in (SURROUNDING, OVERLAPPING, INSIDE)
)

VIEWS = (
    View(
        block="Begin with a square that holds the whole picture",
        sentence="One square of {waiting[0].size} holds the whole picture and {len(surfaces)} surfaces.",
    ),
    View(
        block="Find the relation of each surface to the square",
        row=f"((x, y), size, {_SURROUNDING}, {_OVERLAPPING}, {_INSIDE}, rule(surfaces, seen, square))",
        tables=_TABLES,
        options=repr(_RULES),
        answer="rule(surfaces, seen, square)",
        marks="(square_mark(square),)",
        sentence=f"Square of {{size}} at {{(x, y)}}: surrounding {{{_SURROUNDING}}}, overlapping "
        f"{{{_OVERLAPPING}}}, inside {{{_INSIDE}}}.",
    ),
    View(
        block="Rule 1: all surfaces are outside",
        when="not seen",
        sentence="Rule 1: no surface is in it, so it stays as it is.",
    ),
    View(
        block="Rule 2: only one surface is not",
        when="len(seen) == 1",
        sentence="Rule 2: only surface {number} is in it, and is painted there.",
    ),
    View(
        block="Rule 3: a surrounding surface hides all others",
        when="number != -1",
        sentence="Rule 3: surface {number} surrounds it and is nearer than all others at its four corners, "
        "so it is painted there.",
    ),
    View(
        block="At the size of a pixel its centre decides",
        when="size == 1 and number == -1",
        sentence="It is one pixel, and no surface covers its centre.",
    ),
    View(
        block="At the size of a pixel its centre decides",
        when="size == 1",
        sentence="It is one pixel: surface {number} is the nearest at its centre.",
    ),
    View(block="Divide the square into four", sentence="No rule decides: it is divided into four."),
)
