"""What views may look at: of a large array that a text can write a recording keeps the shape alone."""

from typing import Any

import numpy as np


def is_recorded(*arrays: Any) -> bool:
    """Whether all of these are at hand."""
    return all(isinstance(array, np.ndarray) for array in arrays)
