"""A picture of a scene, drawn by a worker: what of the view plane is seen of it, its zoom and pan."""

from typing import Literal

import numpy as np
from PySide6.QtCore import QLineF, QMargins, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QFocusEvent, QImage, QPainter, QPaintEvent, QPen, QRegion, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.document.model import Rectangle
from workbench.document.scene.model import Scene
from workbench.geometry.conventions import top_row_first
from workbench.geometry.meshes import Array
from workbench.language import _, reason_of
from workbench.panels.space.scene_worker import Draws, SceneJob, SceneWorker
from workbench.panels.space.strokes import lines
from workbench.rendering.scene.edge_picture import EdgePicture, edge_picture
from workbench.rendering.scene.line_drawing import drawn_at_once, line_picture
from workbench.rendering.scene.shaded import Model
from workbench.rendering.scene.shading import QUICK
from workbench.rendering.scene.viewpoint import Viewpoint
from workbench.widgets.look.tokens import RADIUS, colour, theme, tokens

Shows = Literal["faces", "edges", "lines", "both"]
"""Faces, all edges, edges without what faces hide, or faces and edges."""
_NEXT: dict[Shows, Shows] = {"both": "edges", "edges": "lines", "lines": "faces", "faces": "both"}
_DRAWS: dict[Shows, Draws] = {"faces": "faces", "both": "faces", "edges": "edges", "lines": "lines"}

_MARGIN_PX = 44
_LEAST_SCALE, _MOST_SCALE = 1e-6, 1e9
_FINEST_PX = 0.3
_MANY_FACES = 10_000
_PER_WIDTH = 8.0
"""An edge is at least so many times as long as wide, on average: a fine mesh is drawn in fine lines."""


def sentence_of(shows: Shows) -> str:
    """What is shown, in words."""
    return {
        "both": _("Faces and edges are shown."),
        "edges": _("All edges are shown, hidden ones too."),
        "lines": _("Edges are shown where no face hides them."),
        "faces": _("Faces are shown without their edges."),
    }[shows]


def fine(width_px: float, length_px: float) -> float:
    """How wide lines of this average length are drawn that are ``width_px`` wide where there is room."""
    return min(width_px, max(length_px / _PER_WIDTH, _FINEST_PX))


