"""What the eye sees: the picture on the view plane, with horizon and vanishing points to take hold of."""

import math

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from workbench.algorithms.projection import vanishing_points
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.panels.space.control_net import ControlNet, NetPoint, moved_in_picture
from workbench.panels.space.looking import points_of
from workbench.panels.space.object_handles import INKS, Handle, Handles, Mode
from workbench.panels.space.scene_view import REACH_PX, SceneView
from workbench.panels.space.stepped import DIVIDED, Vertex, way_text
from workbench.panels.space.strokes import Labels, lines, short
from workbench.rendering.scene.render import placed
from workbench.widgets.look.tokens import colour, tokens

AXES = "xyz"
_VERTEX_PX = 8.0
_FARTHEST_VANISHING = 3.2  # times as wide as the scene, and its vanishing points are in the picture too


def horizon(matrix: Array) -> tuple[float, float, float] | None:
    """The line ax + by + c = 0, a² + b² = 1, of the view plane where the planes of equal height run together.

    ``matrix``: (4, 4), from the world. None: the line is at infinity, or the directions x and z look alike.
    """
    (x0, x1), (y0, y1), (w0, w1) = matrix[[0, 1, 3]][:, [0, 2]].tolist()
    a, b, c = y0 * w1 - w0 * y1, w0 * x1 - x0 * w1, x0 * y1 - y0 * x1  # their cross product
    length = math.hypot(a, b)
    if not length > 1e-12 * abs(c):
        return None
    return a / length, b / length, c / length


