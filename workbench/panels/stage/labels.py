"""Labels go to that side of their points where they hide least of the handles, and of one another."""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import Word
from workbench.widgets.canvas.drawing import Drawn
from workbench.widgets.canvas.label_places import Box, around, freest

Place = tuple[float, float]

_LETTER_PX, _HIGH_PX, _AWAY_PX, _PAD_PX = 6.8, 18.0, 7.0, 6.0
_GRIP_PX = 8.0
_SIDES = ((1, 1), (-1, 1), (1, -1), (-1, -1), (1, 0), (-1, 0), (0, 1), (0, -1))


def clear_of(drawn: Iterable[Drawn], handles: Sequence[Place], unit: float) -> list[Drawn]:
    """What is drawn, its carded words at the side where they cover least of ``handles`` (device); their own
    side is the first choice. ``unit`` device units are one logical pixel.
    """
    reach = _GRIP_PX * unit
    taken = around(np.array(handles, np.float64).reshape(-1, 2), reach)
    placed: list[Drawn] = []
    for each in drawn:
        if isinstance(each, Word) and each.carded:
            each, box = _freest(each, taken, unit)
            taken = np.vstack([taken, box])
        placed.append(each)
    return placed


def _freest(word: Word, taken: NDArray[np.float64], unit: float) -> tuple[Word, Box]:
    """The word at its first side that is free, else at that where it hides least, and where it is then."""
    sides = list(dict.fromkeys(((word.right, word.up), *_SIDES)))
    turned = [word._replace(right=right, up=up) for right, up in sides]
    boxes = [word_box(each, unit) for each in turned]
    best = freest(boxes, taken)
    return turned[best], boxes[best]


def word_box(word: Word, unit: float) -> Box:
    """About where a word is painted."""
    wide, high = (_LETTER_PX * len(word.text) + _PAD_PX) * unit, _HIGH_PX * unit
    left = word.x + word.right * _AWAY_PX * unit - wide * (1 - word.right) / 2
    low = word.y + word.up * _AWAY_PX * unit - high * (1 - word.up) / 2
    return left, low, left + wide, low + high
