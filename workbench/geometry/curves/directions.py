"""Where a row of points turns sharply, and in which direction it runs, seen past its unsteadiness."""

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.halving import lengths

Array = NDArray[np.float64]

_MOST = 12  # neighbours on each side


def corners(points: Array, reach: float, angle: float) -> list[int]:
    """Numbers of the inner points where a row (n, k) turns by more than ``angle`` (radians).

    Directions are taken to the first points at least ``reach`` away; of corners so near to each other, and
    near along the row, only the sharpest counts.
    """
    before, after = (points[_all_away(points, step, reach)] for step in (-1, 1))
    one, other = points - before, after - points
    size = lengths(one) * lengths(other)
    cosine = np.divide((one * other).sum(axis=-1), size, out=np.ones(len(points)), where=size > 0)
    turns = np.arccos(np.clip(cosine, -1.0, 1.0))
    turns[[0, -1]] = 0.0
    sharp = np.flatnonzero(turns > angle)
    chosen: set[int] = set()
    for i in sharp[np.argsort(-turns[sharp], kind="stable")].tolist():
        near = [j for j in range(i - _MOST + 1, i + _MOST) if j in chosen]
        if not near or lengths(points[near] - points[i]).min() > reach:
            chosen.add(i)
    return sorted(chosen)


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


def _all_away(points: Array, step: int, reach: float) -> NDArray[np.intp]:
    """For every point what ``_away`` says of it, (n,)."""
    last = len(points) - 1
    here = np.arange(len(points))
    there = here.copy()
    going = np.full(len(points), True)
    for _neighbour in range(_MOST):
        there[going] = np.clip(there[going] + step, 0, last)
        apart = points[there] - points
        going &= (apart * apart).sum(axis=-1) < reach * reach
    return there