class ScenePicture(QWidget):
    """Where ``middle`` of the view plane is in the middle, ``scale`` logical pixels a unit; it keeps them
    while the camera turns, and fits the scene anew when it ``keeps_fit`` and something else has changed.

    ``view_changed`` sends the scale, ``pictured`` the camera of a picture as that is shown, ``resized``
    follows another size of the widget, ``failed`` tells why a scene cannot be drawn.
    """

    view_changed = Signal(float)
    pictured = Signal(object)
    resized = Signal()
    failed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(120, 100)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.shows: Shows = "both"
        self.scene = Scene()
        self.chosen = ""
        self.marked = np.zeros((0, 2, 3))
        self.middle, self.scale = (0.0, 0.0), 50.0
        self.keeps_fit = True
        self.dragging = False
        self.worker = SceneWorker(self)
        self.worker.drawn.connect(self._take_drawn)
        self.worker.failed.connect(self._refuse)
        self._job: SceneJob | None = None
        self._lit = QUICK, Model()
        self._picture: EdgePicture | None = None
        self._rows = np.zeros((0, 0), np.uint32)  # the image only refers to them
        self._image = QImage()
        self._awaited: Draws | None = None
        self._came: Draws | None = None
        self._viewpoint: Viewpoint | None = None
        self._device: Array = np.eye(3)
        theme.changed.connect(self.update)

    def sizeHint(self) -> QSize:
        """Any two share their room in halves."""
        return QSize(400, 300)

    # What is shown

    def show_scene(self, scene: Scene, chosen: str = "") -> None:
        """Show a scene through its camera, with one of its objects picked out."""
        self.chosen = chosen
        if scene != self.scene:
            self.scene = scene
            self.redraw()
        if not (self.dragging and self.worker.busy):  # else the picture that is awaited is painted
            self._renew()

    @property
    def is_large(self) -> bool:
        """Whether its picture takes so long that while it is turned nothing else is drawn."""
        return sum(len(thing.mesh.faces) for thing in self.scene.objects if thing.visible) > _MANY_FACES

    @property
    def picture_is_current(self) -> bool:
        """Whether what is painted is the scene as it is now."""
        return self._picture is not None and not self.worker.busy

    def mark(self, segments_world: Array) -> None:
        """Mark segments (n, 2, 3) of the world; none with an empty array."""
        self.marked = segments_world
        self.update()

    def set_shows(self, shows: Shows) -> None:
        """Show faces, edges, edges without hidden lines, or faces and edges."""
        if shows != self.shows:
            self.shows, self._job = shows, None
            self.redraw()

    @property
    def next_shows(self) -> Shows:
        """What comes after what is shown: faces and edges, edges, edges without hidden lines, faces."""
        return _NEXT[self.shows]

    def set_shading(self, shading: str, model: Model) -> None:
        """Show the scene in a shading, by its slug; a quick one has edges, too."""
        if (shading, model) != self._lit:
            self._lit = shading, model
            self.redraw()

    @property
    def device_size(self) -> tuple[int, int]:
        """Width and height in the pixels of the screen."""
        ratio = self.devicePixelRatioF()
        return max(round(self.width() * ratio), 1), max(round(self.height() * ratio), 1)

    @property
    def window_world(self) -> Rectangle:
        """What of the view plane is seen."""
        x, y = self.middle
        half_x, half_y = self.width() / self.scale / 2, self.height() / self.scale / 2
        return Rectangle(x - half_x, y - half_y, x + half_x, y + half_y)

    def redraw(self) -> None:
        """Have the picture drawn anew."""
        if self.isVisible() and self.width() > 1 and self.height() > 1:
            job = SceneJob(self.scene, self.device_size, self.window_world, _DRAWS[self.shows], *self._lit)
            if job != self._job:
                self._job, self._awaited = job, None
                try:
                    if (at_once := self._at_once(job)) is not None:
                        self._take(job, at_once)
                    else:
                        self._await(job)
                except ValueError as error:
                    self._refuse(job, reason_of(error))

    def begin_anew(self) -> None:
        """Another document or sheet is open: nothing of the last one's picture is shown in its place."""
        self.worker.leave()
        self.scene = Scene()  # which is what a redraw shows until there is another, as when it comes in sight
        self._job = self._came = self._picture = None
        self._image = QImage()
        self.update()

    def _at_once(self, job: SceneJob) -> EdgePicture | None:
        """What need not be waited for. Raises: ValueError."""
        if job.draws == "edges":
            return edge_picture(*job[:3], faces=False)
        lines = drawn_at_once(job.scene) if job.draws == "lines" else None
        return None if lines is None else line_picture(lines, *job[:3])

    def _await(self, job: SceneJob) -> None:
        if self._came != job.draws:  # until the first of its kind is there, all edges are
            self._take(job, edge_picture(*job[:3], faces=False))
        self._awaited = job.draws
        self.worker.ask(job)

    def _take(self, job: SceneJob, picture: EdgePicture) -> None:
        before = self._viewpoint
        self._picture, self._viewpoint = picture, job.viewpoint
        self._device = self._viewpoint.device
        self._image = QImage()
        if picture.pixels is not None:
            self._rows = np.ascontiguousarray(top_row_first(picture.pixels))
            height, width = self._rows.shape
            form = QImage.Format.Format_ARGB32_Premultiplied  # no pixel lets through a part only
            self._image = QImage(self._rows.data, width, height, width * 4, form)
        if before is None or before[1:] != self._viewpoint[1:]:
            self.view_changed.emit(self.scale)
        self.pictured.emit(job.scene.camera)
        self._renew()

    def _take_drawn(self, job: SceneJob, picture: EdgePicture) -> None:
        if job.draws == self._awaited:  # else another kind is shown meanwhile
            self._came = job.draws
            self._take(job, picture)

    def _refuse(self, _job: SceneJob, sentence: str) -> None:
        self.failed.emit(sentence)

    # Zoom and pan

    def fit(self) -> None:
        """Show all of the scene."""
        flat = self.extent()
        self.keeps_fit = True
        if len(flat):
            low, high = flat.min(axis=0), flat.max(axis=0)
            room = max(self.width() - 2 * _MARGIN_PX, 40), max(self.height() - 2 * _MARGIN_PX, 40)
            spread = max(float((high - low)[0]) / room[0], float((high - low)[1]) / room[1], 1e-9)
            x, y = ((low + high) / 2).tolist()
            self.middle, self.scale = (x, y), min(max(1.0 / spread, _LEAST_SCALE), _MOST_SCALE)
        self.redraw()
        self.view_changed.emit(self.scale)

    def extent(self) -> Array:
        """The places (n, 2) of the view plane that are to be seen when all fits in."""
        return np.zeros((0, 2))

    def zoom(self, factor: float, at: QPointF | None = None) -> None:
        """Show everything ``factor`` times as large, and what is at a place stays there."""
        at = QPointF(self.rect().center()) if at is None else at
        x, y = self.on_plane(at)
        self.scale = min(max(self.scale * factor, _LEAST_SCALE), _MOST_SCALE)
        after_x, after_y = self.on_plane(at)
        self.middle = self.middle[0] + x - after_x, self.middle[1] + y - after_y
        self.keeps_fit = False
        self.redraw()
        self.view_changed.emit(self.scale)

    def pan(self, dx: float, dy: float) -> None:
        """Shift the picture by so many logical pixels, to the right and down."""
        self.middle = self.middle[0] - dx / self.scale, self.middle[1] + dy / self.scale
        self.keeps_fit = False
        self.redraw()

    def on_plane(self, position: QPointF) -> tuple[float, float]:
        """The place of the view plane at a place of the widget."""
        x, y = self.middle
        return (
            x + (position.x() - self.width() / 2) / self.scale,
            y - (position.y() - self.height() / 2) / self.scale,
        )

    # From space to the widget, as the picture that is shown was drawn

    def on_screen(self, flat: Array) -> Array:
        """Places (n, 2) of the view plane in logical pixels of the widget."""
        if self._viewpoint is None:
            return np.full((len(flat), 2), np.nan)
        device, ratio, height = self._device, self.devicePixelRatioF(), self.device_size[1]
        x = flat[:, 0] * device[0, 0] + device[0, 2]
        y = flat[:, 1] * device[1, 1] + device[1, 2]
        return np.stack([(x + 0.5) / ratio, (height - 0.5 - y) / ratio], axis=1)

    def projected(self, points_world: Array) -> Array:
        """Points (n, 3) of space in logical pixels (n, 2); not a number where none is before the camera."""
        if self._viewpoint is None:
            return np.full((len(points_world), 2), np.nan)
        placed = self._viewpoint.homogeneous(np.asarray(points_world, np.float64))
        w = np.where(placed[:, 3] > 1e-9, placed[:, 3], np.nan)
        return self.on_screen(placed[:, :2] / w[:, None])

    # Painting

    def _renew(self) -> None:
        """Have all painted but what cards hide, whose fields would be painted with each picture."""
        seen = QRegion(self.rect())
        if self.window().styleSheet():  # else a card is clear
            inside = QMargins(RADIUS, RADIUS, RADIUS, RADIUS)
            of_it = Qt.FindChildOption.FindDirectChildrenOnly
            for card in self.findChildren(QWidget, "card", of_it):
                if card.isVisible():
                    seen -= QRegion(card.geometry().marginsRemoved(inside))
        self.update(seen)

    def paintEvent(self, event: QPaintEvent) -> None:
        """The picture, its edges, and what is drawn over them."""
        painter = QPainter(self)
        painter.fillRect(event.rect(), colour(tokens().canvas))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self.paint_under(painter)
        if not self._image.isNull():
            painter.drawImage(QRectF(self.rect()), self._image)
        if self._picture is not None:
            self._paint_edges(painter, self._picture)
        self.paint_over(painter)
        self._paint_marked(painter)
        if self.hasFocus():
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
            painter.setPen(QPen(colour(tokens().accent), 2))
            painter.drawRect(self.rect().adjusted(1, 1, -1, -1))
        painter.end()

    def _paint_edges(self, painter: QPainter, picture: EdgePicture) -> None:
        now = tokens()
        ids = [thing.id for thing in self.scene.objects]
        chosen = ids.index(self.chosen) if self.chosen in ids else -1
        if picture.pixels is None:
            self._lines(painter, picture.seen[picture.seen_of != chosen], QPen(colour(now.muted), 1))
            self._lines(painter, picture.seen[picture.seen_of == chosen], QPen(colour(now.accent), 2))
            return
        faint = QPen(colour(now.accent, 150), 1, Qt.PenStyle.DashLine)
        self._lines(painter, picture.hidden[picture.hidden_of == chosen], faint)
        if self.shows == "both":
            others = picture.seen[picture.seen_of != chosen]
            self._lines(painter, others, QPen(colour(now.text), 1.2))
        self._lines(painter, picture.seen[picture.seen_of == chosen], QPen(colour(now.accent), 2))

    def _lines(self, painter: QPainter, segments: Array, pen: QPen) -> None:
        if len(segments):
            ratio, height = self.devicePixelRatioF(), self.device_size[1]
            x = (segments[:, 0::2] + 0.5) / ratio
            y = (height - 0.5 - segments[:, 1::2]) / ratio
            length = float(np.hypot(np.diff(x, axis=1), np.diff(y, axis=1)).mean())
            pen.setWidthF(fine(pen.widthF(), length))
            pen.setCapStyle(Qt.PenCapStyle.RoundCap)
            painter.setPen(pen)
            rows = zip(x.tolist(), y.tolist(), strict=True)
            painter.drawLines([QLineF(x0, y0, x1, y1) for (x0, x1), (y0, y1) in rows])

    def _paint_marked(self, painter: QPainter) -> None:
        """Lines with a dot at each end."""
        if not len(self.marked):
            return
        ends = self.projected(self.marked.reshape(-1, 3)).reshape(-1, 2, 2)
        for ink, width in ((tokens().canvas, 5.0), (tokens().accent, 3.0)):
            lines(painter, ends[:, 0], ends[:, 1], QPen(colour(ink), width))
        painter.setPen(QPen(colour(tokens().canvas), 1))
        painter.setBrush(colour(tokens().accent))
        for x, y in ends[np.isfinite(ends).all(axis=(1, 2))].reshape(-1, 2).tolist():
            painter.drawEllipse(QPointF(x, y), 3.5, 3.5)
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def paint_under(self, painter: QPainter) -> None:
        """What lies behind the picture."""

    def paint_over(self, painter: QPainter) -> None:
        """What lies over the picture."""

    # Its place

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit again, or show more or less."""
        super().resizeEvent(event)
        self.resized.emit()
        if self.keeps_fit:
            self.fit()
        else:
            self.redraw()

    def showEvent(self, event: QShowEvent) -> None:
        """Draw what was not drawn while it was hidden."""
        if self.keeps_fit:
            self.fit()
        else:
            self.redraw()

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Show the ring."""
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Take it away."""
        super().focusOutEvent(event)
        self.update()
