"""Paths of cubic Bézier pieces: point, handle, handle, point and so on, and how handles hang together.

Index i is that of ``points_world``; a point of the path has an index divisible by three, the handles beside
it the indices before and after. Places are (x, y), world.
"""

import math
from collections.abc import Collection, Iterable, Mapping
from typing import NamedTuple

import numpy as np
from msgspec.structs import replace

from workbench.document.model import Curve, CurvePoint
from workbench.geometry.curves.rounding import nothing_beside
from workbench.language import _

Place = tuple[float, float]
Places = dict[str, Place]

SMOOTH_ANGLE = 1e-3  # radians between the handles of a point, up to which it counts as smooth
_ROUNDING = 1e-9


def is_path(curve: Curve) -> bool:
    """Whether the points of the curve are points and handles of a path."""
    return curve.spline == "bezier_path"


def joint_of(curve: Curve, index: int) -> int | None:
    """Index of the point that the point or handle at ``index`` belongs to; None for a handle that waits."""
    if index % 3 == 0:
        return index
    at = index - 1 if index % 3 == 1 else index + 1
    count = len(curve.points_world)
    if curve.closed and at >= 3 * (count // 3):
        return 0 if index < 3 * (count // 3) else None
    return at if at < count else None


def handles_of(curve: Curve, index: int) -> tuple[int | None, int | None]:
    """Indices of the handles before and after the point at ``index``, None where there is none."""
    count = len(curve.points_world)
    whole = 3 * (count // 3) if curve.closed else count
    if curve.closed and whole:
        return (index - 1) % whole if index < whole else None, index + 1 if index + 1 < whole else None
    return index - 1 if index > 0 else None, index + 1 if index + 1 < count else None


def place(point: CurvePoint) -> Place:
    """Where a point is."""
    return point.x, point.y


def moved(curve: Curve, places: Mapping[str, Place]) -> Curve:
    """``curve`` with these points at these places, and nothing else moved."""
    if not places:
        return curve
    points = (
        replace(p, x=places[p.id][0], y=places[p.id][1]) if p.id in places else p for p in curve.points_world
    )
    return replace(curve, points_world=tuple(points))


def with_followers(curve: Curve, places: Mapping[str, Place]) -> Places:
    """``places`` of points, by id, and of what moves with them along a path.

    A point carries its handles, unless they have places of their own; a handle turns the one opposite when
    their point is smooth, and is mirrored by it when that is symmetric.
    """
    found = dict(places)
    if not is_path(curve):
        return found
    points = curve.points_world
    wanted = [index for index, point in enumerate(points) if point.id in places]
    for index in wanted:
        if index % 3 == 0:
            here = points[index]
            dx, dy = places[here.id][0] - here.x, places[here.id][1] - here.y
            for handle in handles_of(curve, index):
                if handle is not None and points[handle].id not in places:
                    found[points[handle].id] = points[handle].x + dx, points[handle].y + dy
    for index in wanted:
        owner = joint_of(curve, index) if index % 3 else None
        if owner is None:
            continue
        before, after = handles_of(curve, owner)
        opposite = before if index == after else after
        if opposite is None or points[opposite].id in places:
            continue
        centre = found.get(points[owner].id, place(points[owner]))
        now = found.get(points[opposite].id, place(points[opposite]))
        found[points[opposite].id] = _opposite(points[owner].joint, centre, places[points[index].id], now)
    return found


def _opposite(joint: str, centre: Place, handle: Place, now: Place) -> Place:
    """Where the handle opposite to ``handle`` belongs; ``now`` is where it is."""
    dx, dy = centre[0] - handle[0], centre[1] - handle[1]
    if joint == "symmetric":
        return centre[0] + dx, centre[1] + dy
    length = math.hypot(dx, dy)
    if joint != "smooth" or length == 0.0:
        return now
    stretch = math.hypot(now[0] - centre[0], now[1] - centre[1]) / length
    return centre[0] + stretch * dx, centre[1] + stretch * dy


def joint_moves(curve: Curve, index: int, joint: str) -> Places:
    """Which handles move, and where to, for the point at ``index`` of a path to become such a joint.

    Both handles turn onto the mean of their directions; those of a symmetric joint get their mean length. A
    handle that lies on the point gets a length; where both do, they lie along the leg between the neighbours.
    Beside one straight piece that piece stays as it is, and the other handle turns.
    """
    before, after = handles_of(curve, index)
    if joint == "corner" or before is None or after is None:
        return {}
    points = curve.points_world
    here = place(points[index])
    arms = [(points[h].x - here[0], points[h].y - here[1]) for h in (before, after)]
    lengths = [math.hypot(*arm) for arm in arms]
    ways = [(x / n, y / n) if n else (0.0, 0.0) for (x, y), n in zip(arms, lengths, strict=True)]
    way = ways[1][0] - ways[0][0], ways[1][1] - ways[0][1]
    count = len(points)
    neighbours = [(index + step) % count if curve.closed else index + step for step in (-3, 3)]
    ends = [place(points[n]) if 0 <= n < count else here for n in neighbours]
    straight = _straight_way(curve, index, ends) if joint == "smooth" else None
    if straight is not None:
        side, way = straight
        x, y = way
        handle, sign = (after, 1.0) if side == 0 else (before, -1.0)
        length = lengths[1 - side] or math.dist(ends[1 - side], here) / 3.0
        where = here[0] + sign * length * x, here[1] + sign * length * y
        near = math.dist(where, place(points[handle])) <= _ROUNDING * length
        return {} if near else {points[handle].id: where}
    if not any(lengths):
        way = ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]
        lengths = [math.dist(end, here) / 3.0 for end in ends]
    else:
        lengths = [n or math.dist(end, here) / 3.0 for n, end in zip(lengths, ends, strict=True)]
        if math.hypot(*way) < 1e-9:
            way = -ways[0][1], ways[0][0]
    size = math.hypot(*way)
    if size == 0.0:
        return {}
    if joint == "symmetric":
        lengths = [sum(lengths) / 2.0] * 2
    x, y = way[0] / size, way[1] / size
    places = {
        points[before].id: (here[0] - lengths[0] * x, here[1] - lengths[0] * y),
        points[after].id: (here[0] + lengths[1] * x, here[1] + lengths[1] * y),
    }
    if _fits(joint, arms, _ROUNDING):
        return {}
    now = {points[h].id: place(points[h]) for h in (before, after)}
    return {name: where for name, where in places.items() if where != now[name]}


def _straight_way(curve: Curve, index: int, ends: list[Place]) -> tuple[int, Place] | None:
    """Of the pieces before (0) and after (1) the point at ``index`` the one that is straight, if one is.

    With it the direction, of length 1, in which the path goes along it.
    """
    points, count = curve.points_world, len(curve.points_world)
    here = place(points[index])
    ways: list[Place | None] = []
    for step, end in zip((-1, 1), ends, strict=True):
        length = math.dist(here, end)
        handles = [points[(index + step * k) % count] for k in (1, 2)]
        x, y = ((end[0] - here[0]) / length, (end[1] - here[1]) / length) if length else (0.0, 0.0)
        off = max(abs((p.x - here[0]) * y - (p.y - here[1]) * x) for p in handles)
        ways.append((step * x, step * y) if length and off <= _ROUNDING * length else None)
    if (ways[0] is None) == (ways[1] is None):
        return None
    side = 0 if ways[0] is not None else 1
    way = ways[side]
    assert way is not None
    return side, way


def _fits(joint: str, arms: list[Place], within: float) -> bool:
    """Whether two arms lie in one direction, or are each other's mirror image, within an angle or share."""
    (ax, ay), (bx, by) = arms
    one, other = math.hypot(ax, ay), math.hypot(bx, by)
    if joint == "symmetric":
        return math.hypot(ax + bx, ay + by) <= within * max(one, other) and min(one, other) > 0.0
    return abs(ax * by - ay * bx) <= within * one * other and ax * bx + ay * by < 0.0


def natural_joint(before: Place, here: Place, after: Place) -> str:
    """What kind of joint a point with these handles is, within ``SMOOTH_ANGLE``: no file or hand is exact."""
    arms = [(before[0] - here[0], before[1] - here[1]), (after[0] - here[0], after[1] - here[1])]
    lengths = [math.hypot(*arm) for arm in arms]
    if min(lengths) <= 1e-12 * max(*lengths, abs(here[0]), abs(here[1])):
        return "corner"
    return next((joint for joint in ("symmetric", "smooth") if _fits(joint, arms, SMOOTH_ANGLE)), "corner")


class Joint(NamedTuple):
    """A point of a path with the handles before and after it."""

    before: CurvePoint | None
    at: CurvePoint
    after: CurvePoint | None


def joints_of(curve: Curve) -> tuple[list[Joint], tuple[CurvePoint, ...]]:
    """The joints of a path, and the points behind them that wait for more."""
    points = curve.points_world
    count = len(points)
    whole = 3 * (count // 3) if curve.closed else 3 * ((count - 1) // 3) + 1
    found = []
    for index in range(0, whole, 3):
        before, after = handles_of(curve, index)
        last = index + 1 >= whole
        found.append(
            Joint(
                None if before is None else points[before],
                points[index],
                None if after is None or last else points[after],
            )
        )
    return found, points[whole:]


def points_from(
    joints: list[Joint], closed: bool, waiting: tuple[CurvePoint, ...] = ()
) -> tuple[CurvePoint, ...]:
    """The points of the path through ``joints``; a handle that is missing lies on its point."""
    made: list[CurvePoint] = []
    for number, joint in enumerate(joints):
        if number:
            made.append(joint.before or _handle(place(joint.at)))
        made.append(joint.at)
        if closed or number < len(joints) - 1:
            made.append(joint.after or _handle(place(joint.at)))
    if closed and joints:
        made.append(joints[0].before or _handle(place(joints[0].at)))
    return (*made, *waiting)


def _handle(where: Place) -> CurvePoint:
    return CurvePoint("", *where)


def sound(joint: Joint) -> Joint:
    """``joint`` as a corner where its handles are no longer what its kind says."""
    if joint.before is None or joint.after is None or joint.at.joint == "corner":
        return joint
    kind = natural_joint(place(joint.before), place(joint.at), place(joint.after))
    if kind == "corner" or (kind, joint.at.joint) == ("smooth", "symmetric"):
        return joint._replace(at=replace(joint.at, joint=kind))
    return joint


def with_sound_joints(curve: Curve, moved: Collection[str]) -> Curve:
    """``curve`` with corners where points of a path that moved, by id, no longer hang together."""
    if not is_path(curve):
        return curve
    joints, waiting = joints_of(curve)
    joints = [sound(joint) if any(part and part.id in moved for part in joint) else joint for joint in joints]
    return replace(curve, points_world=points_from(joints, curve.closed, waiting))


def refuse_waiting(curve: Curve) -> None:
    """Raise ValueError for a path with points that wait, where they would be lost."""
    if is_path(curve) and joints_of(curve)[1]:
        raise ValueError(
            _(
                "The last points of the path do not make a whole piece yet; add what is missing, or "
                "remove them."
            )
        )


def without_points(curve: Curve, gone: frozenset[str]) -> tuple[CurvePoint, ...]:
    """The points that are left of a path: a point takes its handles with it, a handle alone is drawn in.

    The point of a handle that was drawn in is a corner.
    """
    joints, waiting = joints_of(curve)
    kept: list[Joint] = []
    for joint in joints:
        if joint.at.id in gone:
            continue
        drawn_in = {
            side: replace(handle, x=joint.at.x, y=joint.at.y)
            for side, handle in (("before", joint.before), ("after", joint.after))
            if handle is not None and handle.id in gone
        }
        if drawn_in:
            joint = joint._replace(at=replace(joint.at, joint="corner"), **drawn_in)
        kept.append(joint)
    if joints and joints[-1].at.id in gone:
        waiting = ()
    return points_from(kept, curve.closed, tuple(point for point in waiting if point.id not in gone))


def with_joints_added(curve: Curve, added: Iterable[tuple[Place, Place | None]], first: bool) -> Curve:
    """An open path that goes on by points, each with its handle or None, from its end or its ``first`` point.

    A handle is where the one beyond the new point would be: the one towards the path is its mirror image,
    and the point symmetric. Without it the point is a corner, and its handle lies on the chord.
    """
    joints, waiting = joints_of(curve)
    if first:
        whole = curve.points_world[: len(curve.points_world) - len(waiting)]
        grown = with_joints_added(replace(curve, points_world=whole[::-1]), added, False)
        return replace(grown, points_world=(*grown.points_world[::-1], *waiting))
    for where, handle in added:
        last = joints[-1]
        point = CurvePoint("", *where, joint="corner" if handle is None else "symmetric")
        leaving = waiting[0] if waiting else _handle(_way_on(last, where))
        arriving = _handle(_mirrored(handle, where) if handle is not None else _third(where, place(last.at)))
        joints[-1] = last._replace(after=leaving)
        joints.append(Joint(waiting[1] if len(waiting) > 1 else arriving, point, None))
        waiting = ()
    return replace(curve, points_world=points_from(joints, False, waiting))


def _way_on(last: Joint, where: Place) -> Place:
    """Where the path leaves its last point for another: straight on when that is no corner."""
    if last.before is not None and last.at.joint != "corner":
        return _mirrored(place(last.before), place(last.at))
    return _third(place(last.at), where)


def _third(one: Place, other: Place) -> Place:
    return one[0] + (other[0] - one[0]) / 3.0, one[1] + (other[1] - one[1]) / 3.0


def _mirrored(handle: Place, about: Place) -> Place:
    return 2.0 * about[0] - handle[0], 2.0 * about[1] - handle[1]


def closed_path(curve: Curve) -> Curve:
    """The path with its end joined to its begin: by one point where both are the same, else by a piece.

    Points that wait become handles of that piece.
    """
    joints, waiting = joints_of(curve)
    first, last = joints[0], joints[-1]
    nothing = nothing_beside(np.array([place(point) for point in curve.points_world]))
    if len(joints) > 1 and math.dist(place(first.at), place(last.at)) <= nothing:
        joints = [sound(first._replace(before=last.before)), *joints[1:-1]]
    else:
        there = place(first.at)
        before = (
            _mirrored(place(first.after), there)
            if first.after is not None and first.at.joint != "corner"
            else _third(there, place(last.at))
        )
        joints[-1] = sound(last._replace(after=waiting[0] if waiting else _handle(_way_on(last, there))))
        arriving = waiting[1] if len(waiting) > 1 else _handle(before)
        joints[0] = sound(joints[0]._replace(before=arriving))
        waiting = ()
    return replace(curve, closed=True, points_world=points_from(joints, True, waiting))


def opened_path(curve: Curve, at: int = 0) -> Curve:
    """The closed path cut open at its joint number ``at``: it looks as before, and ends where it begins."""
    joints, waiting = joints_of(curve)
    if not joints:
        return replace(curve, closed=False)
    turned = [*joints[at:], *joints[:at]]
    end = turned[0]._replace(at=replace(turned[0].at, id=""), after=None)
    return replace(curve, closed=False, points_world=points_from([*turned, end], False, waiting))
