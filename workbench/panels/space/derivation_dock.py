"""The perspective derived: similar triangles that follow the mouse, the lines of an answer, the limit."""

import re
from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QScrollArea, QSizePolicy, QSlider, QVBoxLayout, QWidget

from workbench.document.scene.looking import receding
from workbench.document.scene.model import Camera
from workbench.document.scene.viewing import is_central, projection_matrix, view_matrix
from workbench.exchange.diagrams import MARGIN_PT, Derivation, Drawing, lay_out_derivation
from workbench.exchange.formulas.terms import displayed
from workbench.language import _, reason_of
from workbench.panels.space.derivation import InView, in_view, limit_lines, similar_lines, similar_triangles
from workbench.panels.space.stepped import Vertex
from workbench.widgets.canvas.drawing import ink_of
from workbench.widgets.formulas.typesetting import paint_primitives, typesetter_of
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.look.tokens import colour, theme, tokens

_HEIGHT_PX = 110
_TICKS = 100
_LEAST_Z = 1e-3


class SimilarTriangles(QWidget):
    """The eye, the plane and a point, seen from above. While the mouse is over it, the point follows.

    ``pointed`` sends the point that is pointed at, None when none is any longer.
    """

    pointed = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMouseTracking(True)
        self.setFixedHeight(_HEIGHT_PX + 2 * round(MARGIN_PT))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setCursor(Qt.CursorShape.CrossCursor)
        self.setAccessibleName(_("Similar triangles"))
        self.setToolTip(_("The scene seen from above the eye; move the mouse, and the point follows"))
        self._own = InView(1.0, 1.0, 10.0)
        self._moved: InView | None = None
        self._d = 5.0
        theme.changed.connect(self.update)

    def sizeHint(self) -> QSize:
        """As wide as there is room."""
        return QSize(300, self.height())

    @property
    def point(self) -> InView:
        """The point that is shown."""
        return self._moved or self._own

    def show_point(self, d: float, point: InView) -> None:
        """Show a plane at ``d`` and a point, until another is pointed at."""
        self._d, self._own = d, point
        self.update()

    def drawing(self) -> Drawing:
        """What is seen, in the proportions of the widget; its window stays while the point follows."""
        own, axis = self._of(self._own), self._own.aside
        if self._moved is None:
            return own
        return Drawing(own.window, [*own.items[:4], *self._of(self._moved, axis).items[4:]], _HEIGHT_PX)

    def _of(self, point: InView, axis: str = "") -> Drawing:
        return similar_triangles(self._d, point, self._room / _HEIGHT_PX, _HEIGHT_PX, axis)

    @property
    def _room(self) -> float:
        """How wide the drawing is."""
        return max(self.width() - 2 * MARGIN_PT, 40.0)

    def paintEvent(self, event: QPaintEvent) -> None:
        """The drawing on the ground of a panel."""
        painter, now = QPainter(self), tokens()
        painter.fillRect(event.rect(), colour(now.surface))
        inks = {name: ink_of(now, name) for name in ("text", "muted", "accent", "error", "data2", "data3")}
        page = Derivation("", [self.drawing()], inks, float(self.width()))
        setter = typesetter_of(self.font())
        laid = lay_out_derivation(page, setter)
        ground = {**inks, "canvas": now.surface}
        paint_primitives(painter, laid.primitives, setter.metrics, ground.__getitem__)  # type: ignore[arg-type]
        painter.end()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """The point is where the mouse is, as high as it was."""
        left, low, right, high = self._of(self._own).window
        share_x = (event.position().x() - MARGIN_PT) / self._room
        share_y = (event.position().y() - MARGIN_PT) / _HEIGHT_PX
        z, aside = left + share_x * (right - left), high - share_y * (high - low)
        moved = self._own._replace(z=max(z, _LEAST_Z * right), name="P", **{self._own.aside: aside})
        self._moved = moved
        self.update()
        self.pointed.emit(self._moved)

    def leaveEvent(self, _event: object) -> None:
        """The point is that of the scene again."""
        self._moved = None
        self.update()
        self.pointed.emit(None)


