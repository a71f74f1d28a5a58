"""The handles of the chosen object: it is moved along an axis, turned about one, or scaled along one.

A drag writes into the last link of the object's chain where that does the same, else it adds a link, which
acts last, in the world.
"""

import math
from collections.abc import Callable
from typing import Literal, NamedTuple

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import QPointF
from PySide6.QtGui import QPainter, QPen

from workbench.document.scene.links import AnyLink3D, Rotate3D, Scale3D, Translate3D
from workbench.document.scene.model import Object, Scene
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.panels.space.strokes import lines
from workbench.rendering.scene.render import placed
from workbench.widgets.look.tokens import colour, tokens

Mode = Literal["", "move", "turn", "scale"]
MODES: tuple[Mode, ...] = ("", "move", "turn", "scale")
INKS = (1, 3, 2)
"""Which data colour stands for the world's x, y and z."""

_REACH_PX = 10.0
_BEYOND, _RING = 1.3, 48
_SAME_PLACE = 1e-6
_LEAST_FACTOR, _LEAST_PX = 1e-3, 1.0
Project = Callable[[Array], Array]


class Handle(NamedTuple):
    """What is held: the mode, and the number of the axis of the world."""

    mode: Mode
    axis: int


class Handles(NamedTuple):
    """Those of an object (id) about its ``centre`` (3,), as far out as ``reach``, world."""

    thing: str
    centre: Array
    reach: float
    mode: Mode

    @classmethod
    def of(cls, scene: Scene, chosen: str, mode: Mode) -> "Handles | None":
        """Those of the chosen object; None where none is chosen, or it is hidden."""
        visible = [thing.id for thing in scene.objects if thing.visible]
        if not mode or chosen not in visible:
            return None
        vertices = placed(scene)[visible.index(chosen)][0].vertices
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        reach = max(math.dist(low, high) / 2, 1e-6) * _BEYOND
        return cls(chosen, (low + high) / 2, reach, mode)

    def line(self, axis: int) -> Array:
        """What stands for an axis, (n, 3): from the centre outwards, or a ring about it."""
        if self.mode != "turn":
            return self.centre + np.outer((0.0, self.reach), np.eye(3)[axis])
        angles = np.linspace(0.0, math.tau, _RING + 1)
        ring = np.zeros((len(angles), 3))
        ring[:, (axis + 1) % 3], ring[:, (axis + 2) % 3] = np.cos(angles), np.sin(angles)
        return self.centre + self.reach * ring

    def at(self, position: QPointF, project: Project) -> Handle | None:
        """The handle within reach of a place of the widget: an end, or a ring."""
        best, nearest = None, _REACH_PX
        for axis in range(3):
            points = project(self.line(axis))
            points = points if self.mode == "turn" else points[-1:]
            away = np.hypot(*(points - (position.x(), position.y())).T)
            away = away[np.isfinite(away)]
            if len(away) and away.min() < nearest:
                best, nearest = Handle(self.mode, axis), float(away.min())
        return best

    def paint(self, painter: QPainter, project: Project) -> None:
        """Arrows, rings, or lines with a square at the end."""
        now = tokens()
        for axis in range(3):
            points = project(self.line(axis))
            ink = colour(now.data[INKS[axis]])
            lines(painter, points[:-1], points[1:], QPen(ink, 2.2))
            if self.mode == "turn" or not np.isfinite(points).all():
                continue
            painter.setPen(QPen(colour(now.canvas), 1))
            painter.setBrush(ink)
            end = QPointF(*points[-1].tolist())
            if self.mode == "move":
                painter.drawEllipse(end, 5.5, 5.5)
            else:
                painter.drawRect(round(end.x()) - 5, round(end.y()) - 5, 10, 10)

    def dragged(
        self, handle: Handle, begin: QPointF, end: QPointF, project: Project, towards: float
    ) -> float:
        """By how much a drag moves (world), turns (degrees) or scales (a factor).

        ``towards``: how far the axis points to the viewer; below 0 away from them.
        """
        middle = project(self.centre[None])[0]
        start, stop = (np.array([place.x(), place.y()]) for place in (begin, end))
        if handle.mode == "turn":
            angles = [math.atan2(-(y - middle[1]), x - middle[0]) for x, y in (start, stop)]
            turn = math.degrees(math.remainder(angles[1] - angles[0], math.tau))
            return turn if towards >= 0 else -turn
        tip = project(self.line(handle.axis))[-1]
        along = tip - middle
        length = float(along @ along)
        if length < _LEAST_PX:  # the axis is seen end on
            return 1.0 if handle.mode == "scale" else 0.0
        if handle.mode == "move":
            return float((stop - start) @ along) / length * self.reach
        held = float((start - middle) @ along)
        return max(float((stop - middle) @ along) / held, _LEAST_FACTOR) if abs(held) > _LEAST_PX else 1.0


def title_of_mode(mode: Mode) -> str:
    """What is done in a mode, as undo names it."""
    return {"move": _("Move"), "turn": _("Turn"), "scale": _("Scale")}.get(mode, "")


def with_drag(thing: Object, handle: Handle, amount: float, centre: Array, every: bool) -> Object:
    """An object as it was when a drag began, moved, turned or scaled; ``every``: scaled along all axes."""
    chain = thing.transforms
    last = chain[-1] if chain else None
    link = _grown(last, handle, amount, centre, every) if last is not None else None
    if link is not None:
        return replace(thing, transforms=(*chain[:-1], link))
    return replace(thing, transforms=(*chain, _new(handle, amount, centre, every)))


def _new(handle: Handle, amount: float, centre: Array, every: bool) -> AnyLink3D:
    name = "xyz"[handle.axis]
    if handle.mode == "move":
        return replace(Translate3D(""), **{f"t{name}": amount})
    pivot = dict(zip(("x_pivot", "y_pivot", "z_pivot"), map(float, centre), strict=True))
    if handle.mode == "turn":
        axis = {f"{each}_axis": float(each == name) for each in "xyz"}
        return replace(Rotate3D("", angle=amount), **axis, **pivot)
    return replace(Scale3D(""), **{f"s{each}": amount for each in ("xyz" if every else name)}, **pivot)


def _grown(last: AnyLink3D, handle: Handle, amount: float, centre: Array, every: bool) -> AnyLink3D | None:
    """The last link with more of the same; None where it is of another kind, axis or pivot."""
    name = "xyz"[handle.axis]
    if handle.mode == "move" and isinstance(last, Translate3D):
        return replace(last, **{f"t{name}": getattr(last, f"t{name}") + amount})
    if not isinstance(last, Rotate3D | Scale3D) or math.dist(last.pivot, centre) > _SAME_PLACE:
        return None
    if handle.mode == "turn" and isinstance(last, Rotate3D):
        same = (last.x_axis, last.y_axis, last.z_axis) == tuple(np.eye(3)[handle.axis].tolist())
        return replace(last, angle=last.angle + amount) if same else None
    if handle.mode == "scale" and isinstance(last, Scale3D):
        names = [f"s{each}" for each in ("xyz" if every else name)]
        return replace(last, **{each: getattr(last, each) * amount for each in names})
    return None
