"""The scene from outside: the eye, the view plane and volume, projectors, and the picture on the plane.

Eye, lights and planes are moved there: eye and lights by themselves, the planes by their names.
"""

import math

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QPainter, QPen, QShowEvent
from PySide6.QtWidgets import QWidget

from workbench.document.model import Rectangle
from workbench.document.scene.looking import facing, turn_of, turned_to
from workbench.document.scene.model import Camera, Point3D, Scene
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.geometry.meshes import Array, Index, Mesh
from workbench.language import _
from workbench.panels.space.eye_view import EyeView
from workbench.panels.space.lamps import light_at, light_marks, light_place, paint_light
from workbench.panels.space.looking import points_of
from workbench.panels.space.object_handles import INKS
from workbench.panels.space.scene_view import REACH_PX, SceneView
from workbench.panels.space.stepped import DIVIDED, Clipped, Vertex, way_text
from workbench.panels.space.strokes import Labels, lines, outline, short
from workbench.rendering.scene.render import placed
from workbench.widgets.look.tokens import colour, tokens

_ASIDE, _ABOVE = math.radians(-58.0), math.radians(18.0)
_AWAY = 12.0
_MOST_PROJECTORS, _MOST_EDGES = 60, 2_000
_GRID = 8
_LEAST, _NEXT = 1e-3, 1.001
_LIGHT = "light "
"""Before the id of a light as the name of its grip."""