class EyeView(SceneView):
    """``vanishing_moved`` sends axis, place on the view plane, and whether the other ones are pinned;
    ``handle_moved`` the handles as they were when the drag began, the one held, by how much, and whether
    along all axes; ``point_moved`` a NetPoint and where to (3,), world; ``handle_left`` follows either.
    """

    vanishing_moved = Signal(int, float, float, bool)
    handle_moved = Signal(object, object, float, bool)
    handle_left = Signal()
    point_moved = Signal(object, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.vertex: Vertex | None = None
        self.mode: Mode = ""
        self._begun: Handles | None = None
        self.setAccessibleName(_("Picture"))
        self.setToolTip("")

    @property
    def matrix(self) -> Array:
        """From the world to the view plane (4, 4), as it is now. Raises: ValueError."""
        return projection_matrix(self.scene.camera) @ view_matrix(self.scene.camera)

    def extent(self) -> Array:
        """What of the scene is before the camera."""
        points = points_of(self.scene)
        try:
            placed_points = points @ self.matrix[:, :3].T + self.matrix[:, 3]
        except ValueError:
            return np.zeros((0, 2))
        w, z = placed_points[:, 3], placed_points[:, 2]
        before = (w > 1e-9) & (z >= 0) & (z <= w)
        flat: Array = placed_points[before, :2] / w[before, None]
        vanishing = [point for point in vanishing_points(self.matrix) if point is not None]
        if not (len(flat) and vanishing):
            return flat
        both = np.concatenate([flat, vanishing])
        return (
            both if (np.ptp(both, axis=0) <= _FARTHEST_VANISHING * np.ptp(flat, axis=0).max()).all() else flat
        )

    def vanishing(self) -> list[tuple[int, tuple[float, float]]]:
        """Axis and place on the view plane of each principal vanishing point of the picture shown."""
        if self._viewpoint is None or not any(thing.visible for thing in self.scene.objects):
            return []
        points = vanishing_points(self._viewpoint.matrix)
        return [(axis, point) for axis, point in enumerate(points) if point is not None]

    # Painting

    def paint_under(self, painter: QPainter) -> None:
        """The horizon: where the planes of equal height run together."""
        if self._viewpoint is None:
            return
        line = horizon(self._viewpoint.matrix)
        if line is None or not self.vanishing():
            return
        a, b, c = line
        middle = np.array(self.middle)
        foot = middle - (a * middle[0] + b * middle[1] + c) * np.array([a, b])
        along = np.array([-b, a]) * 4 * max(self.width(), self.height()) / self.scale
        start, end = self.on_screen(np.stack([foot - along, foot + along]))
        lines(painter, start[None], end[None], QPen(colour(tokens().agreement), 1, Qt.PenStyle.DashLine))

    def paint_over(self, painter: QPainter) -> None:
        """Vanishing points, what runs together there, and the vertex that is projected."""
        corners, labels = self._corners_of_chosen(), Labels(painter, self)
        vanishing = self.vanishing()
        places = self.on_screen(np.array([point for _axis, point in vanishing]).reshape(-1, 2))
        for (axis, (x, y)), at in zip(vanishing, places, strict=True):
            ink = colour(tokens().data[INKS[axis]])
            outermost = self._outermost(corners, at)
            pen = QPen(ink, 1, Qt.PenStyle.DotLine)  # Qt paints dots of another width much more slowly
            lines(painter, outermost, np.broadcast_to(at, outermost.shape), pen)
            painter.setPen(QPen(ink, 1))
            painter.setBrush(ink)
            mark = QPointF(*at.clip(-1e5, 1e5).tolist())
            self._marker(painter, axis, mark)
            if self.rect().contains(mark.toPoint()):
                text = f"VP{AXES[axis]} ({short(x)}, {short(y)})"
                labels.put(at, text, tokens().data[INKS[axis]])
            painter.setBrush(Qt.BrushStyle.NoBrush)
        net = self.net
        if net is not None:
            net.paint(painter, self.projected)
        handles = self.handles
        if handles is not None:
            handles.paint(painter, self.projected)
        if self.vertex is not None:
            (at,) = self.projected(np.array([self.vertex.place]))
            if np.isfinite(at).all():
                painter.setPen(QPen(colour(tokens().accent), 2))
                painter.setBrush(colour(tokens().canvas))
                painter.drawEllipse(QPointF(*at.tolist()), 5, 5)
                painter.setBrush(Qt.BrushStyle.NoBrush)
                labels.put(at, self._words(self.vertex), tokens().accent)

    @staticmethod
    def _words(vertex: Vertex) -> str:
        """Its name, and with it its place once it has one in the picture."""
        return way_text(vertex if vertex.stage >= DIVIDED else vertex._replace(rows=()))

    @property
    def handles(self) -> Handles | None:
        """Those of the chosen object, where it has any now."""
        return Handles.of(self.scene, self.chosen, self.mode)

    @property
    def net(self) -> ControlNet | None:
        """The points of the chosen object, where no other handles are shown."""
        return None if self.mode else ControlNet.of(self.scene, self.chosen)

    def set_mode(self, mode: Mode) -> None:
        """Show handles to move, turn or scale the chosen object, or none."""
        self.mode = mode
        self.update()

    def _marker(self, painter: QPainter, axis: int, at: QPointF) -> None:
        """A triangle for x, a diamond for y, a square for z."""
        x, y, r = at.x(), at.y(), 5.5
        if axis == 0:
            corners = [QPointF(x - r, y + r), QPointF(x + r, y + r), QPointF(x, y - r)]
            painter.drawPolygon(QPolygonF(corners))
        elif axis == 1:
            corners = [QPointF(x - r, y), QPointF(x, y + r), QPointF(x + r, y), QPointF(x, y - r)]
            painter.drawPolygon(QPolygonF(corners))
        else:
            painter.drawRect(QRectF(x - r + 1, y - r + 1, 2 * r - 2, 2 * r - 2))

    def _corners_of_chosen(self) -> Array:
        visible = [thing for thing in self.scene.objects if thing.visible]
        for thing, (*_rest, lasting) in zip(visible, placed(self.scene), strict=True):
            if thing.id == self.chosen or (not self.chosen and thing is visible[0]):
                screen = self.projected(lasting.outermost)
                corners: Array = screen[np.isfinite(screen).all(axis=1)]
                return corners
        return np.zeros((0, 2))

    @staticmethod
    def _outermost(corners: Array, at: Array) -> Array:
        """The two corners between whose lines to ``at`` all others lie."""
        if len(corners) < 2:
            return corners
        towards = corners.mean(axis=0) - at
        way = corners - at
        angles = np.arctan2(
            towards[0] * way[:, 1] - towards[1] * way[:, 0], way @ towards
        )  # within a half turn of the middle
        return corners[[angles.argmin(), angles.argmax()]]

    # The hand

    def grip_at(self, position: QPointF) -> object | None:
        """A handle of the chosen object, or a vanishing point of a perspective, where one is within reach."""
        handles = self.handles
        if handles is not None and (handle := handles.at(position, self.projected)) is not None:
            return handle
        net = self.net
        if net is not None and (held := net.at(position, self.projected)) is not None:
            return held
        if self.scene.camera.projection != "perspective":
            return None
        for axis, point in self.vanishing():
            (at,) = self.on_screen(np.array([point]))
            if abs(at - [position.x(), position.y()]).max() <= REACH_PX:
                return axis
        return None

    def drag_grip(self, grip: object, position: QPointF, modifiers: Qt.KeyboardModifier) -> None:
        """Tell how far a handle is dragged, or where the vanishing point is."""
        if isinstance(grip, Handle):
            self._drag_handle(grip, position, bool(modifiers & Qt.KeyboardModifier.ShiftModifier))
            return
        if isinstance(grip, NetPoint):
            x, y = self.on_plane(position)
            self.point_moved.emit(grip, moved_in_picture(self.matrix, np.array(grip.place), x, y))
            return
        assert isinstance(grip, int)
        x, y = self.on_plane(position)
        self.vanishing_moved.emit(grip, x, y, bool(modifiers & Qt.KeyboardModifier.ShiftModifier))

    def _drag_handle(self, handle: Handle, position: QPointF, every: bool) -> None:
        begun = self._begun = self._begun or self.handles
        if begun is None or self._press is None:
            return
        towards = -float((view_matrix(self.scene.camera)[:3, :3] @ np.eye(3)[handle.axis])[2])
        amount = begun.dragged(handle, self._press, position, self.projected, towards)
        self.handle_moved.emit(begun, handle, amount, every)

    def release_grip(self, grip: object) -> None:
        """What was dragged stays as it is."""
        if isinstance(grip, Handle | NetPoint):
            self._begun = None
            self.handle_left.emit()
        self.turn_ended.emit()

    def vertex_at(self, position: QPointF) -> Vertex | None:
        """The corner of a visible object that is nearest to a place, within reach."""
        best, reach = None, _VERTEX_PX
        visible = [thing for thing in self.scene.objects if thing.visible]
        for thing, (mesh, *_rest) in zip(visible, placed(self.scene), strict=True):
            away = np.hypot(*(self.projected(mesh.vertices) - [position.x(), position.y()]).T)
            away = np.where(np.isfinite(away), away, np.inf)
            if len(away) and away.min() < reach:
                number = int(away.argmin())
                reach = float(away[number])
                x, y, z = mesh.vertices[number].tolist()
                best = Vertex(thing.id, number, (x, y, z))
        return best
