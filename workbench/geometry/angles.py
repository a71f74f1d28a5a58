"""The cosine and sine of an angle, with quarter turns exact."""

import math

_QUARTER = math.pi / 2
_SHARE = 2.0**-51  # of an angle: what rounding takes from a multiple of a quarter turn, or from its degrees
_MOST = 1e-12


def cosine_and_sine(theta: float) -> tuple[float, float]:
    """Cosine and sine of an angle in radians; 0, 1 and -1 exactly for what is meant as quarter turns."""
    turns = math.floor(theta / _QUARTER + 0.5)
    if abs(theta - turns * _QUARTER) > min(_SHARE * abs(theta), _MOST):
        return math.cos(theta), math.sin(theta)
    turn = turns % 4
    if turn == 0:
        return 1.0, 0.0
    if turn == 1:
        return 0.0, 1.0
    if turn == 2:
        return -1.0, 0.0
    return 0.0, -1.0
