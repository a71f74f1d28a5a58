"""A view of a scene under the hand: dragged to turn or shift it, zoomed at the pointer, led by keys."""

import numpy as np
from PySide6.QtCore import QLineF, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QWheelEvent
from PySide6.QtWidgets import QWidget

from workbench.panels.space.scene_picture import ScenePicture
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import colour, tokens

SLACK_PX = 3.0
REACH_PX = 12.0
TURN_PER_PX = 0.01
TURN_PER_KEY = np.radians(5.0)
_SHIFT_PER_KEY_PX = 24.0
_ZOOM_PER_NOTCH = 1.2
_CURSOR_STEP_PX, _CURSOR_PX = 6.0, 9.0
_SIDES = {
    Qt.Key.Key_1: ("front", "back"),
    Qt.Key.Key_3: ("right", "left"),
    Qt.Key.Key_7: ("top", "bottom"),
}
_ARROWS = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, 1),
    Qt.Key.Key_Down: (0, -1),
}


class SceneView(ScenePicture):
    """``dragging`` tells whether it is being turned or a mark of it moved, ``cursor_at`` where the cursor of
    the keyboard is.

    ``turn_began`` sends where a drag begins that turns it, ``turned`` by how much (theta, phi), radians,
    ``turn_ended`` follows a drag; ``faced`` the side to look at, ``switched`` that perspective and parallel
    are to be exchanged; ``clicked``, ``hovered`` and ``framed`` (a double click) where.
    """

    turn_began = Signal(QPointF)
    turned = Signal(float, float)
    turn_ended = Signal()
    faced = Signal(str)
    switched = Signal()
    clicked = Signal(QPointF)
    hovered = Signal(QPointF)
    framed = Signal(QPointF)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMouseTracking(True)
        self._press: QPointF | None = None
        self._last = QPointF()
        self._moving = False
        self._grip: object | None = None
        self.cursor_at: QPointF | None = None

    # The hand

    def grip_at(self, position: QPointF) -> object | None:
        """What there is to take hold of at a place."""
        return None

    def drag_grip(self, grip: object, position: QPointF, modifiers: Qt.KeyboardModifier) -> None:
        """Move what is held."""

    def release_grip(self, grip: object) -> None:
        """Let go of it."""

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of a mark, or of the scene."""
        if event.button() in (Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton):
            self._press = self._last = event.position()
            self._moving = event.button() == Qt.MouseButton.MiddleButton
            left = event.button() == Qt.MouseButton.LeftButton
            self._grip = self.grip_at(event.position()) if left else None

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Turn, shift, or move the mark that is held."""
        position = event.position()
        if self._press is None:
            self.hovered.emit(position)
            held = self.grip_at(position)
            self.setCursor(Qt.CursorShape.ArrowCursor if held is None else Qt.CursorShape.OpenHandCursor)
            return
        if not self._moving and (position - self._press).manhattanLength() <= SLACK_PX:
            return
        if not self.dragging and self._grip is None:
            self.turn_began.emit(self._press)
        self._moving = self.dragging = True
        delta, self._last = position - self._last, position
        if self._grip is not None:
            self.drag_grip(self._grip, position, event.modifiers())
        elif event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self.pan(delta.x(), delta.y())
        else:
            self.turned.emit(-delta.x() * TURN_PER_PX, delta.y() * TURN_PER_PX)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go, or click."""
        if self._press is None:
            return
        grip, self._grip, self._press = self._grip, None, None
        self.dragging = False
        if grip is not None and self._moving:
            self.release_grip(grip)
        elif self._moving:
            self.turn_ended.emit()
        elif event.button() == Qt.MouseButton.LeftButton:
            self.clicked.emit(event.position())

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Frame what is there."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.framed.emit(event.position())

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom at the pointer."""
        notches = event.angleDelta().y() / 120
        if notches:
            self.zoom(_ZOOM_PER_NOTCH**notches, event.position())
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """1 3 7 look from a side (Ctrl: the opposite one), 5 exchanges the projections, Shift+arrows turn.

        Ctrl+arrows move the cursor, Enter clicks there.
        """
        key, held = event.key(), event.modifiers()
        shift, control = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier
        alone = is_plain(event)
        if key in _SIDES and (alone or held == control):
            self.faced.emit(_SIDES[Qt.Key(key)][bool(held & control)])
        elif key == Qt.Key.Key_5 and alone:
            self.switched.emit()
        elif key in _ARROWS and held & shift and held & control:
            x, y = _ARROWS[Qt.Key(key)]
            self.pan(x * _SHIFT_PER_KEY_PX, -y * _SHIFT_PER_KEY_PX)
        elif key in _ARROWS and held & shift:
            x, y = _ARROWS[Qt.Key(key)]
            self.turned.emit(x * TURN_PER_KEY, y * TURN_PER_KEY)
            self.turn_ended.emit()
        elif key in _ARROWS and held & control:
            self._move_cursor(*_ARROWS[Qt.Key(key)])
        elif alone and key in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.cursor_at is not None:
            self.clicked.emit(self.cursor_at)
        elif alone and key in (Qt.Key.Key_Plus, Qt.Key.Key_Minus):
            self.zoom(_ZOOM_PER_NOTCH if key == Qt.Key.Key_Plus else 1 / _ZOOM_PER_NOTCH)
        else:
            super().keyPressEvent(event)

    def _move_cursor(self, right: int, up: int) -> None:
        """From the middle on, within the widget; what is there is told as of the pointer."""
        at = self.cursor_at or QPointF(self.rect().center())
        x = min(max(at.x() + right * _CURSOR_STEP_PX, 0.0), self.width() - 1.0)
        y = min(max(at.y() - up * _CURSOR_STEP_PX, 0.0), self.height() - 1.0)
        self.cursor_at = QPointF(x, y)
        self.hovered.emit(self.cursor_at)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """The cursor of the keyboard over the picture."""
        super().paintEvent(event)
        if self.cursor_at is None or not self.hasFocus():
            return
        painter, (x, y) = QPainter(self), self.cursor_at.toTuple()
        for ink, width in ((tokens().canvas, 4.0), (tokens().text, 1.6)):
            painter.setPen(QPen(colour(ink), width))
            painter.drawLine(QLineF(x - _CURSOR_PX, y, x + _CURSOR_PX, y))
            painter.drawLine(QLineF(x, y - _CURSOR_PX, x, y + _CURSOR_PX))
        painter.end()
