"""What a drag on the box around something means: from where a handle was and is to a 3 x 3 matrix.

Coordinates are those of one plane, y upwards; angles in radians, counter-clockwise positive.
"""

import math
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

Point = tuple[float, float]
Matrix = NDArray[np.float64]
Kind = Literal["move", "rotate", "scale", "shear"]

SIDES: dict[str, tuple[int, int]] = {
    "bottom left": (-1, -1),
    "bottom": (0, -1),
    "bottom right": (1, -1),
    "right": (1, 0),
    "top right": (1, 1),
    "top": (0, 1),
    "top left": (-1, 1),
    "left": (-1, 0),
}
MOVE, TURN, PIVOT = "move", "turn", "pivot"

STEP = math.radians(15)
LEAST_FACTOR = 1e-3
_STEEPEST = 5


class Box(NamedTuple):
    """A rectangle about its centre, turned by ``angle``; a side may be 0."""

    x: float
    y: float
    width: float
    height: float
    angle: float = 0.0

    @property
    def centre(self) -> Point:
        """Its middle."""
        return self.x, self.y

    def place(self, across: float, up: float) -> Point:
        """The middle is (0, 0), the corners are (-1, -1) to (1, 1), in the box's own directions."""
        return _turned((across * self.width / 2, up * self.height / 2), self.angle, self.centre)

    def corners(self) -> Matrix:
        """(4, 2), counter-clockwise from the bottom left."""
        return np.array([self.place(i, j) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))], np.float64)

    def holds(self, point: Point) -> bool:
        """Whether a point is inside or on the edge."""
        across, up = _turned((point[0] - self.x, point[1] - self.y), -self.angle)
        return abs(across) <= self.width / 2 and abs(up) <= self.height / 2


class Keys(NamedTuple):
    """What is held down: ``constrained`` keeps to steps of 15 degrees, to the ratio of the sides, or to one
    axis; ``about_pivot`` scales and shears about the pivot, not the opposite side; ``shearing`` makes the
    sides shear.
    """

    constrained: bool = False
    about_pivot: bool = False
    shearing: bool = False


class Motion(NamedTuple):
    """What a drag makes of the plane: a homogeneous ``matrix`` for points as columns, and how it is told.

    ``numbers`` by kind: "move" dx, dy; "rotate" angle, x, y; "scale" sx, sy, x, y; "shear" factor, angle, x,
    y. (x, y) stays where it is; scale and shear act in directions turned by ``axis``, and shear along the
    first of them where ``across`` is 1, along the second where it is 0. A negative factor mirrors.
    """

    kind: Kind
    matrix: Matrix
    numbers: dict[str, float]


def motion(box: Box, pivot: Point, handle: str, start: Point, now: Point, keys: Keys = Keys()) -> Motion:  # noqa: B008
    """What dragging ``handle`` of ``box`` from ``start`` to ``now`` does: MOVE, TURN or a name of SIDES.

    The matrix is never singular: a factor stays LEAST_FACTOR away from 0. Raises KeyError for another handle.
    """
    if handle == MOVE:
        return _move(start, now, keys)
    if handle == TURN:
        return _rotate(pivot, start, now, keys)
    across, up = SIDES[handle]
    fixed = pivot if keys.about_pivot else box.place(-across, -up)
    grip = box.place(across, up)
    arm = _turned((grip[0] - fixed[0], grip[1] - fixed[1]), -box.angle)
    way = _turned((now[0] - start[0], now[1] - start[1]), -box.angle)
    if keys.shearing and 0 in (across, up):
        return _shear(box, fixed, arm, way, bool(up), keys)
    return _scale(box, fixed, arm, way, (across, up), keys)


def _move(start: Point, now: Point, keys: Keys) -> Motion:
    dx, dy = now[0] - start[0], now[1] - start[1]
    if keys.constrained:
        dx, dy = (dx, 0.0) if abs(dx) >= abs(dy) else (0.0, dy)
    return Motion("move", np.array([[1, 0, dx], [0, 1, dy], [0, 0, 1]], np.float64), {"dx": dx, "dy": dy})


def _rotate(pivot: Point, start: Point, now: Point, keys: Keys) -> Motion:
    before, after = ((p[0] - pivot[0], p[1] - pivot[1]) for p in (start, now))
    angle = 0.0
    if any(before) and any(after):
        angle = math.remainder(math.atan2(after[1], after[0]) - math.atan2(before[1], before[0]), math.tau)
    if keys.constrained:
        angle = STEP * round(angle / STEP)
    return turned_about(pivot, angle)


def turned_about(pivot: Point, angle: float) -> Motion:
    """A turn about a point."""
    cos, sin = math.cos(angle), math.sin(angle)
    matrix = _about(pivot, np.array([[cos, -sin], [sin, cos]], np.float64))
    return Motion("rotate", matrix, {"angle": angle, "x": pivot[0], "y": pivot[1]})


def _scale(box: Box, fixed: Point, arm: Point, way: Point, side: tuple[int, int], keys: Keys) -> Motion:
    if keys.constrained:
        # As far as the pointer went along the line from the fixed point through the handle
        length = arm[0] ** 2 + arm[1] ** 2
        sx = sy = _factor(1 + (way[0] * arm[0] + way[1] * arm[1]) / length) if length else 1.0
    else:
        sx, sy = (
            _factor(1 + moved / reach) if chosen and reach else 1.0
            for chosen, moved, reach in zip(side, way, arm, strict=True)
        )
    numbers = {"sx": sx, "sy": sy, "x": fixed[0], "y": fixed[1], "axis": box.angle}
    return Motion("scale", _along(box.angle, fixed, np.diag([sx, sy])), numbers)


def _factor(value: float) -> float:
    """``value``, kept away from 0, where everything would fall together, and finite."""
    if not math.isfinite(value):
        return 1.0
    return value if abs(value) >= LEAST_FACTOR else math.copysign(LEAST_FACTOR, value)


def _shear(box: Box, fixed: Point, arm: Point, way: Point, across: bool, keys: Keys) -> Motion:
    moved, reach = (way[0], arm[1]) if across else (way[1], arm[0])
    factor = moved / reach if reach else 0.0
    if not math.isfinite(factor):
        factor = 0.0
    if keys.constrained:
        steps = round(math.atan(factor) / STEP)
        factor = math.tan(STEP * max(-_STEEPEST, min(_STEEPEST, steps)))
    linear = np.array([[1, factor], [0, 1]] if across else [[1, 0], [factor, 1]], np.float64)
    numbers = {
        "factor": factor,
        "angle": math.atan(factor),
        "x": fixed[0],
        "y": fixed[1],
        "axis": box.angle,
        "across": float(across),
    }
    return Motion("shear", _along(box.angle, fixed, linear), numbers)


def _along(angle: float, fixed: Point, linear: Matrix) -> Matrix:
    """``linear`` in directions turned by ``angle``, about a point."""
    cos, sin = math.cos(angle), math.sin(angle)
    turn = np.array([[cos, -sin], [sin, cos]], np.float64)
    return _about(fixed, turn @ linear @ turn.T)


def _about(fixed: Point, linear: Matrix) -> Matrix:
    """The map with this linear part, (2, 2), that leaves a point where it is."""
    matrix = np.eye(3)
    matrix[:2, :2] = linear
    matrix[:2, 2] = np.asarray(fixed) - linear @ np.asarray(fixed)
    return matrix


def _turned(point: Point, angle: float, origin: Point = (0.0, 0.0)) -> Point:
    cos, sin = math.cos(angle), math.sin(angle)
    return origin[0] + cos * point[0] - sin * point[1], origin[1] + sin * point[0] + cos * point[1]
