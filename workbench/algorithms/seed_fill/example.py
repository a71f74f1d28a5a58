"""What the seed fills take, with a ring and two pixels of boundary inside it as their example."""

from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Parameter


def picture(*rows: str) -> NDArray[np.int64]:
    """A small picture from rows of digits, top row first."""
    return np.array([[int(digit) for digit in row] for row in reversed(rows)], np.int64)


RING = picture(
    "0000000000",
    "0011111000",
    "0110001100",
    "0100000100",
    "0100100100",
    "0100010100",
    "0110001100",
    "0011111000",
    "0000000000",
)

FLOOD = (
    Parameter("image", "image", "image", RING, meaning="the picture, filled in place"),
    Parameter("x", "x", "int", 5, 0, 32767, "px", "seed, column"),
    Parameter("y", "y", "int", 5, 0, 32767, "px", "seed, row"),
    Parameter("fill", "fill", "colour", 2, 0, 0xFFFFFF, meaning="colour to fill with"),
)
BOUNDED = (
    *FLOOD,
    Parameter("boundary", "boundary", "colour", 1, 0, 0xFFFFFF, meaning="colour that stops the fill"),
)


def picture_and_seed(chance: Random) -> tuple[Any, ...]:
    """A small picture of four colours, a seed in it or just outside, and a colour that is often there."""
    height, width = (chance.choice((1, chance.randint(1, 6), chance.randint(1, 6))) for _side in range(2))
    rows = [[chance.randint(0, 3) for _column in range(width)] for _row in range(height)]
    x, y = chance.randrange(width), chance.randrange(height)
    match chance.randint(0, 5):
        case 0:
            x = chance.choice((-1, width))
        case 1:
            y = chance.choice((-1, height))
    return np.array(rows, np.int64), x, y, chance.randint(0, 3)


def picture_seed_and_boundary(chance: Random) -> tuple[Any, ...]:
    """The same with a boundary colour, now and then that of the fill."""
    return *picture_and_seed(chance), chance.randint(0, 3)
