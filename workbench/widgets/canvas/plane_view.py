"""A plane to look at and to take hold of: its grips, its ground, the wheel and the arrow keys."""

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QEvent, QPointF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFocusEvent,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.widgets.canvas.handle_names import paint_label, tag_box
from workbench.widgets.canvas.overlay import GRAB
from workbench.widgets.canvas.painter import Scene
from workbench.widgets.canvas.plane import GRID_PX, Plane, grid_step, paint_plane, scene_of
from workbench.widgets.canvas.view import Area
from workbench.widgets.look.tokens import theme_changed, tokens

_NOTCH = 120.0
_ARROWS = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, 1),
    Qt.Key.Key_Down: (0, -1),
}

Modifiers = Qt.KeyboardModifier


class PlaneView(QWidget):
    """Places are sent in the coordinates of the plane, while the scale stays as it was at the press.

    ``pressed`` sends the grip under the pointer too, or "", ``moved`` and ``released`` follow; ``hovered``
    comes without a button. ``turned`` sends notches of the wheel, ``arrow`` steps right and up with the keys
    held, ``cancelled`` is Escape.
    """

    pressed = Signal(float, float, str)
    moved = Signal(float, float)
    released = Signal(float, float)
    hovered = Signal(float, float)
    hover_left = Signal()
    turned = Signal(float, float, float)
    arrow = Signal(int, int, Modifiers)
    cancelled = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(120, 90)
        self._plane = Plane()
        self._held = False
        self._tag = ""
        self._pointer = QPointF()
        self.shape_at: Callable[[float, float, str], Qt.CursorShape] | None = None
        theme_changed.connect(self.update)

    @property
    def plane(self) -> Plane:
        """What is shown."""
        return self._plane

    def set_plane(self, plane: Plane) -> None:
        """Show something else; while it is held the same part of it stays in sight."""
        if self._held:
            plane = replace(plane, box=self._plane.box)
        self._plane = plane
        self.update()

    def set_tag(self, text: str) -> None:
        """Words beside the pointer; empty for none."""
        if text != self._tag:
            self._tag = text
            self.update()

    def sizeHint(self) -> QSize:
        """Room enough to be useful."""
        return QSize(320, 240)

    # Places

    def scene(self) -> Scene:
        """What is painted now."""
        unit = self.devicePixelRatioF()
        area = Area(0, 0, round(self.width() * unit), round(self.height() * unit))
        return scene_of(self._plane, area, tokens(), unit, self.font(), small=False)

    def place(self, position: QPointF) -> tuple[float, float]:
        """The point of the plane under a position of the widget, logical pixels."""
        unit = self.devicePixelRatioF()
        return self.scene().view.to_device(position.x() * unit, position.y() * unit)

    def position(self, x: float, y: float) -> QPointF:
        """Where in the widget a point of the plane lies, logical pixels."""
        unit = self.devicePixelRatioF()
        screen_x, screen_y = self.scene().view.to_screen(x, y)
        return QPointF(screen_x / unit, screen_y / unit)

    @property
    def grid(self) -> float:
        """The distance of two grid lines."""
        unit = self.devicePixelRatioF()
        return grid_step(self.scene().view.cell, GRID_PX * unit)

    @property
    def unit(self) -> float:
        """How long one logical pixel is, in the plane."""
        return self.devicePixelRatioF() / self.scene().view.cell

    @property
    def reach(self) -> float:
        """How far from a line it can be taken hold of, in the plane."""
        return GRAB / 4 * self.unit

    def grip_at(self, position: QPointF) -> str:
        """The grip under a position of the widget; the last of several, since it lies on top."""
        nearest, grip = GRAB / 2, ""
        for handle in self._plane.handles:
            away = self.position(handle.x, handle.y) - position
            distance = max(abs(away.x()), abs(away.y()))
            if distance <= nearest:
                nearest, grip = distance, handle.id
        return grip

    # The pointer and the keys

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._held = True
            self.pressed.emit(*self.place(event.position()), self.grip_at(event.position()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag, or look around."""
        self._pointer = event.position()
        at = self.place(event.position())
        if self._held:
            self.moved.emit(*at)
            return
        if self.shape_at is not None:
            self.setCursor(self.shape_at(*at, self.grip_at(event.position())))
        self.hovered.emit(*at)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        if event.button() == Qt.MouseButton.LeftButton and self._held:
            at = self.place(event.position())
            self._held = False
            self.released.emit(*at)

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is pointed at."""
        self.hover_left.emit()

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Nearer or farther, about the pointer."""
        self.turned.emit(event.angleDelta().y() / _NOTCH, *self.place(event.position()))
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows and Escape."""
        key = Qt.Key(event.key())
        if key in _ARROWS:
            self.arrow.emit(*_ARROWS[key], event.modifiers())
        elif key == Qt.Key.Key_Escape:
            self._held = False
            self.cancelled.emit()
        else:
            super().keyPressEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        """The ring comes."""
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """The ring goes."""
        super().focusOutEvent(event)
        self.update()

    # Painting

    def paintEvent(self, event: QPaintEvent) -> None:
        """The plane, words beside the pointer, the ring of the focus."""
        painter = QPainter(self)
        unit = self.devicePixelRatioF()
        painter.scale(1 / unit, 1 / unit)
        scene = self.scene()
        paint_plane(painter, self._plane, scene, small=False)
        if self._tag:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
            at = self._pointer.x() * unit, self._pointer.y() * unit
            paint_label(painter, self._tag, tag_box(self._tag, *at, scene), scene)
        if self.hasFocus():
            painter.setPen(QPen(QColor(tokens().accent), 2 * unit))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            area = scene.area
            painter.drawRect(
                round(unit), round(unit), area.width - round(2 * unit), area.height - round(2 * unit)
            )
        painter.end()

    def grab_picture(self) -> QImage:
        """What is shown, without ring and words."""
        unit = self.devicePixelRatioF()
        image = QImage(round(self.width() * unit), round(self.height() * unit), QImage.Format.Format_RGB32)
        painter = QPainter(image)
        paint_plane(painter, self._plane, self.scene(), small=False)
        painter.end()
        return image
