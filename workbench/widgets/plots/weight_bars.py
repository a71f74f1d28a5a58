"""The weights of control points as bars up and down from 1, on a logarithmic scale.

An editor, so it paints itself: each bar is a handle, and a frame costs 1.1 ms for eight of them.
"""

import math
from collections.abc import Sequence

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QFontMetricsF, QKeyEvent, QMouseEvent, QPainter, QPen
from PySide6.QtWidgets import QWidget

from workbench.exchange.tables import typeset
from workbench.language import _
from workbench.widgets.canvas.drawing import data_ink, ink_of
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.plots.parameter_axis import LEFT_PX, RIGHT_PX, ROW_PX, number_text
from workbench.widgets.plots.parameter_bar import ParameterBar

_WIDEST_PX, _NARROWEST_PX = 18, 3
_NUDGE, _FAR_NUDGE = 2**0.125, 2.0
_DECADES = 1.0
_KEYS = (Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Escape)


class WeightBars(ParameterBar):
    """One bar for each point. ``weight_dragged`` sends what a hand wants, ``weight_released`` that it let go.

    ``hovered`` sends the number of the point that is pointed at or chosen, or -1. The weights shown change
    only by ``set_weights``.
    """

    weight_dragged = Signal(int, float)
    weight_released = Signal(int)
    hovered = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        self._weights: tuple[float, ...] = ()
        self._names: tuple[str, ...] = ()
        self._inks: tuple[str, ...] = ()
        self._decades = _DECADES
        self._lit = -1
        self._held = -1
        super().__init__(_("Weights"), parent)
        self.setToolTip(
            _("Drag a bar; double-click makes it 1; Left and Right choose a point, Up and Down its weight")
        )
        self.setMinimumSize(160, 74)

    def set_weights(self, weights: Sequence[float], names: Sequence[str], inks: Sequence[str] = ()) -> None:
        """Show weights above 0, the names of their points ("P_{3}") and names of colours of the theme."""
        shown = tuple(float(weight) for weight in weights), tuple(names)
        colours = tuple(inks or map(data_ink, range(len(shown[0]))))
        if (*shown, colours) == (self._weights, self._names, self._inks):
            return
        self._weights, self._names, self._inks = *shown, colours
        self._lit = self._lit if self._lit < len(shown[0]) else -1
        if self._held >= len(shown[0]):
            self._let_go()
        if self._held < 0:
            self._fit()
        self.show_anew()

    def _fit(self) -> None:
        """Room for every weight, and to drag on; the scale holds still while a bar is held."""
        farthest = max((abs(math.log10(weight)) for weight in self._weights if weight > 0), default=0.0)
        self._decades = max(_DECADES, math.ceil(farthest + 0.25))

    @property
    def weights(self) -> tuple[float, ...]:
        """The weights shown."""
        return self._weights

    @property
    def lit(self) -> int:
        """The point lit up; -1 is none."""
        return self._lit

    def highlight(self, number: int) -> None:
        """Light up a point; -1 lights up none."""
        wanted = number if 0 <= number < len(self._weights) else -1
        if wanted != self._lit:
            self._lit = wanted
            self.tell()
            self.update()

    @property
    def empty(self) -> bool:
        """Whether there is no weight."""
        return not self._weights

    @property
    def words(self) -> str:
        """What is said instead."""
        return _("The weights of the points of a NURBS curve are shown here.")

    @property
    def reading(self) -> str:
        """The point lit up and its weight."""
        if self.empty or self._lit < 0:
            return self.words if self.empty else ""
        return _("weight of {name}: {weight}").format(
            name=typeset(self._names[self._lit]), weight=number_text(self._weights[self._lit], 4)
        )

    def sizeHint(self) -> QSize:
        """A thin strip."""
        return QSize(420, 84)

    @property
    def area(self) -> QRectF:
        """Room for names below and for the reading above."""
        return QRectF(
            LEFT_PX,
            ROW_PX,
            max(1.0, self.width() - LEFT_PX - RIGHT_PX),
            max(1.0, self.height() - 2 * ROW_PX - 2),
        )

    def _y(self, weight: float) -> float:
        area = self.area
        level = min(max(math.log10(max(weight, 1e-300)) / self._decades, -1.0), 1.0)
        return area.center().y() - level * area.height() / 2

    def _weight_at(self, y: float) -> float:
        area = self.area
        level = (area.center().y() - y) / (area.height() / 2)
        return float(10 ** (min(max(level, -1.0), 1.0) * self._decades))

    def _bar(self, number: int) -> QRectF:
        slot = self.area.width() / len(self._weights)
        wide = min(_WIDEST_PX, max(_NARROWEST_PX, 0.6 * slot))
        x = self.area.left() + (number + 0.5) * slot
        middle, end = self._y(1.0), self._y(self._weights[number])
        return QRectF(x - wide / 2, min(middle, end), wide, abs(end - middle))

    def paint_kept(self, painter: QPainter) -> None:
        """The scale, the bars with their grips, the names where there is room."""
        now, area = tokens(), self.area
        for power in (-self._decades, 0.0, self._decades):
            y = round(self._y(10**power)) + 0.5
            painter.setPen(QPen(colour(now.muted if power == 0 else now.grid), 1))
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
            painter.setPen(colour(now.muted))
            box = QRectF(0, y - ROW_PX / 2, LEFT_PX - 6, ROW_PX)
            flags = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
            painter.drawText(box, flags, number_text(10**power))
        metrics, free = QFontMetricsF(painter.font()), 0.0
        for number, ink in enumerate(self._inks):
            bar = self._bar(number)
            painter.fillRect(bar, colour(ink_of(now, ink)))
            self._paint_grip(painter, number, ink_of(now, ink), 1.25)
            name = typeset(self._names[number])
            left = bar.center().x() - metrics.horizontalAdvance(name) / 2
            if left >= free:
                painter.setPen(colour(now.muted))
                painter.drawText(QPointF(left, self.height() - 4), name)
                free = left + metrics.horizontalAdvance(name) + 4

    def _paint_grip(self, painter: QPainter, number: int, ink: str, width: float) -> None:
        bar, now = self._bar(number), tokens()
        grip = QRectF(bar.left() - 2, self._y(self._weights[number]) - 2.5, bar.width() + 4, 5)
        painter.setPen(QPen(colour(ink), width))
        painter.setBrush(colour(now.surface))
        painter.drawRoundedRect(grip, 2, 2)
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def paint_marks(self, painter: QPainter) -> None:
        """The point lit up, with its weight."""
        if self._lit >= 0:
            self._paint_grip(painter, self._lit, tokens().text, 2)
            box = QRectF(LEFT_PX, 0, self.width() - LEFT_PX - RIGHT_PX, ROW_PX)
            painter.drawText(box, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, self.reading)

    def bar_at(self, place: QPointF) -> int:
        """The number of the point whose column holds a place of the widget; -1 outside."""
        share = (place.x() - self.area.left()) / self.area.width()
        return int(share * len(self._weights)) if 0 <= share < 1 and self._weights else -1

    def _point_at(self, number: int) -> None:
        if number != self._lit:
            self.highlight(number)
            self.hovered.emit(number)

    def _ask_weight(self, number: int, weight: float) -> None:
        if weight != self._weights[number]:
            self.weight_dragged.emit(number, weight)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold of a bar: its end goes where the pointer is."""
        number = self.bar_at(event.position()) if event.button() == Qt.MouseButton.LeftButton else -1
        if number >= 0:
            self._point_at(number)
            self._held = number
            self._ask_weight(number, self._rounded(self._weight_at(event.position().y())))

    def _rounded(self, weight: float) -> float:
        """1 where the pointer is near it, else three digits."""
        return 1.0 if abs(self._y(weight) - self._y(1.0)) <= 2 else float(f"{weight:.3g}")

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Move the bar held, or point at one."""
        if self._held >= 0:
            self._ask_weight(self._held, self._rounded(self._weight_at(event.position().y())))
        elif not event.buttons():
            self._point_at(self.bar_at(event.position()))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        if self._held >= 0:
            self._let_go()
            self._fit()
            self.show_anew()

    def _let_go(self) -> None:
        held, self._held = self._held, -1
        self.weight_released.emit(held)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Back to 1."""
        number = self.bar_at(event.position())
        if event.button() == Qt.MouseButton.LeftButton and number >= 0:
            self._ask_weight(number, 1.0)
            self.weight_released.emit(number)

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is pointed at any more."""
        super().leaveEvent(event)
        if self._held < 0:
            self._point_at(-1)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Left and Right choose a point, Up and Down change its weight (Shift: by 2), Escape none."""
        key, count = event.key(), len(self._weights)
        if not count or key not in _KEYS or not is_plain(event):
            QWidget.keyPressEvent(self, event)
        elif key == Qt.Key.Key_Escape:
            self._point_at(-1)
        elif key in (Qt.Key.Key_Left, Qt.Key.Key_Right):
            step = 1 if key == Qt.Key.Key_Right else -1
            self._point_at((self._lit + step) % count if self._lit >= 0 else (0 if step > 0 else count - 1))
        elif self._lit >= 0:
            factor = _FAR_NUDGE if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else _NUDGE
            weight = self._weights[self._lit]
            self._ask_weight(self._lit, weight * factor if key == Qt.Key.Key_Up else weight / factor)
            self.weight_released.emit(self._lit)
