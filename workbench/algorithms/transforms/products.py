"""How a row times a column is written: its factors, its products, and the sums a person may choose from."""

from collections.abc import Iterator, Sequence
from typing import Any, TypeAlias

from numpy.typing import NDArray

from workbench.algorithms.marks import Ink, Matrix
from workbench.algorithms.numerals import numeral

Numbers: TypeAlias = Sequence[float] | NDArray[Any]
ROW_INK: Ink = "data1"
COLUMN_INK: Ink = "data2"
SUM_INK: Ink = "accent"


def factor(value: float) -> str:
    """A number as it stands behind a sign of calculation: a negative one in parentheses."""
    text = numeral(value)
    return f"({text})" if text.startswith("−") else text


def factors_text(row: Numbers, column: Numbers) -> str:
    """The products not worked out: 2·5 + (−1)·6."""
    return " + ".join(f"{factor(a)}·{factor(b)}" for a, b in zip(row, column, strict=True))


def sum_of_products(row: Numbers, column: Numbers) -> float:
    """The sum of the products, added from the left."""
    total = 0.0
    for a, b in zip(row, column, strict=True):
        total += float(a) * float(b)
    return total


def sums_in_question(a: NDArray[Any], b: NDArray[Any], row: int, column: int) -> tuple[str, ...]:
    """The sum of a cell among those that are easily taken for it, in ascending order, each once.

    They are the sum with the matrices in the other order, the product of the two cells in that place, and
    the sum without its last product; then numbers beside it, where these are too few.
    """
    right = sum_of_products(a[row], b[:, column])
    sums = [right]
    if b.shape[1] == a.shape[0] and row < b.shape[0] and column < a.shape[1]:
        sums.append(sum_of_products(b[row], a[:, column]))
    if row < b.shape[0] and column < a.shape[1]:
        sums.append(float(a[row, column]) * float(b[row, column]))
    sums += [sum_of_products(a[row, :-1], b[:-1, column]), right + 1.0, right - 1.0]
    texts = {numeral(each): each for each in reversed(sums)}
    kept = sorted(list(texts)[-3:], key=lambda text: texts[text])
    return tuple(kept)


def matrix_mark(name: str, matrix: NDArray[Any], *inked: tuple[int, int, Ink]) -> Matrix:
    """A matrix of numbers as a mark."""
    return Matrix(name, tuple(tuple(map(numeral, row)) for row in matrix.tolist()), inked)


def row_of(name: str, matrix: NDArray[Any], row: int) -> Matrix:
    """The matrix with a row that is multiplied."""
    return matrix_mark(name, matrix, *((row, column, ROW_INK) for column in range(matrix.shape[1])))


def product_marks(a: NDArray[Any], b: NDArray[Any], row: int, column: int) -> Iterator[Matrix]:
    """A row of one matrix, a column of the other, and their product as far as the cell of both."""
    yield row_of("A", a, row)
    yield matrix_mark("B", b, *((k, column, COLUMN_INK) for k in range(b.shape[0])))
    known = row * b.shape[1] + column
    sums = [sum_of_products(a[k // b.shape[1]], b[:, k % b.shape[1]]) for k in range(known + 1)]
    yield product_mark(a, b, sums, (row, column, SUM_INK))


def product_mark(
    a: NDArray[Any], b: NDArray[Any], sums: Sequence[float], *inked: tuple[int, int, Ink]
) -> Matrix:
    """The product of both, of which the first cells are known, row by row."""
    texts = [*map(numeral, sums), *[""] * (a.shape[0] * b.shape[1] - len(sums))]
    rows = (texts[start : start + b.shape[1]] for start in range(0, len(texts), b.shape[1]))
    return Matrix("A B", tuple(map(tuple, rows)), inked)
