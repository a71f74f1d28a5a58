"""Catmull-Rom splines with alpha: the parameter goes as a power of the distances between the points.

Source: Barry and Goldman, 1988; Yuksel, Schaefer and Keyser, Parameterization and applications of
Catmull-Rom curves, 2011.
"""

import numpy as np
from numpy.typing import ArrayLike

from workbench.geometry.curves.hermite import hermite_pieces
from workbench.geometry.curves.pieces import Pieces
from workbench.geometry.curves.sections import Ends, with_neighbours


def catmull_rom(points: ArrayLike, alpha: float = 0.5, ends: Ends = "through") -> Pieces:
    """The spline through the points whose tangents are those of the parabolas through three neighbours.

    Args: points (n, k); alpha 0 for uniform, 1/2 for centripetal (no cusps and no loops within a piece), 1
    for chordal; ``ends`` (see ``sections``). Returns: one piece between each two points, as long in the
    parameter as their distance to the power alpha. Two points in one place make a piece without length (with
    alpha above 0), at which the curve stops. Raises: ValueError for too few points, an alpha not in 0 to 1.
    """
    if not 0.0 <= alpha <= 1.0:
        raise ValueError(f"Alpha is {alpha}; choose it from 0 to 1.")
    around = with_neighbours(points, ends)
    legs = np.diff(around, axis=0)
    length = (np.sqrt((legs * legs).sum(axis=1)) ** alpha)[:, None]
    slope = np.divide(legs, length, out=np.zeros_like(legs), where=length > 0)
    before, after = length[:-1], length[1:]
    both = before + after
    tangents = np.divide(
        after * slope[:-1] + before * slope[1:], both, out=np.zeros_like(slope[1:]), where=both > 0
    )
    knots = np.append(0.0, np.cumsum(length[1:-1]))
    return hermite_pieces(around[1:-1], tangents[:-1], tangents[1:], knots)
