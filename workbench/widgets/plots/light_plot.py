"""Light over time at one place of a tube: by formula, as measured, and the steps of a run."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QSizePolicy, QWidget

from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.plot import Plot, pen_of

Floats = NDArray[np.float64]

_LEAST, _MOST = 1e-3, 1e5
_ROOM = 1.5
_LINE_PX, _DOT_PX, _RING_PX = 1.5, 4, 10
_NOTHING = np.zeros(0)


class Trace(NamedTuple):
    """Milliseconds since a hit, and the light then, over its mean."""

    ms: Floats
    light: Floats


class LightPlot(Plot):
    """The light over its mean, which is 1, on a logarithmic scale; hits are marked at the bottom."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Light over time"), parent)
        self._formula = self._measured = self._stepped = Trace(_NOTHING, _NOTHING)
        self._hits: Sequence[float] = ()
        self._items: dict[str, Any] = {}
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setToolTip(
            _("Light at the probed pixel over its mean: the line by formula, dots from the simulated tube.")
        )

    def sizeHint(self) -> QSize:
        """Low and wide."""
        return QSize(360, 150)

    def show_light(self, formula: Trace, measured: Trace, hits: Sequence[float], words: str) -> None:
        """Draw both over one or more periods; ``hits`` are the times (ms) at which the beam comes."""
        self._formula, self._measured, self._hits = formula, measured, hits
        self.say(words)
        self._draw()

    def show_steps(self, stepped: Trace) -> None:
        """Ring what the run has stepped so far."""
        self._stepped = stepped
        self._draw()

    def numbers(self) -> Table | None:
        """Milliseconds and light, by formula and as measured."""
        rows = [(_("formula"), f"{t:.6g}", f"{light:.6g}") for t, light in np.transpose(self._formula)]
        rows += [(_("measured"), f"{t:.6g}", f"{light:.6g}") for t, light in np.transpose(self._measured)]
        return Table(("", "ms", _("light over its mean")), rows, formulas=False) if rows else None

    def _begin(self) -> None:
        import pyqtgraph

        self._items = {
            "mean": pyqtgraph.InfiniteLine(0.0, angle=0),
            "formula": pyqtgraph.PlotCurveItem(antialias=True),
            "measured": pyqtgraph.ScatterPlotItem(size=_DOT_PX),
            "stepped": pyqtgraph.ScatterPlotItem(size=_RING_PX),
            "hits": pyqtgraph.ScatterPlotItem(size=9, symbol="t1"),
        }
        self._lay(*self._items.values())
        self._plot.getAxis("bottom").setStyle(hideOverlappingLabels=True)
        self._plot.showGrid(x=False, y=True, alpha=0.3)

    def _restyle(self) -> None:
        now, items = tokens(), self._items
        items["mean"].setPen(pen_of(now.muted, 1, Qt.PenStyle.DashLine))
        items["formula"].setPen(pen_of(now.data[0], _LINE_PX))
        items["measured"].setPen(pen_of(now.surface, 0.5))
        items["measured"].setBrush(QColor(now.data[1]))
        items["stepped"].setPen(pen_of(now.text, 1.5))
        items["stepped"].setBrush(None)
        items["hits"].setPen(pen_of(now.surface, 0.5))
        items["hits"].setBrush(QColor(now.muted))
        self._label_axes(_("light / mean"), _("ms"))
        self._draw()

    def _draw(self) -> None:
        if self._plot is None or not self._items:
            return
        low, _high = self._bounds()
        self._items["formula"].setData(*self._logarithmic(self._formula, low))
        self._items["measured"].setData(*self._logarithmic(self._measured, low))
        self._items["stepped"].setData(*self._logarithmic(self._stepped, low))
        self._items["hits"].setData(np.array(self._hits, float), np.full(len(self._hits), low))
        self.show_all()

    @staticmethod
    def _logarithmic(trace: Trace, low: float) -> tuple[Floats, Floats]:
        return trace.ms, np.log10(np.maximum(trace.light, 10.0**low))

    def _bounds(self) -> tuple[float, float]:
        """The least and the most light that is seen, as powers of ten."""
        light = np.concatenate([self._formula.light, self._measured.light])
        light = light[np.isfinite(light) & (light > 0.0)]
        if not len(light):
            return -1.0, 1.0
        low = np.log10(max(float(light.min()) / _ROOM, _LEAST))
        high = np.log10(min(float(light.max()) * _ROOM, _MOST))
        return float(min(low, -0.2)), float(max(high, 0.2))

    def show_all(self) -> None:
        """All periods, all of the light."""
        if self._plot is None or not len(self._formula.ms):
            return
        low, high = self._bounds()
        self._plot.setRange(
            xRange=(0.0, float(self._formula.ms[-1])), yRange=(low, high), padding=0.02, update=True
        )
        powers = range(int(np.floor(low)), int(np.ceil(high)) + 1)
        self._plot.getAxis("left").setTicks([[(p, f"{10.0**p:g}") for p in powers]])
