"""Which distances are none: what rounding leaves between places of a curve that are one."""

import numpy as np
from numpy.typing import NDArray

_OF_THE_SIZE = 1e-9
_OF_THE_COORDINATES = 2.0**-50


def nothing_beside(points: NDArray[np.float64]) -> float:
    """The distance up to which two places are one on a curve of these points (..., k).

    It is a part of the curve's size, wherever that lies, but no less than what coordinates so large can tell.
    """
    rows = points.reshape(-1, points.shape[-1])
    size = float(np.ptp(rows, axis=0).max())
    return max(_OF_THE_SIZE * size, _OF_THE_COORDINATES * float(np.abs(rows).max()))
