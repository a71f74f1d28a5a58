"""Points put into a curve without changing it, and curves cut in two."""

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.document.addresses import figure_with
from workbench.document.building import (
    Edit,
    checked,
    number,
    numbered,
    remembering,
    with_changed,
    with_figures,
)
from workbench.document.curves.changes import changing, curve_with
from workbench.document.curves.conversions import converted
from workbench.document.curves.degrees import raised
from workbench.document.curves.knots import refitted, with_points
from workbench.document.curves.paths import (
    Joint,
    joints_of,
    natural_joint,
    opened_path,
    place,
    points_from,
    sound,
)
from workbench.document.curves.pieces import ends_steer, goes_round, knots_of, pieces_of, place_of
from workbench.document.curves.turns import (
    Rows,
    middle_turn,
    one_turn,
    period_of,
    rows_of,
    turns_of,
    with_rows,
)
from workbench.document.errors import DocumentError
from workbench.document.model import B_SPLINES, Curve, CurvePoint, Document, Knot
from workbench.language import _

Array = NDArray[np.float64]
_ROUNDING = 1e-9


@checked
def insert_on_curve(figure: str, u: float) -> Edit:
    """Put a point into a curve at the parameter u, by ``inserted``."""
    return changing(figure, lambda curve: inserted(curve, number(u)))


def insertion_note(curve: Curve) -> str:
    """The sentence that says how a point more changes a curve; empty where it stays."""
    if curve.spline in ("bezier", "bezier_path", *B_SPLINES):
        return ""
    return _("This curve goes through its points by a rule, so one more point on it changes it slightly.")


def inserted(curve: Curve, u: float) -> Curve:
    """``curve`` with a point more at u, its own parameter.

    A path is subdivided, so is a Bézier curve of degree 3 or less, which becomes a path; above, its degree is
    raised. A B-spline gets a knot, and its rule is "free". The curve stays the same, but not one that is led
    through its points by a rule: that gets a point where it was. Raises: ValueError.
    """
    pieces = pieces_of(curve)
    if curve.spline == "bezier" and pieces.degree > 3:
        return raised(curve)
    if curve.spline in B_SPLINES:
        return _with_knot(curve, u)
    piece, v = place_of(pieces.knots, u)
    if min(v, 1.0 - v) <= _ROUNDING:
        raise ValueError(_("There is already a point at this place; choose a place between two points."))
    if curve.spline in ("bezier", "bezier_path"):
        path = converted(curve, "bezier_path")[0]
        return _subdivided(path, piece, v)
    where = curves.piece_points(pieces, u)
    index = piece + 1 + ends_steer(curve)
    point = CurvePoint("", float(where[0]), float(where[1]))
    if curve.spline == "hermite":
        slope = 0.5 * curves.piece_points(curves.piece_derivative(pieces), u)
        point = replace(point, tangent_x=float(slope[0]), tangent_y=float(slope[1]))
    return with_points(curve, min(index, len(curve.points_world)), (point,))


def _subdivided(path: Curve, piece: int, v: float) -> Curve:
    """A path with a joint more, in its piece number ``piece``."""
    joints, waiting = joints_of(path)
    one, other = joints[piece], joints[(piece + 1) % len(joints)]
    ends = [one.at, one.after or one.at, other.before or other.at, other.at]
    first, second = curves.subdivide(np.array([place(point) for point in ends]), v)
    here = _at(first[3])
    kind = natural_joint(_at(first[2]), here, _at(second[1]))
    added = Joint(
        CurvePoint("", *_at(first[2])), CurvePoint("", *here, joint=kind), CurvePoint("", *_at(second[1]))
    )
    moved = [
        None if handle is None else replace(handle, x=_at(row)[0], y=_at(row)[1])
        for handle, row in ((one.after, first[1]), (other.before, second[2]))
    ]
    joints[piece] = one._replace(after=moved[0])
    after = (piece + 1) % len(joints)
    joints[after] = joints[after]._replace(before=moved[1])
    for number_ in {piece, after}:
        joints[number_] = sound(joints[number_])
    joints.insert(piece + 1, added)
    return refitted(replace(path, points_world=points_from(joints, path.closed, waiting)))


def _at(row: Array) -> tuple[float, float]:
    return float(row[0]), float(row[1])


