"""Curves pulled by the curve itself, and made smooth at a joint with as little moved as can be."""

import math

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import curves
from workbench.document.building import Edit, checked, number
from workbench.document.curves.changes import changing
from workbench.document.curves.paths import (
    Places,
    handles_of,
    is_path,
    joint_moves,
    joints_of,
    moved,
    place,
    with_followers,
    with_sound_joints,
)
from workbench.document.curves.pieces import (
    b_spline_of,
    ends_steer,
    goes_round,
    knots_of,
    pieces_of,
    place_of,
    points_of,
    weights_of,
)
from workbench.document.model import B_SPLINES, Curve
from workbench.language import _

Array = NDArray[np.float64]

SMOOTHNESS = ("G1", "C1", "G2", "C2")
AGREEMENT = 1e-6  # what counts as nothing at a joint, as a part of the sizes compared
_NEAR_END = 0.1
_ROUNDS = 30
_LINEAR = ("bezier", *B_SPLINES)


@checked
def drag_curve(figure: str, u: float, dx_world: float, dy_world: float) -> Edit:
    """Move the curve at its parameter u by (dx, dy), with the least change of the points around."""
    way = number(dx_world), number(dy_world)
    return changing(figure, lambda curve: moved(curve, dragged(curve, number(u), *way)))


def dragged(curve: Curve, u: float, dx: float, dy: float) -> Places:
    """Where points, by id, go so that the curve at u moves by (dx, dy). Raises: ValueError.

    Of a path the handles of the piece move, near its end the point there; of a curve led through its points
    the two beside u; of all others every point as much as it has its part in the curve at u.
    """
    pieces = pieces_of(curve)
    piece, v = place_of(pieces.knots, u)
    share = _shares(curve, u, piece, v)
    pulled = np.flatnonzero(share)
    gain = 1.0 / float((share * share).sum())
    shift = gain * np.array([dx, dy])
    target = curves.piece_points(pieces, u) + np.array([dx, dy])
    size = max(float(np.abs(target).max()), 1.0)
    places = _pulled(curve, share, pulled, shift)
    for _round in range(_ROUNDS if curve.spline not in _LINEAR else 0):
        now = pieces_of(moved(curve, places))
        missing = target - curves.piece_points(now, now.u_at(piece, v))
        if float(np.abs(missing).max()) <= 1e-12 * size:
            break
        shift = shift + gain * missing
        places = _pulled(curve, share, pulled, shift)
    return places


def _pulled(curve: Curve, share: Array, pulled: NDArray[np.int64], shift: Array) -> Places:
    """Where the points with a share of the shift go, and what follows them."""
    places = {}
    for index in pulled.tolist():
        point, part = curve.points_world[index], float(share[index])
        places[point.id] = point.x + part * float(shift[0]), point.y + part * float(shift[1])
    return with_followers(curve, places)


def _shares(curve: Curve, u: float, piece: int, v: float) -> Array:
    """How much of a movement each point (n,) takes."""
    share = np.zeros(len(curve.points_world))
    if is_path(curve):
        count = len(joints_of(curve)[0]) * 3 if curve.closed else len(share)
        if v < _NEAR_END or v > 1.0 - _NEAR_END or (curve.closed and count == 3):
            share[(3 * (piece + round(v))) % count if curve.closed else 3 * (piece + round(v))] = 1.0
        else:
            share[3 * piece + 1 : 3 * piece + 3] = curves.bernstein(3, v)[1:3]
        return share
    if curve.spline == "bezier":
        _fold(share, curves.bernstein(pieces_of(curve).degree, v), 0)
    elif curve.spline in B_SPLINES:
        _points, knots, weights = b_spline_of(curve)
        pulls = weights if curve.spline == "nurbs" else None
        span, part = curves.basis_functions(knots, curve.degree, u, pulls)
        _fold(share, part, int(span) - curve.degree)
    else:
        first = piece + ends_steer(curve)
        share[first % len(share)] += 1.0 - v
        share[(first + 1) % len(share)] += v
    return share


def _fold(share: Array, part: Array, first: int) -> None:
    np.add.at(share, (first + np.arange(len(part))) % len(share), part)


@checked
def smooth_joint(figure: str, joint: int, kind: str) -> Edit:
    """Make the joint number ``joint`` G1, C1, G2 or C2; ``smoothing_moves`` says which points move."""
    return changing(figure, lambda curve: smoothed(curve, joint, kind)[0])


def smoothed(curve: Curve, joint: int, kind: str) -> tuple[Curve, Places]:
    """``curve`` with a joint made smooth, and which points that moved where. Raises: ValueError."""
    places = smoothing_moves(curve, joint, kind)
    return with_sound_joints(moved(curve, places), places), places


def smoothing_moves(curve: Curve, joint: int, kind: str) -> Places:
    """Where points, by id, go to make a joint G1, C1, G2 or C2; none where it is so already, as measured.

    Joints are numbered as by ``curves.joints``: 0 is between the first two pieces, and of a closed curve the
    last is at its begin. Of a path only the handles at the joint move, of a B-spline the points around it as
    little as can be. Raises: ValueError for another joint or word, and for kinds whose joints follow a rule.
    """
    if kind not in SMOOTHNESS:
        raise ValueError(_("Choose one of {choices}.").format(choices=", ".join(SMOOTHNESS)))
    count = len(pieces_of(curve).controls) - (not goes_round(curve))
    if not 0 <= joint < count:
        sentence = _("There is no joint {number}; this curve has {count} of them.")
        raise ValueError(sentence.format(number=joint, count=count))
    if _is_smooth(curve, joint, kind):
        return {}
    if is_path(curve):
        return _handle_moves(curve, 3 * ((joint + 1) % len(joints_of(curve)[0])), kind)
    if curve.spline == "bezier" or (curve.spline in B_SPLINES and _even(curve)):
        return _least_moves(curve, joint, int(kind[1]))
    raise ValueError(_("The joints of this curve follow a rule; convert it to a path to change one of them."))


