"""A colour solid that can be turned, with a colour as a point in it.

The far side is painted in full, the near one thinly over the point, so that it is seen inside.
"""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QPolygonF,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.language import _
from workbench.widgets.canvas.pixel_canvas import ARROWS
from workbench.widgets.colour.solids import Floats, Model, Triple, solid, turned
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import CAPTION_PX, colour, theme, tokens
from workbench.widgets.look.type_faces import scaled

_PER_PX = 0.6  # degrees
_STEP, _FAR = 5.0, 30.0
_STEEPEST = 89.0
_NEAR_SIDE = 0.32
_SPAN = 1.85
"""The solid with its letters is never wider than this."""

_SPOT_PX = 11.0


def titles(model: Model) -> tuple[str, str]:
    """What a solid is called, and what it shows."""
    return {
        "rgb": (_("RGB cube"), _("Light: black at the origin, red, green and blue are added")),
        "cmy": (_("CMY cube"), _("Ink: white at the origin, cyan, magenta and yellow take light away")),
        "hsv": (_("HSV hexcone"), _("Hue around the axis, saturation away from it, value upwards")),
    }[model]


class SolidView(QWidget):
    """``turned`` tells that it was turned by hand."""

    turned = Signal()

    def __init__(self, model: Model, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.model = model
        self._solid = solid(model)
        self._colour: Triple = (0.0, 0.0, 0.0)
        self.turn, self.tilt = 35.0, 24.0
        self._at: QPointF | None = None
        self._sides: tuple[QPixmap, QPixmap] | None = None
        title, meaning = titles(model)
        self.setAccessibleName(title)
        self.setToolTip(_("{meaning}. Drag or press the arrows to turn it.").format(meaning=meaning))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(110, 110)
        theme.changed.connect(self._forget)

    def sizeHint(self) -> QSize:
        """One of three beside each other."""
        return QSize(240, 240)

    def show_colour(self, rgb: Triple, words: str) -> None:
        """Mark a colour, coded 0 to 1; ``words`` are its coordinates."""
        self._colour = rgb
        self.setAccessibleDescription(words)
        self.update()

    def look_from(self, turn: float, tilt: float) -> None:
        """Look at it from a direction, in degrees."""
        self.turn, self.tilt = turn % 360.0, min(max(tilt, -_STEEPEST), _STEEPEST)
        self._forget()

    def _forget(self) -> None:
        self._sides = None
        self.update()

    # The hand

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of it."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._at = event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Turn it under the pointer."""
        if self._at is None:
            return
        way, self._at = event.position() - self._at, event.position()
        self.look_from(self.turn + _PER_PX * way.x(), self.tilt + _PER_PX * way.y())
        self.turned.emit()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let it go."""
        self._at = None

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows turn it, with Shift further."""
        if event.key() not in ARROWS or not is_plain(event):
            super().keyPressEvent(event)
            return
        dx, dy = ARROWS[Qt.Key(event.key())]
        step = _FAR if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else _STEP
        self.look_from(self.turn + step * dx, self.tilt + step * dy)
        self.turned.emit()

    # Painting

    @property
    def _scale(self) -> float:
        return min(self.width(), self.height()) / _SPAN

    def _to_widget(self, places: Floats) -> Floats:
        seen = turned(places, self.turn, self.tilt)
        x = self.width() / 2 + seen[..., 0] * self._scale
        y = self.height() / 2 - seen[..., 1] * self._scale
        return np.stack([x, y], axis=-1)

    def place_of(self, rgb: Triple) -> QPointF:
        """Where a colour is painted, in logical pixels of the widget."""
        return QPointF(*self._to_widget(np.array(self._solid.place_of(rgb))).tolist())

    def _paint_sides(self) -> tuple[QPixmap, QPixmap]:
        """The cells whose outside is turned away, and those that face the eye."""
        flat = self._to_widget(self._solid.cells)
        across, along = flat[:, 2] - flat[:, 0], flat[:, 3] - flat[:, 1]
        # The widget's y runs downwards, so that what is anticlockwise from outside turns the other way
        facing = across[:, 0] * along[:, 1] - across[:, 1] * along[:, 0] < 0.0
        ratio, sides = self.devicePixelRatioF(), []
        for side in (~facing, facing):
            pixmap = QPixmap(self.size() * ratio)
            pixmap.setDevicePixelRatio(ratio)
            pixmap.fill(Qt.GlobalColor.transparent)
            painter = QPainter(pixmap)
            painter.setPen(Qt.PenStyle.NoPen)
            for cell, shade in zip(flat[side].tolist(), self._solid.colours[side].tolist(), strict=True):
                painter.setBrush(QColor.fromRgbF(*shade))
                painter.drawConvexPolygon(QPolygonF([QPointF(x, y) for x, y in cell]))
            painter.end()
            sides.append(pixmap)
        return sides[0], sides[1]

    def resizeEvent(self, event: object) -> None:
        """Paint it anew for this size."""
        self._forget()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Far side, axes, the way to the colour, near side."""
        painter = QPainter(self)
        painter.fillRect(event.rect(), colour(tokens().surface))
        if self._sides is None:
            self._sides = self._paint_sides()
        far, near = self._sides
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.drawPixmap(0, 0, far)
        self._paint_axes(painter, lettered=False)
        painter.setOpacity(_NEAR_SIDE)
        painter.drawPixmap(0, 0, near)
        painter.setOpacity(1.0)
        self._paint_axes(painter, lettered=True)
        self._paint_colour(painter)
        if self.hasFocus():
            painter.setPen(QPen(colour(tokens().accent), 2))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(QRectF(self.rect()).adjusted(1, 1, -1, -1))
        painter.end()

    def _paint_axes(self, painter: QPainter, lettered: bool) -> None:
        """The axes, or the letters at their ends, which nothing covers."""
        font = QFont(painter.font())
        font.setPixelSize(scaled(CAPTION_PX))
        font.setBold(True)
        painter.setFont(font)
        for start, end, letter in self._solid.axes:
            a, b = (QPointF(*place) for place in self._to_widget(np.array([start, end])).tolist())
            painter.setPen(QPen(colour(tokens().text), 1.2))
            if not lettered:
                painter.drawLine(a, b)
                continue
            beyond = b + (b - a) * (10.0 / max((b - a).manhattanLength(), 10.0))
            x = min(max(beyond.x(), 7.0), self.width() - 7.0)
            y = min(max(beyond.y(), 8.0), self.height() - 8.0)
            box = QRectF(x - 7, y - 8, 14, 16)
            painter.fillRect(box, colour(tokens().surface))
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, letter)

    def _paint_colour(self, painter: QPainter) -> None:
        way = [QPointF(*place) for place in self._to_widget(self._solid.lines_to(self._colour)).tolist()]
        for pen in (QPen(colour(tokens().surface), 3.5), QPen(colour(tokens().text), 1.4)):
            painter.setPen(pen)
            painter.drawPolyline(QPolygonF(way))
        painter.setBrush(QColor.fromRgbF(*self._colour))
        for pen in (QPen(colour(tokens().canvas), 5), QPen(colour(tokens().text), 2)):
            painter.setPen(pen)
            painter.drawEllipse(way[-1], _SPOT_PX / 2, _SPOT_PX / 2)
