"""Sentences with their numbers: a template filled in, in pieces that can be linked."""

import re
import string
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, Literal, NamedTuple

from workbench.algorithms.numerals import numeral, with_minus

Link = tuple[Literal["variable"], str] | tuple[Literal["pixel"], tuple[int, int]]

_OPERATORS = ("+", "−", "·", "×", "/")
_NAME = re.compile(r"(?:before\.)?([^\W\d]\w*)")


class Part(NamedTuple):
    """A piece of a sentence; ``link`` is the variable or the pixel it stands for, or None."""

    text: str
    link: Link | None


def fill_in(template: str, value: Callable[[str], Any]) -> tuple[Part, ...]:
    """The pieces of ``template``, each ``{expression}`` replaced by what ``value`` makes of it.

    A name becomes a link to that variable, a pair of whole numbers one to that pixel. A negative number after
    an operator stands in brackets: 0 − (−5).
    """
    parts: list[Part] = []
    for text, expression, _, _ in string.Formatter().parse(template):
        if text:
            parts.append(Part(text, None))
        if expression is not None:
            result = value(expression)
            parts.append(Part(_operand(text, number_text(result)), _link(expression, result)))
    return tuple(parts)


def _operand(before: str, number: str) -> str:
    return f"({number})" if number.startswith("−") and before.rstrip().endswith(_OPERATORS) else number


def joined(sentences: Iterable[Sequence[Part]]) -> Iterator[Part]:
    """Several sentences one after the other, with a space between."""
    told = [sentence for sentence in sentences if sentence]
    for number, sentence in enumerate(told):
        if number:
            yield Part(" ", None)
        yield from sentence


def number_text(value: Any) -> str:
    """A value as a sentence or a table shows it: four decimals at most, a true minus sign."""
    if isinstance(value, tuple | list):
        return f"({', '.join(number_text(item) for item in value)})"
    if isinstance(value, bool) or not hasattr(value, "__float__"):
        return str(value)
    if float(value).is_integer() and not isinstance(value, float):
        return with_minus(str(int(value)))
    return numeral(value)


def _link(expression: str, value: Any) -> Link | None:
    if isinstance(value, tuple) and len(value) == 2 and all(float(part).is_integer() for part in value):
        return "pixel", (int(value[0]), int(value[1]))
    name = _NAME.fullmatch(expression.strip())
    return ("variable", name[1]) if name else None
