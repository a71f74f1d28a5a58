"""A small cube over the picture that turns with it: click a side to look at it, a corner for isometric."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QEnterEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF, QTransform
from PySide6.QtWidgets import QWidget

from workbench.algorithms.projection import STANDARD_VIEWS, standard_view
from workbench.document.scene.looking import kinds
from workbench.document.scene.model import Camera
from workbench.document.scene.viewing import view_matrix
from workbench.geometry.meshes import Array
from workbench.language import _
from workbench.widgets.look.tokens import colour, theme, tokens

SIDE_PX = 74
_HALF_PX = 21.0
_CORNER_PX = 8.0
_WORD_PX = 64.0
_SEEN = 0.05
_ISOMETRIC = "isometric"
_TURNS = {name: standard_view(name)[:3, :3] for name in STANDARD_VIEWS}
"""Of each side the picture's right, up and forward, in the world."""
_SQUARE = np.array([(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)])


class ViewCube(QWidget):
    """``chosen`` sends the slug of the projection that was clicked: a side, or "isometric"."""

    chosen = Signal(str)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.resize(SIDE_PX, SIDE_PX)
        self.setMouseTracking(True)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setAccessibleName(_("View cube"))
        self.setToolTip(_("Click a side to look at it, a corner for the isometric view"))
        self._view: Array = standard_view("front")
        self._over = ""
        self._titles = {kind.slug: kind.title for kind in kinds()}
        theme.changed.connect(self.update)

    def show_camera(self, camera: Camera) -> None:
        """Turn as the world is seen by a camera; where that sees nothing it stays as it is."""
        try:
            view = view_matrix(camera)
        except ValueError:
            return
        if not np.array_equal(view[:3, :3], self._view[:3, :3]):
            self.update()
        self._view = view

    def sides(self) -> dict[str, Array]:
        """The corners (4, 2), logical pixels, of the sides that are seen, the upper left one first."""
        turn, seen = self._view[:3, :3], {}
        for name, own in _TURNS.items():
            if turn[2] @ own[2] > _SEEN:
                corners = (_SQUARE @ own[:2] - own[2]) @ turn.T
                seen[name] = self._on_widget(corners)
        return seen

    def _on_widget(self, points: Array) -> Array:
        flat: Array = SIDE_PX / 2 + points[:, :2] * (_HALF_PX, -_HALF_PX)
        return flat

    def at(self, place: QPointF) -> str:
        """The slug of what a click there chooses; empty beside the cube."""
        seen = self.sides()
        if len(seen) == 3:
            (near,) = self._on_widget(sum(self._towards(name) for name in seen)[None])  # type: ignore[index]
            if np.hypot(*(near - [place.x(), place.y()])) <= _CORNER_PX:
                return _ISOMETRIC
        for name, corners in seen.items():
            if _polygon(corners).containsPoint(place, Qt.FillRule.OddEvenFill):
                return name
        return ""

    def _towards(self, name: str) -> Array:
        """From the middle to a side, in view coordinates."""
        towards: Array = -self._view[:3, :3] @ _TURNS[name][2]
        return towards

    def paintEvent(self, event: QPaintEvent) -> None:
        """The sides that are seen, with their names, and the corner that means isometric."""
        now = tokens()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        seen = self.sides()
        for name, corners in seen.items():
            painter.setPen(QPen(colour(now.field_edge), 1))
            painter.setBrush(colour(now.selected if name == self._over else now.raised))
            painter.drawPolygon(_polygon(corners))
            self._word(painter, name, corners)
        if len(seen) == 3:
            (near,) = self._on_widget(sum(self._towards(name) for name in seen)[None])  # type: ignore[index]
            over = self._over == _ISOMETRIC
            painter.setPen(QPen(colour(now.accent if over else now.field_edge), 1.5))
            painter.setBrush(colour(now.accent if over else now.raised))
            painter.drawEllipse(QPointF(*near.tolist()), 3.5, 3.5)
        painter.end()

    def _word(self, painter: QPainter, name: str, corners: Array) -> None:
        """The name of a side, as if it were written on it."""
        square = QPolygonF(QRectF(0, 0, _WORD_PX, _WORD_PX))
        square.removeLast()
        onto = QTransform()
        if not QTransform.quadToQuad(square, _polygon(corners), onto):
            return
        painter.save()
        painter.setTransform(onto, True)
        font = painter.font()
        font.setPixelSize(18)
        painter.setFont(font)
        painter.setPen(colour(tokens().text))
        painter.drawText(QRectF(0, 0, _WORD_PX, _WORD_PX), Qt.AlignmentFlag.AlignCenter, self._titles[name])
        painter.restore()

    # The hand

    def _hover(self, over: str) -> None:
        if over != self._over:
            self._over = over
            title = self._titles.get(over, "")
            self.setToolTip(title or _("Click a side to look at it, a corner for the isometric view"))
            self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Show what a click would choose."""
        self._hover(self.at(event.position()))

    def enterEvent(self, event: QEnterEvent) -> None:
        """The same."""
        self._hover(self.at(event.position()))

    def leaveEvent(self, _event: object) -> None:
        """Nothing is pointed at."""
        self._hover("")

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Choose what is there; beside the cube the picture takes the press."""
        chosen = self.at(event.position()) if event.button() == Qt.MouseButton.LeftButton else ""
        if chosen:
            self.chosen.emit(chosen)
        else:
            event.ignore()


def _polygon(corners: Array) -> QPolygonF:
    return QPolygonF([QPointF(x, y) for x, y in corners.tolist()])
