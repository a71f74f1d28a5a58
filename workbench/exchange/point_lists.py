"""Points from text and as text: a CSV file, or what a table on the clipboard gives.

Two numbers a line, parted by commas, semicolons, tabs or blanks; a comma may be the decimal sign where
something else parts the numbers. One heading line is passed over, as are empty lines and those after #.
"""

import io
import math
import re
from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.document.numbers import MAX_COORDINATE
from workbench.document.storage.content import Progress, silent
from workbench.language import _

Array = NDArray[np.float64]

MOST_POINTS = 100_000
MOST_CHARACTERS = 16 * 2**20
LONGEST_LINE = 10_000
_BETWEEN_REPORTS = 1000

_NUMBER = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?")
_DECIMAL_COMMA = re.compile(r"\d,\d")
_SEPARATORS = {"\t": r"\t", ";": ";", ",": ",", " ": r"\s+"}


class PointsError(ValueError):
    """Text that holds no points: one sentence with line and column."""


def read_points(text: str, progress: Progress = silent) -> Array:
    """The points (n, 2) in a text, world units. Raises: PointsError."""
    if len(text) > MOST_CHARACTERS:
        sentence = _("The list has {size:,} characters, and at most {most:,} can be read; give fewer points.")
        raise PointsError(sentence.format(size=len(text), most=MOST_CHARACTERS))
    lines = _lines(text)
    if not lines:
        raise PointsError(_("There are no points; give two numbers a line."))
    if _is_heading(lines[0][1]):
        lines = lines[1:]
    if not lines:
        raise PointsError(_("There is a heading and no points; give two numbers a line."))
    if len(lines) > MOST_POINTS:
        sentence = _("There are more than {most:,} points, which is all that can be read; give fewer.")
        raise PointsError(sentence.format(most=MOST_POINTS))
    separator, comma = _dialect([line for _number, line in lines])
    points = np.empty((len(lines), 2))
    for row, (number, line) in enumerate(lines):
        if row % _BETWEEN_REPORTS == 0:
            progress(row / len(lines))
        points[row] = _point(number, line, separator, comma)
    return points


def _lines(text: str) -> list[tuple[int, str]]:
    """Number and content of the lines that say something, of no more than are read and a heading."""
    said: list[tuple[int, str]] = []
    for number, line in enumerate(io.StringIO(text, newline=None), 1):
        content = line.partition("#")[0].strip(" \r\n\ufeff")
        if not content or content.isspace():
            continue
        if len(content) > LONGEST_LINE:
            sentence = _("Line {line}: it has {size:,} characters; give x and y, and nothing else.")
            raise PointsError(sentence.format(line=number, size=len(content)))
        said.append((number, content))
        if len(said) > MOST_POINTS + 1:
            break
    return said


def write_points(points: ArrayLike, separator: str = ",") -> str:
    """Points (n, 2) as text under the heading x, y, every digit kept; with tabs it pastes as a table."""
    rows: Iterable[list[float]] = np.asarray(points, float).reshape(-1, 2).tolist()
    return "".join(f"{a}{separator}{b}\n" for a, b in (("x", "y"), *((repr(x), repr(y)) for x, y in rows)))


def _dialect(lines: list[str]) -> tuple[str, bool]:
    """What parts the numbers, and whether a comma is the decimal sign."""
    for sign in ("\t", ";"):
        if any(sign in line for line in lines):
            return sign, any("," in line for line in lines)
    # Blanks part numbers with decimal commas: 1,5 2,5; a comma with blanks around it parts by itself.
    if any("," in line for line in lines):
        return (" ", True) if all(map(_has_decimal_comma, lines)) else (",", False)
    return " ", False


def _has_decimal_comma(line: str) -> bool:
    """Whether blanks part two numbers, at least one of which has a decimal comma."""
    match line.split():
        case [x, y]:
            return bool(_DECIMAL_COMMA.search(y) or (_DECIMAL_COMMA.search(x) and re.search(r"\d", y)))
    return False


def _is_heading(line: str) -> bool:
    cells = re.split(r"[\t;,\s]+", line.strip())
    return not any(_NUMBER.match(cell.strip('"').replace("\u2212", "-")) for cell in cells)


def _point(number: int, line: str, separator: str, comma: bool) -> tuple[float, float]:
    cells = re.split(_SEPARATORS[separator], line.strip(" "))
    while len(cells) > 2 and not cells[-1].strip():
        cells.pop()
    if len(cells) != 2:
        sentence = _("Line {line}: there are {count} values; give x and y, and nothing else.")
        raise PointsError(sentence.format(line=number, count=len(cells)))
    x, y = (_value(number, column, cell, comma) for column, cell in enumerate(cells, 1))
    return x, y


def _value(line: int, column: int, cell: str, comma: bool) -> float:
    text = cell.strip().strip('"').strip()
    plain = text.replace(",", ".", 1) if comma else text
    plain = plain.replace("\u2212", "-")
    where = {"line": line, "column": column, "text": text[:30]}
    if not _NUMBER.fullmatch(plain):
        sentence = _("Line {line}, column {column}: {text!r} is not a number; correct it.")
        raise PointsError(sentence.format(**where))
    value = float(plain)
    if not (math.isfinite(value) and abs(value) <= MAX_COORDINATE):
        sentence = _("Line {line}, column {column}: {text!r} is outside ±{most:,.0f}; give a smaller number.")
        raise PointsError(sentence.format(**where, most=MAX_COORDINATE))
    return value