class OutsideView(SceneView):
    """Shows the scene of an ``EyeView`` with that eye in it, from a camera of its own.

    ``camera_moved`` sends the camera of the scene as it is dragged, ``light_moved`` the id of a light and its
    new position; ``move_ended`` follows a drag.
    """

    camera_moved = Signal(object)
    light_moved = Signal(str, object)
    move_ended = Signal()

    def __init__(self, eye: EyeView, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._eye = eye
        self.seen = Scene()
        self.window_seen = Rectangle(-1.0, -1.0, 1.0, 1.0)
        self.vertex: Vertex | None = None
        self.clipped: Clipped | None = None
        self.grips: list[tuple[str, QRectF]] = []
        self._turn = (_ASIDE, _ABOVE)
        self._begun: tuple[Camera, QPointF] | None = None
        self.setAccessibleName(_("From outside"))
        self.turned.connect(self._orbit)

    def show_seen(self, scene: Scene, window: Rectangle, vertex: Vertex | None, chosen: str) -> None:
        """Show what is seen of ``scene`` through a window of its view plane, and its vertex on its way.

        Hidden, it only keeps that until it is to be seen.
        """
        self.seen, self.window_seen, self.vertex, self.chosen = scene, window, vertex, chosen
        if not self.isVisible():
            return
        held = self._begun is not None
        scene = replace(scene, camera=self.scene.camera if held else self._camera())
        if self.keeps_fit and not held:
            self.scene = scene  # to be drawn once, as it fits
            self.fit()
        self.show_scene(scene, chosen)

    def showEvent(self, event: QShowEvent) -> None:
        """Show what it has kept while it was hidden."""
        self.show_seen(self.seen, self.window_seen, self.vertex, self.chosen)
        super().showEvent(event)

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

    @property
    def _matrix(self) -> Array:
        """From the world to the eye's view plane (4, 4)."""
        matrix: Array = projection_matrix(self.seen.camera) @ view_matrix(self.seen.camera)
        return matrix

    def _lifted(self, flat: Array) -> Array:
        """Places (n, 2) of the eye's view plane as points of space (n, 3)."""
        back = np.linalg.inv(view_matrix(self.seen.camera))
        distance = np.full(len(flat), self.seen.camera.distance)
        lifted: Array = np.column_stack([flat, distance, np.ones(len(flat))]) @ back[:3].T
        return lifted

    def _in_space(self, homogeneous: Array) -> Array:
        """Points (n, 4) after the projection, before the division, as points of the world (n, 3)."""
        back = homogeneous @ np.linalg.inv(self._matrix).T
        points: Array = back[:, :3] / back[:, 3:]
        return points

    def _corners(self) -> Array:
        """The corners (4, 2) of what is seen of the eye's view plane."""
        w = self.window_seen
        return np.array([(w.xmin, w.ymin), (w.xmax, w.ymin), (w.xmax, w.ymax), (w.xmin, w.ymax)])

    def _plane(self) -> Array:
        """The corners of the picture on the plane; none where the matrix is one of somebody's own."""
        if self.seen.camera.projection == "matrix":
            return np.zeros((0, 3))
        return self._lifted(self._corners())

    def volume(self) -> Array:
        """The corners (2, 4, 3) of the view volume, world: those on the near plane, those on the far one."""
        flat = self._corners()
        ends = [np.column_stack([flat, np.full(4, depth), np.ones(4)]) for depth in (0.0, 1.0)]
        return np.stack([self._in_space(end) for end in ends])

    def _images(self, points: Array) -> Array:
        """Where on the plane points of space (n, 3) are projected to; not a number for those behind."""
        placed_points = points @ self._matrix[:, :3].T + self._matrix[:, 3]
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
        """Volume, plane, projectors, the picture on the plane, and the eye."""
        camera, now = self.seen.camera, tokens()
        self.grips = []
        labels = Labels(painter, self)
        self._paint_volume(painter, labels)
        plane = self._plane()
        (eye,) = self.projected(np.array([camera.eye.xyz]))
        central = camera.projection == "perspective"
        if len(plane):
            corners = self.projected(plane)
            painter.setPen(QPen(colour(now.accent), 1.5))
            painter.setBrush(colour(now.accent, 30))
            outline(painter, corners)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            if self.clipped is None:
                self._paint_projectors(painter, eye if central else None)
                self._paint_way(painter, labels, eye if central else None)
            words = _("view plane, d = {d:.4g}").format(d=camera.distance)
            at = corners[corners[:, 1].argmin()]
            self.grips.append(("distance", labels.put(at, words, now.accent)))
        if self.clipped is not None:
            self._paint_clipped(painter, self.clipped)
        for mark in light_marks(self, self.seen):
            paint_light(painter, labels, mark)
            reach = QPointF(REACH_PX, REACH_PX)
            self.grips.append((_LIGHT + mark[0].id, QRectF(mark[1] - reach, mark[1] + reach)))
        if np.isfinite(eye).all() and (central or camera.projection == "orthographic"):
            painter.setPen(QPen(colour(now.text), 2))
            painter.setBrush(colour(now.canvas))
            painter.drawEllipse(QPointF(*eye.tolist()), 6, 6)
            painter.setBrush(colour(now.text))
            painter.drawEllipse(QPointF(*eye.tolist()), 2.2, 2.2)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            x, y, z = map(short, camera.eye.xyz)
            text = _("eye ({x}, {y}, {z})").format(x=x, y=y, z=z)
            card = labels.put(eye + np.array([0.0, 34.0]), text, now.text)
            round_eye = QRectF(eye[0] - REACH_PX, eye[1] - REACH_PX, 2 * REACH_PX, 2 * REACH_PX)
            self.grips += [("eye", round_eye), ("eye", card)]

    def _paint_volume(self, painter: QPainter, labels: Labels) -> None:
        """The edges of the view volume, and the names of its near and far plane."""
        camera, now = self.seen.camera, tokens()
        near, far = (self.projected(end) for end in self.volume())
        faint = QPen(colour(now.muted), 1, Qt.PenStyle.DashLine)
        lines(painter, near, far, faint)
        ink = now.data[4]
        for name, corners in (("near", near), ("far", far)):
            painter.setPen(QPen(colour(ink, 170), 1))
            outline(painter, corners)
            if camera.projection != "matrix" and np.isfinite(corners).all():
                # The near plane often lies about the eye, whose name is below it
                upper = corners[corners[:, 1].argmin()] - np.array([0.0, 12.0])
                low = corners[corners[:, 1].argmax()] + np.array([0.0, 26.0])
                title = _("near {z:.4g}") if name == "near" else _("far {z:.4g}")
                words = title.format(z=getattr(camera, name))
                self.grips.append((name, labels.put(upper if name == "near" else low, words, ink)))

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

    def _paint_way(self, painter: QPainter, labels: Labels, eye: Array | None) -> None:
        """The vertex as far as it has come: in the world, along the axes of the view, on the plane."""
        vertex, now = self.vertex, tokens()
        if vertex is None:
            return
        place = np.array([vertex.place])
        start, end = self.projected(place), self.projected(self._images(place))
        stage = vertex.stage
        if not 0 < stage < DIVIDED - 1:
            lines(painter, start, end if eye is None else eye[None], QPen(colour(now.accent), 2.5))
        if stage in (DIVIDED - 2, DIVIDED - 1):
            self._paint_view_axes(painter, vertex)
        if stage == DIVIDED - 1:
            dashed = QPen(colour(now.accent), 2, Qt.PenStyle.DashLine)
            lines(painter, start, end if eye is None else eye[None], dashed)
        painter.setPen(QPen(colour(now.accent), 2))
        painter.setBrush(colour(now.canvas))
        for at in (start[0], *([end[0]] if not stage or stage >= DIVIDED else [])):
            if np.isfinite(at).all():
                painter.drawEllipse(QPointF(*at.tolist()), 4.5, 4.5)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if stage:
            at = end[0] if stage >= DIVIDED else start[0]
            labels.put(at, way_text(vertex), now.accent)

    def _paint_view_axes(self, painter: QPainter, vertex: Vertex) -> None:
        """From the eye into the picture, then to the right, then up: z, x and y of view coordinates."""
        back = np.linalg.inv(view_matrix(self.seen.camera))
        x, y, z = vertex.rows[1][:3]
        corners = np.array([(0, 0, 0, 1), (0, 0, z, 1), (x, 0, z, 1), (x, y, z, 1)], np.float64)
        places = self.projected(corners @ back[:3].T)
        for number, axis in enumerate((2, 0, 1)):
            pen = QPen(colour(tokens().data[INKS[axis]]), 2.5)
            lines(painter, places[number][None], places[number + 1][None], pen)

    def _paint_clipped(self, painter: QPainter, clipped: Clipped) -> None:
        """The polygon that a plane takes, dashed, what it hands on, and the rings that are done."""
        now = tokens()
        for ring in clipped.done:
            self._paint_ring(painter, ring, QPen(colour(now.data[2]), 2), 60)
        self._paint_ring(painter, clipped.taken, QPen(colour(now.text), 2, Qt.PenStyle.DashLine), 0)
        self._paint_ring(painter, clipped.handed_on, QPen(colour(now.accent), 2), 70)

    def _paint_ring(self, painter: QPainter, ring: Array, pen: QPen, share: int) -> None:
        """A polygon (n, 4) in space, its inside filled by a share of its ink, 0 to 255."""
        if len(ring):
            ink = pen.color()
            ink.setAlpha(share)
            painter.setPen(pen)
            painter.setBrush(ink)
            outline(painter, self.projected(self._in_space(ring)))
            painter.setBrush(Qt.BrushStyle.NoBrush)

    # The hand

    def grip_at(self, position: QPointF) -> object | None:
        """The eye, a light, or a plane by its name."""
        return next((name for name, place in reversed(self.grips) if place.contains(position)), None)

    def drag_grip(self, grip: object, position: QPointF, modifiers: Qt.KeyboardModifier) -> None:
        """Move the eye or a light, or a plane along the line of sight."""
        assert isinstance(grip, str)
        if grip.startswith(_LIGHT):
            self._drag_light(grip.removeprefix(_LIGHT), position)
            return
        if self._begun is None:
            self._begun = self.seen.camera, self._press or position
        camera, begin = self._begun
        by = position - begin
        if grip == "eye":
            right, up = view_matrix(self.scene.camera)[:2, :3]
            shift = (by.x() * right - by.y() * up) / self.scale
            moved = replace(camera, eye=Point3D(*(camera.eye.xyz + shift).tolist()))
        else:
            along = self._along_sight(camera)
            length = float(along @ along)
            if length < 1.0:  # the line of sight is seen end on: no way to tell how far
                return
            to = getattr(camera, grip) + float(along @ (by.x(), by.y())) / length
            moved = replace(camera, **{grip: _within(camera, grip, to)})
        self.camera_moved.emit(moved)

    def _drag_light(self, identity: str, position: QPointF) -> None:
        """Move a light beside and above, as far from here as it was."""
        light = next((each for each in self.seen.lights if each.id == identity), None)
        if light is None:
            return
        place = light_place(light, self.seen)
        x, y = self.projected(place[None])[0].tolist()
        right, up = view_matrix(self.scene.camera)[:2, :3]
        shift = ((position.x() - x) * right - (position.y() - y) * up) / self.scale
        self.light_moved.emit(identity, light_at(light, self.seen, place + shift))

    def release_grip(self, _grip: object) -> None:
        """It stays where it was dragged to, and the picture takes room for it."""
        self._begun = None
        self.move_ended.emit()

    def _along_sight(self, camera: Camera) -> Array:
        """A unit along the line of sight, in pixels (2,) to the right and down."""
        matrix = view_matrix(self.scene.camera)
        x, y = (matrix[:2, :3] @ view_matrix(camera)[2, :3] * self.scale).tolist()
        return np.array([x, -y])


def _within(camera: Camera, name: str, value: float) -> float:
    """A distance that the planes leave room for: near before far."""
    if name == "near":
        return min(max(value, _LEAST), camera.far / _NEXT)
    return max(value, camera.near * _NEXT if name == "far" else _LEAST)
