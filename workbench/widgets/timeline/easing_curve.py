"""The curve of an easing, with the handles of the Bézier curve that fits it, to drag.

An editor, so it paints itself.
"""

from collections.abc import Callable

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import colour, theme_changed, tokens

Handles = tuple[float, float, float, float]
_SAMPLES = 64
_GRAB_PX = 14
_ROOM = 0.35
_NUDGE = 0.02


def stays_between() -> str:
    """Why a handle goes no farther in time."""
    return _("The handle stays between its two keys: beyond them the easing would go back in time.")


class EasingCurve(QWidget):
    """The part of the way over the part of the time. ``handles_dragged`` sends x1, y1, x2, y2 as a hand
    wants them, ``handles_dropped`` that it let go, ``handles_put_back`` that all is wanted as before,
    ``said`` why one goes no farther; what is shown changes only by ``show_easing``.
    """

    handles_dragged = Signal(float, float, float, float)
    handles_dropped = Signal()
    handles_put_back = Signal()
    said = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._ease: Callable[[float], float] = lambda t: t
        self._handles: Handles | None = None
        self._at: float | None = None
        self._held = -1
        self._chosen = 0
        self.setAccessibleName(_("Easing curve"))
        self.setToolTip(
            _("Drag a handle to shape the easing; arrows move it by a little, Page Up chooses the other one")
        )
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(140, 110)
        theme_changed.connect(self.update)

    def show_easing(self, ease: Callable[[float], float], handles: Handles | None, at: float | None) -> None:
        """Show an easing, its handles where it has some, and the part of the time that is shown."""
        self._ease, self._handles, self._at = ease, handles, at
        if at is not None:
            self.setAccessibleDescription(_("t = {t:.4g} becomes {part:.4g}").format(t=at, part=ease(at)))
        self.update()

    @property
    def handles(self) -> Handles | None:
        """The handles shown."""
        return self._handles

    def sizeHint(self) -> QSize:
        """A square."""
        return QSize(190, 130)

    @property
    def _area(self) -> QRectF:
        side = min(self.width() - 48.0, (self.height() - 24.0) / (1 + 2 * _ROOM) * 1.35)
        side = max(min(side, self.height() - 40.0), 60.0)
        return QRectF((self.width() - side) / 2, (self.height() - side) / 2, side, side)

    def place(self, t: float, part: float) -> QPointF:
        """Where a point of the curve is painted."""
        area = self._area
        return QPointF(area.left() + t * area.width(), area.bottom() - part * area.height())

    def _handle_places(self) -> list[QPointF]:
        if self._handles is None:
            return []
        x1, y1, x2, y2 = self._handles
        return [self.place(x1, y1), self.place(x2, y2)]

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Frame, straight line, curve, handles, and the point of now."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        now, area = tokens(), self._area
        painter.fillRect(area, colour(now.canvas))
        painter.setPen(colour(now.grid))
        for quarter in range(5):
            share = quarter / 4
            painter.drawLine(self.place(share, 0.0), self.place(share, 1.0))
            painter.drawLine(self.place(0.0, share), self.place(1.0, share))
        painter.setPen(QPen(colour(now.muted), 1, Qt.PenStyle.DashLine))
        painter.drawLine(self.place(0.0, 0.0), self.place(1.0, 1.0))
        curve = QPolygonF([self.place(n / _SAMPLES, self._ease(n / _SAMPLES)) for n in range(_SAMPLES + 1)])
        painter.setPen(QPen(colour(now.accent), 2))
        painter.drawPolyline(curve)
        ends = (self.place(0.0, 0.0), self.place(1.0, 1.0))
        for number, (end, handle) in enumerate(zip(ends, self._handle_places(), strict=False)):
            painter.setPen(QPen(colour(now.accent), 1))
            painter.drawLine(end, handle)
            chosen = self.hasFocus() and number == self._chosen
            painter.setBrush(colour(now.accent if chosen else now.surface))
            painter.setPen(QPen(colour(now.accent), 2))
            painter.drawEllipse(handle, 4.5, 4.5)
        if self._at is not None:
            self._paint_now(painter, self._at)

    def _paint_now(self, painter: QPainter, t: float) -> None:
        now, part = tokens(), self._ease(t)
        point = self.place(t, part)
        painter.setPen(QPen(colour(now.text), 1, Qt.PenStyle.DotLine))
        painter.drawLine(point, self.place(t, 0.0))
        painter.drawLine(point, self.place(0.0, part))
        painter.setPen(QPen(colour(now.text), 2))
        painter.setBrush(colour(now.canvas))
        painter.drawEllipse(point, 4.0, 4.0)
        painter.setPen(colour(now.text))
        area = self._area
        painter.drawText(QPointF(area.left() + t * area.width() - 18, area.bottom() + 15), f"t = {t:.3g}")
        painter.drawText(QPointF(2, min(max(point.y() + 4, 12), self.height() - 4)), f"{part:.3g}")

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of the nearest handle."""
        places = self._handle_places()
        near = [(place - event.position()).manhattanLength() for place in places]
        self._held = near.index(min(near)) if near and min(near) <= _GRAB_PX else -1
        if self._held >= 0:
            self._chosen = self._held
            self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Ask for the handle where the hand is, in time between both keys."""
        if self._held < 0:
            return
        area, at = self._area, event.position()
        self._ask(
            self._held,
            (at.x() - area.left()) / area.width(),
            (area.bottom() - at.y()) / area.height(),
        )

    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        """Let go."""
        if self._held >= 0:
            self._held = -1
            self.handles_dropped.emit()

    def _ask(self, number: int, x: float, y: float) -> None:
        if self._handles is None:
            return
        if not 0.0 <= x <= 1.0:
            self.said.emit(stays_between())
        handles = list(self._handles)
        handles[2 * number : 2 * number + 2] = min(max(x, 0.0), 1.0), min(max(y, -1.0), 2.0)
        self.handles_dragged.emit(*(round(value, 3) for value in handles))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows move the chosen handle, Page Up and Page Down choose the other, Escape takes a drag back."""
        moves = {
            Qt.Key.Key_Left: (-_NUDGE, 0.0),
            Qt.Key.Key_Right: (_NUDGE, 0.0),
            Qt.Key.Key_Up: (0.0, _NUDGE),
            Qt.Key.Key_Down: (0.0, -_NUDGE),
        }
        key = Qt.Key(event.key())
        if not is_plain(event):
            super().keyPressEvent(event)
        elif key in moves and self._handles is not None:
            x, y = self._handles[2 * self._chosen : 2 * self._chosen + 2]
            self._ask(self._chosen, x + moves[key][0], y + moves[key][1])
            self.handles_dropped.emit()
        elif key in (Qt.Key.Key_PageUp, Qt.Key.Key_PageDown):
            self._chosen = 1 - self._chosen
            self.update()
        elif key == Qt.Key.Key_Escape and self._held >= 0:
            self.handles_put_back.emit()
        else:
            super().keyPressEvent(event)
