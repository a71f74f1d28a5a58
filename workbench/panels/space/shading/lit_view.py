"""A scene at full size in one of the shadings, with its lights to take hold of."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QPainter, QPen
from PySide6.QtWidgets import QWidget

from workbench.document.scene.model import Light, Point3D, Scene
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.panels.space.control_net import moved_in_picture
from workbench.panels.space.looking import points_of
from workbench.panels.space.scene_view import REACH_PX, SceneView
from workbench.panels.space.strokes import Labels
from workbench.widgets.look.tokens import colour, tokens

_DISC_PX, _RAY_PX, _EDGE_PX = 5.0, 10.0, 34.0
_AWAY = 1.6
"""A distant light stands on its direction, so many times as far out as the scene reaches."""


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


class LitView(SceneView):
    """``light_moved`` sends the id of a light and its new position; ``light_left`` follows the drag."""

    light_moved = Signal(str, object)
    light_left = Signal()

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.title = title
        self.chosen_light = ""
        self.shows = "faces"
        self.setAccessibleName(title)

    def set_title(self, title: str) -> None:
        """What stands in its corner."""
        self.title = title
        self.setAccessibleName(title)
        self.update()

    def show_scene(self, scene: Scene, chosen: str = "") -> None:
        """Show a scene; until the picture of other objects has come, their edges."""
        if scene.objects != self.scene.objects:
            self._came = None
        super().show_scene(scene, chosen)

    @property
    def matrix(self) -> Array:
        """From the world to the view plane (4, 4)."""
        return projection_matrix(self.scene.camera) @ view_matrix(self.scene.camera)

    def extent(self) -> Array:
        """What of the scene is before the camera."""
        points = points_of(self.scene)
        placed = points @ self.matrix[:, :3].T + self.matrix[:, 3]
        before = (placed[:, 3] > 1e-9) & (placed[:, 2] >= 0) & (placed[:, 2] <= placed[:, 3])
        flat: Array = placed[before, :2] / placed[before, 3:]
        return flat

    def light_marks(self) -> list[tuple[Light, QPointF, bool]]:
        """Each light, where its mark is, and whether that is where it is, or at the edge on the way there."""
        if not self.scene.lights:
            return []
        places = self.projected(np.array([light_place(light, self.scene) for light in self.scene.lights]))
        marks = []
        for light, (x, y) in zip(self.scene.lights, places.tolist(), strict=True):
            if np.isfinite([x, y]).all():
                at_x = min(max(x, _EDGE_PX), self.width() - _EDGE_PX)
                at_y = min(max(y, _EDGE_PX), self.height() - _EDGE_PX)
                marks.append((light, QPointF(at_x, at_y), (at_x, at_y) == (x, y)))
        return marks

    def paint_over(self, painter: QPainter) -> None:
        """The lights, and the name of the shading."""
        now, labels = tokens(), Labels(painter, self)
        for light, at, inside in self.light_marks():
            ink = colour(now.accent if light.id == self.chosen_light else now.text)
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
        metrics = painter.fontMetrics()
        low = self.height() - metrics.height() - 14
        box = QRectF(8, low, metrics.horizontalAdvance(self.title) + 16, metrics.height() + 8)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour(now.surface))
        painter.drawRoundedRect(box, 6, 6)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(colour(now.text))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self.title)

    # The hand

    def grip_at(self, position: QPointF) -> object | None:
        """The id of the light within reach."""
        for light, at, _inside in self.light_marks():
            if (at - position).manhattanLength() <= REACH_PX:
                return light.id
        return None

    def drag_grip(self, grip: object, position: QPointF, _modifiers: Qt.KeyboardModifier) -> None:
        """Move the light beside and above, as deep in the picture as it was."""
        light = next((each for each in self.scene.lights if each.id == grip), None)
        if light is None:
            return
        x, y = self.on_plane(position)
        try:
            place = moved_in_picture(self.matrix, light_place(light, self.scene), x, y)
        except np.linalg.LinAlgError:
            self.failed.emit(
                _("In this projection a light cannot be dragged, since it has no depth; type its numbers.")
            )
            return
        self.light_moved.emit(light.id, light_at(light, self.scene, place))

    def release_grip(self, _grip: object) -> None:
        """It stays where it was dragged to."""
        self.light_left.emit()
