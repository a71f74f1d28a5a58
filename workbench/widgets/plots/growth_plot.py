"""Time over how much there is to do, both logarithmic: a power of n is a line, its slope the power."""

import math
from collections.abc import Sequence
from html import escape
from typing import Any, NamedTuple

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QWidget

from workbench.algorithms.numerals import with_minus
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.plot import Plot, pen_of

_SYMBOLS = {
    "o": "●", "s": "■", "t": "▼", "d": "◆", "star": "★", "t1": "▲", "+": "✚", "x": "✖", "h": "⬢", "p": "⬟",
}  # fmt: skip
_PLAIN_PX, _STRONG_PX, _NUMBER_PX = 1.2, 2.6, 40


def _look(number: int) -> tuple[str, str, Qt.PenStyle]:
    """Colour, symbol and pen of a line by its number: no two of the first ten have the same."""
    inks = tokens().data
    style = Qt.PenStyle.SolidLine if number // len(inks) % 2 == 0 else Qt.PenStyle.DashLine
    return inks[number % len(inks)], list(_SYMBOLS)[number % len(_SYMBOLS)], style


class GrowthCurve(NamedTuple):
    """What it is called, its points (n, seconds), and the power of n that was fitted, if one was."""

    name: str
    points: Sequence[tuple[int, float]]
    power: float | None


class GrowthPlot(Plot):
    """One line for each; the one that is ``strong`` is told of, and stands before the others."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Growth of the time"), parent)
        self._curves: Sequence[GrowthCurve] = ()
        self._unit = ""
        self._strong = ""
        self._lines: list[Any] = []
        self._decades: tuple[int, int] | None = None
        self._say()

    def show_curves(self, curves: Sequence[GrowthCurve], unit: str, strong: str) -> None:
        """Plot the curves; ``unit`` is what n counts, ``strong`` the name of the one that is spoken of."""
        if (curves, unit, strong) != (self._curves, self._unit, self._strong):
            self._curves, self._unit, self._strong = curves, unit, strong
            self._draw()

    def numbers(self) -> Table | None:
        """Name, n and milliseconds."""
        rows = [
            (curve.name, n, f"{seconds * 1e3:.6g}") for curve in self._curves for n, seconds in curve.points
        ]
        return Table((_("method"), self._unit, _("ms")), rows, formulas=False) if rows else None

    def _begin(self) -> None:
        self._plot.setLogMode(x=True, y=True)
        self._plot.setMouseEnabled(x=True, y=True)
        view = self._plot.getViewBox()
        for moved in (view.sigRangeChanged, view.sigResized):
            moved.connect(self._number_powers)

    def _number_powers(self, *_view: object) -> None:
        """Powers of ten alone have numbers, as many as there is room for."""
        ranges, sizes = self._plot.viewRange(), (self._plot.width(), self._plot.height())
        for side, (low, high), size in zip(("bottom", "left"), ranges, sizes, strict=True):
            axis = self._plot.getAxis(side)
            axis.setStyle(maxTextLevel=0)
            axis.setTickSpacing(levels=[(max(1, math.ceil((high - low) * _NUMBER_PX / max(size, 1))), 0)])

    def _restyle(self) -> None:
        self._label_axes(_("ms"), self._unit)
        self._draw()

    def _draw(self) -> None:
        self._say()
        if self._plot is None:
            return
        for line in self._lines:
            self._plot.removeItem(line)
        self._lines = []
        self._label_axes(_("ms"), self._unit)
        self._plot.setVisible(bool(self._curves))
        self._show_decades()
        for k, curve in enumerate(self._curves):
            points = np.array([(n, seconds * 1e3) for n, seconds in curve.points if seconds > 0], np.float64)
            if not len(points):
                continue
            (of_line, symbol, style), strong = _look(k), curve.name == self._strong
            ink = QColor(of_line)
            line = self._plot.plot(
                points[:, 0], points[:, 1], pen=pen_of(ink, _STRONG_PX if strong else _PLAIN_PX, style),
                symbol=symbol, symbolSize=9 if strong else 6, symbolBrush=ink, symbolPen=None, antialias=True,
            )  # fmt: skip
            line.setZValue(1 if strong else 0)
            self._lines.append(line)

    def _show_decades(self) -> None:
        """Whole decades of time, so that two powers of ten at least have numbers."""
        times = [seconds * 1e3 for curve in self._curves for _n, seconds in curve.points if seconds > 0]
        if not times:
            return
        low, high = math.floor(math.log10(min(times))), math.ceil(math.log10(max(times)))
        decades = low, max(high, low + 1)
        if decades != self._decades:  # else somebody may have zoomed in
            self._decades = decades
            self._plot.setYRange(*decades, padding=0.04)

    def _say(self) -> None:
        """The one that is spoken of, then the others, the steepest first, those without a power last."""
        of_power = [(k, curve, curve.power) for k, curve in enumerate(self._curves)]
        of_power.sort(key=lambda each: (each[1].name != self._strong, each[2] is None, -(each[2] or 0.0)))
        said, plain = [], []
        for k, curve, power in of_power:
            ink, symbol, _style = _look(k)
            raised = "" if power is None else with_minus(f"{power:.2f}")
            plain.append(f"{curve.name} n^{raised}" if raised else curve.name)
            name = escape(f"{curve.name} n" if raised else curve.name)
            name = name.replace(" ", "&nbsp;")  # a line ends between two of them
            mark = f'<span style="color:{ink}">{_SYMBOLS[symbol]}</span>'
            said.append(f"{mark}&nbsp;{name}<sup>{raised}</sup>" if raised else f"{mark}&nbsp;{name}")
        self.say(
            " · ".join(said) or _("Measure the times to see how they grow."),
            "; ".join(plain) or _("Nothing is measured yet."),
        )
