"""A ruled grid of words on paper: headings over columns, every cell folded at the width of its column."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from workbench.exchange.formulas.folding import folded
from workbench.exchange.formulas.layout import Line, Primitive, Typesetter, moved

_PAD_PT = 4.0
_RULE_PT = 0.6


@dataclass(frozen=True, slots=True)
class Grid:
    """Rows of cells under their ``headings``; the first cell of each row is its name. What stands between
    dollar signs is a formula. ``shares`` are the widths of the columns to each other, equal where none are
    given. Raises ValueError where a row or ``shares`` has another length than ``headings``.
    """

    headings: Sequence[str]
    rows: Sequence[Sequence[str]]
    shares: Sequence[float] = ()

    def __post_init__(self) -> None:
        if not self.headings or any(len(row) != len(self.headings) for row in (*self.rows, self.widths)):
            raise ValueError("A grid has as many cells in each row as it has headings.")

    @property
    def widths(self) -> Sequence[float]:
        """The widths of the columns to each other."""
        return self.shares or (1.0,) * len(self.headings)


class LaidGrid(NamedTuple):
    """Width and height in points, and what is drawn there, its top left at the origin."""

    width: float
    height: float
    primitives: tuple[Primitive, ...]


def lay_out_grid(typesetter: Typesetter, grid: Grid, room: float, size: float) -> LaidGrid:
    """The grid in ``room`` points; a column with a word wider than its share widens it."""
    whole = sum(grid.widths)
    rows = [
        [
            folded(typesetter, text, room * share / whole - 2 * _PAD_PT, size, strong=not (number and column))
            for column, (text, share) in enumerate(zip(row, grid.widths, strict=True))
        ]
        for number, row in enumerate((grid.headings, *grid.rows))
    ]
    wide = [
        max(room * share / whole, *(cell.width + 2 * _PAD_PT for cell in cells))
        for share, cells in zip(grid.widths, zip(*rows, strict=True), strict=True)
    ]
    x = list(itertools.accumulate(wide, initial=0.0))
    y = list(
        itertools.accumulate((max(cell.height for cell in row) + 2 * _PAD_PT for row in rows), initial=0.0)
    )
    primitives: list[Primitive] = [Line(((0.0, at), (x[-1], at)), _RULE_PT, "muted") for at in y]
    primitives += [Line(((at, 0.0), (at, y[-1])), _RULE_PT, "muted") for at in x]
    for row, top in zip(rows, y, strict=False):
        for cell, left in zip(row, x, strict=False):
            primitives += moved(cell.primitives, left + _PAD_PT, top + _PAD_PT)
    return LaidGrid(x[-1], y[-1], tuple(primitives))
