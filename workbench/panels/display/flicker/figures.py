"""What the tube of the page Flicker shows: the sheet as it is, or a spot or a bar that moves over it."""

import numpy as np
from numpy.typing import NDArray

from workbench.rendering.subjects.flicker import BAR, SPOT

_WHITE = 0xFFFFFF
_SPOT_SHARE, _BAR_SHARE = 0.08, 0.05


def moving(figure: str) -> bool:
    """Whether it is one of the figures that move."""
    return figure in (SPOT, BAR)


def column_at(size_px: tuple[int, int], speed: float, seconds: float) -> int:
    """The column where a figure begins that goes ``speed`` pixels a second to the right, again and again."""
    return int(np.floor(speed * seconds)) % size_px[0]


def moved_picture(figure: str, size_px: tuple[int, int], column: int) -> NDArray[np.uint32]:
    """A frame buffer (h, w), dark but for the figure; what leaves at the right comes in at the left."""
    width, height = size_px
    image = np.zeros((height, width), np.uint32)
    if figure == SPOT:
        side = max(1, round(_SPOT_SHARE * height))
        low = (height - side) // 2
        rows, columns = slice(low, low + side), side
    else:
        rows, columns = slice(0, height), max(1, round(_BAR_SHARE * width))
    image[rows, (column + np.arange(columns)) % width] = _WHITE
    return image
