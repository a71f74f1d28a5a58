"""One cubic fitted to a run of points whose ends and directions there are given.

Source: Schneider, An algorithm for automatically fitting digitized curves, Graphics Gems, 1990.
"""

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.bernstein import bernstein
from workbench.geometry.curves.halving import lengths

Array = NDArray[np.float64]

_ROUNDS = 4  # without it getting much better
_BETTER = 0.9
_SLIDING = 0.95  # of a distance, what lies along the curve


def fitted_cubic(
    run: Array, way: Array, leaving: Array, arriving: Array, tolerance: float
) -> tuple[Array, Array]:
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
