"""Curves of the document as numbers: their points, knots and weights, and their Bézier pieces, world."""

from collections import deque
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces
from workbench.document.model import NEIGHBOUR_SPLINES, Curve
from workbench.geometry.curves.kochanek_bartels import Signed
from workbench.geometry.curves.sections import Ends
from workbench.language import _, ngettext

Array = NDArray[np.float64]

# Twice the degree, and the crossings of a Bézier curve with itself take minutes to find.
MAX_BEZIER_DEGREE = 49
_WORTH_KEEPING = 50
_NEVER_ROUND, _ALWAYS_ROUND = ("natural_cubic", "clamped_cubic"), ("periodic_cubic",)


@lru_cache(maxsize=64)
def _table(curve: Curve) -> Array:
    """x, y, weight and tangent of each point (n, 5); read-only."""
    rows = [(p.x, p.y, p.weight, p.tangent_x, p.tangent_y) for p in curve.points_world]
    table = np.array(rows, np.float64).reshape(-1, 5)
    table.setflags(write=False)
    return table


def points_of(curve: Curve) -> Array:
    """The control points (n, 2), world."""
    return _table(curve)[:, :2]


def weights_of(curve: Curve) -> Array:
    """The weight of each control point (n,)."""
    return _table(curve)[:, 2]


def tangents_of(curve: Curve) -> Array:
    """The derivative by u at each point (n, 2), world."""
    return _table(curve)[:, 3:]


def knots_of(curve: Curve) -> Array:
    """The knots of a B-spline as its rule makes them: n + degree + 1, of a closed one n + 1 for one turn.

    Raises: ValueError for too few points.
    """
    if curve.knot_rule == "free":
        return np.array([knot.u for knot in curve.knots], np.float64)
    count = len(curve.points_world)
    if curve.closed:
        return np.arange(count + 1.0)
    rule = curves.uniform_knots if curve.knot_rule == "uniform" else curves.open_uniform_knots
    return rule(count, curve.degree)


def b_spline_of(curve: Curve) -> tuple[Array, Array, Array]:
    """Points (n, 2), knots and weights (n,) of the B-spline; a closed one has its first points once more.

    Raises: ValueError for too few points.
    """
    points, weights = points_of(curve), weights_of(curve)
    if not curve.closed:
        return points, knots_of(curve), weights
    around, knots = curves.closed_b_spline(np.column_stack([points, weights]), curve.degree, knots_of(curve))
    return around[:, :2], knots, around[:, 2]


@lru_cache(maxsize=256)
def pieces_of(curve: Curve, spline: str = "") -> Pieces:
    """The Bézier pieces, world, of a curve as it is or as one of another kind over the same points.

    Raises: ValueError with the sentence that says what is missing, as for too few points.
    """
    points = points_of(curve)
    ends: Ends = "closed" if curve.closed else "inner" if curve.ends == "inner" else "through"
    match spline or curve.spline:
        case "bezier":
            around = np.vstack([points, points[:1]]) if curve.closed else points
            _refuse_degree(len(around) - 1)
            return _bezier(around[None], np.array([0.0, 1.0]))
        case "bezier_path":
            return _path(points, curve.closed)
        case "b_spline":
            controls, knots, _weights = b_spline_of(curve)
            return _b_spline_pieces(controls, knots, curve.degree)
        case "nurbs":
            controls, knots, weights = b_spline_of(curve)
            whole = _b_spline_pieces(curves.homogeneous(controls, weights), knots, curve.degree)
            flat, pulls = curves.projected(whole.controls)
            return Pieces(whole.knots, flat, pulls)
        case "hermite":
            tangents = tangents_of(curve)
            if curve.closed:
                points, tangents = np.vstack([points, points[:1]]), np.vstack([tangents, tangents[:1]])
            return curves.hermite(points, tangents)
        case "natural_cubic":
            return curves.natural_cubic(points)
        case "clamped_cubic":
            tangents = tangents_of(curve)
            return curves.clamped_cubic(points, tangents[0], tangents[-1])
        case "periodic_cubic":
            return curves.periodic_cubic(points)
        case "cardinal":
            return curves.cardinal(points, curve.tension, ends)
        case "catmull_rom":
            return curves.catmull_rom(points, curve.alpha, ends)
        case _:
            signed_by: Signed = "paper" if curve.continuity_sign == "paper" else "book"
            shape = curve.tension, curve.continuity, curve.bias
            return curves.kochanek_bartels(points, *shape, ends, signed_by)


def _refuse_degree(degree: int) -> None:
    if degree > MAX_BEZIER_DEGREE:
        sentence = _(
            "This Bézier curve has degree {degree}, but only degrees up to {most} are "
            "drawn; choose another kind."
        )
        raise ValueError(sentence.format(degree=degree, most=MAX_BEZIER_DEGREE))


