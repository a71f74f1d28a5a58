"""What a row of matrices consists of, as values: cells, matrices, signs and words between them."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.numerals import numeral, settled

Shows = Literal["symbols", "numbers", "both"]
HIDDEN, ABSENT = "?", "·"
MOST = 4


def displayed(value: float) -> str:
    """A number of a matrix as the course writes it: four decimals at most, a true minus sign, never -0.

    What is left of a rounding, such as the cosine of a right angle, is 0.
    """
    return numeral(*settled(value))


@dataclass(frozen=True, slots=True)
class Cell:
    """One element: ``symbol`` in the notation of formulas, ``value``, or both; without either a dot.

    Only an ``editable`` one with a value can be changed; ``hidden`` shows a question mark instead.
    """

    symbol: str = ""
    value: float | None = None
    editable: bool = False
    hidden: bool = False

    @property
    def number(self) -> str:
        """Its value as it is displayed; empty without one."""
        return "" if self.value is None else displayed(self.value)

    def seen(self, shows: Shows) -> tuple[str, str]:
        """The symbol and the number shown of it, of which one may be empty; HIDDEN and ABSENT are numbers."""
        if self.hidden:
            return "", HIDDEN
        symbol = self.symbol if shows != "numbers" or self.value is None else ""
        figure = self.number if shows != "symbols" or not self.symbol else ""
        if symbol == figure.replace("−", "-"):
            symbol = ""  # a 0 or 1 says the same both ways
        return symbol, figure or ("" if symbol else ABSENT)


@dataclass(frozen=True, slots=True)
class Matrix:
    """Rows of cells in brackets, up to 4 x 4, all rows as long. ``name`` is a formula; ``named``: where.

    Raises ValueError when rows differ in length, or there are none or more than four.
    """

    cells: tuple[tuple[Cell, ...], ...]
    name: str = ""
    named: Literal["over", "under"] = "over"

    def __post_init__(self) -> None:
        rows, columns = len(self.cells), {len(row) for row in self.cells}
        if len(columns) != 1 or not (1 <= rows <= MOST and 1 <= max(columns) <= MOST):
            raise ValueError("A matrix has one to four rows, all of the same one to four columns.")

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return len(self.cells), len(self.cells[0])

    def with_values(self, values: NDArray[np.float64]) -> "Matrix":
        """The same with other values (rows, columns)."""
        rows = zip(self.cells, np.asarray(values, np.float64).tolist(), strict=True)
        return replace(
            self,
            cells=tuple(
                tuple(replace(cell, value=value) for cell, value in zip(row, numbers, strict=True))
                for row, numbers in rows
            ),
        )


@dataclass(frozen=True, slots=True)
class Sign:
    """An operator between terms, such as = or ·."""

    text: str


@dataclass(frozen=True, slots=True)
class Phrase:
    """A formula that stands as a term of its own; a ``note`` is small and muted, ``strong`` half bold."""

    formula: str
    strong: bool = False
    note: bool = False


Term = Matrix | Sign | Phrase
Terms = Sequence[Term]
Place = tuple[int, int, int]
"""Term, row and column of a cell, from 0."""


def matrix(
    values: NDArray[np.float64] | Sequence[Sequence[float]],
    symbols: Sequence[Sequence[str]] | None = None,
    *,
    name: str = "",
    named: Literal["over", "under"] = "over",
    editable: bool = False,
) -> Matrix:
    """A matrix of values (rows, columns), with a formula for each where ``symbols`` gives them."""
    rows = np.asarray(values, np.float64).tolist()
    cells = tuple(
        tuple(Cell("" if symbols is None else symbols[i][j], value, editable) for j, value in enumerate(row))
        for i, row in enumerate(rows)
    )
    return Matrix(cells, name, named)
