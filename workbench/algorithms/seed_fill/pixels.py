"""Reading the picture that a fill works in."""

from typing import Any

import numpy as np
from numpy.typing import NDArray


def is_in(image: NDArray[Any], x: int, y: int) -> bool:
    """Whether pixel (x, y) is in a picture (h, w)."""
    return bool(0 <= x < image.shape[1] and 0 <= y < image.shape[0])


def get_pixel(image: NDArray[Any], x: int, y: int, outside: int) -> int:
    """The colour of pixel (x, y) of a picture (h, w); ``outside`` beyond its edge.

    A number of 64 bits whatever the picture's own are, so that both branches give the same kind.
    """
    if 0 <= x < image.shape[1] and 0 <= y < image.shape[0]:
        return np.int64(image[y, x])  # type: ignore[return-value]
    return outside
