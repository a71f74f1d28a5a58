"""The hexcone from above: red, yellow, green, cyan, blue and magenta are the corners of a hexagon.

Seen along the line of greys the cube of red, green and blue is that hexagon; grey is in its middle.
"""

import math
from collections.abc import Iterator

from workbench.algorithms.marks import Mark, Points, Stroke, Word, along, closed

CORNERS = "RYGCBM"
_HALF_ROOT_3 = 0.5 * math.sqrt(3.0)
_WORDS_AT = 1.14


def place(r: float, g: float, b: float) -> tuple[float, float]:
    """Where a colour lies, red at (1, 0), green a third of a turn further, blue another third."""
    return r - 0.5 * (g + b), _HALF_ROOT_3 * (g - b)


def hexagon(v: float) -> Points:
    """The six corners (6, 2) of the colours whose largest component is ``v``."""
    turns = [math.radians(60.0 * sixth) for sixth in range(6)]
    return along(*((v * math.cos(turn), v * math.sin(turn)) for turn in turns))


def outline() -> Iterator[Mark]:
    """The hexagon of the purest colours, with their letters."""
    yield Stroke(closed(hexagon(1.0)), "muted", "thin")
    for letter, (x, y) in zip(CORNERS, hexagon(_WORDS_AT).tolist(), strict=True):
        yield Word(letter, x, y, "muted")
