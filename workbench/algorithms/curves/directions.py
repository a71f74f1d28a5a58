"""Where a row of points turns sharply, and in which direction it runs, seen past its unsteadiness."""

import math

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.curves.halving import lengths

Array = NDArray[np.float64]

_MOST = 12  # neighbours on each side


def corners(points: Array, reach: float, angle: float) -> list[int]:
    """Numbers of the inner points where a row (n, k) turns by more than ``angle`` (radians).

    Directions are taken to the first points at least ``reach`` away; of corners so near to each other only
    the sharpest counts.
    """
    turns = np.zeros(len(points))
    for i in range(1, len(points) - 1):
        before, after = points[_away(points, i, -1, reach)], points[_away(points, i, 1, reach)]
        one, other = points[i] - before, after - points[i]
        size = math.sqrt(float(one @ one) * float(other @ other))
        if size > 0:
            turns[i] = math.acos(min(max(float(one @ other) / size, -1.0), 1.0))
    found: list[int] = []
    for i in np.argsort(-turns, kind="stable"):
        if turns[i] <= angle:
            break
        apart = lengths(points[found] - points[i]) if found else np.array([math.inf])
        nearest = min((abs(int(i) - j) for j in found), default=_MOST)
        if apart.min() > reach or nearest >= _MOST:
            found.append(int(i))
    return sorted(found)


def tangent(points: Array, at: int, first: int, last: int, reach: float) -> Array:
    """The unit direction of the row at point ``at``, from its neighbours between ``first`` and ``last``.

    It is that of the parabola through the point that is nearest to the neighbours up to ``reach`` away, and
    to one on each side at least, or two on the only side.
    """
    least = 1 if first < at < last else 2
    low = max(min(_away(points, at, -1, reach), at - least), first)
    high = min(max(_away(points, at, 1, reach), at + least), last)
    near = points[low : high + 1]
    way = np.append(0.0, np.cumsum(lengths(np.diff(near, axis=0))))
    s = (way - way[at - low]) / way[-1]
    terms = np.column_stack([s, s * s])[:, : min(2, high - low)]
    along: Array = np.linalg.lstsq(terms, (near - points[at]) / way[-1], rcond=None)[0][0]
    size = float(np.sqrt(along @ along))
    if not size > 1e-6:
        chord = near[-1] - near[0]
        along = chord if chord.any() else points[min(at + 1, last)] - points[max(at - 1, first)]
        along = along if along.any() else np.eye(1, points.shape[1])[0]
        size = float(np.sqrt(along @ along))
    return along / size


def _away(points: Array, at: int, step: int, reach: float) -> int:
    """The number of the first point from ``at`` on, forwards or backwards, that is ``reach`` away."""
    end = len(points) - 1 if step > 0 else 0
    i = at
    for _neighbour in range(_MOST):
        if i == end:
            break
        i += step
        apart = points[i] - points[at]
        if float(apart @ apart) >= reach * reach:
            break
    return i
