"""Arrays of places as what Qt paints, without a Python object for each."""

from typing import Any

import numpy as np
import shiboken6
from numpy.typing import NDArray
from PySide6.QtGui import QPolygonF

_POINT_BYTES = 16
_pointer: Any = shiboken6.VoidPtr  # its stub leaves out the size


def polygon(x: NDArray[np.float64], y: NDArray[np.float64]) -> QPolygonF:
    """The points (x, y), both (n,), as a polygon."""
    made = QPolygonF()
    if len(x):
        made.resize(len(x))
        room = np.frombuffer(_pointer(made.data(), _POINT_BYTES * len(x), True)).reshape(-1, 2)
        room[:, 0], room[:, 1] = x, y
    return made
