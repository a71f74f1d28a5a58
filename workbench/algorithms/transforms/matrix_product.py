"""The product of two matrices, cell by cell: a row of the first times a column of the second.

row, column     the cell that is worked out, counted from 0
k               number of the product in its sum
product         one cell of the row times one cell of the column
total           the products added so far
"""

import math
from collections.abc import Iterator, Mapping
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.marks import Mark
from workbench.algorithms.numerals import numeral
from workbench.algorithms.transforms.plane import rotation, translation
from workbench.algorithms.transforms.products import (
    factors_text,
    matrix_mark,
    product_mark,
    product_marks,
    sums_in_question,
)
from workbench.algorithms.transforms.refusals import refuse_product


def matrix_product(a: NDArray[Any], b: NDArray[Any]) -> Iterator[tuple[int, int, float]]:
    """Multiply every row of the first matrix by every column of the second, and add the products.

    Args: (n, m) and (m, p) matrices; a point is a column, (3, 1) or (4, 1). Emits: (row, column, value) of
    each cell of the (n, p) product, row by row, counted from 0. Raises: ValueError where they do not fit.
    Source: Hearn and Baker, Computer Graphics, C Version, section A-4.
    """
    # Check that rows and columns match
    refuse_product(a, b)

    for row in range(a.shape[0]):
        for column in range(b.shape[1]):
            # Add the products of the row and the column
            total = 0.0
            for k in range(a.shape[1]):
                product = float(a[row, k]) * float(b[k, column])
                total += product

            # Write the sum into its cell
            yield row, column, total


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """Both matrices, and their product as far as it is known."""
    a, b = arguments
    yield matrix_mark("A", a)
    yield matrix_mark("B", b)
    yield product_mark(a, b, [value for *_place, value in emitted.tolist()])


def _matrices(chance: Random) -> tuple[Any, ...]:
    """Two matrices that fit, square ones and columns most often, their cells whole numbers or not."""
    n, m, p = chance.choice(((3, 3, 3), (3, 3, 1), (4, 4, 4), (4, 4, 1), (1, 1, 1), (2, 3, 4), (1, 4, 2)))
    return _filled(chance, n, m), _filled(chance, m, p)


def _filled(chance: Random, rows: int, columns: int) -> NDArray[np.float64]:
    cells = (0.0, 0.0, 1.0, -1.0, float(chance.randint(-9, 9)), chance.uniform(-1e3, 1e3), 1e-9)
    return np.array([[chance.choice(cells) for _column in range(columns)] for _row in range(rows)])


ENTRY = Entry(
    function=matrix_product,
    topic="transforms",
    title="Matrix product",
    summary="Each cell is a row of the first matrix times a column of the second.",
    parameters=(
        Parameter("a", "A", "matrix", rotation(math.radians(45)), meaning="the matrix on the left"),
        Parameter("b", "B", "matrix", translation(-3, -3), meaning="the one on the right, which acts first"),
    ),
    arguments=_matrices,
    emits="cells",
    source="Hearn and Baker, Computer Graphics, C Version, section A-4",
    columns=("i, j", "row × column", "m_{ij}"),
    view_functions=(factors_text, product_marks, sums_in_question, numeral),
    views=(
        View(
            block="Check that rows and columns match",
            sentence="A matrix of {a.shape[0]} × {a.shape[1]} times one of {b.shape[0]} × {b.shape[1]} "
            "is one of {a.shape[0]} × {b.shape[1]}; each of its elements is a row times a column.",
        ),
        View(
            block="Add the products of the row and the column",
            row="(f'{row + 1}, {column + 1}', factors_text(a[row], b[:, column]), total)",
            options="sums_in_question(a, b, row, column)",
            answer="numeral(total)",
            marks="product_marks(a, b, row, column)",
            tables={
                "Products": (
                    "[(k + 1, a[row, k], b[k, column], a[row, k] * b[k, column]) for k in range(len(b))]",
                    ("k", "a_{row,k}", "b_{k,column}", "product"),
                )
            },
            sentence="Row {row + 1} of A times column {column + 1} of B is "
            "{factors_text(a[row], b[:, column])} = {total}.",
        ),
    ),
    laws=(
        Law(
            "Every cell is the sum of the products of its row and its column, but for rounding.",
            "transforms/test_texts.py::test_a_product_is_that_of_exact_fractions",
        ),
        Law(
            "The identity, on either side, changes nothing.",
            "transforms/test_texts.py::test_the_identity_changes_nothing",
        ),
        Law(
            "Which product of a chain is worked out first does not matter, apart from rounding.",
            "transforms/test_texts.py::test_products_may_be_taken_in_any_order_of_working",
        ),
    ),
    not_laws=(
        "A B and B A are the same: turning and then moving ends elsewhere than moving and then turning.",
    ),
    questions=(12,),
    labs=("Transformations in 2D and 3D",),
    next_rung="transform_point",
    count="len(a) * b.shape[1]",
    marks=marks,
)
