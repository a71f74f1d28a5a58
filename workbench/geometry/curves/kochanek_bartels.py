"""Kochanek-Bartels splines: cardinal splines with tension, continuity and bias at every point.

Hearn and Baker write the continuity with the opposite sign of the paper it is from: their c is the paper's
-c, and both name the same curves. Theirs is the course's, and what is meant unless the other is asked for.
Source: Hearn and Baker, Computer Graphics, C Version, section 10-7; Kochanek and Bartels, Interpolating
splines with local tension, continuity, and bias control, SIGGRAPH 1984, equations 8 and 9.
"""

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from workbench.geometry.curves.hermite import hermite_pieces, parameters
from workbench.geometry.curves.pieces import Pieces
from workbench.geometry.curves.sections import Ends, with_neighbours

Signed = Literal["book", "paper"]


def kochanek_bartels(
    points: ArrayLike,
    tension: ArrayLike = 0.0,
    continuity: ArrayLike = 0.0,
    bias: ArrayLike = 0.0,
    ends: Ends = "inner",
    signed_by: Signed = "book",
) -> Pieces:
    """The spline whose tangents t, c and b shape; each one number, or one for each point on the curve.

    Args: points (n, k); tension t, 1 for straight lines; continuity c, not 0 for a corner; bias b, towards
    the leg before (above 0) or after; ``ends`` (see ``sections``): as the course writes it, the curve goes
    from P_1 to P_{n-1}; ``signed_by``, whose sign c has: Hearn and Baker's or the paper's. Returns: one piece
    for each section, from 0 to 1, 1 to 2 and so on.
    Raises: ValueError for too few points, or numbers that do not fit.
    """
    around = with_neighbours(points, ends)
    through = around[1:-1]
    t, c, b = (_shaped(value, len(through)) for value in (tension, continuity, bias))
    c = -c if signed_by == "paper" else c
    before, after = through - around[:-2], around[2:] - through
    leaving = 0.5 * (1.0 - t) * ((1.0 + b) * (1.0 - c) * before + (1.0 - b) * (1.0 + c) * after)
    arriving = 0.5 * (1.0 - t) * ((1.0 + b) * (1.0 + c) * before + (1.0 - b) * (1.0 - c) * after)
    return hermite_pieces(through, leaving[:-1], arriving[1:], parameters(len(through), None))


def _shaped(value: ArrayLike, count: int) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """One number for each point, as a column."""
    numbers = np.asarray(value, float)
    if numbers.shape not in ((), (count,)) or not np.isfinite(numbers).all():
        raise ValueError(f"Give tension, continuity and bias one finite number, or {count} of them.")
    return np.broadcast_to(numbers, (count,))[:, None]