def _with_knot(curve: Curve, u: float) -> Curve:
    """A B-spline with the knot u, and so with a point, more."""
    knots, degree, count = knots_of(curve), curve.degree, len(curve.points_world)
    pieces = pieces_of(curve)
    place_of(pieces.knots, u)
    opened = rows_of(curve)
    if curve.closed:
        period, turn = period_of(curve), middle_turn(curve)
        u = u if u < knots[-1] else float(knots[0])
        span = int(np.searchsorted(knots, u, side="right")) - 1
        for k in range(turns_of(curve)):
            opened = _one_more(opened, u + k * period)
        opened = one_turn(curve, opened, degree + turn * (count + 1), count + 1)
        new = min(span + 1 + degree // 2, count)
    else:
        span = min(int(np.searchsorted(knots, u, side="right")) - 1, count - 1)
        opened = _one_more(opened, u)
        new = span - degree + 1 + degree // 2
    points: list[CurvePoint | None] = [*curve.points_world[:new], None, *curve.points_world[new:]]
    old: list[Knot | None] = [*curve.knots] if curve.knots else [None] * len(knots)
    old.insert(span + 1, None)
    return with_rows(curve, opened, points, old)


def _one_more(made: Rows, u: float) -> Rows:
    rows, knots = curves.insert_knot(made.rows, made.knots, made.degree, u)
    return Rows(rows, knots, made.degree)


@checked
def split(figure: str, u: float) -> Edit:
    """Cut a curve at the parameter u, its own; the second part is a figure of its own, right in front of it.

    A closed curve is cut open there and stays one. Both parts look as the whole did: a curve led through its
    points by a rule becomes a path.
    """

    def edit(document: Document) -> Document:
        curve = curve_with(document, figure)
        try:
            first, second = parts(curve, number(u))
        except ValueError as problem:
            raise DocumentError(figure, str(problem)) from problem
        after = remembering(document, with_changed(document, [numbered(document, first)]))
        if second is None:
            return after
        sheet = figure_with(after, figure)[0]
        at = next(i for i, other in enumerate(sheet.figures) if other.id == figure) + 1
        # The ids that the first part has lost may be the second one's; none of them is given anew.
        chain = tuple(replace(link, id="") for link in second.transforms)
        new = numbered(after, replace(second, id="", transforms=chain))
        return with_figures(after, sheet, (*sheet.figures[:at], new, *sheet.figures[at:]))

    return edit


def parts(curve: Curve, u: float) -> tuple[Curve, Curve | None]:
    """The parts of a curve before and after u; of a closed one the whole, open there. Raises: ValueError."""
    pieces = pieces_of(curve)
    piece, v = place_of(pieces.knots, u)
    nothing = _ROUNDING * float(pieces.knots[-1] - pieces.knots[0])
    if not goes_round(curve) and not pieces.knots[0] + nothing < u < pieces.knots[-1] - nothing:
        raise ValueError(_("At the end of a curve there is nothing to cut off; choose a u between its ends."))
    if curve.spline == "bezier":
        if 0.0 < v < 1.0:
            return _halves(curve, v)
        end = replace(curve.points_world[0], id="")
        return refitted(replace(curve, closed=False, points_world=(*curve.points_world, end))), None
    if curve.spline in B_SPLINES:
        return _cut(curve, u)
    path = converted(curve, "bezier_path")[0]
    if min(v, 1.0 - v) > _ROUNDING:
        path = _subdivided(path, piece, v)
        piece += 1
    elif v > 0.5:
        piece += 1
    joints, waiting = joints_of(path)
    if path.closed:
        return refitted(opened_path(path, piece % len(joints))), None
    middle = joints[piece]
    first = [*joints[:piece], middle._replace(after=None)]
    second = [middle._replace(before=None, at=replace(middle.at, id="")), *joints[piece + 1 :]]
    return (
        refitted(replace(path, points_world=points_from(first, False))),
        _with_new_knots(refitted(replace(path, points_world=points_from(second, False, waiting)))),
    )


def _with_new_knots(curve: Curve) -> Curve:
    return replace(curve, knots=tuple(replace(knot, id="") for knot in curve.knots))


def _halves(curve: Curve, v: float) -> tuple[Curve, Curve]:
    """Both parts of a Bézier curve, each of its degree."""
    first, second = curves.subdivide(pieces_of(curve).controls[0], v)
    points = curve.points_world
    names: list[list[str]] = [[p.id for p in points[: len(first) // 2]], []]
    names[0] += [""] * (len(first) - len(names[0]))
    rest = [p.id for p in points[len(first) // 2 :]][-(len(second) - 1) :]
    names[1] = [""] * (len(second) - len(rest)) + rest
    halves = [
        tuple(CurvePoint(name, *_at(row)) for name, row in zip(known, rows, strict=True))
        for known, rows in zip(names, (first, second), strict=True)
    ]
    bare = replace(curve, closed=False, knot_rule="open_uniform", knots=())
    return replace(bare, points_world=halves[0]), replace(bare, points_world=halves[1])


def _cut(curve: Curve, u: float) -> tuple[Curve, Curve | None]:
    """Both parts of a B-spline, with knots enough at the cut to end there; of a closed one the whole."""
    whole = rows_of(curve)
    open_curve = replace(curve, closed=False)
    if curve.closed:
        period = period_of(curve)
        turn = middle_turn(curve)
        _before, after = curves.split_b_spline(whole.rows, whole.knots, whole.degree, u + turn * period)
        (rows, knots), _rest = curves.split_b_spline(*after, whole.degree, u + (turn + 1) * period)
        made = Rows(rows, knots, whole.degree)
        kept: list[CurvePoint | None] = [None] * len(rows)
        at = int(np.searchsorted(knots_of(curve), u, side="right")) - 1
        turned = [*curve.points_world[at:], *curve.points_world[:at]]
        kept[: len(turned)] = turned[: len(kept)]
        return with_rows(open_curve, made, kept, [None] * len(knots)), None
    halves = curves.split_b_spline(whole.rows, whole.knots, whole.degree, u)
    counts = [len(rows) for rows, _knots in halves]
    points, known = curve.points_world, curve.knots
    front = min(counts[0] - 1, len(points))
    back = min(counts[1] - 1, len(points) - front)
    names: list[list[CurvePoint | None]] = [
        [*points[:front], *[None] * (counts[0] - front)],
        [*[None] * (counts[1] - back), *points[len(points) - back :]],
    ]
    low = len([knot for knot in known if knot.u < u])
    high = len([knot for knot in known if knot.u > u])
    tags: list[list[Knot | None]] = [
        [*known[:low], *[None] * (len(halves[0][1]) - low)],
        [*[None] * (len(halves[1][1]) - high), *known[len(known) - high :]],
    ]
    one, other = (
        with_rows(open_curve, Rows(rows, knots, whole.degree), name, tag)
        for (rows, knots), name, tag in zip(halves, names, tags, strict=True)
    )
    return one, other
