"""The knots of a curve while its points come and go: always as many as points and degree ask for."""

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.document.curves.pieces import b_spline_of, knots_of
from workbench.document.laws import needed_knots
from workbench.document.model import Curve, CurvePoint, Knot

Array = NDArray[np.float64]


def with_knot_rule(curve: Curve, rule: str) -> Curve:
    """``curve`` under another rule; "free" begins with the knots that it has. Raises: ValueError."""
    if rule == curve.knot_rule:
        return curve
    if rule != "free":
        return replace(curve, knot_rule=rule, knots=())
    return replace(curve, knot_rule=rule, knots=_numbered(knots_of(curve), ()))


def with_points(curve: Curve, index: int, more: tuple[CurvePoint, ...]) -> Curve:
    """``curve`` with points more before the one at ``index``, under the rule "free" with as many knots more.

    Behind the last point the curve is longer by a span for each; before the first likewise; else a span is
    parted evenly.
    """
    points = (*curve.points_world[:index], *more, *curve.points_world[index:])
    if curve.knot_rule != "free":
        return replace(curve, points_world=points)
    count, degree = len(curve.points_world), curve.degree
    if count <= degree:
        return refitted(replace(curve, points_world=points))
    values = knots_of(curve)
    first, last = (0, count) if curve.closed else (degree, count)
    step = float(values[last] - values[first]) / (last - first)
    number, grown = len(more), values.copy()
    if index == count and not curve.closed:
        at = last
        new = values[at] + step * np.arange(number)
        grown[at:] += step * number
    elif index == 0 and not curve.closed:
        at = first + 1
        new = values[first] - step * np.arange(number)[::-1]
        grown[:at] -= step * number
    else:
        at = 1 + min(max(index - degree // 2 if curve.closed else index + degree // 2, first), last - 1)
        new = np.linspace(values[at - 1], values[at], number + 2)[1:-1]
    knots = [
        knot if knot.u == u else replace(knot, u=u)
        for knot, u in zip(curve.knots, grown.tolist(), strict=True)
    ]
    fresh = [Knot("", u) for u in new.tolist()]
    return replace(curve, points_world=points, knots=(*knots[:at], *fresh, *knots[at:]))


def without_point(curve: Curve, index: int) -> Curve:
    """``curve`` without the point at ``index``, and under the rule "free" without a knot in its middle."""
    points = (*curve.points_world[:index], *curve.points_world[index + 1 :])
    if curve.knot_rule != "free":
        return replace(curve, points_world=points)
    count, degree = len(curve.points_world), curve.degree
    first, last = (0, count) if curve.closed else (degree, count)
    if last - first < 2:
        return refitted(replace(curve, points_world=points))
    middle = index - degree // 2 if curve.closed else index + (degree + 1) // 2
    gone = min(max(middle, first + 1), last - 1)
    return replace(curve, points_world=points, knots=(*curve.knots[:gone], *curve.knots[gone + 1 :]))


def with_degree(curve: Curve, degree: int) -> Curve:
    """``curve`` over the same points with another degree; free knots between the ends stay where they can."""
    if curve.knot_rule != "free" or degree == curve.degree or curve.closed:
        return replace(curve, degree=degree)
    return refitted(replace(curve, degree=degree), curve)


def opened(curve: Curve) -> Curve:
    """``curve`` no longer closed, with the knots that it went round by."""
    if curve.knot_rule != "free":
        return replace(curve, closed=False)
    knots = b_spline_of(curve)[1][: len(curve.points_world) + curve.degree + 1]
    return replace(curve, closed=False, knots=_numbered(knots, curve.knots))


def closed(curve: Curve) -> Curve:
    """``curve`` going round, with the knots between its ends and as many more as it needs."""
    if curve.knot_rule != "free":
        return replace(curve, closed=True)
    count, degree = len(curve.points_world), curve.degree
    inner = knots_of(curve)[degree : count + 1] if count > degree else np.array([0.0, 1.0])
    step = float(inner[-1] - inner[0]) / (len(inner) - 1) or 1.0
    more = inner[-1] + step * np.arange(1, count + 2 - len(inner))
    return replace(curve, closed=True, knots=_numbered(np.append(inner, more), curve.knots))


def refitted(curve: Curve, before: Curve | None = None) -> Curve:
    """``curve`` with as many free knots as it needs, spread as those it had, or those of ``before``."""
    needed = needed_knots(curve)
    if curve.knot_rule != "free" or (before is None and len(curve.knots) == needed):
        return curve
    old, count, degree = before or curve, len(curve.points_world), curve.degree
    values = np.array([knot.u for knot in old.knots])
    if curve.closed or count <= degree or len(old.knots) <= 2 * old.degree + 1:
        spread = np.linspace(0, len(values) - 1, needed)
        return replace(curve, knots=_numbered(np.interp(spread, np.arange(len(values)), values), old.knots))
    inner = values[old.degree : len(values) - old.degree]
    spread = np.linspace(0, len(inner) - 1, count - degree + 1)
    fitted = np.interp(spread, np.arange(len(inner)), inner)
    outer = np.arange(1, degree + 1)
    steps = [
        0.0 if values[0] == inner[0] else fitted[1] - fitted[0],
        0.0 if values[-1] == inner[-1] else fitted[-1] - fitted[-2],
    ]
    left, right = fitted[0] - steps[0] * outer[::-1], fitted[-1] + steps[1] * outer
    return replace(curve, knots=_numbered(np.concatenate([left, fitted, right]), old.knots))


def _numbered(values: Array, old: tuple[Knot, ...]) -> tuple[Knot, ...]:
    """Knots at ``values``, with the ids of the ``old`` ones in their order; what is more has none yet."""
    ids = [knot.id for knot in old[: len(values)]]
    ids += [""] * (len(values) - len(ids))
    return tuple(Knot(name, float(u)) for name, u in zip(ids, values, strict=True))
