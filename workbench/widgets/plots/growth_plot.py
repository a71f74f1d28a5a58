"""Time over how much there is to do, both logarithmic: a power of n is a line, its slope the power."""

import math
from collections.abc import Sequence
from html import escape
from typing import Any, NamedTuple

import numpy as np
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QWidget

from workbench.algorithms.numerals import with_minus
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.plot import Plot, pen_of

_SYMBOLS = ("o", "s", "t", "d", "+", "x", "star", "h", "p")
_NAMED, _PLAIN_PX, _STRONG_PX, _NUMBER_PX = 3, 1.2, 2.6, 40


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
        inks = tokens().data
        for k, curve in enumerate(self._curves):
            points = np.array([(n, seconds * 1e3) for n, seconds in curve.points if seconds > 0], np.float64)
            if not len(points):
                continue
            ink, strong = QColor(inks[k % len(inks)]), curve.name == self._strong
            line = self._plot.plot(
                points[:, 0], points[:, 1], pen=pen_of(ink, _STRONG_PX if strong else _PLAIN_PX),
                symbol=_SYMBOLS[k % len(_SYMBOLS)], symbolSize=9 if strong else 6, symbolBrush=ink,
                symbolPen=None, antialias=True,
            )  # fmt: skip
            line.setZValue(1 if strong else 0)
            self._lines.append(line)

    def _say(self) -> None:
        """The one that is spoken of, then the steepest others."""
        now = tokens()
        fitted = [(k, curve) for k, curve in enumerate(self._curves) if curve.power is not None]
        fitted.sort(key=lambda pair: (pair[1].name != self._strong, -(pair[1].power or 0.0)))
        said, plain = [], []
        for k, curve in fitted[: _NAMED + 1]:
            power, ink = with_minus(f"{curve.power:.2f}"), now.data[k % len(now.data)]
            plain.append(f"{curve.name} n^{power}")
            name = f"{escape(curve.name)} n".replace(" ", "&nbsp;")  # a line ends between two of them
            said.append(f'<span style="color:{ink}">●</span>&nbsp;{name}<sup>{power}</sup>')
        self.say(
            " · ".join(said) or _("Measure the times to see how they grow."),
            "; ".join(plain) or _("Nothing is measured yet."),
        )
