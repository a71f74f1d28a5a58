"""Knots taken out of B-splines, where the curve stays within a tolerance."""

import math

import numpy as np
from msgspec.structs import replace

from workbench.algorithms import curves
from workbench.document.addresses import Address, parse, part_with
from workbench.document.building import Edit, checked, number
from workbench.document.curves.changes import changing
from workbench.document.curves.conversions import TOLERANCE_WORLD
from workbench.document.curves.cutting import inserted
from workbench.document.curves.knots import with_knot_rule
from workbench.document.curves.pieces import knots_of
from workbench.document.curves.turns import (
    Rows,
    middle_turn,
    one_turn,
    period_of,
    rows_of,
    turns_of,
    with_rows,
)
from workbench.document.model import B_SPLINES, Curve, Knot
from workbench.language import _


@checked
def remove_knot(address: Address | str, tolerance_world: float = TOLERANCE_WORLD) -> Edit:
    """Take a free knot, and with it a point, out of a B-spline; refused where it would change by more."""
    where, most = parse(address), number(tolerance_world)

    def change(curve: Curve) -> Curve:
        knot = part_with(curve, where.point)
        if not isinstance(knot, Knot):
            raise ValueError(_("{address} is a point; choose a knot.").format(address=where))
        made, error = without_knot(curve, curve.knots.index(knot))
        if not error <= most:
            sentence = _(
                "Without this knot the curve would change by up to {error:.3g}, and {most:g} is allowed; "
                "choose another one, or move the points."
            )
            raise ValueError(sentence.format(error=error, most=most))
        return made

    return changing(where.figure, change)


def knots_fault(curve: Curve) -> str:
    """The sentence that says why a curve has no knots; empty where it has."""
    if curve.spline in B_SPLINES:
        return ""
    return _("Only a B-spline or NURBS curve has knots; convert the curve first.")


def without_knot(curve: Curve, index: int) -> tuple[Curve, float]:
    """A B-spline without its knot number ``index``, and how far it is off at most, world.

    Raises: ValueError for another kind, for knots at the ends of the curve or beyond, and for too few points.
    """
    fault = knots_fault(curve)
    if fault:
        raise ValueError(fault)
    least = 3 if curve.closed else curve.degree + 1
    if len(curve.points_world) <= least:
        sentence = _("Without this knot there would be too few points; at least {least} are needed.")
        raise ValueError(sentence.format(least=least))
    curve = with_knot_rule(curve, "free")
    u = curve.knots[index].u
    if curve.closed and u == curve.knots[-1].u:
        u = curve.knots[0].u
    while curve.closed and u == curve.knots[0].u:
        curve, index = _begun_before(curve), (index + 1) % len(curve.knots)
    knots, rational = knots_of(curve), curve.spline == "nurbs"
    last = int(np.searchsorted(knots, u, side="right")) - 1
    rows = rows_of(curve)
    for turn in range(turns_of(curve) if curve.closed else 1):
        at = u + turn * period_of(curve) if curve.closed else u
        less = curves.remove_knot(rows.rows, rows.knots, rows.degree, at, rational=rational)
        rows = Rows(less.points, less.knots, rows.degree)
    points, kept = [*curve.points_world], [*curve.knots]
    gone = last - curve.degree + curve.degree // 2
    if curve.closed:
        count = len(points) - 1
        rows = one_turn(curve, rows, curve.degree + middle_turn(curve) * count, count)
        gone = min(last + curve.degree // 2, count)
    if rational and rows.rows[:, -1].min() <= 0.0:
        return curve, math.inf
    del points[gone], kept[index]
    left = with_rows(curve, rows, [*points], [*kept])
    # Put in again, the knot gives points whose distance from the old ones bounds that of the curves.
    before, after = rows_of(curve).rows, rows_of(inserted(left, u)).rows
    return left, curves.gap_between(before, after, rational)


def _begun_before(curve: Curve) -> Curve:
    """A closed curve that begins one knot earlier; it looks the same."""
    points, knots = curve.points_world, curve.knots
    first = replace(knots[-1], u=knots[-2].u - period_of(curve))
    return replace(curve, points_world=(points[-1], *points[:-1]), knots=(first, *knots[:-1]))
