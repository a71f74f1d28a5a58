"""A ring with two pixels of boundary inside it, as the example of the seed fills."""

import numpy as np
from numpy.typing import NDArray


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
