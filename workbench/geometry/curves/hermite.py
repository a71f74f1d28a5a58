"""Hermite curves: cubic pieces between points, with given tangents.

Source: Hearn and Baker, Computer Graphics, C Version, section 10-7.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import Fault, faults, refuse, there_are
from workbench.geometry.curves.pieces import Pieces

Array = NDArray[np.float64]


def hermite(points: ArrayLike, tangents: ArrayLike, knots: ArrayLike | None = None) -> Pieces:
    """The cubic pieces that go through points (n, k) with these tangents (n, k), the derivatives by u.

    Args: knots (n,): the parameter at each point, ascending; 0, 1, 2 and so on if none are given. Where two
    are equal, the piece is the straight line between its points. Raises: ValueError.
    """
    through, along = np.asarray(points, float), np.asarray(tangents, float)
    refuse(faults(through))
    if along.shape != through.shape or not np.isfinite(along).all():
        there = there_are(len(along), "tangent")
        raise ValueError(f"{there} for {len(through)} points; give each point one, finite.")
    t = parameters(len(through), knots)
    return hermite_pieces(through, along[:-1], along[1:], t)


def hermite_pieces(through: Array, leaving: Array, arriving: Array, knots: Array) -> Pieces:
    """As ``hermite``, with the tangents (n-1, k) at the begin and at the end of each piece."""
    third = np.diff(knots)[:, None] / 3.0
    begin, end = through[:-1], through[1:]
    return Pieces(knots, np.stack([begin, begin + third * leaving, end - third * arriving, end], axis=1))


def parameters(count: int, knots: ArrayLike | None, strictly: bool = False) -> Array:
    """The parameter at each of ``count`` points: 0, 1, 2 and so on, or ``knots`` if they are fit for that.

    Raises: ValueError where they decrease, or, ``strictly``, where two are equal.
    """
    if knots is None:
        return np.arange(count, dtype=float)
    t = np.asarray(knots, float)
    faulty: list[Fault] = []
    if t.shape != (count,) or not np.isfinite(t).all():
        there = there_are(t.size, "knot")
        faulty.append(Fault("knots", -1, f"{there} for {count} points; give each point one, finite."))
    else:
        steps = np.diff(t)
        for i in np.flatnonzero((steps < 0) | (strictly & (steps == 0))):
            what = f"Knot {i + 1} is {t[i + 1]:g}, after {t[i]:g}; raise it"
            faulty.append(
                Fault("knots", int(i) + 1, f"{what}, or part the points." if strictly else f"{what}.")
            )
    refuse(faulty)
    return t
