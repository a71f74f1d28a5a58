"""Path data of SVG, looked at strictly before it is believed: every command, number and flag.

Source: SVG 1.1, section 8.3, and the grammar for path data in 8.3.9.
"""

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from workbench.exchange.svg_arcs import Arc
from workbench.exchange.svg_tree import SvgError
from workbench.language import _

LARGEST = 1e12
MOST_POINTS = 200_000  # in one drawing, handles of curves included

_BETWEEN = re.compile(r"[\s,]*")
_BLANK = re.compile(r"\s*")
_NUMBER = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?")
_NUMBERS = re.compile(rf"({_NUMBER.pattern})[\s,]*")
_COUNTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
_POINTS = {"C": 3, "S": 3, "Q": 2, "T": 2}
_MIRRORED_BY = {"C": "S", "S": "S", "Q": "T", "T": "T"}
_FLAGS = (3, 4)


class TooManyPointsError(SvgError):
    """A drawing has more points than are read; the sentence begins small."""

    def __init__(self) -> None:
        super().__init__(
            _("there are more than {most:,} points; choose a smaller picture.").format(most=MOST_POINTS)
        )


Place = tuple[float, float]


@dataclass(slots=True)
class Run:
    """Segments each of which begins where the one before ends, in the coordinates of the path.

    ``kinds`` are their degrees, or arcs; ``points`` the begin, then of each segment what follows its begin:
    as many points as its degree, of an arc its end.
    """

    points: list[Place]
    kinds: list[int | Arc] = field(default_factory=list)
    closed: bool = False

    @property
    def curved(self) -> bool:
        """Whether any segment is no line."""
        return any(kind != 1 for kind in self.kinds)


def runs(data: str) -> list[Run]:
    """The runs of path data. Raises: SvgError as ``commands`` does."""
    drawn: list[Run] = []
    x = y = 0.0
    handle, mirrored_by = (0.0, 0.0), ""
    for letter, values in commands(data):
        kind = letter.upper()
        if kind == "Z":
            if drawn[-1].closed:
                drawn.append(Run(drawn[-1].points[:1]))
            drawn[-1].closed = True
            (x, y), mirrored_by = drawn[-1].points[0], ""
            continue
        needed = _COUNTS[kind]
        for k in range(0, len(values), needed):
            part = values[k : k + needed]
            if letter != kind:
                part = _absolute(kind, part, x, y)
            here, inner, segment = (x, y), [], 1  # type: Place, list[Place], int | Arc
            match kind:
                case "H":
                    x = part[0]
                case "V":
                    y = part[0]
                case "A":
                    x, y = part[5:]
                    rx, ry, turn, large, sweep = part[:5]
                    segment = Arc(rx, ry, turn, bool(large), bool(sweep))
                case _:
                    x, y = part[-2:]
                    inner = list(zip(part[:-2:2], part[1:-2:2], strict=True))
            if kind == "M" and k == 0:
                drawn.append(Run([(x, y)]))
                mirrored_by = ""
                continue
            if kind in "ST":
                inner.insert(0, _mirrored(handle, here) if kind == mirrored_by else here)
            if inner:
                handle, segment = inner[-1], len(inner) + 1
            mirrored_by = _MIRRORED_BY.get(kind, "")
            if drawn[-1].closed:
                drawn.append(Run(drawn[-1].points[:1]))
            drawn[-1].kinds.append(segment)
            drawn[-1].points += [*inner, (x, y)]
    return drawn


def _absolute(kind: str, part: list[float], x: float, y: float) -> list[float]:
    match kind:
        case "H":
            return [part[0] + x]
        case "V":
            return [part[0] + y]
        case "A":
            return [*part[:5], part[5] + x, part[6] + y]
    return [value + (y if k % 2 else x) for k, value in enumerate(part)]


def _mirrored(handle: Place, about: Place) -> Place:
    return 2.0 * about[0] - handle[0], 2.0 * about[1] - handle[1]


def commands(data: str) -> Iterator[tuple[str, list[float]]]:
    """Each command with all its numbers, as many as it needs once or several times.

    Raises: SvgError, a sentence that begins small and names the number of the command, counted from 1.
    """
    at, number, points = _BLANK.match(data).end(), 0, 0  # type: ignore[union-attr]
    while at < len(data):
        number += 1
        letter = data[at]
        needed = _COUNTS.get(letter.upper(), -1)
        if needed < 0:
            raise _refusal(number, _("{what} is not a command").format(what=_excerpt(data, at)))
        if number == 1 and letter not in "Mm":
            raise _refusal(1, _("a path begins with M, not with {letter}").format(letter=letter))
        at = _BLANK.match(data, at + 1).end()  # type: ignore[union-attr]
        values: list[float] = []
        if needed:
            read = _arc_values if letter in "Aa" else _values
            at = read(data, at, number, values)
        if needed and (not values or len(values) % needed):
            there = len(values) % needed
            what = _("{letter} needs {needed} numbers, but has only {there}").format(
                letter=letter, needed=needed, there=there
            )
            if at < len(data) and data[at].upper() not in _COUNTS:
                what = _("{what} is not a number").format(what=_excerpt(data, at))
            raise _refusal(number, what)
        points += len(values) // max(needed, 1) * _POINTS.get(letter.upper(), 1) + 1
        if points > MOST_POINTS:
            raise TooManyPointsError
        yield letter, values


def _values(data: str, at: int, number: int, values: list[float]) -> int:
    """Put the numbers that begin at ``at`` on the end of ``values``; returns where what follows begins."""
    while match := _NUMBERS.match(data, at):
        values.append(_checked(match[1], number))
        at = match.end()
        if len(values) > 2 * MOST_POINTS:
            raise TooManyPointsError
    return at


def _arc_values(data: str, at: int, number: int, values: list[float]) -> int:
    """The same of arcs, whose two flags need nothing between them."""
    while at < len(data) and len(values) <= 2 * MOST_POINTS:
        if len(values) % 7 in _FLAGS:
            if data[at] not in "01":
                raise _refusal(
                    number, _("{what} is not a flag, which is 0 or 1").format(what=_excerpt(data, at))
                )
            values.append(int(data[at]))
            at += 1
        elif match := _NUMBER.match(data, at):
            values.append(_checked(match.group(), number))
            at = match.end()
        else:
            break
        at = _BETWEEN.match(data, at).end()  # type: ignore[union-attr]
    return at


def _checked(text: str, number: int) -> float:
    value = float(text)
    if not (math.isfinite(value) and abs(value) <= LARGEST):
        what = _("{value} is too large; at most {most:g} can be drawn")
        raise _refusal(number, what.format(value=text[:20], most=LARGEST))
    return value


def _refusal(number: int, what: str) -> SvgError:
    sentence = _("command {number} of the path is wrong: {what}; correct it there.")
    return SvgError(sentence.format(number=number, what=what))


def _excerpt(data: str, at: int) -> str:
    return repr(data[at : at + 12])
