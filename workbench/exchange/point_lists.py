"""Points from text and as text: a CSV file, or what a table on the clipboard gives.

Two numbers a line, parted by commas, semicolons, tabs or blanks; a comma may be the decimal sign where
something else parts the numbers. One heading line is passed over, as are empty lines and those after #.
"""

import math
import re
from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.document.check import MAX_COORDINATE
from workbench.language import _

MOST_POINTS = 100_000

_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")
_SEPARATORS = {"\t": r"\t", ";": ";", ",": ",", " ": r"\s+"}


class PointsError(ValueError):
    """Text that holds no points: one sentence with line and column."""


def read_points(text: str) -> NDArray[np.float64]:
    """The points (n, 2) in a text, world units. Raises: PointsError."""
    lines = [
        (number, line.partition("#")[0].strip(" \r\ufeff"))
        for number, line in enumerate(text.splitlines(), 1)
    ]
    lines = [(number, line) for number, line in lines if line.strip()]
    if not lines:
        raise PointsError(_("There are no points; give two numbers a line."))
    if _is_heading(lines[0][1]):
        lines = lines[1:]
    if not lines:
        raise PointsError(_("There is a heading and no points; give two numbers a line."))
    if len(lines) > MOST_POINTS:
        sentence = _("There are {count:,} points, and at most {most:,} can be read; give fewer.")
        raise PointsError(sentence.format(count=len(lines), most=MOST_POINTS))
    separator, comma = _dialect([line for _number, line in lines])
    return np.array([_point(number, line, separator, comma) for number, line in lines])


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
        blank = all(re.fullmatch(r"\S*\d,\d\S*\s+\S*\d\S*|\S+\s+\S*\d,\d\S*", line.strip()) for line in lines)
        return (" ", True) if blank else (",", False)
    return " ", False


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
        sentence = _("Line {line}, column {column}: {text!r} is no number; correct it.")
        raise PointsError(sentence.format(**where))
    value = float(plain)
    if not (math.isfinite(value) and abs(value) <= MAX_COORDINATE):
        sentence = _("Line {line}, column {column}: {text!r} is outside ±{most:,.0f}; give a smaller number.")
        raise PointsError(sentence.format(**where, most=MAX_COORDINATE))
    return value
