"""What is between two keys other than each number by itself: an outline, a turn in space, a colour."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from workbench.algorithms.animation.easings import eased
from workbench.algorithms.animation.morph import morph
from workbench.algorithms.animation.slerp import NEARLY_EQUAL, shares
from workbench.document.model import Sheet, WorldPoint
from workbench.document.motion.groups import Group, Path, packed, read, written
from workbench.document.motion.model import EASINGS, EULER, SPLINE, Key
from workbench.geometry.euler import euler_angles, euler_between, euler_quaternion
from workbench.geometry.quaternions import Quaternion, quaternion_about


def with_between(sheet: Sheet, group: Group, first: Key, second: Key, part: float) -> Sheet:
    """The sheet with a group that is this part of the way from one key to the next."""
    path = group.slots[0].path
    if group.kind == "outline":
        return _morphed(sheet, path[:2], first, second, min(max(part, 0.0), 1.0))
    if group.kind == "turn":
        names = [str(slot.path[-1]) for slot in group.slots]
        turn = dict(zip(names, turned(first, second, part), strict=True))
        return _with(sheet, path[:-1], replace(read(sheet, path[:-1]), **turn))
    red, green, blue = (a + part * (b - a) for a, b in zip(first.value, second.value, strict=True))
    return _coloured(sheet, path, packed(red, green, blue))


def _with(sheet: Sheet, path: Path, value: Any) -> Sheet:
    changed = written(sheet, path, value)
    assert isinstance(changed, Sheet)
    return changed


def corners(key: Key) -> NDArray[np.float64]:
    """The vertices (n, 2) of an outline in a key."""
    return np.array(key.value, np.float64).reshape(-1, 2)


def _morphed(sheet: Sheet, path: Path, first: Key, second: Key, part: float) -> Sheet:
    """The outline between two others, by the course's rule; points beyond the figure's own get ids of now."""
    figure = read(sheet, path)
    outline = corners(first).tolist()
    if part > 0.0:
        closed = getattr(figure, "closed", True)
        outline = list(morph(corners(first), corners(second), closed, first.shift, part))
    names = [point.id for point in figure.points_world]
    names += [f"{figure.id}-{number}-" for number in range(len(names), len(outline))]
    points = tuple(WorldPoint(name, x, y) for name, (x, y) in zip(names, outline, strict=False))
    return _with(sheet, path, replace(figure, points_world=points))


def part_of_the_way(first: Key, second: Key, frame: float) -> float:
    """How far it has come from one key to the next in a frame between them, eased; of a spline the time."""
    t = (frame - first.frame) / (second.frame - first.frame)
    return t if first.easing == SPLINE else eased(EASINGS.index(first.easing), *first.handles, t)


def turned(first: Key, second: Key, part: float) -> tuple[float, ...]:
    """The turn (angle in degrees, axis) that is a part of the way between two: on the shorter arc, evenly, or
    each of Euler's angles by itself."""
    if part == 0.0:
        return first.value
    p, q = quaternion_of(first.value), quaternion_of(second.value)
    if first.turning == EULER:
        between = euler_quaternion(euler_between(euler_angles(p), euler_angles(q), part))
    else:
        between = slerped(p, q, part)
    w, *axis = between
    sine = math.sqrt(sum(x * x for x in axis))
    if sine <= NEARLY_EQUAL:
        return 0.0, *first.value[1:]
    return 2.0 * math.degrees(math.atan2(sine, w)), *(x / sine for x in axis)


def slerped(p: Quaternion, q: Quaternion, part: float) -> Quaternion:
    """The orientation that is a part of the way between two, evenly, on the shorter arc."""
    cosine = sum(a * b for a, b in zip(p, q, strict=True))
    omega = math.acos(min(abs(cosine), 1.0))
    a, b = shares(omega if omega > NEARLY_EQUAL else 0.0, part)
    b = b if cosine >= 0.0 else -b
    w, x, y, z = (a * here + b * there for here, there in zip(p, q, strict=True))
    return w, x, y, z


def quaternion_of(turn: Sequence[float]) -> Quaternion:
    """That of a turn: its angle in degrees and its axis, of any length."""
    angle, *axis = turn
    length = math.sqrt(sum(x * x for x in axis)) or 1.0
    x, y, z = (part / length for part in axis)
    return quaternion_about(math.radians(angle), (x, y, z))


def _coloured(sheet: Sheet, path: Path, colour: int) -> Sheet:
    """The sheet with a colour of its own for the figure whose colour stands at ``path``."""
    palette = sheet.palette if colour in sheet.palette else (*sheet.palette, colour)
    return _with(replace(sheet, palette=palette), path, palette.index(colour))
