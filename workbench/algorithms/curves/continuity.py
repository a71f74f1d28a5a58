"""How smoothly two curves join, in numbers.

C0, C1 and C2 compare points and derivatives by the parameter; G0, G1 and G2 points, directions and curvature.
Source: Hearn and Baker, Computer Graphics, C Version, section 10-6; Farin, Curves and Surfaces for CAGD.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.algorithms.curves.bernstein import hodograph
from workbench.algorithms.curves.conditions import faults, refuse
from workbench.algorithms.curves.pieces import Pieces

Array = NDArray[np.float64]


class Continuity(NamedTuple):
    """What is left between the two sides of a joint, and what may be said of it.

    c0: distance of the points; c1, c2: lengths of the differences of first and second derivatives; g1: angle
    between the tangents in radians; g2: length of the difference of the curvature vectors. A number that does
    not exist is nan. ``parametric`` is "C2", "C1", "C0" or "", ``geometric`` "G2", "G1", "G0" or "".
    """

    c0: float
    c1: float
    c2: float
    g0: float
    g1: float
    g2: float
    parametric: str
    geometric: str


class _Side(NamedTuple):
    """A curve at one of its ends."""

    point: Array
    first: Array
    second: Array
    direction: Array | None
    curvature: Array | None


def continuity(
    before: ArrayLike,
    after: ArrayLike,
    length_before: float = 1.0,
    length_after: float = 1.0,
    tolerance: float = 1e-9,
) -> Continuity:
    """How the end of one Bézier curve joins the begin of the next.

    Args: control points (n+1, k) and (m+1, k); how long each piece is in the parameter; what counts as
    nothing, as a part of the sizes compared. Raises: ValueError for too few points, lengths not above 0.
    """
    if not (length_before > 0 and length_after > 0):
        raise ValueError("A piece has no length in the parameter; part its knots, or leave it out.")
    refuse(faults(before) + faults(after))
    one, other = np.asarray(before, float), np.asarray(after, float)
    size = float(np.ptp(np.vstack([one, other]), axis=0).max())
    end = _end_of(one[::-1], -length_before, tolerance * size)
    begin = _end_of(other, length_after, tolerance * size)
    short = min(length_before, length_after)
    c0, c1, c2 = (float(np.linalg.norm(a - b)) for a, b in zip(end[:3], begin[:3], strict=True))
    joined = c0 <= tolerance * size
    same_first = joined and c1 <= tolerance * max(_norm(end.first, begin.first), size / short)
    same_second = same_first and c2 <= tolerance * max(_norm(end.second, begin.second), size / short**2)
    g1 = g2 = float("nan")
    if end.direction is not None and begin.direction is not None:
        g1 = _angle(-end.direction, begin.direction)
    if end.curvature is not None and begin.curvature is not None:
        g2 = float(np.linalg.norm(end.curvature - begin.curvature))
    along = joined and g1 <= tolerance
    bent = along and g2 * size <= tolerance * max(_norm(end.curvature, begin.curvature) * size, 1.0)
    parametric = "C2" if same_second else "C1" if same_first else "C0" if joined else ""
    geometric = "G2" if bent else "G1" if along else "G0" if joined else ""
    return Continuity(c0, c1, c2, c0, g1, g2, parametric, geometric)


def joints(pieces: Pieces, closed: bool = False, tolerance: float = 1e-9) -> list[Continuity]:
    """The continuity at each knot between two pieces; of a ``closed`` curve at its end, too."""
    lengths, controls = np.diff(pieces.knots), pieces.controls
    count = len(controls) if closed else len(controls) - 1
    follow = [(j, (j + 1) % len(controls)) for j in range(count)]
    return [continuity(controls[j], controls[k], lengths[j], lengths[k], tolerance) for j, k in follow]


def _end_of(points: Array, length: float, nothing: float) -> _Side:
    """The curve at its first point; a curve that was turned round has a negative length.

    Legs no longer than ``nothing`` are rounding errors and have no direction.
    """
    first = hodograph(points)
    second = hodograph(first) if len(first) > 1 else np.zeros((1, points.shape[1]))
    legs = points - points[0]
    apart = np.flatnonzero(np.abs(legs).max(axis=1) > nothing)
    direction = curvature = None
    if len(apart):
        direction = legs[apart[0]] / np.abs(legs[apart[0]]).max()
        direction /= np.linalg.norm(direction)
    speed = float(np.linalg.norm(first[0]))
    if direction is not None and speed > nothing:
        curvature = (second[0] - (second[0] @ direction) * direction) / speed / speed
    return _Side(points[0], first[0] / length, second[0] / length**2, direction, curvature)


def _norm(one: Array | None, other: Array | None) -> float:
    """The larger length of the two."""
    return max(float(np.linalg.norm(v)) for v in (one, other) if v is not None) if one is not None else 0.0


def _angle(one: Array, other: Array) -> float:
    """The angle between two unit vectors, exact for small ones too."""
    return float(2.0 * np.arctan2(np.linalg.norm(one - other), np.linalg.norm(one + other)))
