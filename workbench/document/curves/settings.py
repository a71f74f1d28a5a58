"""Edits of what shapes a curve besides its points: its kind, degree, knots, weights and tangents."""

from collections.abc import Iterable, Mapping

from msgspec.structs import replace

from workbench.document.addresses import Address, parse, part_with, point_with
from workbench.document.building import Edit, checked, number, whole_number, with_changed
from workbench.document.curves.changes import changing, curve_with
from workbench.document.curves.knots import with_degree, with_knot_rule
from workbench.document.errors import DocumentError
from workbench.document.model import TANGENT_SPLINES, Curve, Document, Knot
from workbench.language import _


@checked
def set_spline(figure: str, spline: str) -> Edit:
    """Let the curve be of another kind, over the same points.

    The first time that a kind with tangents is chosen, these are made from the neighbours.
    """

    def change(curve: Curve) -> Curve:
        return _with_tangents(replace(curve, spline=spline))

    return changing(figure, change)


@checked
def set_beside(figure: str, splines: Iterable[str]) -> Edit:
    """Choose the kinds that are shown beside the curve over the same points; each once, in this order."""
    kinds = tuple(dict.fromkeys(splines))
    return changing(figure, lambda curve: _with_tangents(replace(curve, beside=kinds)))


def _with_tangents(curve: Curve) -> Curve:
    """``curve`` with tangents half the way between both neighbours, where it needs and has none."""
    points = curve.points_world
    needs = any(kind in TANGENT_SPLINES for kind in (curve.spline, *curve.beside))
    if not needs or len(points) < 2 or any(p.tangent_x or p.tangent_y for p in points):
        return curve
    with_tangents = []
    for index, point in enumerate(points):
        if curve.closed:
            a, b, share = points[index - 1], points[(index + 1) % len(points)], 2.0
        else:
            low, high = max(index - 1, 0), min(index + 1, len(points) - 1)
            a, b, share = points[low], points[high], float(high - low)
        with_tangents.append(replace(point, tangent_x=(b.x - a.x) / share, tangent_y=(b.y - a.y) / share))
    return replace(curve, points_world=tuple(with_tangents))


@checked
def set_degree(figure: str, degree: int) -> Edit:
    """Give a B-spline another degree over the same points: the curve changes (see ``raise_degree``)."""
    wanted = whole_number(degree)

    def change(curve: Curve) -> Curve:
        if type(wanted) is not int or wanted < 1:
            return replace(curve, degree=wanted)
        return with_degree(curve, wanted)

    return changing(figure, change)


@checked
def set_knot_rule(figure: str, rule: str) -> Edit:
    """Choose how knots are made; "free" begins with those that there are."""
    return changing(figure, lambda curve: with_knot_rule(curve, rule))


@checked
def set_knot(address: Address | str, u: float) -> Edit:
    """Put a free knot to the parameter ``u``; refused where the knots would decrease."""
    where, value = parse(address), number(u)

    def edit(document: Document) -> Document:
        curve = curve_with(document, where.figure)
        if not isinstance(part_with(curve, where.point), Knot):
            sentence = _("{address} is a point; choose a knot.").format(address=where)
            raise DocumentError(str(where), sentence)
        knots = tuple(replace(k, u=value) if k.id == where.point else k for k in curve.knots)
        return with_changed(document, [replace(curve, knots=knots)])

    return edit


@checked
def set_weights(weights: Mapping[Address | str, float]) -> Edit:
    """Give control points weights, above 0, which a NURBS curve is pulled by."""
    by_figure: dict[str, dict[str, float]] = {}
    for text, weight in weights.items():
        where = parse(text)
        by_figure.setdefault(where.figure, {})[where.point] = number(weight)

    def edit(document: Document) -> Document:
        new = []
        for figure, of_points in by_figure.items():
            curve = curve_with(document, figure)
            for point in of_points:
                point_with(curve, point)
            points = (
                replace(p, weight=of_points[p.id]) if p.id in of_points else p for p in curve.points_world
            )
            new.append(replace(curve, points_world=tuple(points)))
        return with_changed(document, new)

    return edit
