"""A small instrument: one quantity over time, as an oscilloscope or a meter would draw it."""

import math
from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QFont, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.widgets.look.tokens import CAPTION_PX, RADIUS, colour, theme, tokens


def short(value: float) -> str:
    """A number in at most four digits."""
    return f"{value:.3g}" if value else "0"


class TracePlot(QWidget):
    """Title and unit above, the curve between two bounds, time below; ``number`` picks the data colour."""

    def __init__(self, title: str, unit: str, number: int = 0, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._title, self._unit, self._number = title, unit, number
        self._xs: Sequence[float] = ()
        self._ys: Sequence[float] = ()
        self._bounds = (0.0, 1.0)
        self._time_text = ""
        self._cursor: float | None = None
        self._logarithmic = False
        self._empty = ""
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.setMinimumSize(120, 74)
        self.setAccessibleName(title)
        theme.changed.connect(self.update)

    def sizeHint(self) -> QSize:
        """One of four beside each other."""
        return QSize(240, 104)

    def show_curve(
        self,
        xs: Sequence[float],
        ys: Sequence[float],
        bounds: tuple[float, float],
        time_text: str,
        cursor: float | None = None,
        logarithmic: bool = False,
    ) -> None:
        """Draw ``ys`` over ``xs``; ``cursor`` marks now, in the unit of ``xs``; ``time_text`` is the span."""
        self._xs, self._ys, self._bounds = xs, ys, bounds
        self._time_text, self._cursor, self._logarithmic = time_text, cursor, logarithmic
        self._empty = ""
        self.setAccessibleDescription(self._reading())
        self.update()

    def show_words(self, words: str) -> None:
        """Say why there is no curve."""
        self._xs, self._ys, self._empty = (), (), words
        self.setAccessibleDescription(words)
        self.update()

    def _reading(self) -> str:
        value = self._at_cursor()
        return self._time_text if value is None else f"{short(value)} {self._unit}, {self._time_text}"

    def _at_cursor(self) -> float | None:
        if self._cursor is None or len(self._xs) < 2:
            return None
        nearest = min(range(len(self._xs)), key=lambda i: abs(self._xs[i] - (self._cursor or 0.0)))
        return float(self._ys[nearest])

    def _height(self, value: float, area: QRectF) -> float:
        low, high = self._bounds
        if self._logarithmic:
            value, low, high = (math.log10(max(v, 1e-12)) for v in (value, low, high))
        share = (min(max(value, low), high) - low) / (high - low)
        return area.bottom() - share * area.height()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Caption, grid, curve, cursor."""
        now = tokens()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        frame = QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5)
        painter.setPen(QPen(colour(now.line), 1))
        painter.setBrush(colour(now.surface))
        painter.drawRoundedRect(frame, RADIUS, RADIUS)
        font = QFont(self.font())
        font.setPixelSize(CAPTION_PX)
        painter.setFont(font)
        row = CAPTION_PX + 5
        caption = frame.adjusted(8, 4, -8, 0)
        caption.setHeight(row)
        painter.setPen(colour(now.text))
        title = painter.fontMetrics().elidedText(
            self._title, Qt.TextElideMode.ElideRight, int(caption.width()) - 60
        )
        painter.drawText(caption, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, title)
        painter.setPen(colour(now.muted))
        value = self._at_cursor()
        reading = self._unit if value is None else f"{short(value)} {self._unit}"
        painter.drawText(caption, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, reading)
        area = frame.adjusted(34, row + 9, -10, -row - 2)
        if self._empty or len(self._xs) < 2:
            words = frame.adjusted(12, row, -12, -4)
            flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
            painter.drawText(words, flags, self._empty)
            return
        self._paint_axes(painter, area, frame, row)
        self._paint_curve(painter, area)

    def _paint_axes(self, painter: QPainter, area: QRectF, frame: QRectF, row: int) -> None:
        now = tokens()
        low, high = self._bounds
        levels = [low, high]
        if self._logarithmic:
            levels = [10.0**k for k in range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)]
        elif low < 0.0 < high:
            levels = [low, 0.0, high]
        for level in levels:
            y = round(self._height(level, area)) + 0.5
            painter.setPen(QPen(colour(now.grid), 1))
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
            painter.setPen(colour(now.muted))
            box = QRectF(frame.left() + 2, y - row / 2, 28, row)
            if not self._logarithmic or level in (levels[0], levels[-1], 1.0):
                painter.drawText(
                    box, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, short(level)
                )
        below = QRectF(area.left(), area.bottom() + 3, area.width(), row)
        painter.drawText(below, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, self._time_text)

    def _paint_curve(self, painter: QPainter, area: QRectF) -> None:
        now = tokens()
        first, last = self._xs[0], self._xs[-1]
        scale = area.width() / (last - first) if last > first else 0.0
        curve = QPolygonF(
            [
                QPointF(area.left() + (x - first) * scale, self._height(y, area))
                for x, y in zip(self._xs, self._ys, strict=True)
            ]
        )
        painter.setPen(QPen(colour(now.data[self._number % len(now.data)]), 1.6))
        painter.drawPolyline(curve)
        if self._cursor is not None and first <= self._cursor <= last:
            x = area.left() + (self._cursor - first) * scale
            painter.setPen(QPen(colour(now.text), 1.2))
            painter.drawLine(QPointF(x, area.top() - 3), QPointF(x, area.bottom() + 3))
