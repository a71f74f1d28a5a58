"""The scene from outside: the eye, the view plane, the projectors of an object, its picture on the plane."""

import math

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainter, QPen
from PySide6.QtWidgets import QWidget

from workbench.document.model import Rectangle
from workbench.document.scene.looking import facing, turn_of, turned_to
from workbench.document.scene.model import Camera, Point3D, Scene
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.geometry.meshes import Array, Index, Mesh
from workbench.language import _
from workbench.panels.space.eye_view import EyeView, Vertex
from workbench.panels.space.looking import points_of
from workbench.panels.space.scene_view import SceneView
from workbench.panels.space.strokes import label, lines, outline
from workbench.rendering.scene.render import placed
from workbench.widgets.look.tokens import colour, tokens

_ASIDE, _ABOVE = math.radians(-58.0), math.radians(18.0)
_AWAY = 12.0
_MOST_PROJECTORS, _MOST_EDGES = 60, 2_000
_GRID = 8


class OutsideView(SceneView):
    """Shows the scene of an ``EyeView`` with that eye in it, from a camera of its own."""

    def __init__(self, eye: EyeView, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._eye = eye
        self.seen = Scene()
        self.window_seen = Rectangle(-1.0, -1.0, 1.0, 1.0)
        self.vertex: Vertex | None = None
        self._turn = (_ASIDE, _ABOVE)
        self.setAccessibleName(_("From outside"))
        self.turned.connect(self._orbit)

    def show_seen(self, scene: Scene, window: Rectangle, vertex: Vertex | None, chosen: str) -> None:
        """Show what is seen of ``scene`` through a window of its view plane, and its vertex on its way."""
        self.seen, self.window_seen, self.vertex = scene, window, vertex
        self.show_scene(replace(scene, camera=self._camera()), chosen)
        if self.keeps_fit:
            self.fit()

    def stand_aside(self) -> None:
        """Look from the side of the eye, and fit."""
        x, _y, z = np.subtract(self.seen.camera.eye.xyz, self.seen.camera.look_at.xyz)
        self.keeps_fit = True
        self.turn_to(math.atan2(x, z) + _ASIDE, _ABOVE)

    def turn_to(self, theta: float, phi: float) -> None:
        """Look from a place of the turntable."""
        self._turn = theta, min(max(phi, -math.pi / 2), math.pi / 2)
        self.show_seen(self.seen, self.window_seen, self.vertex, self.chosen)

    def face(self, side: str) -> None:
        """Look from one of the six sides."""
        self.turn_to(*turn_of(facing(self.scene.camera, side)))

    def _orbit(self, d_theta: float, d_phi: float) -> None:
        theta, phi = self._turn
        self.turn_to(theta + d_theta, phi + d_phi)

    def _camera(self) -> Camera:
        points = self._everything()
        low, high = points.min(axis=0), points.max(axis=0)
        radius = max(math.dist(low, high) / 2, 1e-6)
        middle = Point3D(*((low + high) / 2).tolist())
        far = 2 * _AWAY * radius
        camera = Camera("orthographic", look_at=middle, near=far * 1e-6 + 1e-3, far=far + 1.0)
        return turned_to(camera, *self._turn, _AWAY * radius)

    def _everything(self) -> Array:
        """All that is to be seen in space: the scene, the eye, the part of the plane that is the picture."""
        points = points_of(self.seen)
        return np.concatenate([points, [self.seen.camera.eye.xyz], self._plane()])

    def extent(self) -> Array:
        """All of it in the view plane of this view."""
        points = self._everything()
        matrix = projection_matrix(self.scene.camera) @ view_matrix(self.scene.camera)
        flat: Array = (points @ matrix[:, :3].T + matrix[:, 3])[:, :2]
        return flat

    # The eye's picture in space

    def _lifted(self, flat: Array) -> Array:
        """Places (n, 2) of the eye's view plane as points of space (n, 3)."""
        back = np.linalg.inv(view_matrix(self.seen.camera))
        distance = np.full(len(flat), self.seen.camera.distance)
        lifted: Array = np.column_stack([flat, distance, np.ones(len(flat))]) @ back[:3].T
        return lifted

    def _plane(self) -> Array:
        """The corners of the picture on the plane; none where the matrix is one of somebody's own."""
        if self.seen.camera.projection == "matrix":
            return np.zeros((0, 3))
        w = self.window_seen
        corners = [(w.xmin, w.ymin), (w.xmax, w.ymin), (w.xmax, w.ymax), (w.xmin, w.ymax)]
        return self._lifted(np.array(corners))

    def _images(self, points: Array) -> Array:
        """Where on the plane points of space (n, 3) are projected to; not a number for those behind."""
        matrix = projection_matrix(self.seen.camera) @ view_matrix(self.seen.camera)
        placed_points = points @ matrix[:, :3].T + matrix[:, 3]
        w = np.where(placed_points[:, 3] > 1e-9, placed_points[:, 3], np.nan)
        return self._lifted(placed_points[:, :2] / w[:, None])

    # Painting

    def paint_under(self, painter: QPainter) -> None:
        """The ground, y = 0."""
        pen = QPen(colour(tokens().grid_strong), 1)
        reach = np.linspace(-_GRID, _GRID, _GRID + 1)
        ends = np.array([(-_GRID, _GRID)] * len(reach), float)
        across = np.stack([ends, np.zeros_like(ends), np.stack([reach, reach], axis=1)], axis=2)
        both = np.concatenate([across, across[:, :, ::-1]])
        places = self.projected(both.reshape(-1, 3)).reshape(-1, 2, 2)
        lines(painter, places[:, 0], places[:, 1], pen)

    def paint_over(self, painter: QPainter) -> None:
        """Plane, projectors, the picture on the plane, and the eye."""
        camera, now = self.seen.camera, tokens()
        plane = self._plane()
        (eye,) = self.projected(np.array([camera.eye.xyz]))
        central = camera.projection == "perspective"
        if len(plane):
            corners = self.projected(plane)
            painter.setPen(QPen(colour(now.accent), 1.5))
            painter.setBrush(colour(now.accent, 30))
            outline(painter, corners)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            faint = QPen(colour(now.muted), 1, Qt.PenStyle.DashLine)
            if central:
                lines(painter, np.broadcast_to(eye, corners.shape), corners, faint)
            self._paint_projectors(painter, eye if central else None)
            words = _("view plane, d = {d:.4g}").format(d=camera.distance)
            label(painter, self.size(), corners[corners[:, 1].argmin()], words, now.accent)
        if np.isfinite(eye).all() and (central or camera.projection == "orthographic"):
            painter.setPen(QPen(colour(now.text), 2))
            painter.setBrush(colour(now.canvas))
            painter.drawEllipse(QPointF(*eye.tolist()), 6, 6)
            painter.setBrush(colour(now.text))
            painter.drawEllipse(QPointF(*eye.tolist()), 2.2, 2.2)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            x, y, z = camera.eye.xyz
            text = _("eye ({x:.3g}, {y:.3g}, {z:.3g})").format(x=x, y=y, z=z).replace("-", "−")
            label(painter, self.size(), eye + np.array([0.0, 34.0]), text, now.text)

    def _chosen_mesh(self) -> tuple[Mesh, Index] | None:
        """The mesh of the chosen object, else of the first, in the world, and its edges; none where there are
        too many to be told apart."""
        visible = [thing for thing in self.seen.objects if thing.visible]
        chosen = next((k for k, thing in enumerate(visible) if thing.id == self.chosen), 0)
        parts = placed(self.seen)
        if not parts:
            return None
        mesh, *_rest, lasting = parts[chosen]
        few = len(mesh.faces.corners) <= 4 * _MOST_EDGES
        return mesh, lasting.edges[:_MOST_EDGES] if few else np.zeros((0, 2), np.int64)

    def _paint_projectors(self, painter: QPainter, eye: Array | None) -> None:
        """From the vertices of the chosen object to the eye, or in parallel to the plane."""
        chosen, now = self._chosen_mesh(), tokens()
        if chosen is None:
            return
        mesh, edges = chosen
        image = self.projected(self._images(mesh.vertices)) if len(edges) else np.zeros((0, 2))
        if 0 < len(image) <= _MOST_PROJECTORS:
            pen = QPen(colour(now.muted, 170), 1)
            ends = image if eye is None else np.broadcast_to(eye, image.shape)
            lines(painter, self.projected(mesh.vertices), ends, pen)
        pen = QPen(colour(now.data[0]), 1.5)
        lines(painter, image[edges[:, 0]], image[edges[:, 1]], pen)
        if self.vertex is not None:
            place = np.array([self.vertex.place])
            start, end = self.projected(place), self.projected(self._images(place))
            lines(painter, start, end if eye is None else eye[None], QPen(colour(now.accent), 2.5))
            painter.setPen(QPen(colour(now.accent), 2))
            painter.setBrush(colour(now.canvas))
            for at in (start[0], end[0]):
                if np.isfinite(at).all():
                    painter.drawEllipse(QPointF(*at.tolist()), 4.5, 4.5)
            painter.setBrush(Qt.BrushStyle.NoBrush)