def _is_smooth(curve: Curve, joint: int, kind: str) -> bool:
    """Whether a joint is G1, C1, G2 or C2 by the measure of the table of joints."""
    measured = curves.joints(pieces_of(curve), goes_round(curve), AGREEMENT)
    if joint >= len(measured):  # beside a piece without length
        return False
    now = measured[joint].geometric if kind[0] == "G" else measured[joint].parametric
    return now >= kind


def _even(curve: Curve) -> bool:
    return bool(curve.spline == "b_spline" or np.ptp(weights_of(curve)) == 0)


def _handle_moves(curve: Curve, index: int, kind: str) -> Places:
    """Where the handles of the point at ``index`` of a path go.

    G1 turns them onto one line; C1 makes them each other's mirror image, by their mean; C2 lays them along
    the line between the handles beyond; G2 changes their lengths, or does as C2 where that is not enough.
    """
    before, after = handles_of(curve, index)
    points = curve.points_world
    if before is None or after is None:
        return {}
    if kind == "G1":
        return joint_moves(curve, index, "smooth")
    count = 3 * len(joints_of(curve)[0]) if curve.closed else len(points)
    if kind in ("G2", "C2") and count == 3:
        raise ValueError(_("A closed curve of one piece cannot be that smooth; insert a point on it first."))
    here, one, other = (np.array(place(points[i])) for i in (index, before, after))
    far, beyond = (np.array(place(points[i % count])) for i in (before - 1, after + 1))
    arms = {"C1": lambda: 0.5 * (other - one), "C2": lambda: 0.25 * (beyond - far)}
    if kind == "G2":
        turned = joint_moves(curve, index, "smooth")
        one, other = (np.array(turned.get(points[i].id, place(points[i]))) for i in (before, after))
        bent = _bent(here, one, other, far, beyond)
        if bent is not None:
            return _if_moved(curve, {points[before].id: bent[0], points[after].id: bent[1]})
        kind = "C2"
    arm = arms[kind]()
    return _if_moved(curve, {points[before].id: here - arm, points[after].id: here + arm})


def _bent(here: Array, one: Array, other: Array, far: Array, beyond: Array) -> tuple[Array, Array] | None:
    """Two handles on one line, so long that the curvatures agree; None where their lengths cannot do it.

    The curvature at the end of a cubic is 2/3 of the distance of the handle beyond from the tangent, by the
    square of the arm.
    """
    way = other - one
    size = float(np.hypot(*way))
    if size == 0.0:
        return None
    way = way / size
    off = [float(way[0] * (p - here)[1] - way[1] * (p - here)[0]) for p in (far, beyond)]
    if off[0] * off[1] <= 0.0:
        return None
    ratio = math.sqrt(off[1] / off[0])
    return here - way * (size / (1.0 + ratio)), here + way * (size * ratio / (1.0 + ratio))


def _if_moved(curve: Curve, wanted: dict[str, Array]) -> Places:
    """``wanted`` without the points that are there already."""
    now = {point.id: place(point) for point in curve.points_world if point.id in wanted}
    size = float(np.abs(points_of(curve)).max()) or 1.0
    return {
        name: (float(where[0]), float(where[1]))
        for name, where in wanted.items()
        if float(np.abs(where - now[name]).max()) > 1e-12 * size
    }


def _least_moves(curve: Curve, joint: int, order: int) -> Places:
    """The least movement, in squares, after which derivatives up to ``order`` agree at a joint.

    The pieces are made of the points by a matrix, and so are the jumps of their derivatives.
    """
    matrix = _matrix(curve)
    lengths = np.diff(matrix.knots)
    one, other = matrix.controls[joint], matrix.controls[(joint + 1) % len(matrix.controls)]
    ends = lengths[joint], lengths[(joint + 1) % len(lengths)]
    jumps = []
    factor = 1.0
    for k in range(1, min(order, matrix.degree) + 1):
        factor *= matrix.degree + 1 - k
        left, right = (
            np.diff(one, n=k, axis=0)[-1] / ends[0] ** k,
            np.diff(other, n=k, axis=0)[0] / ends[1] ** k,
        )
        jumps.append(factor * (right - left))
    conditions, points = np.array(jumps), points_of(curve)
    missing = -conditions @ points
    change = np.linalg.lstsq(conditions, missing, rcond=1e-10)[0]
    if order > matrix.degree or not np.allclose(
        conditions @ (points + change), 0.0, atol=1e-9 * _size(curve)
    ):
        raise ValueError(_("With this degree the joint cannot be made that smooth; raise the degree first."))
    wanted = {point.id: points[i] + change[i] for i, point in enumerate(curve.points_world)}
    return _if_moved(curve, wanted)


def _size(curve: Curve) -> float:
    return float(np.abs(points_of(curve)).max()) or 1.0


def _matrix(curve: Curve) -> curves.Pieces:
    """The pieces of a curve over unit vectors in place of its points: what each point has its part in."""
    unit = np.eye(len(curve.points_world))
    if curve.spline == "bezier":
        around = np.vstack([unit, unit[:1]]) if curve.closed else unit
        return curves.Pieces(np.array([0.0, 1.0]), around[None])
    if curve.closed:
        unit, knots = curves.closed_b_spline(unit, curve.degree, knots_of(curve))
    else:
        knots = knots_of(curve)
    return curves.b_spline_to_bezier(unit, knots, curve.degree)
