"""How smoothly two curves join, in numbers.

C0, C1 and C2 compare points and derivatives by the parameter; G0, G1 and G2 points, directions and curvature.
Source: Hearn and Baker, Computer Graphics, C Version, section 10-6; Farin, Curves and Surfaces for CAGD.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse
from workbench.geometry.curves.derivatives import local_derivatives
from workbench.geometry.curves.halving import lengths
from workbench.geometry.curves.pieces import Pieces, with_length

Array = NDArray[np.float64]


class Continuity(NamedTuple):
    """What is left between the two sides of a joint, and what may be said of it.

    c0 and g0: distance of the points; c1, c2: lengths of the differences of first and second derivatives;
    g1: angle between the tangents in radians; g2: length of the difference of the curvature vectors. A number
    that does not exist is nan. ``parametric`` is "C2", "C1", "C0" or "", ``geometric`` likewise.
    """

    c0: float
    c1: float
    c2: float
    g0: float
    g1: float
    g2: float
    parametric: str
    geometric: str


class _Sides(NamedTuple):
    """Curves at one of their ends, (m, k) each; a direction or a curvature that does not exist is nan."""

    points: Array
    firsts: Array
    seconds: Array
    directions: Array
    curvatures: Array


def continuity(
    before: ArrayLike,
    after: ArrayLike,
    length_before: float = 1.0,
    length_after: float = 1.0,
    tolerance: float = 1e-9,
    weights: tuple[ArrayLike | None, ArrayLike | None] = (None, None),
) -> Continuity:
    """How the end of one Bézier curve joins the begin of the next.

    Args: control points (n+1, k) and (m+1, k); how long each piece is in the parameter; what counts as
    nothing, as a part of the sizes compared; the weights (n+1,) and (m+1,) of rational curves.
    Raises: ValueError for too few points, lengths not above 0, weights that are not.
    """
    if not (length_before > 0 and length_after > 0):
        raise ValueError("A piece has no length in the parameter; move its knots apart, or leave it out.")
    refuse(faults(before, weights=weights[0]) + faults(after, weights=weights[1]))
    one, other = np.asarray(before, float), np.asarray(after, float)
    size = np.ptp(np.vstack([one, other]), axis=0).max(keepdims=True)
    pulls = [None if w is None else np.asarray(w, float)[None] for w in weights]
    last, first = np.array([length_before]), np.array([length_after])
    end = _ends(one[None, ::-1], pulls[0] if pulls[0] is None else pulls[0][:, ::-1], -last, tolerance * size)
    begin = _ends(other[None], pulls[1], first, tolerance * size)
    return _compared(end, begin, size, np.minimum(last, first), tolerance)[0]


def joints(pieces: Pieces, closed: bool = False, tolerance: float = 1e-9) -> list[Continuity]:
    """The continuity at each knot between two pieces; of a ``closed`` curve at its end, too.

    A piece without length in the parameter is passed over: its neighbours join.
    """
    knots, controls, weights = with_length(pieces)
    length = np.diff(knots)
    before = np.arange(len(controls) if closed else len(controls) - 1)
    if not len(before):
        return []
    after = (before + 1) % len(controls)
    low, high = controls.min(axis=1), controls.max(axis=1)
    size = (np.maximum(high[before], high[after]) - np.minimum(low[before], low[after])).max(axis=1)
    turned, begun = (None, None) if weights is None else (weights[before, ::-1], weights[after])
    end = _ends(controls[before, ::-1], turned, -length[before], tolerance * size)
    begin = _ends(controls[after], begun, length[after], tolerance * size)
    return _compared(end, begin, size, np.minimum(length[before], length[after]), tolerance)


def _ends(points: Array, weights: Array | None, length: Array, nothing: Array) -> _Sides:
    """Curves (m, n+1, k) at their first points; one that was turned round has a negative length (m,).

    Legs no longer than ``nothing`` (m,) are rounding errors and have no direction.
    """
    _point, first, second = local_derivatives(points, weights, 0.0, 2)
    legs = points - points[:, :1]
    apart = np.abs(legs).max(axis=2) > nothing[:, None]
    leg = np.take_along_axis(legs, apart.argmax(axis=1)[:, None, None], axis=1)[:, 0]
    directions = np.where(apart.any(axis=1)[:, None], leg, np.nan)
    directions = directions / np.abs(directions).max(axis=1, keepdims=True)
    directions = directions / lengths(directions)[:, None]
    speed = lengths(first)[:, None]
    across = second - (second * directions).sum(axis=1, keepdims=True) * directions
    moving = speed > nothing[:, None]
    curvatures = np.divide(across, speed, out=np.full_like(across, np.nan), where=moving)
    curvatures = np.divide(curvatures, speed, out=curvatures, where=moving)
    once = length[:, None]
    return _Sides(points[:, 0], first / once, second / once**2, directions, curvatures)


def _compared(end: _Sides, begin: _Sides, size: Array, short: Array, tolerance: float) -> list[Continuity]:
    """What is left between ends and begins of curves of this ``size`` (m,), and what may be said of it."""
    c0, c1, c2 = (lengths(a - b) for a, b in zip(end[:3], begin[:3], strict=True))
    g1 = _angles(-end.directions, begin.directions)
    g2 = lengths(end.curvatures - begin.curvatures)
    firsts = np.maximum(lengths(end.firsts), lengths(begin.firsts))
    seconds = np.maximum(lengths(end.seconds), lengths(begin.seconds))
    bends = np.maximum(lengths(end.curvatures), lengths(begin.curvatures))
    joined = c0 <= tolerance * size
    same_first = joined & (c1 <= tolerance * np.maximum(firsts, size / short))
    same_second = same_first & (c2 <= tolerance * np.maximum(seconds, size / short**2))
    along = joined & (g1 <= tolerance)
    bent = along & (g2 * size <= tolerance * np.maximum(bends * size, 1.0))
    parametric = joined.astype(int) + same_first + same_second
    geometric = joined.astype(int) + along + bent
    columns = [column.tolist() for column in (c0, c1, c2, c0, g1, g2)]
    told = [("", "C0", "C1", "C2")[k] for k in parametric], [("", "G0", "G1", "G2")[k] for k in geometric]
    return [Continuity(*row) for row in zip(*columns, *told, strict=True)]


def _angles(one: Array, other: Array) -> Array:
    """The angles between unit vectors (m, k), exact for small ones too."""
    angles: Array = 2.0 * np.arctan2(lengths(one - other), lengths(one + other))
    return angles
