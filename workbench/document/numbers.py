"""The numbers that several structs of a document share."""

from workbench.document.fields import Number
from workbench.language import _

MAX_COORDINATE = 1_000_000.0
LARGEST_ENTRY = 1e9
"""Of a matrix that is given by its numbers."""


def coordinate(label: str, symbol: str = "", unit: str = "world") -> Number:
    """A number that may be negative, as large as pictures have use for."""
    return Number(
        label=label,
        symbol=symbol or label,
        low=-MAX_COORDINATE,
        high=MAX_COORDINATE,
        unit=unit,
        keyed=True,
    )


def factor(label: str, symbol: str, largest: float = MAX_COORDINATE) -> Number:
    """A number without a unit, as large to both sides of 0."""
    return Number(label=label, symbol=symbol, low=-largest, high=largest, keyed=True)


def matrix_entry(row: int, column: int) -> Number:
    """The number in a row and a column of a matrix, counted as in its symbol."""
    label = _("row {row}, column {column} of the matrix").format(row=row, column=column)
    return factor(label, f"m_{row}{column}", LARGEST_ENTRY)


COORDINATE = coordinate("x")
