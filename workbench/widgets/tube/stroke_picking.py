"""Which stroke of a picture is under the pointer."""

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF

_REACH_PX = 14.0


def nearest_stroke(ends: NDArray[np.float64], place: QPointF) -> int | None:
    """The stroke nearest to a place of the widget, of those with these ends (n, 2, 2) in logical pixels; None
    where none is near.
    """
    if not len(ends):
        return None
    starts, ways = ends[:, 0], ends[:, 1] - ends[:, 0]
    to = np.array([place.x(), place.y()]) - starts
    squares = np.maximum((ways**2).sum(axis=1), 1e-9)
    share = np.clip((to * ways).sum(axis=1) / squares, 0.0, 1.0)
    away = np.hypot(*(to - share[:, None] * ways).T)
    nearest = int(away.argmin())
    return nearest if away[nearest] < _REACH_PX else None
