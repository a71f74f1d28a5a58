"""Curves of one degree more, which stay the same, and of one less, with the error stated in world units."""

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.document.building import Edit, checked
from workbench.document.curves.changes import changing
from workbench.document.curves.pieces import MAX_BEZIER_DEGREE, pieces_of
from workbench.document.curves.turns import Rows, one_turn, rows_of, spread, spread_knots, with_rows
from workbench.document.model import B_SPLINES, MAX_DEGREE, Curve, CurvePoint
from workbench.language import _

Array = NDArray[np.float64]


@checked
def raise_degree(figure: str) -> Edit:
    """Raise the degree of a Bézier curve or B-spline by one; it stays the same and has more points."""
    return changing(figure, raised)


@checked
def lower_degree(figure: str) -> Edit:
    """Lower the degree of a Bézier curve or B-spline by one; ``lowered`` tells by how much it is off."""
    return changing(figure, lambda curve: lowered(curve)[0])


def raised(curve: Curve) -> Curve:
    """``curve`` one degree higher. Raises: ValueError where its kind has one degree only, or none above."""
    if curve.spline == "bezier":
        (points,) = pieces_of(curve).controls
        _refuse_highest(len(points) - 1, MAX_BEZIER_DEGREE)
        return _with_bezier(curve, curves.elevate_degree(points))
    _refuse_others(curve)
    _refuse_highest(curve.degree, MAX_DEGREE)
    whole = rows_of(curve)
    rows, knots = curves.elevate_b_spline(whole.rows, whole.knots, whole.degree)
    made = Rows(rows, knots, curve.degree + 1)
    return _fitted(curve, one_turn(curve, made) if curve.closed else made)


def lowered(curve: Curve) -> tuple[Curve, float]:
    """``curve`` one degree lower, and how far it is off at most. Raises: ValueError."""
    if curve.spline == "bezier":
        points, error = curves.lower_degree(pieces_of(curve).controls[0])
        return _with_bezier(curve, points), error
    _refuse_others(curve)
    if curve.closed:
        raise ValueError(_("The degree of a closed B-spline cannot be lowered; open the curve first."))
    whole = rows_of(curve)
    rows, knots, error = curves.lower_b_spline(whole.rows, whole.knots, whole.degree)
    if curve.spline == "nurbs":
        if not (rows[:, 2] > 0).all():
            raise ValueError(
                _("With a lower degree a weight would no longer be above 0; convert the curve instead.")
            )
        # |A / w - A' / w'| is at most (|A - A'| + |A / w| |w - w'|) / w'.
        far = float(np.linalg.norm(pieces_of(curve).controls, axis=-1).max())
        error = error * (1.0 + far) / float(rows[:, 2].min())
    return _fitted(curve, Rows(rows, knots, curve.degree - 1)), error


def _refuse_highest(degree: int, most: int) -> None:
    if degree >= most:
        raise ValueError(_("The degree is already {most}, the highest there is.").format(most=most))


def _refuse_others(curve: Curve) -> None:
    if curve.spline not in B_SPLINES:
        raise ValueError(_("This kind of curve has a fixed degree; convert it to a B-spline first."))


def _with_bezier(curve: Curve, rows: Array) -> Curve:
    if curve.closed:
        rows = rows[:-1]
    points = tuple(
        replace(old or CurvePoint("", 0.0, 0.0), x=x, y=y)
        for old, (x, y) in zip(spread(curve.points_world, len(rows)), rows.tolist(), strict=True)
    )
    return replace(curve, points_world=points, knot_rule="open_uniform", knots=())


def _fitted(curve: Curve, made: Rows) -> Curve:
    old = spread(curve.points_world, len(made.rows))
    return with_rows(curve, made, old, spread_knots(curve, len(made.knots)))
