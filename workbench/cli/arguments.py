"""The arguments of an algorithm, read from the words of a command line.

A word is a Python literal, or ``@file`` for a literal in a file. A picture is rows of digits, the top row
first: in the file one row a line, blanks between its digits or not, on the command line a list of texts.
"""

import ast
import math
import re
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np

from workbench.algorithms.entry import Entry, Parameter
from workbench.cli.failure import BadInputError
from workbench.document.storage.content import read_text
from workbench.language import _, ngettext

MOST_BYTES = 20_000_000  # of a file: a picture as large as a sheet may be
MOST_CHARACTERS = 500_000  # of a literal: Python takes a thousand times the memory of its text to read one


def read_arguments(entry: Entry, words: Sequence[str]) -> tuple[Any, ...]:
    """The arguments for ``entry.function``; those with a default may be left out at the end.

    Without any word they are those of the entry's own example. Raises BadInputError, naming the argument.
    """
    if not words:
        return entry.example
    least = len(entry.parameters) - len(entry.function.__defaults__ or ())
    if not least <= len(words) <= len(entry.parameters):
        names = " ".join(parameter.name for parameter in entry.parameters)
        raise BadInputError(
            ngettext(
                "{slug} takes {count} arguments ({names}), but {given} was given.",
                "{slug} takes {count} arguments ({names}), but {given} were given.",
                len(words),
            ).format(slug=entry.slug, count=len(entry.parameters), names=names, given=len(words))
        )
    return tuple(_read(parameter, word) for parameter, word in zip(entry.parameters, words, strict=False))


def _read(parameter: Parameter, word: str) -> Any:
    where = f"{parameter.name} = {word}" if len(word) <= 40 else parameter.name
    try:
        text = read_text(word[1:], MOST_BYTES) if word.startswith("@") else word
        if parameter.kind == "image" and word.startswith("@"):
            lines = ("".join(line.split()) for line in text.splitlines())
            return _picture([line for line in lines if line])
        value = _CONVERT[parameter.kind](_literal(text))
        _check_range(parameter, value)
    except ValueError as error:
        raise BadInputError(f"{where}: {error}") from None
    return value


def _literal(text: str) -> Any:
    if len(text) > MOST_CHARACTERS:
        sentence = _("this has {size:,} characters, but at most {most:,} can be read; give fewer.")
        raise ValueError(sentence.format(size=len(text), most=MOST_CHARACTERS))
    try:
        return ast.literal_eval(text.strip())
    except (ValueError, TypeError, SyntaxError, RecursionError, MemoryError):
        most = sys.get_int_max_str_digits()
        if most and re.search(rf"(?<!\d)[0-9_]{{{most + 1}}}", text):
            sentence = _("this has a number of more than {most:,} digits; give a shorter one.")
            raise ValueError(sentence.format(most=most)) from None
        raise ValueError(_("this is not a number or a list as Python writes it.")) from None


def _check_range(parameter: Parameter, value: Any) -> None:
    if parameter.kind not in ("int", "float"):
        return
    low, high = parameter.low, parameter.high
    if low is not None and value < low:
        raise ValueError(_("it must be at least {low:g}.").format(low=low))
    if high is not None and value > high:
        raise ValueError(_("it must be at most {high:g}.").format(high=high))


def _whole(value: Any) -> int:
    if isinstance(value, bool) or not isinstance(value, int):
        raise ValueError(_("it must be a whole number."))
    if not -(2**63) <= value < 2**63:
        raise ValueError(_("it does not fit in 64 bits."))
    return value


def _real(value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ValueError(_("it must be a number."))
    try:
        real = float(value)
    except OverflowError:
        real = math.inf
    if not math.isfinite(real):
        raise ValueError(_("it must be a finite number."))
    return real


def _truth(value: Any) -> bool:
    if not isinstance(value, bool | int) or value not in (0, 1):
        raise ValueError(_("it must be True or False."))
    return bool(value)


def _listed(value: Any) -> list[Any]:
    if not isinstance(value, list | tuple):
        raise ValueError(_("it must be a list."))
    return list(value)


def _points(value: Any) -> Any:
    rows = _equally_long([[_real(number) for number in _listed(point)] for point in _listed(value)])
    return np.array(rows, dtype=np.float64).reshape(len(rows), -1)


def _matrix(value: Any) -> Any:
    """A (rows, columns) array; a single list of numbers is a column."""
    listed = _listed(value)
    if not listed:
        raise ValueError(_("the matrix is empty."))
    if not any(isinstance(row, list | tuple) for row in listed):
        return _reals(listed).reshape(-1, 1)
    return _points(listed)


def _integers(value: Any) -> Any:
    """Whole numbers, or rows of equally many."""
    listed = _listed(value)
    if listed and all(isinstance(row, list | tuple) for row in listed):
        return np.array(_equally_long([[_whole(number) for number in row] for row in listed]), dtype=np.int64)
    return np.array([_whole(number) for number in listed], dtype=np.int64)


def _reals(value: Any) -> Any:
    return np.array([_real(number) for number in _listed(value)], dtype=np.float64)


def _depths(value: Any) -> Any:
    """An (h, w) array, row 0 lowest, from rows of numbers, the top row first."""
    rows = _equally_long([[_real(number) for number in _listed(row)] for row in _listed(value)])
    return np.array(rows[::-1], dtype=np.float64).reshape(len(rows), -1)


def _equally_long(rows: list[list[Any]]) -> list[list[Any]]:
    if len({len(row) for row in rows}) > 1:
        raise ValueError(_("its rows are not all the same length."))
    return rows


def _picture(value: Any) -> Any:
    """An (h, w) array, row 0 lowest, from rows of digits, the top row first."""
    rows = [
        str(row) if isinstance(row, str | int) else "".join(map(str, _listed(row))) for row in _listed(value)
    ]
    if not rows or not rows[0]:
        raise ValueError(_("the picture is empty."))
    for number, row in enumerate(rows, 1):
        if not (row.isascii() and row.isdecimal()):
            raise ValueError(_("row {number} of the picture is not made of digits.").format(number=number))
        if len(row) != len(rows[0]):
            raise ValueError(
                _("row {number} of the picture has {length} digits, but the first has {first}.").format(
                    number=number, length=len(row), first=len(rows[0])
                )
            )
    return np.array([[int(digit) for digit in row] for row in reversed(rows)], dtype=np.int64)


_CONVERT = {
    "int": _whole,
    "float": _real,
    "bool": _truth,
    "colour": _whole,
    "image": _picture,
    "depth": _depths,
    "points": _points,
    "floats": _reals,
    "ints": _integers,
    "matrix": _matrix,
}
