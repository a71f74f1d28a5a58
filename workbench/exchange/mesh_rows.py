"""Lines of numbers as arrays, as mesh files have them by the million."""

from typing import Any, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_COMMAS = bytes.maketrans(b" \n", b",,")
# Ten times as fast as NumPy's own, and as exact; it takes numbers as JSON writes them, which nearly all are.
_decoder = msgspec.json.Decoder(list[float])


class Rows(NamedTuple):
    """The numbers of some lines, one line after the other, and how many each line has.

    ``lines`` are the numbers of the lines, among those that were given, that hold numbers alone.
    """

    numbers: Array
    sizes: Index
    lines: Index

    @property
    def starts(self) -> Index:
        """Where in ``numbers`` each line begins."""
        return np.cumsum(self.sizes) - self.sizes

    def columns(self, first: int, count: int) -> Array:
        """``count`` numbers of each line from its ``first`` on; every line must have as many."""
        columns: Array = self.numbers[self.starts[:, None] + np.arange(first, first + count)]
        return columns


def numbers_of(text: bytes) -> Array:
    """The numbers of a text with blanks between them. Raises: ValueError where it holds anything else."""
    if b"," in text:
        raise ValueError  # it would part what is one number to who wrote it
    if text[:1].isspace() or text[-1:].isspace() or b"  " in text or not text:
        text = b" ".join(text.split())
    try:
        return np.array(_decoder.decode(b"[" + text.translate(_COMMAS) + b"]"), np.float64)
    except msgspec.DecodeError:
        return np.fromstring(text.replace(b"\0", b"?"), np.float64, sep=" ")


def whole_numbers(numbers: NDArray[Any], otherwise: int) -> Index:
    """Numbers as whole ones; ``otherwise`` where one is none, or does not fit in 53 bits."""
    if np.issubdtype(numbers.dtype, np.integer):
        return numbers.astype(np.int64)
    fits = (np.abs(numbers) < 2.0**53) & (numbers == np.floor(numbers))
    return np.where(fits, numbers, otherwise).astype(np.int64)


def rows_of(lines: list[bytes]) -> Rows:
    """The numbers of lines; a line that holds anything else is left out."""
    text = b"\n".join(lines)
    if b"  " in text or b" \n" in text or b"\n " in text or text[:1] == b" " or text[-1:] == b" ":
        lines = [b" ".join(line.split()) for line in lines]
        text = b"\n".join(lines)
    sizes = np.fromiter((line.count(b" ") + (line != b"") for line in lines), np.int64, len(lines))
    try:
        numbers = numbers_of(text)
    except ValueError:
        return _line_by_line(lines)
    if len(numbers) != sizes.sum():  # something else than blanks parts some of them
        return _line_by_line(lines)
    return Rows(numbers, sizes, np.arange(len(lines)))


def _line_by_line(lines: list[bytes]) -> Rows:
    parts = [(number, values) for number, line in enumerate(lines) if (values := _try(line)) is not None]
    numbers = np.concatenate([values for _number, values in parts] or [np.zeros(0)])
    sizes = np.array([len(values) for _number, values in parts], np.int64)
    return Rows(numbers, sizes, np.array([number for number, _values in parts], np.int64))


def _try(line: bytes) -> Array | None:
    try:
        return numbers_of(line)
    except ValueError:
        return None
