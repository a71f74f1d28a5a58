"""The pixel canvas: a picture of cells that can be zoomed, panned, pointed at and drawn on.

It knows nothing of documents: it is given a picture and an overlay, and tells what the pointer and the keys
do in device coordinates (pixel centres at integers, y upwards).
"""

import math

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QAccessibleEvent,
    QCursor,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QNativeGestureEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QWidget

from workbench.geometry.conventions import round_half_up
from workbench.widgets.canvas.edge_scroll import EdgeScroll
from workbench.widgets.canvas.overlay import GRAB, Cell, Handle, handle_places
from workbench.widgets.canvas.surface import CanvasSurface
from workbench.widgets.look.plain_keys import is_plain

# Up to so far, in logical pixels, a press that trembles is a click, and drags nothing.
CLICK_SLACK = 3
# Handles no farther from each other, in logical pixels, cannot be told apart.
TOGETHER = 3
WHEEL_NOTCH = 120
ARROWS = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, 1),
    Qt.Key.Key_Down: (0, -1),
}


class PixelCanvas(CanvasSurface):
    """A picture of cells under grid, rulers, marks and handles.

    The left button sends ``pressed``, ``moved``, ``released`` (device coordinates, modifiers), or, when it
    came down on a handle, ``handle_pressed``, ``handle_dragged``, ``handle_released``; a press and release in
    place also sends ``cell_clicked``, and no move. The middle button pans. ``cancelled`` is Escape, ``arrow``
    an arrow key outside cursor mode (dx, dy, modifiers). In cursor mode (C) arrows move it and Enter acts as
    a click does.
    """

    pressed = Signal(float, float, object)
    moved = Signal(float, float, object)
    released = Signal(float, float, object)
    double_clicked = Signal(float, float, object)
    handle_pressed = Signal(str, object)
    handle_dragged = Signal(str, float, float)
    handle_released = Signal(str)
    cell_clicked = Signal(int, int)
    hovered = Signal(int, int)
    hover_left = Signal()
    cursor_moved = Signal(int, int)
    arrow = Signal(int, int, object)
    cancelled = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._grabbed: Handle | None = None
        self._grab_offset = (0.0, 0.0)
        self._press: QPointF | None = None
        self._in_place = True
        self._panning: QPoint | None = None
        self._wheel = 0
        self._last_hover: Cell | None = None
        self._shape = QCursor(Qt.CursorShape.ArrowCursor)
        self.takes_handles = True
        self.edge = EdgeScroll(self)

    @property
    def dragging(self) -> bool:
        """Whether the left button is down on the picture."""
        return self._press is not None

    def set_shape(self, shape: QCursor) -> None:
        """The pointer's shape over the picture, one for each tool."""
        self._shape = shape
        self.setCursor(shape)

    # The pointer

    def handle_at(self, position: QPointF) -> Handle | None:
        """The nearest handle whose grab area holds a position of the widget; of several together the one
        painted last."""
        handles = self._overlay.handles
        if not handles:
            return None
        places, cell = handle_places(handles), self._view.cell / self.devicePixelRatioF()
        away = np.abs(places - self.device_position(position)).max(axis=1)
        nearest = int(away.argmin())
        if away[nearest] * cell > GRAB / 2:
            return None
        together = np.abs(places - places[nearest]).max(axis=1) * cell <= TOGETHER
        return handles[int(np.flatnonzero(together)[-1])]

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Grab a handle, begin a gesture, or begin to pan."""
        if event.button() == Qt.MouseButton.MiddleButton:
            self._panning = event.position().toPoint()
            self.setCursor(Qt.CursorShape.ClosedHandCursor)
        elif event.button() == Qt.MouseButton.LeftButton:
            self._press, self._in_place = event.position(), True
            self._grabbed = self.handle_at(event.position()) if self.takes_handles else None
            x, y = self.device_position(event.position())
            if self._grabbed is not None:
                self._grab_offset = (self._grabbed.x - x, self._grabbed.y - y)
                self.handle_pressed.emit(self._grabbed.id, event.modifiers())
            else:
                self.pressed.emit(x, y, event.modifiers())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag, pan or hover."""
        self._pointer = event.position()
        if self._press is not None and (event.position() - self._press).manhattanLength() > CLICK_SLACK:
            self.edge.follow(event)
        x, y = self.device_position(event.position())
        if self._panning is not None:
            here, unit = event.position().toPoint(), self.devicePixelRatioF()
            step = here - self._panning
            self._panning = here
            self.pan(round(step.x() * unit), round(step.y() * unit))
        elif self._press is not None and self._stays_at(self._press, event.position()):
            self.hover_at(x, y)
        elif self._grabbed is not None:
            self.handle_dragged.emit(self._grabbed.id, x + self._grab_offset[0], y + self._grab_offset[1])
        else:
            self.hover_at(x, y)
            if self._press is None:
                over = self.takes_handles and self.handle_at(event.position()) is not None
                self.setCursor(QCursor(Qt.CursorShape.SizeAllCursor) if over else self._shape)
            self.moved.emit(x, y, event.modifiers())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End what the press began."""
        if event.button() == Qt.MouseButton.MiddleButton:
            self._panning = None
            self.setCursor(self._shape)
            return
        if event.button() != Qt.MouseButton.LeftButton or self._press is None:
            return
        self.edge.stop()
        press, grabbed = self._press, self._grabbed
        clicked = self._stays_at(press, event.position())
        self._press = self._grabbed = None
        x, y = self.device_position(press if clicked else event.position())
        if grabbed is not None:
            self.handle_released.emit(grabbed.id)
            self.hover_at(x, y)
        else:
            self.released.emit(x, y, event.modifiers())
        if clicked and self._holds(x, y):
            self.cell_clicked.emit(round_half_up(x), round_half_up(y))

    def _stays_at(self, press: QPointF, position: QPointF) -> bool:
        """Whether the pointer has been at the place of the press until now, but for a hand that trembles."""
        self._in_place = self._in_place and (position - press).manhattanLength() <= CLICK_SLACK
        return self._in_place

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """A second press, and a double click."""
        self.mousePressEvent(event)
        if event.button() == Qt.MouseButton.LeftButton:
            self.double_clicked.emit(*self.device_position(event.position()), event.modifiers())

    def _holds(self, x: float, y: float) -> bool:
        width, height = self._picture.size
        return 0 <= round_half_up(x) < width and 0 <= round_half_up(y) < height

    def hover_at(self, x: float, y: float) -> None:
        """The pointer is over a device point."""
        cell = (round_half_up(x), round_half_up(y)) if self._holds(x, y) else None
        if cell != self._hover:
            self._hover = cell
            if cell is None:
                self.hover_left.emit()
            else:
                self._last_hover = cell
                self.hovered.emit(*cell)
        self.repaint_soon()

    def leaveEvent(self, event: QEvent) -> None:
        """The pointer is elsewhere."""
        self.forget_hover()

    def forget_hover(self) -> None:
        """Nothing is pointed at any more."""
        if self._hover is not None:
            self._hover = None
            self.hover_left.emit()
            self.repaint_soon()

    def wheelEvent(self, event: QWheelEvent) -> None:
        """A wheel zooms at the pointer; with Shift it pans sideways; two fingers pan, with Ctrl they zoom."""
        control = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        shift = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        unit = self.devicePixelRatioF()
        fingers = event.pixelDelta()
        if not fingers.isNull() and not control:
            self.pan(round(fingers.x() * unit), round(fingers.y() * unit))
        elif shift:
            turn = event.angleDelta().y() or event.angleDelta().x()
            self.pan(round(turn * unit / 2), 0)
        else:
            self._wheel += event.angleDelta().y()
            steps = math.trunc(self._wheel / WHEEL_NOTCH)
            self._wheel -= steps * WHEEL_NOTCH
            if steps:
                self.zoom(steps, event.position())
        event.accept()

    def event(self, event: QEvent) -> bool:
        """Pinching zooms at the pointer."""
        if isinstance(event, QNativeGestureEvent) and (
            event.gestureType() == Qt.NativeGestureType.ZoomNativeGesture
        ):
            x, y = self._screen(event.position())
            self._show(self._view.pinched(1 + event.value(), x, y, self._least_cell))
            return True
        return super().event(event)

    # The keys

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Zoom, cursor mode, arrows."""
        key, modifiers = event.key(), event.modifiers()
        if key in ARROWS:
            dx, dy = ARROWS[Qt.Key(key)]
            if self._cursor is None:
                self.arrow.emit(dx, dy, modifiers)
            else:
                far = 10 if modifiers & Qt.KeyboardModifier.ShiftModifier else 1
                self._move_cursor(self._cursor[0] + far * dx, self._cursor[1] + far * dy)
        elif key == Qt.Key.Key_C and modifiers == Qt.KeyboardModifier.NoModifier:
            self._toggle_cursor()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self._cursor is not None:
            x, y = self._cursor
            self.pressed.emit(float(x), float(y), modifiers)
            self.released.emit(float(x), float(y), modifiers)
            self.cell_clicked.emit(x, y)
        elif key == Qt.Key.Key_Escape:
            if self._cursor is not None:
                self._toggle_cursor()
            self.cancelled.emit()
        elif is_plain(event) and key in (Qt.Key.Key_Plus, Qt.Key.Key_Equal):
            self.zoom(1)
        elif is_plain(event) and key == Qt.Key.Key_Minus:
            self.zoom(-1)
        else:
            super().keyPressEvent(event)

    @property
    def cursor_cell(self) -> Cell | None:
        """Where the keyboard's cursor is; None outside cursor mode."""
        return self._cursor

    @property
    def pointed_cell(self) -> Cell | None:
        """The cell of the keyboard's cursor, or else the one that the pointer is over or was over last."""
        return self._cursor or self._hover or self._last_hover

    def _toggle_cursor(self) -> None:
        if self._cursor is not None:
            self._cursor = None
            self.setAccessibleDescription("")
            self.repaint_soon()
            return
        width, height = self._picture.size
        self._move_cursor(*(self._hover or (width // 2, height // 2)))

    def _move_cursor(self, x: int, y: int) -> None:
        self._cursor = self._inside(x, y)
        self._bring_into_view(self._cursor)
        self.moved.emit(float(self._cursor[0]), float(self._cursor[1]), Qt.KeyboardModifier.NoModifier)
        self.cursor_moved.emit(*self._cursor)
        said = self._describe(*self._cursor) if self._describe else f"({self._cursor[0]}, {self._cursor[1]})"
        self.setAccessibleDescription(said)
        QAccessible.updateAccessibility(QAccessibleEvent(self, QAccessible.Event.DescriptionChanged))
        self.repaint_soon()

    def focusInEvent(self, event: QFocusEvent) -> None:
        """The focus ring appears."""
        super().focusInEvent(event)
        self.repaint_soon()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The focus ring goes."""
        super().focusOutEvent(event)
        self.repaint_soon()
