"""The basis functions of a curve over its parameter, each linked to its control point."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QFontMetricsF, QKeyEvent, QMouseEvent, QPainter, QPen
from PySide6.QtWidgets import QWidget

from workbench.exchange.tables import typeset
from workbench.language import _
from workbench.widgets.canvas.drawing import DATA_INKS, PATTERNS, data_ink, ink_of
from workbench.widgets.canvas.polygons import polygon
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.plots.parameter_plot import (
    LEFT_PX,
    ROW_PX,
    Array,
    ParameterPlot,
    number_text,
    same,
    tick_text,
    ticks,
)

_NEAR_PX = 9


class BasisCurves(ParameterPlot):
    """``hovered`` sends the number of the function that is pointed at, or -1; Up and Down choose one too."""

    hovered = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        self._us: Array = np.zeros(0)
        self._values: Array = np.zeros((0, 0))
        self._names: tuple[str, ...] = ()
        self._inks: tuple[str, ...] = ()
        self._reach: list[tuple[int, int]] = []
        self._heights = (0.0, 1.0)
        self._lit = -1
        self._pointed = -1
        super().__init__(_("Basis functions"), parent)
        self.setToolTip(
            _("Drag to move u; point at a function, or press Up and Down, to light it up with its point")
        )
        self.setMinimumSize(160, 74)

    def set_functions(self, us: Array, values: Array, names: Sequence[str], inks: Sequence[str] = ()) -> None:
        """Plot functions over the parameter.

        ``us`` (m,) ascending, ``values`` (m, n), ``names`` of the n functions ("N_{3}"), ``inks`` names of
        colours of the theme, by default the six data colours in turn; a pattern stands beside every colour.
        The arrays are kept, not copied.
        """
        shown = tuple(names), tuple(inks or map(data_ink, range(len(names))))
        if shown == (self._names, self._inks) and same(us, self._us) and same(values, self._values):
            return
        self._us, self._values = us, values
        self._names, self._inks = shown
        self._reach = [_extent(column) for column in values.T]
        low, high = (float(values.min()), float(values.max())) if values.size else (0.0, 1.0)
        self._heights = min(0.0, low), max(1.0, high)
        self._lit = self._lit if self._lit < len(names) else -1
        self.show_anew()

    @property
    def lit(self) -> int:
        """The function that is lit up; -1 is none."""
        return self._lit

    def highlight(self, number: int) -> None:
        """Light up a function; -1 lights up none."""
        wanted = number if 0 <= number < len(self._names) else -1
        if wanted != self._lit:
            self._lit = wanted
            self.tell()
            self.update()

    @property
    def ends(self) -> list[float]:
        """The first and the last parameter that functions are given at."""
        return [float(self._us[0]), float(self._us[-1])]

    def values_at(self, u: float) -> Array:
        """(n,) the values at u, between the given ones."""
        us = self._us
        after = int(np.clip(np.searchsorted(us, u), 1, len(us) - 1))
        length = us[after] - us[after - 1]
        share = min(max((u - us[after - 1]) / length, 0.0), 1.0) if length > 0 else 1.0
        found: Array = (1 - share) * self._values[after - 1] + share * self._values[after]
        return found

    @property
    def empty(self) -> bool:
        """Whether there is no function."""
        return len(self._us) < 2 or not self._names

    @property
    def words(self) -> str:
        """What is said instead."""
        return _("Select a curve: its basis functions are plotted here.")

    @property
    def reading(self) -> str:
        """u, and the function lit up with its value there."""
        said = super().reading
        if self._lit < 0 or self.empty or self._u is None:
            return said
        return _("{name} is {value} at {u}").format(
            name=typeset(self._names[self._lit]),
            value=number_text(float(self.values_at(self._u)[self._lit])),
            u=said,
        )

    def sizeHint(self) -> QSize:
        """A thin plot."""
        return QSize(420, 110)

    @property
    def area(self) -> QRectF:
        """Room for the names above."""
        return super().area.adjusted(0, ROW_PX - 4, 0, 0)

    def _ys(self, values: Array) -> Array:
        low, high = self._heights
        area = self.area
        placed: Array = area.bottom() - (values - low) / (high - low) * area.height()
        return placed

    def _y(self, value: float) -> float:
        return float(self._ys(np.array(value)))

    def _pen(self, number: int, width: float) -> QPen:
        style = PATTERNS[("solid", "dash", "dot")[number // DATA_INKS % 3]]
        return QPen(colour(ink_of(tokens(), self._inks[number])), width, style)

    def _line(self, painter: QPainter, number: int, width: float) -> None:
        first, last = self._reach[number]
        if last - first > 1:
            painter.setPen(self._pen(number, width))
            us = self._us[first:last]
            low, high = self.range
            x = self.area.left() + (us - low) / (high - low) * self.area.width()
            painter.drawPolyline(polygon(x, self._ys(self._values[first:last, number])))

    def paint_kept(self, painter: QPainter) -> None:
        """Axes, functions, their names where they peak."""
        now, area = tokens(), self.area
        self.paint_axis(painter)
        low, high = self._heights
        for level in ticks(low, high, max(2, int(area.height() / 22))):
            y = self._y(level)
            painter.setPen(QPen(colour(now.grid), 1))
            painter.drawLine(QPointF(area.left(), round(y) + 0.5), QPointF(area.right(), round(y) + 0.5))
            painter.setPen(colour(now.muted))
            box = QRectF(0, y - ROW_PX / 2, LEFT_PX - 6, ROW_PX)
            painter.drawText(
                box, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, tick_text(level)
            )
        for number in range(len(self._names)):
            self._line(painter, number, 1.5)
        self._paint_names(painter)

    def _paint_names(self, painter: QPainter) -> None:
        """Each name above its peak, where there is room."""
        metrics = QFontMetricsF(painter.font())
        free = 0.0
        peaks = self._us[self._values.argmax(axis=0)]
        for number in np.argsort(peaks, kind="stable").tolist():
            name = typeset(self._names[number])
            wide = metrics.horizontalAdvance(name)
            left = min(max(self.x_of(float(peaks[number])) - wide / 2, LEFT_PX), self.width() - wide - 2)
            if left >= free:
                painter.setPen(colour(ink_of(tokens(), self._inks[number])))
                painter.drawText(QPointF(left, metrics.ascent() + 1), name)
                free = left + wide + 4

    def paint_marks(self, painter: QPainter) -> None:
        """The function lit up, u, and where u meets the functions."""
        if self._lit >= 0:
            self._line(painter, self._lit, 3.5)
        super().paint_marks(painter)
        if self._u is None:
            return
        values = self.values_at(self._u)
        x, now = self.x_of(self._u), tokens()
        for number in np.flatnonzero(values).tolist():
            strong = number == self._lit
            painter.setPen(QPen(colour(now.surface), 1))
            painter.setBrush(colour(ink_of(now, self._inks[number])))
            painter.drawEllipse(
                QPointF(x, self._y(float(values[number]))), *((5, 5) if strong else (3.5, 3.5))
            )
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if self._lit >= 0:
            self._paint_value(painter, x, float(values[self._lit]))

    def _paint_value(self, painter: QPainter, x: float, value: float) -> None:
        """The value of the function lit up, on the side of u where there is room."""
        text, now, area = number_text(value), tokens(), self.area
        wide = painter.fontMetrics().horizontalAdvance(text) + 6
        left = x + 8 if x + 8 + wide <= area.right() else x - 8 - wide
        top = min(max(self._y(value) - ROW_PX / 2, area.top()), area.bottom() - ROW_PX)
        box = QRectF(left, top, wide, ROW_PX)
        painter.fillRect(box, colour(now.surface, 220))
        painter.setPen(colour(now.text))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)

    def function_at(self, place: QPointF) -> int:
        """The function whose line is near a place of the widget; -1 if none is."""
        if self.empty or not self._us[0] <= self.u_at(place.x()) <= self._us[-1]:
            return -1
        values = self.values_at(self.u_at(place.x()))
        away = np.where(values != 0, np.abs(self._ys(values) - place.y()), np.inf)
        nearest = int(away.argmin())
        return nearest if away[nearest] <= _NEAR_PX else -1

    def _point_at(self, number: int) -> None:
        if number != self._pointed:
            self._pointed = number
            self.highlight(number)
            self.hovered.emit(number)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on asking for u, or point at a function."""
        super().mouseMoveEvent(event)
        if not event.buttons():
            self._point_at(self.function_at(event.position()))

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is pointed at any more."""
        super().leaveEvent(event)
        self._point_at(-1)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Up and Down light up the next function; Escape none."""
        steps = {Qt.Key.Key_Up: 1, Qt.Key.Key_Down: -1}
        if event.key() in steps and not self.empty:
            step, count = steps[Qt.Key(event.key())], len(self._names)
            self._point_at((self._lit + step) % count if self._lit >= 0 else (0 if step > 0 else count - 1))
        elif event.key() == Qt.Key.Key_Escape and self._pointed >= 0:
            self._point_at(-1)
        else:
            super().keyPressEvent(event)


def _extent(values: Array) -> tuple[int, int]:
    """From where to where a function is not 0, with the 0 on either side."""
    there = np.flatnonzero(values)
    return (max(int(there[0]) - 1, 0), min(int(there[-1]) + 2, len(values))) if len(there) else (0, 0)
