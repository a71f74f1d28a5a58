"""A point transformed by a homogeneous matrix.

x, y        the point; as a column it is x, y, 1
x_h, y_h    the homogeneous coordinates of its image
w           their weight; where it is not 1, they are divided by it
"""

import math
from collections.abc import Iterator, Mapping
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.marks import Mark, Spot, Stroke, Word, along
from workbench.algorithms.numerals import numeral
from workbench.algorithms.transforms.plane import rotation_about
from workbench.algorithms.transforms.products import factor, factors_text, matrix_mark, row_of
from workbench.algorithms.transforms.refusals import refuse_point


def transform_point(matrix: NDArray[Any], point: NDArray[Any]) -> Iterator[tuple[float, float, float]]:
    """Multiply the matrix by the point as a column, and divide by w where it is not 1.

    Args: (3, 3) matrix and a point (x, y), in one frame. Emits: (x', y', w); where w is neither 1 nor 0
    also (x'/w, y'/w, 1). Raises: ValueError where they do not fit.
    Source: Hearn and Baker, Computer Graphics, C Version, section 5-2.
    """
    # Write the point as a column
    refuse_point(matrix, point)
    x = float(point[0])
    y = float(point[1])

    # Multiply the first row by it
    x_h = float(matrix[0, 0]) * x + float(matrix[0, 1]) * y + float(matrix[0, 2])

    # Multiply the second row by it
    y_h = float(matrix[1, 0]) * x + float(matrix[1, 1]) * y + float(matrix[1, 2])

    # Multiply the third row by it
    w = float(matrix[2, 0]) * x + float(matrix[2, 1]) * y + float(matrix[2, 2])
    yield x_h, y_h, w

    if w != 1.0 and w != 0.0:
        # Divide by w
        x_h /= w
        y_h /= w
        yield x_h, y_h, 1.0


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The matrix, the point, and its image once it is known."""
    matrix, point = arguments
    yield matrix_mark("M", matrix)
    x, y = point.tolist()
    if len(emitted) and emitted[-1, 2] == 1.0:
        image_x, image_y, _w = emitted[-1].tolist()
        yield Stroke(along((x, y), (image_x, image_y)), "muted", "thin", "dash")
        yield Spot(image_x, image_y, "accent", "dot")
        yield Word("P′", image_x, image_y, "accent", 1, 1, True)
    yield Spot(x, y, "data1", "ring")
    yield Word("P", x, y, "data1", -1, 1, True)


def _matrix_and_point(chance: Random) -> tuple[Any, ...]:
    """Affine matrices and others; some points get w = 0."""
    cells = [[_number(chance) for _column in range(3)] for _row in range(3)]
    match chance.randint(0, 3):
        case 0:
            cells[2] = [0.0, 0.0, float(chance.choice((0, 2, -1)))]
        case 1 | 2:
            cells[2] = [0.0, 0.0, 1.0]
    return np.array(cells), np.array([_number(chance), _number(chance)])


def _number(chance: Random) -> float:
    return chance.choice((0.0, 1.0, float(chance.randint(-9, 9)), chance.uniform(-1e3, 1e3)))


_COLUMN = "(x, y, 1.0)"
_OPTIONS = "('divide by w', 'nothing is left to do', 'the point is at infinity')"


def _row_view(block: str, number: int, name: str, variable: str) -> View:
    """The view of a row of the matrix times the point."""
    factors = f"factors_text(matrix[{number}], {_COLUMN})"
    return View(
        block=f"Multiply the {block} row by it",
        row=f"({name!r}, factors_text(matrix[{number}], {_COLUMN}), {variable})",
        marks=f"(row_of('M', matrix, {number}),)",
        sentence=f"{name} = {{{factors}}} = {{{variable}}}.",
    )


def _weight_view(when: str, answer: str, sentence: str) -> View:
    """The view of the third row, where w tells what is left to do."""
    factors = f"factors_text(matrix[2], {_COLUMN})"
    return View(
        block="Multiply the third row by it",
        when=when,
        row=f"('w', factors_text(matrix[2], {_COLUMN}), w)",
        options=_OPTIONS,
        answer=repr(answer),
        marks="(row_of('M', matrix, 2),)",
        sentence=f"w = {{{factors}}} = {{w}}{sentence}",
    )


ENTRY = Entry(
    function=transform_point,
    topic="transforms",
    title="Point times matrix",
    summary="Each row of the matrix, times the point, gives one coordinate; w says what to divide them by.",
    parameters=(
        Parameter(
            "matrix", "M", "matrix", rotation_about(math.radians(45), 3, 3), meaning="homogeneous, 3 × 3"
        ),
        Parameter("point", "P", "floats", np.array([5.0, 6.0]), meaning="x and y of the point"),
    ),
    arguments=_matrix_and_point,
    emits="points",
    emitted_columns=("x′", "y′", "w"),
    source="Hearn and Baker, Computer Graphics, C Version, section 5-2",
    columns=("coordinate", "calculation", "value"),
    view_functions=(factor, factors_text, numeral, row_of),
    views=(
        View(
            block="Write the point as a column",
            sentence="The point {(x, y)} becomes the column {x}, {y}, 1: with the 1 a translation, too, is "
            "a product.",
        ),
        _row_view("first", 0, "x′", "x_h"),
        _row_view("second", 1, "y′", "y_h"),
        _weight_view("w == 1.0", "nothing is left to do", ": the image is {(x_h, y_h)}."),
        _weight_view(
            "w == 0.0",
            "the point is at infinity",
            ": the image lies at infinity, in the direction {(x_h, y_h)}.",
        ),
        _weight_view("True", "divide by w", ", which is not 1: divide by it."),
        View(
            block="Divide by w",
            row="('(x′, y′)/w', f'{numeral(before.x_h)}/{factor(w)}, {numeral(before.y_h)}/{factor(w)}', "
            "(x_h, y_h))",
            sentence="x′/w = {before.x_h}/{factor(w)} = {x_h} and y′/w = {before.y_h}/{factor(w)} = {y_h}.",
        ),
    ),
    laws=(
        Law(
            "What is emitted last is the matrix times the column, divided by its last number.",
            "transforms/test_texts.py::test_a_point_is_the_matrix_times_its_column",
        ),
        Law(
            "Under an affine matrix, last row 0 0 1, w is exactly 1 and nothing is divided.",
            "transforms/test_texts.py::test_under_an_affine_matrix_nothing_is_divided",
        ),
        Law(
            "A matrix multiplied by any number but 0 takes a point to the same place, but for rounding.",
            "transforms/test_texts.py::test_a_multiple_of_a_matrix_is_the_same_transformation",
        ),
    ),
    questions=(12,),
    labs=("Transformations in 2D and 3D",),
    frame="world",
    marks=marks,
)
