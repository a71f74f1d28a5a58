"""Points from text and as text: a CSV file, or what a table on the clipboard gives.

Two numbers a line, parted by commas, semicolons, tabs or blanks, in brackets or not; a comma may be the
decimal sign where something else parts the numbers, or quotes hold them together. A line such as ``sep=;``,
one heading line, empty lines and what stands after # are passed over.
"""

import codecs
import io
import math
import re
from collections.abc import Iterable
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.document.numbers import MAX_COORDINATE
from workbench.document.storage.content import Progress, decoded, silent
from workbench.language import _

Array = NDArray[np.float64]

MOST_POINTS = 100_000
MOST_CHARACTERS = 16 * 2**20
LONGEST_LINE = 10_000
_BETWEEN_REPORTS = 1000
_MOST_JSON = 4 * 2**20

_NUMBER = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?")
_DECIMAL_COMMA = re.compile(r"\d,\d")
_SEPARATORS = {"\t": r"\t", ";": ";", ",": ",", " ": r"\s+"}
_STATED = re.compile(r"sep=([,;\t])", re.IGNORECASE)
_QUOTED = re.compile(r'"([^"]*)"')
_BRACKETED = re.compile(r"[(\[{]+([^()\[\]{}]*)[)\]}]+[,;]?")
_HELD = "\x1f"  # stands for a comma between quotes, which parts nothing


class PointsError(ValueError):
    """Text that holds no points: one sentence with line and column."""


def text_of(content: bytes, path: Path | str) -> str:
    """The text of a list of points as tables are saved: UTF-8, UTF-16, or else as Windows writes it.

    Raises: DocumentError where it is no text.
    """
    if content[:2] in (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE):
        return content.decode("utf-16", "replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        if b"\0" in content:
            return decoded(content, path)
        return content.decode("cp1252", "replace")


def read_points(text: str, progress: Progress = silent) -> Array:
    """The points (n, 2) in a text, world units. Raises: PointsError."""
    if len(text) > MOST_CHARACTERS:
        sentence = _("The list has {size:,} characters, but at most {most:,} can be read; give fewer points.")
        raise PointsError(sentence.format(size=len(text), most=MOST_CHARACTERS))
    pairs = _pairs_of_json(text)
    if pairs is not None:
        text = "\n".join(f"{x!r} {y!r}" for x, y in pairs)
    lines = _lines(text)
    stated = _STATED.fullmatch(lines[0][1].strip()) if lines else None
    lines = lines[1:] if stated else lines
    if not lines:
        raise PointsError(_("There are no points; give two numbers on each line."))
    if _is_heading(lines[0][1]):
        lines = lines[1:]
    if not lines:
        raise PointsError(_("There is a heading but no points; give two numbers on each line."))
    if len(lines) > MOST_POINTS:
        sentence = _("There are more than {most:,} points, the most that can be read; give fewer.")
        raise PointsError(sentence.format(most=MOST_POINTS))
    separator, comma = _dialect([line for _number, line in lines], stated[1] if stated else "")
    points = np.empty((len(lines), 2))
    for row, (number, line) in enumerate(lines):
        if row % _BETWEEN_REPORTS == 0:
            progress(row / len(lines))
        points[row] = _point(number, line, separator, comma)
    return points


def _pairs_of_json(text: str) -> list[tuple[float, float]] | None:
    """The pairs in a list of pairs such as programs write; None where the text is none."""
    text = text.strip("\ufeff \t\r\n")
    if not text.startswith("[") or len(text) > _MOST_JSON:
        return None
    try:
        pairs = msgspec.json.decode(text, type=list[tuple[float, float]])
    except msgspec.MsgspecError:
        return None
    return pairs or None


def _lines(text: str) -> list[tuple[int, str]]:
    """Number and content of the lines that say something, of no more than are read and a heading."""
    said: list[tuple[int, str]] = []
    for number, line in enumerate(io.StringIO(text, newline=None), 1):
        content, comment, _rest = line.partition("#")
        content = (content.rstrip() if comment else content).strip(" \r\n\ufeff")
        if not content or content.isspace():
            continue
        if len(content) > LONGEST_LINE:
            sentence = _("Line {line}: it has {size:,} characters; give x and y, and nothing else.")
            raise PointsError(sentence.format(line=number, size=len(content)))
        if content[0] in "([{" and (bracketed := _BRACKETED.fullmatch(content)):
            content = bracketed[1]
        if '"' in content:
            content = _QUOTED.sub(lambda cell: cell[1].replace(",", _HELD), content)
        said.append((number, content))
        if len(said) > MOST_POINTS + 1:
            break
    return said


def write_points(points: ArrayLike, separator: str = ",") -> str:
    """Points (n, 2) as text under the heading x, y, every digit kept; with tabs it pastes as a table."""
    rows: Iterable[list[float]] = np.asarray(points, float).reshape(-1, 2).tolist()
    return "".join(f"{a}{separator}{b}\n" for a, b in (("x", "y"), *((repr(x), repr(y)) for x, y in rows)))


def _dialect(lines: list[str], stated: str) -> tuple[str, bool]:
    """What parts the numbers, if it is not ``stated``, and whether a comma is the decimal sign."""
    if stated:
        return stated, stated != ","
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
    return not any(_NUMBER.fullmatch(cell.replace(_HELD, ".").replace("\u2212", "-")) for cell in cells)


def _point(number: int, line: str, separator: str, comma: bool) -> tuple[float, float]:
    cells = re.split(_SEPARATORS[separator], line.strip(" "))
    while len(cells) > 2 and not cells[-1].strip():
        cells.pop()
    if len(cells) < 2:
        sentence = _("Line {line}: there is only one value; give x and y with {sign} between them.")
        raise PointsError(sentence.format(line=number, sign=_name_of(separator)))
    if len(cells) > 2:
        sentence = _("Line {line}: there are {count} values; give x and y, and nothing else.")
        raise PointsError(sentence.format(line=number, count=len(cells)))
    x, y = (_value(number, column, cell, comma) for column, cell in enumerate(cells, 1))
    return x, y


def _name_of(separator: str) -> str:
    names = {"\t": _("a tab"), ";": _("a semicolon"), ",": _("a comma"), " ": _("a blank")}
    return names[separator]


def _value(line: int, column: int, cell: str, comma: bool) -> float:
    text = cell.strip()
    plain = text.replace(",", ".", 1) if comma else text
    plain = plain.replace(_HELD, ".", 1).replace("\u2212", "-")
    where = {"line": line, "column": column, "text": text[:30].replace(_HELD, ",")}
    if not _NUMBER.fullmatch(plain):
        sentence = _("Line {line}, column {column}: {text!r} is not a number; correct it.")
        raise PointsError(sentence.format(**where))
    value = float(plain)
    if not (math.isfinite(value) and abs(value) <= MAX_COORDINATE):
        sentence = _("Line {line}, column {column}: {text!r} is outside ±{most:,.0f}; give a smaller number.")
        raise PointsError(sentence.format(**where, most=MAX_COORDINATE))
    return value
