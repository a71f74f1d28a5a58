"""A small instrument: one quantity over time, as an oscilloscope or a meter would draw it."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QWidget

from workbench.algorithms.numerals import with_minus
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.elided_label import ElidedLabel
from workbench.widgets.look.tokens import RADIUS, colour, tokens
from workbench.widgets.plots.plot import Plot

_LEAST = 1e-12
_AXIS_PX = 34
_WIDTH_PX = 1.5
_HALF_LINE_PX = 6
_APART_PX = 6
_PADDING = 0.02  # what lies at the very edge of the range has no label


def short(value: float) -> str:
    """A number in at most four digits."""
    return with_minus(f"{value:.3g}") if value else "0"


class TracePlot(Plot):
    """Title and value above, the curve between two bounds, time below; ``number`` picks the data colour."""

    def __init__(self, title: str, unit: str, number: int = 0, parent: QWidget | None = None) -> None:
        super().__init__(title, parent)
        self._unit, self._number = unit, number
        self._xs: Sequence[float] = ()
        self._ys: Sequence[float] = ()
        self._bounds = (0.0, 1.0)
        self._time_text = ""
        self._logarithmic = False
        self._curve: Any = None
        self._scale: object = None
        self._rules: list[Any] = []
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.setMinimumSize(120, 74)
        self._value = QLabel()
        self._value.setProperty("role", "caption")
        self._title = ElidedLabel(title)
        row = QHBoxLayout()
        row.setSpacing(_APART_PX)
        row.addWidget(self._title, 1)
        row.addWidget(self._value)
        self._column.insertLayout(0, row)
        self._time = ElidedLabel()
        self._time.setProperty("role", "caption")
        self._time.setAlignment(Qt.AlignmentFlag.AlignRight)
        self._column.addWidget(self._time)
        self._column.setSpacing(0)
        self.caption.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.caption.hide()
        self._take_type()

    def _take_type(self) -> None:
        for label in (self._title, self._value, self._time):
            label.setFont(self._font())
        super()._take_type()

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
        self._time_text, self._logarithmic = time_text, logarithmic
        self.place_cursor(cursor)
        value = self._at_cursor()
        self._value.setText(self._unit if value is None else f"{short(value)} {self._unit}")
        self.setAccessibleDescription(time_text if value is None else f"{self._value.text()}, {time_text}")
        self._draw()

    def show_words(self, words: str) -> None:
        """Say why there is no curve."""
        self._xs, self._ys = (), ()
        self._value.setText(self._unit)
        self.say(words)
        self.setAccessibleDescription(words)
        self._draw()

    def numbers(self) -> Table | None:
        """Seconds and the value."""
        rows = [(f"{x:.6g}", f"{y:.6g}") for x, y in zip(self._xs, self._ys, strict=True)]
        return Table((_("seconds"), self._unit), rows, formulas=False) if rows else None

    def _at_cursor(self) -> float | None:
        if self._cursor_x is None or len(self._xs) < 2:
            return None
        nearest = int(np.abs(np.asarray(self._xs) - self._cursor_x).argmin())
        return float(self._ys[nearest])

    def _begin(self) -> None:
        self._curve = self._plot.plot([], [], antialias=True)
        self._plot.hideAxis("bottom")
        self._plot.getPlotItem().setContentsMargins(0, _HALF_LINE_PX, 0, _HALF_LINE_PX)
        self._plot.getAxis("left").setStyle(hideOverlappingLabels=False)  # those at the very ends
        self._plot.showGrid(y=False)  # with which those would be left out again
        self._plot.getAxis("left").setWidth(_AXIS_PX)

    @staticmethod
    def _pen(ink: str) -> QPen:
        pen = QPen(QColor(ink), _WIDTH_PX)
        pen.setCosmetic(True)
        return pen

    def _restyle(self) -> None:
        self._curve.setPen(self._pen(tokens().data[self._number % len(tokens().data)]))
        self._scale = None
        self._draw()

    def _draw(self) -> None:
        there = len(self._xs) > 1
        self.caption.setVisible(not there)
        self._time.setVisible(there)
        self._time.setText(self._time_text)
        if self._plot is None:
            return
        self._plot.setVisible(there)
        if not there:
            return
        low, high = self._bounds
        ys = np.clip(np.asarray(self._ys), low, high)
        self._curve.setData(np.asarray(self._xs), self._heights(ys))
        scale = self._bounds, self._logarithmic, self._xs[0], self._xs[-1]
        if scale != self._scale:
            self._scale = scale
            self.show_all()

    def show_all(self) -> None:
        """The whole time between the bounds."""
        if self._plot is None or len(self._xs) < 2:
            return
        low, high = self._heights(np.array(self._bounds)).tolist()
        self._plot.setRange(xRange=(self._xs[0], self._xs[-1]), yRange=(low, high), padding=_PADDING)
        levels = self._levels()
        self._rule(levels)
        ticks = zip(self._heights(np.array(levels)).tolist(), map(self._level_text, levels), strict=True)
        self._plot.getAxis("left").setTicks([list(ticks)])

    def _rule(self, levels: Sequence[float]) -> None:
        """A line across at each level."""
        import pyqtgraph

        for line in self._rules:
            self._plot.removeItem(line)
        pen = QPen(QColor(tokens().grid), 0)
        self._rules = [
            pyqtgraph.InfiniteLine(height, angle=0, pen=pen)
            for height in self._heights(np.array(levels)).tolist()
        ]
        for line in self._rules:
            line.setZValue(-1)
            self._lay(line)

    def _heights(self, values: Any) -> Any:
        return np.log10(np.maximum(values, _LEAST)) if self._logarithmic else values

    def _levels(self) -> list[float]:
        low, high = self._bounds
        if self._logarithmic:
            return [10.0**k for k in range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)]
        return [low, 0.0, high] if low < 0.0 < high else [low, high]

    def _level_text(self, level: float) -> str:
        """Of many powers of ten the first, 1 and the last are written."""
        ends = self._levels()[0], self._levels()[-1]
        return short(level) if not self._logarithmic or level in (*ends, 1.0) else ""

    def paintEvent(self, event: QPaintEvent) -> None:
        """A frame of its own, since four stand beside each other."""
        super().paintEvent(event)
        if not self.hasFocus():
            painter = QPainter(self)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(QPen(colour(tokens().line), 1))
            painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), RADIUS, RADIUS)
            painter.end()
