"""Emitted rows as pixels: which were painted, and which rows touch one."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Emits

_PIXELS = ("pixels", "coverage", "fragments")


def painted(rows: NDArray[Any], emits: Emits, size: tuple[int, int]) -> NDArray[np.bool_]:
    """(height, width) which pixels the ``rows`` (n, k) paint, in a picture of ``size`` (width, height).

    Points and segments are no pixels and paint nothing.
    """
    width, height = size
    found = np.zeros((height, width), bool)
    if not len(rows):
        return found
    if emits == "spans":
        for y, left, right in rows[:, :3].astype(int):
            if 0 <= y < height:
                found[y, max(left, 0) : max(right + 1, 0)] = True
    elif emits in _PIXELS:
        x, y = rows[:, 0].astype(int), rows[:, 1].astype(int)
        inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        found[y[inside], x[inside]] = True
    return found


def touching(rows: NDArray[Any], emits: Emits, x: int, y: int) -> NDArray[np.int64]:
    """Numbers of the ``rows`` (n, k) that touch the pixel (x, y)."""
    if len(rows) and emits == "spans":
        return np.flatnonzero((rows[:, 0] == y) & (rows[:, 1] <= x) & (x <= rows[:, 2]))
    if len(rows) and emits in _PIXELS:
        return np.flatnonzero((rows[:, 0] == x) & (rows[:, 1] == y))
    return np.zeros(0, np.int64)
