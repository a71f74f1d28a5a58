"""The points that the chosen object is made over, drawn as a net in the picture, and moved there."""

from typing import NamedTuple

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainter, QPen

from workbench.algorithms.transforms import Matrix
from workbench.document.scene.model import Object, Scene
from workbench.document.scene.solids import Extrusion, Surface
from workbench.geometry.meshes import Array, Index
from workbench.panels.space.object_handles import Project
from workbench.panels.space.strokes import lines
from workbench.widgets.look.tokens import colour, tokens

_REACH_PX, _DOT_PX = 9.0, 3.5
_MOST_DRAWN = 400


class NetPoint(NamedTuple):
    """A point of an object (ids), and where it is in the world."""

    thing: str
    point: str
    place: tuple[float, float, float]


class ControlNet(NamedTuple):
    """The points of an object in the world (n, 3), and the pairs (m, 2) of them that are joined by lines."""

    thing: Object
    places: Array
    pairs: Index

    @classmethod
    def of(cls, scene: Scene, chosen: str) -> "ControlNet | None":
        """That of the chosen object; None where it has no points, or too many to be told apart."""
        thing = next((each for each in scene.objects if each.id == chosen and each.visible), None)
        if thing is None or not 0 < len(thing.points) <= _MOST_DRAWN:
            return None
        local = np.array([(point.x, point.y, point.z, 1.0) for point in thing.points])
        return cls(thing, (local @ _matrix(thing).T)[:, :3], _pairs(thing))

    def paint(self, painter: QPainter, project: Project) -> None:
        """Dashed lines, and a dot for each point."""
        now, flat = tokens(), project(self.places)
        pen = QPen(colour(now.data[4]), 1.2, Qt.PenStyle.DashLine)
        lines(painter, flat[self.pairs[:, 0]], flat[self.pairs[:, 1]], pen)
        painter.setPen(QPen(colour(now.canvas), 1))
        painter.setBrush(colour(now.data[4]))
        for x, y in flat[np.isfinite(flat).all(axis=1)].tolist():
            painter.drawEllipse(QPointF(x, y), _DOT_PX, _DOT_PX)
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def at(self, position: QPointF, project: Project) -> NetPoint | None:
        """The point within reach of a place of the widget."""
        away = np.hypot(*(project(self.places) - (position.x(), position.y())).T)
        away = np.where(np.isfinite(away), away, np.inf)
        number = int(away.argmin())
        if away[number] > _REACH_PX:
            return None
        x, y, z = self.places[number].tolist()
        return NetPoint(self.thing.id, self.thing.points[number].id, (x, y, z))


def moved_in_picture(matrix: Matrix, place: Array, x: float, y: float) -> Array:
    """Where a point (3,) of the world goes that comes to (x, y) of the view plane at the same depth.

    ``matrix`` (4, 4): from the world to the view plane, depths between 0 and 1.
    """
    before = matrix @ [*place, 1.0]
    after = np.linalg.solve(matrix, np.array([x, y, before[2] / before[3], 1.0]))
    moved: Array = after[:3] / after[3]
    return moved


def coordinates(thing: Object, place: Array) -> dict[str, float]:
    """The coordinates, in those of the object, of a place of the world: those that its points have."""
    local = np.linalg.solve(_matrix(thing), [*place, 1.0])[:3].tolist()
    names = "xyz" if isinstance(thing.solid, Surface) else "xy"
    return dict(zip(names, local, strict=False))


def _matrix(thing: Object) -> Matrix:
    return np.eye(4) if thing.matrix is None else thing.matrix


def _pairs(thing: Object) -> Index:
    count = len(thing.points)
    numbers = np.arange(count)
    if isinstance(thing.solid, Surface) and count % thing.solid.rows == 0:
        net = numbers.reshape(thing.solid.rows, -1)
        across = np.stack([net[:, :-1].ravel(), net[:, 1:].ravel()], axis=1)
        along = np.stack([net[:-1].ravel(), net[1:].ravel()], axis=1)
        return np.concatenate([across, along])
    after = np.roll(numbers, -1)
    pairs = np.stack([numbers, after], axis=1)
    return pairs if isinstance(thing.solid, Extrusion) else pairs[:-1]
