"""What the octree shows of its blocks."""

from workbench.algorithms.entry import View
from workbench.algorithms.visibility.octants import Cell
from workbench.algorithms.visibility.surface_marks import square_mark
from workbench.algorithms.visibility.surface_words import listed

COLUMNS = ("cell at", "size", "z from", "z to", "surfaces", "so")

_FATES = ("hidden", "empty", "divide", "draw")


def fate(cell: Cell, hidden: bool, few: int) -> str:
    """What becomes of a cell."""
    if hidden or not cell.members:
        return _FATES[0] if hidden else _FATES[1]
    return _FATES[2] if len(cell.members) > few and cell.size > 1 else _FATES[3]


def cell_rows(waiting: list[Cell]) -> list[tuple[int, int, int, float, float, str]]:
    """The cells that wait."""
    return [(one.x, one.y, one.size, one.z_near, one.z_far, listed(one.members)) for one in waiting]


VIEW_FUNCTIONS = (cell_rows, fate, listed, square_mark)

_CELL = "Cell of {cell.size} at {(cell.x, cell.y)}, z = {cell.z_near} to {cell.z_far}: "
_COLUMNS = ("x", "y", "size", "z from", "z to", "surfaces")


def _cell_view(number: int, sentence: str) -> View:
    name = _FATES[number]
    return View(
        block="Take the nearest cell",
        when=f"fate(cell, hidden, few) == {name!r}",
        row="((cell.x, cell.y), cell.size, cell.z_near, cell.z_far, listed(cell.members), "
        "fate(cell, hidden, few))",
        tables={"Cells that wait, the nearest last": ("cell_rows(waiting)", _COLUMNS)},
        options=repr(_FATES),
        answer=repr(name),
        marks="(square_mark(cell),)",
        sentence=_CELL + sentence,
    )


VIEWS = (
    View(
        block="Begin with a cell that holds everything",
        sentence="One cell holds {len(waiting[0].members)} surfaces.",
    ),
    _cell_view(0, "all its pixels are painted by what is nearer, so it is hidden."),
    _cell_view(1, "no surface reaches into it."),
    _cell_view(2, "{len(cell.members)} surfaces may be in it, so it is divided into eight octants."),
    _cell_view(3, "surface {listed(cell.members)} is drawn where nothing is painted yet."),
)
