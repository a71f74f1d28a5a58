"""A row of terms, laid out: matrices, signs and phrases beside one another, on several lines where narrow."""

import itertools
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from workbench.exchange.formulas.layout import Box, MatrixBox, Primitive, Rectangle, Typesetter, moved
from workbench.exchange.formulas.terms import Matrix, Phrase, Place, Shows, Sign, Term, Terms

_NOTE = 0.85
_BETWEEN, _ADJACENT, _LINES, _INDENT = 0.6, 0.3, 0.8, 1.2


class LaidRow(NamedTuple):
    """The primitives of a row from (0, 0) at its top left, the rectangle of each cell, each term's columns.

    ``widest`` is how wide the widest term is, with the sign before it: it needs at least that much room.
    """

    width: float
    height: float
    widest: float
    primitives: tuple[Primitive, ...]
    cells: dict[Place, Rectangle]
    columns: dict[int, tuple[float, ...]]


class _Item(NamedTuple):
    """A term about the left end of its line's middle."""

    number: int
    term: Term
    width: float
    above: float
    below: float
    primitives: tuple[Primitive, ...]
    cells: dict[tuple[int, int], Rectangle]
    columns: tuple[float, ...]


def lay_out(
    typesetter: Typesetter,
    terms: Terms,
    shows: Shows,
    size: float,
    room: float,
    least: Mapping[int, tuple[float, ...]] | None = None,
) -> LaidRow:
    """Lay ``terms`` out in type of ``size``, on as many lines as ``room`` asks for, broken before a term.

    ``least`` are the least widths of a matrix's columns, so that nothing moves while its numbers change.
    """
    items = [
        _item(typesetter, number, term, shows, size, (least or {}).get(number, ()))
        for number, term in enumerate(terms)
    ]
    groups = _groups(items)
    widest = max((_width(group, size) for group in groups), default=0.0)
    indent = min(_INDENT * size, max(0.0, room - widest))
    primitives: list[Primitive] = []
    cells: dict[Place, Rectangle] = {}
    width = y = 0.0
    for number, line in enumerate(_lines(groups, size, room, indent)):
        x = indent if number else 0.0
        above, below = (max(getattr(item, side) for item in line) for side in ("above", "below"))
        y += _LINES * size if number else 0.0
        for k, item in enumerate(line):
            x += _gap(line[k - 1].term, item.term) * size if k else 0.0
            primitives += moved(item.primitives, x, y + above)
            for (i, j), cell in item.cells.items():
                cells[item.number, i, j] = cell.moved(x, y + above)
            x += item.width
        width = max(width, x)
        y += above + below
    columns = {item.number: item.columns for item in items if item.columns}
    return LaidRow(width, y, widest, tuple(primitives), cells, columns)


def widest_of(typesetter: Typesetter, terms: Terms, shows: Shows, size: float) -> float:
    """The least room that ``terms`` need in type of ``size``."""
    items = [_item(typesetter, number, term, shows, size, ()) for number, term in enumerate(terms)]
    return max((_width(group, size) for group in _groups(items)), default=0.0)


def _item(
    typesetter: Typesetter, number: int, term: Term, shows: Shows, size: float, least: tuple[float, ...]
) -> _Item:
    match term:
        case Matrix():
            box: MatrixBox = typesetter.matrix(term, shows, size, least)
            return _Item(number, term, *box)
        case Sign():
            sign = typesetter.formula(term.text, 1.15 * size)
        case Phrase(note=True):
            sign = typesetter.formula(term.formula, _NOTE * size, ink="muted")
        case Phrase():
            sign = typesetter.formula(term.formula, 1.1 * size, term.strong)
    return _about_the_middle(number, term, sign)


def _about_the_middle(number: int, term: Term, box: Box) -> _Item:
    half = box.height / 2
    shifted = moved(box.primitives, 0.0, (box.ascent - box.descent) / 2)
    return _Item(number, term, box.width, half, half, tuple(shifted), {}, ())


def _groups(items: Sequence[_Item]) -> list[list[_Item]]:
    """What stays together: a sign and what follows it."""
    groups: list[list[_Item]] = []
    for item in items:
        if groups and isinstance(groups[-1][-1].term, Sign):
            groups[-1].append(item)
        else:
            groups.append([item])
    return groups


def _width(line: Sequence[_Item], size: float) -> float:
    gaps = sum(_gap(a.term, b.term) for a, b in itertools.pairwise(line)) * size
    return sum(item.width for item in line) + gaps


def _lines(groups: list[list[_Item]], size: float, room: float, indent: float) -> list[list[_Item]]:
    """The terms of each line."""
    lines: list[list[_Item]] = []
    for group in groups:
        left = indent if len(lines) > 1 else 0.0
        if lines and left + _width([*lines[-1], *group], size) <= room + 1e-6:
            lines[-1] += group
        else:
            lines.append(list(group))
    return lines


def _gap(before: Term, after: Term) -> float:
    return _ADJACENT if isinstance(before, Matrix) and isinstance(after, Matrix) else _BETWEEN
