"""B-splines as rows of numbers: open ones as they are, closed ones over several turns, and back again.

Rows are homogeneous (w x, w y, w) for NURBS and (x, y) else, so that one formula serves both.
"""

import math
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.document.curves.pieces import knots_of, points_of, weights_of
from workbench.document.model import Curve, CurvePoint, Knot

Array = NDArray[np.float64]


class Rows(NamedTuple):
    """A B-spline: rows (n, 2 or 3), knots (n + degree + 1,), degree."""

    rows: Array
    knots: Array
    degree: int


def rows_of(curve: Curve) -> Rows:
    """An open B-spline or NURBS curve as it is; a closed one over ``turns_of`` turns. Raises: ValueError."""
    rows = points_of(curve)
    if curve.spline == "nurbs":
        rows = curves.homogeneous(rows, weights_of(curve))
    knots, degree, count = knots_of(curve), curve.degree, len(rows)
    if not curve.closed:
        return Rows(rows, knots, degree)
    curves.closed_b_spline(rows, degree, knots)
    at = np.arange(-degree, turns_of(curve) * count + degree + 1)
    turned = knots[at % count] + period_of(curve) * (at // count)
    return Rows(rows[np.arange(turns_of(curve) * count + degree) % count], turned, degree)


def turns_of(curve: Curve) -> int:
    """How many turns of a closed curve are enough for whatever is done to one of them."""
    return 2 * middle_turn(curve) + 1


def middle_turn(curve: Curve) -> int:
    """Number of the turn, from 0, that the ends of ``rows_of`` have no part in."""
    return 1 + math.ceil((curve.degree + 1) / len(curve.points_world))


def period_of(curve: Curve) -> float:
    """The length in u of one turn of a closed curve."""
    knots = knots_of(curve)
    return float(knots[-1] - knots[0])


def one_turn(curve: Curve, turned: Rows, begin: int = -1, count: int = 0) -> Rows:
    """Rows (n, k) and knots (n+1,) of the middle turn of a closed curve, which ``turned`` is several of.

    It begins at the knot number ``begin`` and has ``count`` points; if none is given, at the last knot there.
    """
    first, period, turn = float(knots_of(curve)[0]), period_of(curve), middle_turn(curve)
    end = begin + count
    if begin < 0:
        begin, end = (
            int(np.searchsorted(turned.knots, first + k * period + 1e-9 * period, side="right")) - 1
            for k in (turn, turn + 1)
        )
    rows = turned.rows[begin - turned.degree : end - turned.degree]
    return Rows(rows, turned.knots[begin : end + 1] - turn * period, turned.degree)


def with_rows(
    curve: Curve, made: Rows, old_points: list[CurvePoint | None], old_knots: list[Knot | None]
) -> Curve:
    """``curve`` with these rows and free knots; what was there before keeps its id, None is new."""
    rows, weights = made.rows, np.ones(len(made.rows))
    if curve.spline == "nurbs":
        rows, weights = curves.projected(made.rows)
    points = tuple(
        replace(old or CurvePoint("", 0.0, 0.0), x=x, y=y, weight=w if curve.spline == "nurbs" else 1.0)
        for old, (x, y), w in zip(old_points, rows.tolist(), weights.tolist(), strict=True)
    )
    knots = tuple(
        Knot(old.id if old else "", u) for old, u in zip(old_knots, made.knots.tolist(), strict=True)
    )
    return replace(curve, points_world=points, degree=made.degree, knot_rule="free", knots=knots)


def spread(old: tuple[CurvePoint, ...], count: int) -> list[CurvePoint | None]:
    """``count`` places for the ``old`` points: from both ends to the middle, where what is new comes in."""
    front, back = old[: (min(len(old), count) + 1) // 2], old[(len(old) + 1) // 2 :]
    back = back[max(len(back) - (count - len(front)), 0) :]
    return [*front, *[None] * (count - len(front) - len(back)), *back]


def spread_knots(curve: Curve, count: int) -> list[Knot | None]:
    """``count`` places for the free knots of ``curve``, as ``spread`` does for points."""
    knots = curve.knots
    front = knots[: (min(len(knots), count) + 1) // 2]
    back = knots[len(knots) - min(len(knots) // 2, count - len(front)) :] if count > len(front) else ()
    return [*front, *[None] * (count - len(front) - len(back)), *back]
