"""The lights of a scene in its views: where each is shown, how it is drawn, and where a drag puts it."""

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainter, QPen

from workbench.document.scene.model import Light, Point3D, Scene
from workbench.geometry.meshes import Array
from workbench.panels.space.looking import points_of
from workbench.panels.space.scene_view import SceneView
from workbench.panels.space.strokes import Labels
from workbench.widgets.look.tokens import colour, tokens

_DISC_PX, _RAY_PX, _EDGE_PX = 5.0, 10.0, 34.0
_AWAY = 1.6
"""A distant light stands on its direction, so many times as far out as the scene reaches."""

LightMark = tuple[Light, QPointF, bool]
"""A light, where its mark is, and whether that is where it is, or at the edge on the way there."""


def light_place(light: Light, scene: Scene) -> Array:
    """Where (3,) a light is shown: at its place, or on its way from far."""
    position = np.array(light.position.xyz)
    if not light.distant:
        return position
    middle, reach = _around(scene)
    size = float(np.linalg.norm(position))
    return middle + _AWAY * reach * position / size if size else middle


def light_at(light: Light, scene: Scene, place: Array) -> Point3D:
    """The position that has a light shown at ``place``; a direction keeps its length."""
    if light.distant:
        middle, _reach = _around(scene)
        way = place - middle
        size = float(np.linalg.norm(way))
        place = way / size * float(np.linalg.norm(light.position.xyz)) if size else way
    return Point3D(*np.round(place, 3).tolist())


def _around(scene: Scene) -> tuple[Array, float]:
    """The middle of what is visible, and how far it reaches."""
    points = points_of(scene)
    if not len(points):
        return np.zeros(3), 1.0
    low, high = points.min(axis=0), points.max(axis=0)
    return (low + high) / 2, max(float(np.linalg.norm(high - low)) / 2, 1e-6)


def light_marks(view: SceneView, scene: Scene) -> list[LightMark]:
    """The marks of the lights of a scene in a view."""
    if not scene.lights:
        return []
    places = view.projected(np.array([light_place(light, scene) for light in scene.lights]))
    marks = []
    for light, (x, y) in zip(scene.lights, places.tolist(), strict=True):
        if np.isfinite([x, y]).all():
            at_x = min(max(x, _EDGE_PX), view.width() - _EDGE_PX)
            at_y = min(max(y, _EDGE_PX), view.height() - _EDGE_PX)
            marks.append((light, QPointF(at_x, at_y), (at_x, at_y) == (x, y)))
    return marks


def paint_light(painter: QPainter, labels: Labels, mark: LightMark, chosen: bool = False) -> None:
    """A disc of the light's colour with rays, dotted where it stands at the edge, and its name."""
    light, at, inside = mark
    now = tokens()
    ink = colour(now.accent if chosen else now.text)
    for pen in (
        QPen(colour(now.canvas), 5),
        QPen(ink, 2, Qt.PenStyle.SolidLine if inside else Qt.PenStyle.DotLine),
    ):
        painter.setPen(pen)
        for k in range(8):
            way = QPointF(np.cos(k * np.pi / 4), np.sin(k * np.pi / 4))
            painter.drawLine(at + way * (_DISC_PX + 2), at + way * _RAY_PX)
    painter.setPen(QPen(colour(now.text), 1.5))
    painter.setBrush(colour(f"#{light.colour:06x}"))
    painter.drawEllipse(at, _DISC_PX, _DISC_PX)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    labels.put(np.array([at.x(), at.y()]), light.name or light.id, ink.name())
