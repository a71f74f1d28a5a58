"""Curves as curves of another kind: the same curve, or one near it, with the error stated in world units."""

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces
from workbench.document.building import Edit, checked, number
from workbench.document.curves.changes import changing
from workbench.document.curves.paths import Joint, natural_joint, points_from, refuse_waiting
from workbench.document.curves.pieces import goes_round, pieces_of, points_of, weights_of
from workbench.document.model import B_SPLINES, KNOT_RULES, Curve, CurvePoint, Knot
from workbench.geometry.curves.rounding import nothing_beside
from workbench.language import _

Array = NDArray[np.float64]

CONVERSIONS = ("bezier_path", "bezier", *B_SPLINES, "hermite")
TOLERANCE_WORLD = 0.01


@checked
def convert(figure: str, spline: str, tolerance_world: float = TOLERANCE_WORLD) -> Edit:
    """Make a curve one of another kind that looks the same; ``converted`` tells by how much it is off."""
    return changing(figure, lambda curve: converted(curve, spline, number(tolerance_world))[0])


def converted(curve: Curve, spline: str, tolerance_world: float = TOLERANCE_WORLD) -> tuple[Curve, float]:
    """``curve`` as one of the kind ``spline``, and how far at most it is off; 0 but for rounding if exact.

    Points that are still there keep their ids. Raises: ValueError where there is no curve, no such
    kind, or a path has points that are no whole piece yet.
    """
    if spline == curve.spline:
        return curve, 0.0
    refuse_waiting(curve)
    if spline == "bezier_path":
        return _as_path(curve, tolerance_world)
    if spline == "bezier":
        return _as_bezier(curve), 0.0
    if spline in B_SPLINES:
        return _as_b_spline(curve, spline, tolerance_world)
    if spline == "hermite":
        return _as_hermite(curve, tolerance_world)
    sentence = _("A curve cannot be turned into this kind; change its kind, which keeps the points instead.")
    raise ValueError(sentence)


def path_through(curve: Curve, pieces: Pieces) -> Curve:
    """The path over cubic ``pieces``: points where ``curve`` has one keep its id, in their order."""
    controls = pieces.controls
    nothing = nothing_beside(controls)
    ends = np.vstack([controls[:, 0], controls[-1:, -1]])
    is_closed = goes_round(curve) and float(np.abs(ends[0] - ends[-1]).max()) <= nothing
    if is_closed:
        ends = ends[:-1]
    known = iter(_ids_at(curve, ends, nothing))
    joints = []
    for number_, end in enumerate(ends):
        before = controls[number_ - 1, 2] if number_ or is_closed else None
        after = controls[number_, 1] if number_ < len(controls) else None
        joint = "corner"
        if before is not None and after is not None:
            joint = natural_joint(_pair(before), _pair(end), _pair(after))
        at = CurvePoint(next(known), *_pair(end), joint=joint)
        joints.append(
            Joint(
                None if before is None else CurvePoint("", *_pair(before)),
                at,
                None if after is None else CurvePoint("", *_pair(after)),
            )
        )
    return replace(
        curve,
        points_world=points_from(joints, is_closed),
        spline="bezier_path",
        closed=is_closed,
        knot_rule=KNOT_RULES[0],
        knots=(),
    )


def _pair(row: Array) -> tuple[float, float]:
    return float(row[0]), float(row[1])


def _ids_at(curve: Curve, ends: Array, nothing: float) -> list[str]:
    """For each place the id of the point that lies there, of points in their order; empty where none does."""
    if not curve.points_world:
        return [""] * len(ends)
    found, start = [], 0
    points = points_of(curve)
    for end in ends:
        near = np.flatnonzero(np.abs(points[start:] - end).max(axis=1) <= nothing)
        found.append(curve.points_world[start + int(near[0])].id if len(near) else "")
        start += int(near[0]) + 1 if len(near) else 0
    return found


def _as_path(curve: Curve, tolerance: float) -> tuple[Curve, float]:
    pieces, error = curves.to_cubic_pieces(pieces_of(curve), tolerance)
    return path_through(curve, pieces), error


def _as_bezier(curve: Curve) -> Curve:
    pieces = pieces_of(curve)
    if len(pieces.controls) > 1 or (pieces.weights is not None and np.ptp(pieces.weights) > 0):
        raise ValueError(_("The curve has several pieces or weights; turn it into a path of pieces instead."))
    ids = _ids_at(curve, pieces.controls[0], 0.0)
    points = (CurvePoint(name, *_pair(row)) for name, row in zip(ids, pieces.controls[0], strict=True))
    return replace(
        curve,
        points_world=tuple(points),
        spline="bezier",
        closed=False,
        knot_rule=KNOT_RULES[0],
        knots=(),
    )


def _as_b_spline(curve: Curve, spline: str, tolerance: float) -> tuple[Curve, float]:
    """A B-spline with every knot between pieces as often as its degree; what goes round stays closed."""
    if curve.spline in B_SPLINES and np.ptp(weights_of(curve)) == 0:
        return replace(curve, spline=spline), 0.0
    if curve.spline == "b_spline":
        even = (replace(p, weight=1.0) for p in curve.points_world)
        return replace(curve, spline=spline, points_world=tuple(even)), 0.0
    pieces, error = pieces_of(curve), 0.0
    if pieces.weights is not None or pieces.degree > 7:
        pieces, error = curves.to_cubic_pieces(pieces, tolerance)
    degree = pieces.degree
    rows = pieces.controls[:, :-1].reshape(-1, 2)
    values = np.repeat(pieces.knots, degree)
    around = goes_round(curve) and len(rows) >= 3
    if around:
        values = values[degree - 1 :]
    else:
        rows = np.vstack([rows, pieces.controls[-1, -1:]])
        values = np.concatenate([values[:1], values, values[-1:]])
    ids = _ids_at(curve, rows, 0.0)
    path = replace(
        curve,
        points_world=tuple(CurvePoint(name, *_pair(row)) for name, row in zip(ids, rows, strict=True)),
        spline=spline,
        degree=degree,
        closed=around,
        knot_rule="free",
        knots=tuple(Knot("", float(u)) for u in values),
    )
    return path, error


def _as_hermite(curve: Curve, tolerance: float) -> tuple[Curve, float]:
    """Hermite's curve through the joints; where the derivatives differ there, it has their mean."""
    path, error = _as_path(curve, tolerance)
    controls = pieces_of(path).controls
    leaving, arriving = 3.0 * (controls[:, 1] - controls[:, 0]), 3.0 * (controls[:, 3] - controls[:, 2])
    count = len(controls)
    after = leaving if path.closed else np.vstack([leaving, arriving[-1:]])
    before = np.roll(arriving, 1, axis=0) if path.closed else np.vstack([leaving[:1], arriving])
    tangents = 0.5 * (after + before)
    points = tuple(
        replace(p, tangent_x=float(t[0]), tangent_y=float(t[1]), joint="corner")
        for p, t in zip(path.points_world[::3], tangents, strict=True)
    )
    made = replace(path, points_world=points, spline="hermite")
    off = np.abs(pieces_of(made).controls - controls).reshape(count, -1, 2)
    return made, error + float(np.hypot(off[..., 0], off[..., 1]).max())
