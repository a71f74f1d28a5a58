"""A scene at full size in one of the shadings, with its lights to take hold of."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QWidget

from workbench.document.scene.model import Scene
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.panels.space.control_net import moved_in_picture
from workbench.panels.space.lamps import LightMark, light_at, light_marks, light_place, paint_light
from workbench.panels.space.looking import points_of
from workbench.panels.space.scene_view import REACH_PX, SceneView
from workbench.panels.space.strokes import Labels
from workbench.widgets.look.tokens import colour, tokens


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

    def light_marks(self) -> list[LightMark]:
        """Each light, where its mark is, and whether that is where it is, or at the edge on the way there."""
        return light_marks(self, self.scene)

    def paint_over(self, painter: QPainter) -> None:
        """The lights, and the name of the shading."""
        now, labels = tokens(), Labels(painter, self)
        for mark in self.light_marks():
            paint_light(painter, labels, mark, mark[0].id == self.chosen_light)
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
