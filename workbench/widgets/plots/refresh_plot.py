"""Refresh rate against the number of lines, with the number that is drawn now as a line to be dragged."""

from typing import Any, NamedTuple

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QWidget

from workbench.exchange.tables import Table
from workbench.language import _, ngettext
from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.plot import Plot, pen_of

_POINTS = 240
_WIDE_PX = 2.0


class RefreshCurve(NamedTuple):
    """``line_s`` is the time of one line, ``shortest_s`` that of the shortest picture. Below ``fusion_hz``
    pictures flicker; ``most`` lines do not yet (None: any number). ``raster_hz`` is that of a raster beside
    it, which no line slows down; None for none.
    """

    line_s: float
    shortest_s: float
    fusion_hz: float
    most: int | None
    raster_hz: float | None = None

    def hz(self, lines: float) -> float:
        """Pictures a second with so many lines."""
        return 1.0 / max(lines * self.line_s, self.shortest_s)


class RefreshPlot(Plot):
    """``lines_wanted`` sends a number of lines that a hand asks for: a drag, a click, or the arrow keys.

    ``held`` tells whether the mark is being dragged.
    """

    lines_wanted = Signal(int)
    held = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Refresh rate against the number of lines"), parent)
        self._shown: RefreshCurve | None = None
        self._lines = 0
        self._reach = (1.0, 2.0)
        self._most_lines = 1
        self._curve: Any = None
        self._fusion: Any = None
        self._limit: Any = None
        self._raster: Any = None
        self._grip: Any = None
        self._placing = False

    def show_curve(self, curve: RefreshCurve, lines: int, most_lines: int) -> None:
        """Show it with ``lines`` marked; nobody can ask for more than ``most_lines``."""
        if (curve, lines, most_lines) != (self._shown, self._lines, self._most_lines):
            self._shown, self._lines, self._most_lines = curve, lines, most_lines
            self._draw()

    @property
    def reach(self) -> tuple[float, float] | None:
        """From one line to as many as are plotted."""
        return None if self._shown is None else (1.0, self._reach[1])

    def _chosen(self, x: float) -> None:
        lines = min(max(round(x), 1), self._most_lines)
        if lines != self._lines:
            self.lines_wanted.emit(lines)

    def numbers(self) -> Table | None:
        """Lines, time of the picture, pictures a second."""
        if self._shown is None:
            return None
        curve = self._shown
        lines = np.unique(np.linspace(1, self._reach[1], 24).round().astype(int)).tolist()
        rows = [(n, 1e3 / curve.hz(n), curve.hz(n)) for n in lines]
        return Table((_("lines"), _("T in ms"), _("refresh in Hz")), rows, formulas=False)

    def _begin(self) -> None:
        import pyqtgraph

        self._curve = self._plot.plot([], [], antialias=True)
        self._fusion = pyqtgraph.InfiniteLine(angle=0)
        self._limit = pyqtgraph.InfiniteLine(angle=90)
        self._raster = pyqtgraph.InfiniteLine(angle=0)
        self._grip = pyqtgraph.InfiniteLine(angle=90, movable=True)
        self._grip.addMarker("v", 0.94, 12)
        self._grip.sigDragged.connect(self._dragged)
        self._grip.sigPositionChangeFinished.connect(self._let_go)
        self._lay(self._raster, self._fusion, self._limit, self._grip)
        self._plot.setMouseEnabled(x=False, y=False)

    def _dragged(self, line: Any) -> None:
        if not self._placing:
            self.held.emit(True)
            self._choose(float(line.value()))

    def _let_go(self, _line: Any) -> None:
        if not self._placing:
            self.held.emit(False)

    def _restyle(self) -> None:
        now = tokens()
        self._label_axes(_("Hz"), _("lines"))
        self._curve.setPen(pen_of(now.data[0], _WIDE_PX))
        self._raster.setPen(pen_of(now.data[1], _WIDE_PX, Qt.PenStyle.DashDotLine))
        self._fusion.setPen(pen_of(now.error, 0, Qt.PenStyle.DashLine))
        self._limit.setPen(pen_of(now.error, 0, Qt.PenStyle.DotLine))
        self._grip.setPen(pen_of(QColor(now.accent), _WIDE_PX))
        self._grip.setHoverPen(pen_of(QColor(now.accent), _WIDE_PX + 1))
        self._draw()

    def _draw(self) -> None:
        curve = self._shown
        if curve is None:
            return
        self._say(curve)
        # The scale stays while the mark is dragged on it: it grows only when the mark would leave it
        asked = 2.5 * (curve.most or curve.shortest_s / curve.line_s or 1)
        right = self._reach[1]
        if not asked <= right <= 4 * asked or self._lines > right:
            right = min(max(asked, 1.4 * self._lines, 8.0), float(max(self._most_lines, 8)))
        self._reach = (0.0, right)
        if self._plot is None:
            return
        lines = np.linspace(0.0, right, _POINTS)
        rates = 1.0 / np.maximum(lines * curve.line_s, curve.shortest_s)
        self._curve.setData(lines, rates)
        self._fusion.setValue(curve.fusion_hz)
        self._raster.setVisible(curve.raster_hz is not None)
        self._raster.setValue(curve.raster_hz or 0.0)
        self._limit.setVisible(curve.most is not None)
        self._limit.setValue(curve.most or 0)
        top = 1.15 * max(float(rates.max()), curve.fusion_hz, curve.raster_hz or 0.0)
        self._plot.setRange(xRange=(0.0, right), yRange=(0.0, top), padding=0.0)
        self._placing = True
        self._grip.setValue(self._lines)
        self._placing = False
        self.place_cursor(self._lines)
        self._cursor_line.hide()

    def _say(self, curve: RefreshCurve) -> None:
        if curve.most is None:
            self.say(_("This phosphor glows so long that no number of lines is seen to flicker."))
            return
        if not curve.most:
            said = _(
                "It flickers with any list: {rate:.3g} Hz at most, and the eye asks for {fusion:.3g} Hz."
            )
            self.say(said.format(rate=1.0 / curve.shortest_s, fusion=curve.fusion_hz))
            return
        said = ngettext(
            "{now:,} line: {rate:.3g} Hz. Up to {most:,} it is steady; from {next:,} on it flickers.",
            "{now:,} lines: {rate:.3g} Hz. Up to {most:,} it is steady; from {next:,} on it flickers.",
            self._lines,
        )
        rate = curve.hz(self._lines)
        self.say(said.format(now=self._lines, rate=rate, most=curve.most, next=curve.most + 1))

    def show_all(self) -> None:
        """The whole curve: it is shown always."""
        self._draw()
