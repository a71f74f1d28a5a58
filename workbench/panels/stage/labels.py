"""Labels go to that side of their points where they hide least of the handles, and of one another."""

import math
from collections.abc import Iterable, Sequence

from workbench.algorithms.marks import Word
from workbench.widgets.canvas.drawing import Drawn

Place = tuple[float, float]
Box = tuple[float, float, float, float]

_LETTER_PX, _HIGH_PX, _AWAY_PX, _PAD_PX = 6.8, 18.0, 7.0, 6.0
_GRIP_PX = 8.0
_SIDES = ((1, 1), (-1, 1), (1, -1), (-1, -1), (1, 0), (-1, 0), (0, 1), (0, -1))


def clear_of(drawn: Iterable[Drawn], handles: Sequence[Place], unit: float) -> list[Drawn]:
    """What is drawn, its carded words at the side where they cover least of ``handles`` (device); their own
    side is the first choice. ``unit`` device units are one logical pixel.
    """
    reach = _GRIP_PX * unit
    taken = [(x - reach, y - reach, x + reach, y + reach) for x, y in handles]
    placed: list[Drawn] = []
    for each in drawn:
        if isinstance(each, Word) and each.carded:
            each, box = _freest(each, taken, unit)
            taken.append(box)
        placed.append(each)
    return placed


def _freest(word: Word, taken: Sequence[Box], unit: float) -> tuple[Word, Box]:
    """The word at its first side that is free, else at that where it hides least, and where it is then."""
    best, least = (word, word_box(word, unit)), math.inf
    for right, up in dict.fromkeys(((word.right, word.up), *_SIDES)):
        turned = word._replace(right=right, up=up)
        box = word_box(turned, unit)
        hidden = sum(overlap(box, other) for other in taken)
        if hidden < least:
            best, least = (turned, box), hidden
        if hidden == 0.0:
            break
    return best


def word_box(word: Word, unit: float) -> Box:
    """About where a word is painted."""
    wide, high = (_LETTER_PX * len(word.text) + _PAD_PX) * unit, _HIGH_PX * unit
    left = word.x + word.right * _AWAY_PX * unit - wide * (1 - word.right) / 2
    low = word.y + word.up * _AWAY_PX * unit - high * (1 - word.up) / 2
    return left, low, left + wide, low + high


def overlap(a: Box, b: Box) -> float:
    """The area that two boxes have in common."""
    if a[0] >= b[2] or b[0] >= a[2] or a[1] >= b[3] or b[1] >= a[3]:
        return 0.0
    return (min(a[2], b[2]) - max(a[0], b[0])) * (min(a[3], b[3]) - max(a[1], b[1]))