class DerivationDock(QScrollArea):
    """``looked`` sends a camera to see the scene by, ``said`` a sentence."""

    looked = Signal(object)
    said = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWidgetResizable(True)
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._camera = Camera()
        self._radius = 1.0
        self._told: Callable[[], None] | None = None
        self.in_sight = InSight(self)
        self.in_sight.changed.connect(self._come_in_sight)
        self.triangles = SimilarTriangles()
        self.triangles.pointed.connect(lambda _point: self._tell())
        self.words, self.limit = _words(), _words()
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(0, _TICKS)
        self.slider.setAccessibleName(_("1/d, the centre of projection to infinity"))
        self.slider.setToolTip(_("At 0 the centre is at infinity, and the projection parallel"))
        self.slider.valueChanged.connect(self._recede)
        row = QHBoxLayout()
        row.setContentsMargins(12, 0, 12, 0)
        self.inverse = QLabel()
        row.addWidget(QLabel("1/d"))
        row.addWidget(self.slider, 1)
        row.addWidget(self.inverse)
        inner = QWidget()
        column = QVBoxLayout(inner)
        column.setContentsMargins(0, 0, 0, 8)
        column.setSpacing(2)
        column.addWidget(self.triangles)
        column.addWidget(self.words)
        column.addLayout(row)
        column.addWidget(self.limit)
        column.addStretch(1)
        self.setWidget(inner)

    def show_camera(self, camera: Camera, vertex: Vertex | None, radius: Callable[[], float]) -> None:
        """Derive the picture of a vertex; the scene reaches as far as ``radius`` tells from what the camera
        looks at. Out of sight this waits."""
        self._told = partial(self._show, camera, vertex, radius)
        if self.in_sight.now:
            self._told()

    def _come_in_sight(self, seen: bool) -> None:
        if seen and self._told is not None:
            self._told()

    def _show(self, camera: Camera, vertex: Vertex | None, radius: Callable[[], float]) -> None:
        self._camera, self._radius = camera, radius()
        try:
            point = in_view(camera, vertex)
        except ValueError as error:
            self.words.setText(reason_of(error))
            return
        if not self.slider.isSliderDown():
            central = camera.projection == "perspective"
            self._show_inverse(1.0 / camera.distance if central else 0.0)
        self.triangles.show_point(camera.distance, point or InView(1.0, 1.0, 2 * camera.distance))
        self._tell()

    def _show_inverse(self, inverse: float) -> None:
        self.slider.blockSignals(True)
        self.slider.setValue(round(min(inverse * self._radius, 1.0) * _TICKS))
        self.slider.blockSignals(False)

    def _recede(self, ticks: int) -> None:
        try:
            self.looked.emit(receding(self._camera, ticks / _TICKS / self._radius, self._radius))
        except ValueError as error:
            self.said.emit(reason_of(error))

    def _tell(self) -> None:
        camera, point = self._camera, self.triangles.point
        perspective = camera.projection == "perspective"
        lines = [*similar_lines(camera.distance, point)]
        try:
            central = is_central(camera)
            w = _w_now(camera, point)
        except ValueError as error:
            self.words.setText(reason_of(error))
            return
        if not perspective:
            now = (
                _(
                    "This is a matrix of your own, and its projectors meet at a point. The triangles here "
                    "are those of the perspective with $d = {d}$."
                )
                if central
                else _(
                    "The projectors are parallel now. The triangles here are those of the perspective with "
                    "$d = {d}$."
                )
            )
            lines.insert(0, now.format(d=displayed(camera.distance)))
        self.words.setText("<br>".join(map(rich, lines)))
        if perspective:
            self.inverse.setText(displayed(1.0 / camera.distance))
        else:
            self.inverse.setText("\N{EN DASH}" if central else "0")
        self.limit.setText("<br>".join(map(rich, (*limit_lines(camera.distance, point), w, *book(camera)))))


def _w_now(camera: Camera, point: InView) -> str:
    """What w is, as the camera projects a point now. Raises: ValueError where the matrix is no projection."""
    if camera.projection == "matrix":
        w = float(projection_matrix(camera)[3] @ [point.x, point.y, point.z, 1.0])
        return _("The last row of your matrix gives $w = {w}$ now.").format(w=displayed(w))
    # z from the plane, and d, make z from the eye
    w = point.z / camera.distance if camera.projection == "perspective" else 1.0
    return _("$w = 1 + z/d = {w}$ now.").format(w=displayed(w))


def book(camera: Camera) -> list[str]:
    """The camera in the names of Hearn and Baker, whose z points towards the viewer."""
    up, forward = view_matrix(camera)[1:3, :3]
    vrp = ", ".join(
        displayed(e + camera.distance * f) for e, f in zip(camera.eye.xyz, forward.tolist(), strict=True)
    )
    vpn, vup = (", ".join(map(displayed, axis)) for axis in ((-forward).tolist(), up.tolist()))
    return [
        _(
            "In the book: VRP ({vrp}), VPN ({vpn}), VUP ({vup}), PRP (0, 0, {d}); its z is the opposite "
            "of ours."
        ).format(vrp=vrp, vpn=vpn, vup=vup, d=displayed(camera.distance))
    ]


def rich(line: str) -> str:
    """A sentence with formulas between dollar signs as rich text."""
    parts = line.split("$")
    for k in range(1, len(parts), 2):
        parts[k] = re.sub(r"([a-z])_([a-z0-9]+)", r"\1<sub>\2</sub>", f"<i>{parts[k]}</i>")
    return "".join(parts)


def _words() -> QLabel:
    label = QLabel()
    label.setWordWrap(True)
    label.setContentsMargins(12, 2, 12, 2)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    return label
