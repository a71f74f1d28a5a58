"""An object in space with its axes, as it was made, at a stage, and transformed; dragging looks round it."""

import itertools
import math

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QFont, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.language import _
from workbench.panels.transform.space_scene import Points, SpaceScene, seen_from
from workbench.panels.transform.told import space_text
from workbench.widgets.canvas.drawing import PATTERNS, ink_of
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import colour, theme, tokens

_ANGLE_Y, _ANGLE_X = -32.0, 22.0
_STEEPEST = 89.0
_DEGREES_A_PX, _KEY_DEGREES = 0.4, 5.0
_MARGIN_PX = 36.0
_AXIS_BEYOND = 1.6
_DOT_PX = 7.0
_AXIS_INK = "data4"
_LEGEND_PX, _SAMPLE_PX = 12.0, 26.0


class SpaceView(QWidget):
    """``next_wanted`` asks for the next vertex."""

    next_wanted = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._scene: SpaceScene | None = None
        self._angle_y, self._angle_x = _ANGLE_Y, _ANGLE_X
        self._from: QPointF | None = None
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(200, 120)
        self.setToolTip(
            _("Drag to look around the object; arrows turn the view, Enter follows the next vertex")
        )
        self.setCursor(Qt.CursorShape.OpenHandCursor)
        theme.changed.connect(self.update)

    def show_scene(self, scene: SpaceScene | None) -> None:
        """Show another object, or another stage of it."""
        self._scene = scene
        self.setAccessibleName(_("The object in space"))
        if scene is not None:
            places = space_text(*scene.way[0].tolist()), space_text(*scene.way[-1].tolist())
            self.setAccessibleDescription(
                _("The vertex P is drawn at {start} and is now at {now}.").format(
                    start=places[0], now=places[1]
                )
            )
        self.update()

    @property
    def angles(self) -> tuple[float, float]:
        """From where it is seen: degrees about y, and about x."""
        return self._angle_y, self._angle_x

    def turn(self, about_y: float, about_x: float) -> None:
        """Look from elsewhere, degrees."""
        self._angle_y = math.remainder(self._angle_y + about_y, 360.0)
        self._angle_x = min(max(self._angle_x + about_x, -_STEEPEST), _STEEPEST)
        self.update()

    # Where things are

    def _reach(self) -> float:
        """How long the axes are, world: as far as anything is from the planes of the frame."""
        scene = self._scene
        return 1.0 if scene is None else float(np.abs(scene.every).max()) or 1.0

    def positions(self, places: Points) -> Points:
        """Where places (n, 3) of the world lie in the widget, (n, 2); every stage has room there."""
        flat = seen_from(*self.angles)[:2, :3].T
        axes = self._reach() * np.vstack([np.zeros(3), np.eye(3)])
        parts = [axes] if self._scene is None else [axes, self._scene.every]
        shown = np.concatenate(parts) @ flat
        low, high = shown.min(axis=0), shown.max(axis=0)
        margin = min(_MARGIN_PX, self.height() / 9)
        room = np.maximum(np.array([self.width(), self.height()]) - 2 * margin, 20.0)
        unit = float((room / np.maximum(high - low, 1e-9)).min())
        middle = np.array([self.width(), self.height()]) / 2
        away: Points = (places @ flat - (low + high) / 2) * (unit, -unit)
        return away + middle

    # Looking round

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of space."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._from = event.position()
            self.setCursor(Qt.CursorShape.ClosedHandCursor)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Turn it with the hand."""
        if self._from is not None:
            way = event.position() - self._from
            self._from = event.position()
            self.turn(_DEGREES_A_PX * way.x(), _DEGREES_A_PX * way.y())

    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        """Let go."""
        self._from = None
        self.setCursor(Qt.CursorShape.OpenHandCursor)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows look from elsewhere, Enter goes to the next vertex."""
        ways = {
            Qt.Key.Key_Left: (-1, 0),
            Qt.Key.Key_Right: (1, 0),
            Qt.Key.Key_Up: (0, -1),
            Qt.Key.Key_Down: (0, 1),
        }
        if not is_plain(event):
            super().keyPressEvent(event)
        elif event.key() in ways:
            self.turn(*(_KEY_DEGREES * way for way in ways[Qt.Key(event.key())]))
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.next_wanted.emit()
        else:
            super().keyPressEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        """The ring of the focus."""
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The ring of the focus."""
        super().focusOutEvent(event)
        self.update()

    # Painting

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Axes, the object thrice, the axis of the turn, the way of the vertex."""
        now, painter = tokens(), QPainter(self)
        painter.fillRect(self.rect(), QColor(now.canvas))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        scene = self._scene
        self._paint_axes(painter)
        if scene is not None:
            self._edges(painter, scene, scene.made, "muted", 1.25, "solid")
            if scene.axis is not None:
                self._paint_turn(painter, scene.axis)
            if scene.stage is not None:
                self._edges(painter, scene, scene.stage, "data2", 1.75, "dash")
            self._edges(painter, scene, scene.image, "data1", 2.25, "solid")
            self._paint_way(painter, scene)
            self._paint_legend(painter, scene)
        if self.hasFocus():
            painter.setPen(QPen(QColor(now.accent), 2))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(self.rect().adjusted(1, 1, -1, -1))
        painter.end()

    def _paint_axes(self, painter: QPainter) -> None:
        ends = self.positions(self._reach() * np.vstack([np.zeros(3), np.eye(3)]))
        painter.setPen(QPen(QColor(tokens().muted), 1.25))
        for k, name in enumerate("xyz", 1):
            painter.drawLine(QPointF(*ends[0]), QPointF(*ends[k]))
            painter.drawText(QPointF(ends[k, 0] + 5, ends[k, 1] - 4), name)

    def _edges(
        self, painter: QPainter, scene: SpaceScene, places: Points, ink: str, width: float, pattern: str
    ) -> None:
        at = self.positions(places)
        painter.setPen(QPen(QColor(ink_of(tokens(), ink)), width, PATTERNS[pattern]))
        for a, b in scene.edges.tolist():
            painter.drawLine(QPointF(*at[a]), QPointF(*at[b]))

    def _paint_turn(self, painter: QPainter, axis: Points) -> None:
        """The axis of the rotation where this stage has it, beyond both its places."""
        ends = self.positions(axis[:1] + np.outer([-_AXIS_BEYOND, 0.0, 1.0, _AXIS_BEYOND], axis[1] - axis[0]))
        ink = QColor(ink_of(tokens(), _AXIS_INK))
        painter.setPen(QPen(ink, 2, PATTERNS["dash"]))
        painter.drawLine(QPointF(*ends[0]), QPointF(*ends[3]))
        painter.setPen(QPen(ink, 2))
        painter.setBrush(QColor(tokens().canvas))
        for place, name in ((ends[1], "P₁"), (ends[2], "P₂")):
            painter.drawEllipse(QPointF(*place), _DOT_PX / 2, _DOT_PX / 2)
            painter.drawText(QPointF(place[0] + 7, place[1] + 12), name)

    def _paint_legend(self, painter: QPainter, scene: SpaceScene) -> None:
        """Which line is what, in the corner."""
        rows = [("muted", "solid", _("as it was made")), ("data1", "solid", _("after the whole chain"))]
        if scene.stage is not None:
            rows.insert(1, ("data2", "dash", _("after this step")))
        if scene.axis is not None:
            rows.append((_AXIS_INK, "dash", _("the axis at this step")))
        painter.setFont(self.font())
        high = painter.fontMetrics().height() + 4
        for number, (ink, pattern, words) in enumerate(rows):
            y = _LEGEND_PX + high * (number + 0.5)
            painter.setPen(QPen(QColor(ink_of(tokens(), ink)), 2, PATTERNS[pattern]))
            painter.drawLine(QPointF(_LEGEND_PX, y), QPointF(_LEGEND_PX + _SAMPLE_PX, y))
            painter.setPen(QColor(tokens().muted))
            painter.drawText(
                QPointF(_LEGEND_PX + _SAMPLE_PX + 8, y + painter.fontMetrics().ascent() / 2 - 1), words
            )

    def _paint_way(self, painter: QPainter, scene: SpaceScene) -> None:
        now, at = tokens(), self.positions(scene.way)
        painter.setPen(QPen(QColor(now.text), 1.25))
        for a, b in itertools.pairwise(at):
            painter.drawLine(QPointF(*a), QPointF(*b))
        left = 1 if at[0, 0] <= at[-1, 0] else -1
        low = 1 if at[0, 1] >= at[-1, 1] else -1
        self._paint_vertex(painter, at[0], scene.way[0], "muted", -left, low)
        if len(at) > 1:
            self._paint_vertex(painter, at[-1], scene.way[-1], "text", left, -low)

    def _paint_vertex(
        self, painter: QPainter, at: Points, where: Points, role: str, right: int, down: int
    ) -> None:
        """A dot, and at that side of it the place in the world."""
        now, ink = tokens(), QColor(getattr(tokens(), role))
        painter.setPen(QPen(QColor(now.canvas), 2))
        painter.setBrush(ink)
        painter.drawEllipse(QPointF(*at), _DOT_PX / 2 + 1, _DOT_PX / 2 + 1)
        font = QFont(self.font())
        font.setBold(role == "text")
        painter.setFont(font)
        name = "P′" if role == "text" else "P"
        text, metrics = f"{name} {space_text(*where.tolist())}", painter.fontMetrics()
        wide, high = metrics.horizontalAdvance(text), metrics.height()
        box = QRectF(0, 0, wide + 8, high + 2)
        box.moveCenter(QPointF(at[0] + right * (wide / 2 + 14), at[1] + down * (high / 2 + 7)))
        box.moveLeft(min(max(box.left(), 2.0), self.width() - box.width() - 2.0))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour(now.canvas, 210))
        painter.drawRoundedRect(box, 4, 4)
        painter.setPen(ink)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
