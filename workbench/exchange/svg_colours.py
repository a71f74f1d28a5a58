"""Colours of SVG, and what they become on a sheet."""

import re
from functools import lru_cache
from typing import NamedTuple

from workbench.document.model import MAX_PALETTE, Sheet
from workbench.language import _

_LONGEST = 100
_REFERENCE = re.compile(r"url\([^)]*\)\s*")
_OTHER_PAINTS = ("none", "inherit", "currentcolor", "context-fill", "context-stroke")
_UNSEEN = 24  # of 255 in each channel: a colour no farther from that of the paper is not seen on it
_GREY = 0x7F7F7F


class Paint(NamedTuple):
    """A colour, 0xRRGGBB, and how much of what is below it hides, above 0 to 1."""

    colour: int
    alpha: float = 1.0

    def over(self, paper: int) -> int:
        """The colour, 0xRRGGBB, that it makes on ``paper``."""
        mixed = 0
        for shift in (16, 8, 0):
            above, below = self.colour >> shift & 255, paper >> shift & 255
            mixed |= round(below + self.alpha * (above - below)) << shift
        return mixed


BLACK = Paint(0x000000)


@lru_cache(1000)
def paint_of(text: str, current: str = "black") -> Paint | None:
    """The paint that ``fill`` or ``stroke`` states, ``current`` being what ``currentColor`` means.

    None where nothing is painted; black where it cannot be understood, or refers to what is no colour.
    """
    word = text.strip()
    if word.startswith("url("):
        word = _REFERENCE.sub("", word) or "black"
    if word.lower() == "currentcolor":
        word = current.strip()
    if word.lower() == "none":
        return None
    rgba = _parsed(word)
    if rgba is None:
        return BLACK
    red, green, blue, alpha = rgba
    return Paint(red << 16 | green << 8 | blue, alpha) if alpha > 0 else None


def is_paint(text: str) -> bool:
    """Whether a text is what ``fill`` or ``stroke`` may be."""
    word = text.strip()
    if word.startswith("url("):
        word = _REFERENCE.sub("", word) or "none"
    return word.lower() in _OTHER_PAINTS or _parsed(word) is not None


@lru_cache(1000)
def _parsed(word: str) -> tuple[int, int, int, float] | None:
    if len(word) > _LONGEST:
        return None
    from tinycss2.color3 import RGBA, parse_color

    rgba = parse_color(word)
    if not isinstance(rgba, RGBA):
        return None
    red, green, blue = (round(255 * min(max(share, 0.0), 1.0)) for share in rgba[:3])
    return red, green, blue, min(max(rgba[3], 0.0), 1.0)


class Colours:
    """The ``palette`` of a sheet, with the colours that a drawing adds at its end, and ``notes`` on them."""

    def __init__(self, sheet: Sheet) -> None:
        self.palette = list(sheet.palette)
        self._paper = sheet.background
        self._notes: dict[str, None] = {}

    @property
    def notes(self) -> list[str]:
        """A sentence for each way in which a colour is not as the drawing states it."""
        return list(self._notes)

    def index_of(self, paint: Paint) -> int:
        """The index of ``paint``, blended with the paper; never that of the paper, which is not seen."""
        paper = self.palette[self._paper]
        colour = paint.over(paper)
        if paint.alpha < 1.0:
            self._notes[_("Opacity is blended with the background colour.")] = None
        elif max(_apart(colour, paper)) < _UNSEEN:
            colour = _GREY
            self._notes[_("What has the background colour is drawn in grey, so that it can be seen.")] = None
        usable = [index for index in range(len(self.palette)) if index != self._paper]
        for index in usable:
            if self.palette[index] == colour:
                return index
        if len(self.palette) < MAX_PALETTE:
            self.palette.append(colour)
            return len(self.palette) - 1
        self._notes[_("The palette is full; further colours are replaced by the nearest it has.")] = None
        return min(usable, key=lambda index: sum(d * d for d in _apart(self.palette[index], colour)))


def _apart(one: int, other: int) -> tuple[int, ...]:
    return tuple(abs((one >> shift & 255) - (other >> shift & 255)) for shift in (16, 8, 0))


def written(colour: int) -> str:
    """0xRRGGBB as SVG writes it."""
    return f"#{colour:06x}"
