"""What a seed fill colours, found at once: whole runs of rows, layer after layer from the seed.

It stands for a text that is not compiled yet; a law proves that both colour the same pixels.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

Region = NDArray[np.bool_]


def bounded_4(image: NDArray[Any], x: int, y: int, fill: int, boundary: int) -> Region:
    """Where (h, w) the 4-connected boundary fill colours."""
    return _reached((image != boundary) & (image != fill), x, y, 0)


def bounded_8(image: NDArray[Any], x: int, y: int, fill: int, boundary: int) -> Region:
    """Where (h, w) the 8-connected boundary fill colours."""
    return _reached((image != boundary) & (image != fill), x, y, 1)


def flooded_4(image: NDArray[Any], x: int, y: int, fill: int) -> Region:
    """Where (h, w) the 4-connected flood fill colours."""
    return _reached(_alike(image, x, y, fill), x, y, 0)


def flooded_8(image: NDArray[Any], x: int, y: int, fill: int) -> Region:
    """Where (h, w) the 8-connected flood fill colours."""
    return _reached(_alike(image, x, y, fill), x, y, 1)


def _alike(image: NDArray[Any], x: int, y: int, fill: int) -> Region:
    height, width = image.shape
    if not (0 <= x < width and 0 <= y < height):
        return np.zeros(image.shape, bool)
    return np.asarray((image == image[y, x]) & (image != fill))


def _reached(free: Region, x: int, y: int, corner: int) -> Region:
    """The free pixels that can be reached from a seed; ``corner`` is 1 where steps may go over corners."""
    height, width = free.shape
    if not (0 <= x < width and 0 <= y < height and free[y, x]):
        return np.zeros(free.shape, bool)
    # Each run of free pixels of a row, from its first to one past its last
    edges = np.diff(np.pad(free.view(np.int8), ((0, 0), (1, 1))), axis=1)
    row, first = np.nonzero(edges == 1)
    end = np.nonzero(edges == -1)[1]
    # The runs of the next row that each touches follow one another
    line = width + 2
    low = np.searchsorted(row * line + end, (row + 1) * line + first - corner, side="right")
    high = np.searchsorted(row * line + first, (row + 1) * line + end + corner, side="left")
    count = np.maximum(high - low, 0)
    below = np.repeat(np.arange(len(row)), count)
    above = np.arange(len(below)) + np.repeat(low - (np.cumsum(count) - count), count)
    one, other = np.concatenate([below, above]), np.concatenate([above, below])
    order = np.argsort(one, kind="stable")
    neighbours = other[order]
    starts = np.searchsorted(one[order], np.arange(len(row) + 1))
    # From the seed's run to its neighbours, and on to theirs
    seen = np.zeros(len(row), bool)
    layer = np.array([np.searchsorted(row * line + first, y * line + x, side="right") - 1])
    while len(layer):
        seen[layer] = True
        many = starts[layer + 1] - starts[layer]
        places = np.arange(many.sum()) + np.repeat(starts[layer] - (np.cumsum(many) - many), many)
        reached = neighbours[places]
        layer = np.unique(reached[~seen[reached]])
    steps = np.zeros((height, width + 1), np.int8)
    steps[row[seen], first[seen]] = 1
    steps[row[seen], end[seen]] = -1
    return np.asarray(np.cumsum(steps, axis=1, dtype=np.int8)[:, :-1] == 1)
