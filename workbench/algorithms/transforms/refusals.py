"""What stands at the door of the texts; compiled, a sentence holds no numbers."""

import math
from typing import Any

from numpy.typing import NDArray


def refuse_product(a: NDArray[Any], b: NDArray[Any]) -> None:
    """Raise ValueError unless the rows of ``a`` are as long as the columns of ``b``, and not empty."""
    if a.shape[1] != b.shape[0] or a.size == 0 or b.size == 0:
        raise ValueError("The first matrix needs as many columns as the second has rows, and at least one.")


def refuse_point(matrix: NDArray[Any], point: NDArray[Any]) -> None:
    """Raise ValueError unless these are a (3, 3) matrix and a point (2,)."""
    if matrix.shape[0] != 3 or matrix.shape[1] != 3 or len(point) != 2:
        raise ValueError("A point x, y is transformed by a matrix of 3 rows and 3 columns.")


def refuse_axis(length: float) -> None:
    """Raise ValueError unless an axis of this length has a direction."""
    if not (0.0 < length < math.inf):
        raise ValueError("The axis has no direction; give two finite points apart.")
