"""Labels stand where they hide least of what is there already: handles, and one another."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Box = tuple[float, float, float, float]
"""Both least coordinates, then both largest."""


def hidden_area(box: Box, taken: NDArray[np.float64]) -> float:
    """How much of the boxes ``taken``, (n, 4), one that is laid over them hides."""
    wide = np.minimum(box[2], taken[:, 2]) - np.maximum(box[0], taken[:, 0])
    high = np.minimum(box[3], taken[:, 3]) - np.maximum(box[1], taken[:, 1])
    return float((wide.clip(0.0) * high.clip(0.0)).sum())


def freest(boxes: Sequence[Box], taken: NDArray[np.float64]) -> int:
    """The number of the first box that hides nothing of ``taken``, (n, 4), else of that which hides least."""
    best, least = 0, np.inf
    for number, box in enumerate(boxes):
        hidden = hidden_area(box, taken)
        if hidden < least:
            best, least = number, hidden
        if hidden == 0.0:
            break
    return best


def around(places: NDArray[np.float64], reach: float) -> NDArray[np.float64]:
    """The boxes (n, 4) that reach so far on all sides of ``places``, (n, 2)."""
    return np.hstack([places - reach, places + reach])
