"""A curve fitted to points that were drawn or pasted: cubic pieces, as few as a tolerance allows.

Points are parted at corners. Each run gets one cubic with tangents estimated at its ends and the lengths of
its handles by least squares; the parameters of the points are improved by Newton's method, and where the
cubic stays too far off, the run is parted at the worst point, with one tangent for both sides.
Source: Schneider, An algorithm for automatically fitting digitized curves, Graphics Gems, 1990.
"""

import itertools
import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse
from workbench.geometry.curves.cubic_fit import fitted_cubic
from workbench.geometry.curves.directions import corners, tangent
from workbench.geometry.curves.halving import lengths
from workbench.geometry.curves.pieces import Pieces
from workbench.geometry.curves.refusals import refuse_many_pieces, refuse_tolerance

Array = NDArray[np.float64]

CORNER_ANGLE = math.radians(60.0)
_SOME = 500


def fit_pieces(
    points: ArrayLike,
    tolerance: float,
    corner_angle: float = CORNER_ANGLE,
    most_pieces: float = math.inf,
    progress: Callable[[float], None] = lambda share: None,
) -> tuple[Pieces, float]:
    """Cubic pieces that pass all points (n, k) within ``tolerance``, and the largest distance that is left.

    It begins and ends at the first and the last point; where the points turn by more than ``corner_angle``
    (radians) it has a corner, elsewhere its direction is continuous, and also where it ends at its first
    point. The parameter is the length of the way along the points. The error is that of the points; nothing
    is known between them. ``progress`` is told the share that is done, and ends the work by raising.
    Raises: ValueError for fewer than two places, a tolerance not above 0, or more than ``most_pieces``.
    """
    given = np.asarray(points, float)
    refuse(faults(given))
    refuse_tolerance(tolerance)
    way = np.append(0.0, np.cumsum(lengths(np.diff(given, axis=0))))
    if way[-1] <= 0.0:
        raise ValueError("All points are in one place; draw a longer line.")
    # A step that the way is too long to feel leads nowhere; the first point stays, and so does the last.
    kept = np.append(np.diff(way) > 0, True)
    kept[way == way[0]] = False
    kept[0] = True
    through, way = given[kept], way[kept]
    reach = 2.0 * tolerance
    turns = corners(through, reach, corner_angle)
    refuse_many_pieces(len(turns) + 1, most_pieces, tolerance)
    ends = [0, *turns, len(through) - 1]
    waiting = [
        (a, b, tangent(through, a, a, b, reach), -tangent(through, b, a, b, reach))
        for a, b in itertools.pairwise(ends)
    ]
    _smooth_seam(through, waiting, reach, corner_angle)
    waiting.reverse()
    controls: list[Array] = []
    knots, error = [way[0]], 0.0
    while waiting:
        refuse_many_pieces(len(controls) + len(waiting), most_pieces, tolerance)
        first, last, leaving, arriving = waiting.pop()
        progress(first / (len(through) - 1))
        # Where some of the points do not let a cubic pass, all of them would not either.
        for count in (_SOME, len(through)):
            some = np.unique(np.linspace(first, last, min(count, last - first + 1)).astype(np.intp))
            cubic, off = fitted_cubic(through[some], way[some], leaving, arriving, tolerance)
            if off.max() > tolerance or len(some) == last - first + 1:
                break
        if off.max() <= tolerance or last - first < 2:
            controls.append(cubic)
            knots.append(way[last])
            error = max(error, float(off.max()))
            continue
        worst = min(max(int(some[off.argmax()]), first + 1), last - 1)
        along = tangent(through, worst, first, last, reach)
        waiting.append((worst, last, along, arriving))
        waiting.append((first, worst, leaving, -along))
    return Pieces(np.array(knots), np.array(controls)), error


def _smooth_seam(
    through: Array, runs: list[tuple[int, int, Array, Array]], reach: float, corner_angle: float
) -> None:
    """Give a curve that ends where it begins one tangent there, if it has no corner."""
    count = len(through) - 1
    if count < 3 or np.any(through[0] != through[-1]):
        return
    around = np.concatenate([through[count // 2 : -1], through[: count // 2 + 1]])
    seam = count - count // 2
    if seam in corners(around, reach, corner_angle):
        return
    along = tangent(around, seam, 0, len(around) - 1, reach)
    runs[0] = (*runs[0][:2], along, runs[0][3])
    runs[-1] = (*runs[-1][:3], -along)
