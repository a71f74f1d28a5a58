"""A curve fitted to points that were drawn or pasted: cubic pieces, as few as a tolerance allows.

Points are parted at corners. Each run gets one cubic with tangents estimated at its ends and the lengths of
its handles by least squares; the parameters of the points are improved by Newton's method, and where the
cubic stays too far off, the run is parted at the worst point, with one tangent for both sides.
Source: Schneider, An algorithm for automatically fitting digitized curves, Graphics Gems, 1990.
"""

import itertools
import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.algorithms.curves.bernstein import bernstein
from workbench.algorithms.curves.conditions import faults, refuse
from workbench.algorithms.curves.directions import corners, tangent
from workbench.algorithms.curves.halving import lengths
from workbench.algorithms.curves.pieces import Pieces
from workbench.algorithms.curves.refusals import refuse_tolerance

Array = NDArray[np.float64]

CORNER_ANGLE = math.radians(60.0)
_ROUNDS = 4  # without it getting much better
_BETTER = 0.9
_SLIDING = 0.95  # of a distance, what lies along the curve


def fit_pieces(
    points: ArrayLike, tolerance: float, corner_angle: float = CORNER_ANGLE
) -> tuple[Pieces, float]:
    """Cubic pieces that pass all points (n, k) within ``tolerance``, and the largest distance that is left.

    It begins and ends at the first and the last point; where the points turn by more than ``corner_angle``
    (radians) it has a corner, elsewhere its direction is continuous, and also where it ends at its first
    point. The parameter is the length of the way along the points. The error is that of the points; nothing
    is known between them. Raises: ValueError for fewer than two places, or a tolerance not above 0.
    """
    given = np.asarray(points, float)
    refuse(faults(given))
    refuse_tolerance(tolerance)
    way = np.append(0.0, np.cumsum(lengths(np.diff(given, axis=0))))
    if way[-1] <= 0.0:
        raise ValueError("All points are in one place; draw a line that has a length.")
    # A step that the way is too long to feel leads nowhere; the first point stays, and so does the last.
    kept = np.append(np.diff(way) > 0, True)
    kept[way == way[0]] = False
    kept[0] = True
    through, way = given[kept], way[kept]
    reach = 2.0 * tolerance
    turns = corners(through, reach, corner_angle)
    ends = [0, *turns, len(through) - 1]
    waiting = [
        (a, b, tangent(through, a, a, b, reach), -tangent(through, b, a, b, reach))
        for a, b in itertools.pairwise(ends)
    ]
    _smooth_seam(through, waiting, reach, corner_angle)
    waiting.reverse()
    controls, knots, error = [], [way[0]], 0.0
    while waiting:
        first, last, leaving, arriving = waiting.pop()
        run = through[first : last + 1]
        cubic, off = _fitted(run, way[first : last + 1], leaving, arriving, tolerance)
        if off.max() <= tolerance or last - first < 2:
            controls.append(cubic)
            knots.append(way[last])
            error = max(error, float(off.max()))
            continue
        worst = first + min(max(int(off.argmax()), 1), last - first - 1)
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


def _fitted(run: Array, way: Array, leaving: Array, arriving: Array, tolerance: float) -> tuple[Array, Array]:
    """The cubic (4, k) of a run of points (n, k), and the distance (n,) of each point from it."""
    v = (way - way[0]) / (way[-1] - way[0])
    cubic = best = _least_squares(run, v, leaving, arriving, way[-1] - way[0])
    off = lengths(bernstein(3, v) @ cubic - run)
    rounds = _ROUNDS if len(run) > 2 else 0
    while rounds > 0 and off.max() > tolerance:
        rounds -= 1
        v = _nearer(cubic, run, v)
        cubic = _least_squares(run, v, leaving, arriving, way[-1] - way[0], cubic)
        apart = lengths(bernstein(3, v) @ cubic - run)
        if apart.max() < off.max():
            rounds = _ROUNDS if apart.max() < _BETTER * off.max() else rounds
            best, off = cubic, apart
    return best, off


def _least_squares(
    run: Array, v: Array, leaving: Array, arriving: Array, length: float, before: Array | None = None
) -> Array:
    """The cubic with these ends and unit tangents whose handles are as long as least squares ask for.

    Points slide along the curve when their parameters are improved, so once there is a cubic ``before``, what
    lies along it counts little.
    """
    basis = bernstein(3, v)
    begin, end = basis[:, :2].sum(axis=1)[:, None], basis[:, 2:].sum(axis=1)[:, None]
    parts = np.stack(
        [basis[:, 1, None] * leaving, basis[:, 2, None] * arriving, run - begin * run[0] - end * run[-1]]
    )
    if before is not None:
        speed = bernstein(2, v) @ np.diff(before, axis=0)
        size = lengths(speed)[:, None]
        along = np.divide(speed, size, out=np.zeros_like(speed), where=size > 0)
        parts -= _SLIDING * (parts * along).sum(axis=-1, keepdims=True) * along
    one, other, rest = parts
    a, b, c = (one * one).sum(), (one * other).sum(), (other * other).sum()
    x, y = (one * rest).sum(), (other * rest).sum()
    det = a * c - b * b
    handles = np.full(2, length / 3.0)
    if det > 1e-12 * a * c:
        solved = np.array([(c * x - b * y) / det, (a * y - b * x) / det])
        if (solved > 1e-3 * length).all() and (solved < 4.0 * length).all():
            handles = solved
    return np.stack([run[0], run[0] + handles[0] * leaving, run[-1] + handles[1] * arriving, run[-1]])


def _nearer(cubic: Array, run: Array, v: Array) -> Array:
    """The parameters one step of Newton's method nearer to the feet of the points; ascending as they were."""
    first, second = 3.0 * np.diff(cubic, axis=0), 6.0 * np.diff(cubic, n=2, axis=0)
    apart = bernstein(3, v) @ cubic - run
    speed, bend = bernstein(2, v) @ first, bernstein(1, v) @ second
    slope = (speed * speed).sum(axis=1) + (apart * bend).sum(axis=1)
    step = np.divide((apart * speed).sum(axis=1), slope, out=np.zeros_like(v), where=slope > 0)
    moved = np.clip(v - step, 0.0, 1.0)
    moved[0], moved[-1] = 0.0, 1.0
    return np.maximum.accumulate(moved)
