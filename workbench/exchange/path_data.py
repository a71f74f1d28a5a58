"""Path data of SVG, looked at strictly before it is believed: every command, number and flag.

Source: SVG 1.1, section 8.3.9, the grammar for path data.
"""

import math
import re
from collections.abc import Iterator
from typing import NamedTuple

from workbench.exchange.svg_arcs import Arc
from workbench.exchange.svg_tree import SvgError
from workbench.language import _

LARGEST = 1e12

_BETWEEN = re.compile(r"[\s,]*")
_BLANK = re.compile(r"\s*")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")
_COUNTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
_FLAGS = (3, 4)
_MIRRORED = {"S": "CS", "T": "QT"}


def commands(data: str) -> Iterator[tuple[str, list[float]]]:
    """Each command with all its numbers, as many as it needs once or several times.

    Raises: SvgError, a sentence that begins small and names the number of the command, counted from 1.
    """
    at, number = _BLANK.match(data).end(), 0  # type: ignore[union-attr]
    while at < len(data):
        number += 1
        letter = data[at]
        needed = _COUNTS.get(letter.upper(), -1)
        if needed < 0:
            raise _refusal(number, _("{what} is no command").format(what=_shown(data, at)))
        if number == 1 and letter not in "Mm":
            raise _refusal(1, _("a path begins with M, not with {letter}").format(letter=letter))
        at += 1
        values: list[float] = []
        at = _BLANK.match(data, at).end()  # type: ignore[union-attr]
        while needed and at < len(data):
            found = _value(data, at, letter, len(values), number)
            if found is None:
                break
            value, at = found
            values.append(value)
            at = _BETWEEN.match(data, at).end()  # type: ignore[union-attr]
        if needed and (not values or len(values) % needed):
            there = len(values) % needed
            what = _("{letter} needs {needed} numbers, and {there} are there").format(
                letter=letter, needed=needed, there=there
            )
            if at < len(data) and data[at].upper() not in _COUNTS:
                what = _("{what} is no number").format(what=_shown(data, at))
            raise _refusal(number, what)
        yield letter, values


class PathData(NamedTuple):
    """Path data as svgelements takes it; its segments are counted from 0.

    ``arcs`` are written as lines, and stated here by the number of their segment: svgelements loses the way
    round of an arc whose ends are near to each other. ``put_in`` are lines without length before S and T that
    follow another kind of segment, since svgelements mirrors the control point of any.
    """

    text: str
    arcs: dict[int, Arc]
    put_in: set[int]


def checked(data: str) -> PathData:
    """Path data that was looked at. Raises: SvgError as ``commands`` does."""
    found = PathData("", {}, set())
    words: list[str] = []
    count, before = 0, ""
    for letter, values in commands(data):
        kind = letter.upper()
        if kind in _MIRRORED and before not in _MIRRORED[kind]:
            words.append("l 0 0")
            found.put_in.add(count)
            count += 1
        if kind == "A":
            for k in range(0, len(values), 7):
                rx, ry, turn, large, sweep = values[k : k + 5]
                found.arcs[count + k // 7] = Arc(rx, ry, turn, bool(large), bool(sweep))
                words += ["l" if letter == "a" else "L", *map(repr, values[k + 5 : k + 7])]
        else:
            words += [letter, *map(repr, values)]
        count += len(values) // _COUNTS[kind] if values else 1
        before = kind
    return found._replace(text=" ".join(words))


def _value(data: str, at: int, letter: str, count: int, number: int) -> tuple[float, int] | None:
    """The number or flag at ``at``, and where it ends."""
    if letter in "Aa" and count % 7 in _FLAGS:
        if data[at] not in "01":
            what = _("{what} is no flag, which is 0 or 1").format(what=_shown(data, at))
            raise _refusal(number, what)
        return int(data[at]), at + 1
    found = _NUMBER.match(data, at)
    if found is None:
        return None
    value = float(found.group())
    if not (math.isfinite(value) and abs(value) <= LARGEST):
        what = _("{value} is too large; at most {most:g} can be drawn")
        raise _refusal(number, what.format(value=found.group()[:20], most=LARGEST))
    return value, found.end()


def _refusal(number: int, what: str) -> SvgError:
    sentence = _("command {number} of the path is wrong: {what}; correct it there.")
    return SvgError(sentence.format(number=number, what=what))


def _shown(data: str, at: int) -> str:
    return repr(data[at : at + 12])