class _Made(NamedTuple):
    """A B-spline and its pieces."""

    controls: Array
    knots: Array
    degree: int
    pieces: Pieces


_made: deque[_Made] = deque(maxlen=8)


def _b_spline_pieces(controls: Array, knots: Array, degree: int) -> Pieces:
    """The pieces of a B-spline; of one that was there before only those are made anew whose points moved."""
    for before in tuple(_made):
        if before.degree != degree or before.controls.shape != controls.shape:
            continue
        if not np.array_equal(before.knots, knots):
            continue
        moved = _made_anew(before, controls)
        if moved is not None:
            _made.append(_Made(controls, knots, degree, moved))
            return moved
    pieces = curves.b_spline_to_bezier(controls, knots, degree)
    if len(controls) >= _WORTH_KEEPING:
        _made.append(_Made(controls, knots, degree, pieces))
    return pieces


def _made_anew(before: _Made, controls: Array) -> Pieces | None:
    """The pieces with some of the points moved; None where that is not worth while."""
    knots, degree, count = before.knots, before.degree, len(controls)
    moved = np.flatnonzero((before.controls != controls).any(axis=1))
    if not len(moved):
        return before.pieces
    low, high = max(int(moved[0]) - degree, 0), min(int(moved[-1]) + degree + 1, count)
    if high - low > count // 2 or knots[low + degree] == knots[high]:
        return None
    part = curves.b_spline_to_bezier(controls[low:high], knots[low : high + degree + 1], degree)
    first = int(np.count_nonzero(np.diff(knots[degree : low + degree + 1]) > 0))
    moved_controls = before.pieces.controls.copy()
    moved_controls[first : first + len(part.controls)] = part.controls
    return Pieces(before.pieces.knots, moved_controls)


def _bezier(controls: Array, knots: Array) -> Pieces:
    if controls.shape[1] < 2:
        raise ValueError("There is 1 point, but 2 are needed; add 1.")
    return Pieces(knots, controls)


def _path(points: Array, closed: bool) -> Pieces:
    """Cubic pieces over point, handle, handle, point; of a closed path the last ends at the first point."""
    count = len(points) // 3 if closed else (len(points) - 1) // 3
    if count < 1:
        missing = (3 if closed else 4) - len(points)
        sentence = ngettext(
            "There is {count} point, and a piece needs {missing} more; add {missing}.",
            "There are {count} points, and a piece needs {missing} more; add {missing}.",
            len(points),
        )
        raise ValueError(sentence.format(count=len(points), missing=missing))
    at = 3 * np.arange(count)[:, None] + np.arange(4)
    return Pieces(np.arange(count + 1.0), points[at % (3 * count) if closed else at])


def goes_round(curve: Curve) -> bool:
    """Whether the curve comes back to its begin: some kinds always do, and some never."""
    return curve.closed if may_be_closed(curve) else curve.spline in _ALWAYS_ROUND


def may_be_closed(curve: Curve) -> bool:
    """Whether a curve of this kind is open or closed as one likes."""
    return curve.spline not in (*_NEVER_ROUND, *_ALWAYS_ROUND)


def ends_steer(curve: Curve) -> bool:
    """Whether the first and the last point only steer, and the curve joins those between."""
    return curve.spline in NEIGHBOUR_SPLINES and curve.ends == "inner" and not curve.closed


def fault_of(curve: Curve, spline: str = "") -> str:
    """The sentence that says why there is no such curve yet; empty when there is one."""
    try:
        pieces_of(curve, spline)
    except ValueError as problem:
        return str(problem)
    return ""


def place_of(knots: Array, u: float) -> tuple[int, float]:
    """Number of the piece that u lies in, and where in it, 0 to 1. Raises: ValueError outside."""
    if not knots[0] <= u <= knots[-1]:
        sentence = _("There is no u = {u:g} on this curve; choose it from {low:g} to {high:g}.")
        raise ValueError(sentence.format(u=u, low=knots[0], high=knots[-1]))
    piece, v, _length = curves.located(knots, u)
    return int(piece), float(v)


def parameter_at(curve: Curve, share: float) -> float:
    """The parameter u at a share, 0 to 1, of the range of u. Raises: ValueError where there is no curve."""
    knots = pieces_of(curve).knots
    if share >= 1.0:
        return float(knots[-1])
    # Rounding may not lead beyond the end.
    return float(min(knots[0] + max(share, 0.0) * (knots[-1] - knots[0]), knots[-1]))


def share_at(curve: Curve, u: float) -> float:
    """How far u is in the range of u, 0 to 1. Raises: ValueError where there is no curve."""
    knots = pieces_of(curve).knots
    length = knots[-1] - knots[0]
    if length == 0.0:  # all points in one place, and alpha above 0
        return 0.0
    return float(min(max((u - knots[0]) / length, 0.0), 1.0))
