"""The cosine and sine of an angle, with quarter and eighth turns exact."""

import math

import numpy as np
from numpy.typing import NDArray

_EIGHTH = math.pi / 4
_COSINES = (1.0, math.sqrt(0.5), 0.0, -math.sqrt(0.5), -1.0, -math.sqrt(0.5), 0.0, math.sqrt(0.5))
_SHARE = 2.0**-51  # of an angle: what rounding takes from a multiple of an eighth turn, or from its degrees
_MOST = 1e-12


def cosine_and_sine(theta: float) -> tuple[float, float]:
    """Cosine and sine of an angle in radians.

    For what is meant as quarter turns they are 0, 1 and -1 exactly; halfway between both have one size.
    """
    turns = math.floor(theta / _EIGHTH + 0.5)
    if abs(theta - turns * _EIGHTH) > min(_SHARE * abs(theta), _MOST):
        return math.cos(theta), math.sin(theta)
    return _COSINES[turns % 8], _COSINES[(turns - 2) % 8]


def cosines_and_sines(thetas: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The same of many angles (n,), each as it is by itself."""
    turns = np.floor(thetas / _EIGHTH + 0.5)
    meant = np.abs(thetas - turns * _EIGHTH) <= np.minimum(_SHARE * np.abs(thetas), _MOST)
    angles = thetas.tolist()  # NumPy's own cosine may differ in the last bit
    eighths = turns[meant].astype(np.int64)
    both = np.array([list(map(math.cos, angles)), list(map(math.sin, angles))])
    for row, behind in zip(both, (0, 2), strict=True):
        row[meant] = np.array(_COSINES)[(eighths - behind) % 8]
    return both[0], both[1]
