"""The basis functions of a curve over its parameter, each linked to its control point."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from PySide6.QtCore import QPointF, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QFontMetricsF, QKeyEvent, QPen
from PySide6.QtWidgets import QWidget

from workbench.exchange.tables import Table, typeset
from workbench.language import _
from workbench.widgets.canvas.drawing import DATA_INKS, PATTERNS, data_ink, ink_of
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.plots.parameter_axis import ROW_PX, Array, number_text, same
from workbench.widgets.plots.parameter_plot import ParameterPlot
from workbench.widgets.plots.plot import pen_of
from workbench.widgets.plots.scrubbed_plot import LINE_PX

_NEAR_PX = 9
_LIT_PX = 3.5
_SPOT_PX, _LIT_SPOT_PX = 7, 10
_GAP_PX = 4


class BasisCurves(ParameterPlot):
    """``hovered`` sends the number of the function that is pointed at, or -1; Up and Down choose one too."""

    hovered = Signal(int)
    head_px = 2
    over_px = ROW_PX

    def __init__(self, parent: QWidget | None = None) -> None:
        self._us: Array = np.zeros(0)
        self._values: Array = np.zeros((0, 0))
        self._names: tuple[str, ...] = ()
        self._inks: tuple[str, ...] = ()
        self._reach: list[tuple[int, int]] = []
        self._peaks: list[float] = []
        self._named: object = None
        self._inked: object = None
        self._brushes: list[QBrush] = []
        self._heights = (0.0, 1.0)
        self._lit = -1
        self._pointed = -1
        self._lines: list[Any] = []
        self._labels: list[Any] = []
        self._bold: Any = None
        self._value: Any = None
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
        self._peaks = us[values.argmax(axis=0)].tolist() if values.size else []
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
        lit = number if 0 <= number < len(self._names) else -1
        if lit != self._lit:
            self._lit = lit
            self._mark()
            self.tell()

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
        between: Array = (1 - share) * self._values[after - 1] + share * self._values[after]
        return between

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
        if self._lit < 0 or self.empty or self.u is None:
            return said
        return _("{name} is {value} at {u}").format(
            name=typeset(self._names[self._lit]),
            value=number_text(float(self.values_at(self.u)[self._lit])),
            u=said,
        )

    @property
    def heading(self) -> str:
        """Nothing: the names of the functions stand above them."""
        return ""

    def sizeHint(self) -> QSize:
        """A thin plot."""
        return QSize(420, 110)

    @property
    def heights(self) -> tuple[float, float]:
        """From 0, or from the least value, to 1, or to the greatest."""
        return self._heights

    def numbers(self) -> Table | None:
        """The parameter and each function there."""
        if self.empty:
            return None
        rows = [tuple(f"{value:.6g}" for value in row) for row in np.column_stack([self._us, self._values])]
        return Table(("u", *map(typeset, self._names)), rows, formulas=False)

    def _begin(self) -> None:
        import pyqtgraph

        super()._begin()
        self._bold = pyqtgraph.PlotCurveItem(antialias=True)
        self._bold.setZValue(1)
        self._value = pyqtgraph.TextItem()
        self._value.setFont(self._font())
        self._value.setZValue(3)
        self._lay(self._bold, self._value)

    def _pen(self, number: int, width: float) -> QPen:
        style = PATTERNS[("solid", "dash", "dot")[number // DATA_INKS % 3]]
        return pen_of(ink_of(tokens(), self._inks[number]), width, style)

    def _line_of(self, number: int) -> tuple[Array, Array]:
        first, last = self._reach[number]
        return self._us[first:last], self._values[first:last, number]

    def _draw(self) -> None:
        super()._draw()
        self._take_items(len(self._names))
        inked = self._inks, tokens()
        if inked != self._inked:
            self._inked = inked
            self._brushes = [QBrush(QColor(ink_of(tokens(), ink))) for ink in self._inks]
            self._spots.setPen(pen_of(tokens().surface, 1))
            for number, line in enumerate(self._lines):
                line.setPen(self._pen(number, LINE_PX))
        for number, line in enumerate(self._lines):
            line.setData(*self._line_of(number))
        named = self._names, self._inks, self._view, self.size(), tokens(), self._peaks
        if named != self._named:
            self._named = named
            self._place_names()

    def _take_items(self, count: int) -> None:
        """One line and one name for each function."""
        import pyqtgraph

        while len(self._lines) > count:
            self._plot.removeItem(self._lines.pop())
            self._plot.removeItem(self._labels.pop())
        while len(self._lines) < count:
            self._lines.append(pyqtgraph.PlotCurveItem(antialias=True))
            self._labels.append(pyqtgraph.TextItem())
            self._labels[-1].setFont(self._font())
            self._labels[-1].textItem.document().setDocumentMargin(0)
            self._lay(self._lines[-1], self._labels[-1], kept=True)

    def _place_names(self) -> None:
        """Each name above its peak, where there is room."""
        metrics, area, now = QFontMetricsF(self._font()), self.area, tokens()
        free = 0.0
        for number in np.argsort(self._peaks, kind="stable").tolist():
            name, label = typeset(self._names[number]), self._labels[number]
            wide, x = metrics.horizontalAdvance(name), self.x_of(self._peaks[number])
            left = min(max(x - wide / 2, area.left()), area.right() - wide)
            fits = left >= free and area.left() - 1 <= x <= area.right() + 1
            label.setVisible(fits)
            if fits:
                label.setText(name, QColor(ink_of(now, self._inks[number])))
                label.setPos(self.u_at(left), self._top())
                free = left + wide + _GAP_PX

    def _mark(self) -> None:
        """The function lit up, and where u meets the functions."""
        if self._bold is None or self.empty:
            return
        lit = self._lit >= 0
        self._bold.setVisible(lit)
        if lit:
            self._bold.setData(*self._line_of(self._lit), pen=self._pen(self._lit, _LIT_PX))
        values = np.zeros(0) if self.u is None else self.values_at(self.u)
        there = np.flatnonzero(values).tolist()
        self._spots.setData(
            [self.u] * len(there),
            values[there],
            brush=[self._brushes[number] for number in there],
            size=[_LIT_SPOT_PX if number == self._lit else _SPOT_PX for number in there],
        )
        self._value.setVisible(lit and self.u is not None)
        if lit and self.u is not None:
            self._place_value(self.u, float(values[self._lit]))

    def _place_value(self, u: float, value: float) -> None:
        """The value of the function lit up, on the side of u where there is room."""
        text, now, area = number_text(value), tokens(), self.area
        wide = QFontMetricsF(self._font()).horizontalAdvance(text) + 2 * _LIT_SPOT_PX
        self._value.setText(text, QColor(now.text))
        self._value.fill.setColor(colour(now.surface, 220))
        self._value.fill.setStyle(Qt.BrushStyle.SolidPattern)
        right = self.x_of(u) + wide <= area.right()
        self._value.setAnchor((-0.2 if right else 1.2, 0.5))
        half = ROW_PX / 2
        y = min(max(self.y_of(value), area.top() + half), area.bottom() - half)
        low = self.heights[0]
        self._value.setPos(u, low + (area.bottom() - y) / area.height() * (self._top() - low))

    def function_at(self, place: QPointF) -> int:
        """The function whose line is near a place of the widget; -1 if none is."""
        if self.empty or not self._us[0] <= self.u_at(place.x()) <= self._us[-1]:
            return -1
        values = self.values_at(self.u_at(place.x()))
        away = np.where(values != 0, np.abs(self.y_of(values) - place.y()), np.inf)
        nearest = int(away.argmin())
        return nearest if away[nearest] <= _NEAR_PX else -1

    def _point_at(self, place: QPointF | None) -> None:
        super()._point_at(place)
        self._tell_pointed(-1 if place is None else self.function_at(place))

    def _tell_pointed(self, number: int) -> None:
        if number != self._pointed:
            self._pointed = number
            self.highlight(number)
            self.hovered.emit(number)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Up and Down light up the next function; Escape none."""
        steps = {Qt.Key.Key_Up: 1, Qt.Key.Key_Down: -1}
        if not is_plain(event):
            super().keyPressEvent(event)
        elif event.key() in steps and not self.empty:
            step, count = steps[Qt.Key(event.key())], len(self._names)
            self._tell_pointed(
                (self._lit + step) % count if self._lit >= 0 else (0 if step > 0 else count - 1)
            )
        elif event.key() == Qt.Key.Key_Escape and self._pointed >= 0:
            self._tell_pointed(-1)
        else:
            super().keyPressEvent(event)


def _extent(values: Array) -> tuple[int, int]:
    """From where to where a function is not 0, with the 0 on either side."""
    there = np.flatnonzero(values)
    return (max(int(there[0]) - 1, 0), min(int(there[-1]) + 2, len(values))) if len(there) else (0, 0)
