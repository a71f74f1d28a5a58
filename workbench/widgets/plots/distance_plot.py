"""Plots how far each painted pixel lies from the ideal curve."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Signal
from PySide6.QtGui import QColor, QPen
from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.late_plot import LatePlot

Curves = Sequence[tuple[str, NDArray[np.float64]]]
_SYMBOLS, _SIZES = ("o", "s"), (9, 5)


class DistancePlot(LatePlot):
    """Distance over the number of the pixel, for one or two algorithms; a line marks the pixel painted last.

    ``pixel_wanted`` sends the number of a pixel that was clicked.
    """

    pixel_wanted = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Distance from the ideal curve"), parent)
        self._curves: list[tuple[str, NDArray[np.float64]]] = []
        self._cursor: int | None = None
        self._line: Any = None
        self.caption.setText(_("Select a figure to see how far its pixels lie from the ideal curve."))

    def show_distances(self, curves: Curves) -> None:
        """Plot these (title, distances in pixels, in the order of painting)."""
        new = [(title, values) for title, values in curves if len(values)]
        same = len(new) == len(self._curves) and all(
            a[0] == b[0] and np.array_equal(a[1], b[1]) for a, b in zip(new, self._curves, strict=True)
        )
        self._curves = new
        if not same:
            self._draw()

    def show_cursor(self, pixel: int | None) -> None:
        """Mark the pixel with this number, from 0; None marks none."""
        if pixel != self._cursor:
            self._cursor = pixel
            self._place_cursor()

    def _restyle(self) -> None:
        self._label_axes(_("px"), _("pixel k"))
        self._draw()

    def _draw(self) -> None:
        if self._plot is None:
            return
        import pyqtgraph

        now = tokens()
        plot = self._plot
        plot.clear()
        self._line = None
        plot.setVisible(bool(self._curves))
        plot.addItem(pyqtgraph.InfiniteLine(0, angle=0, pen=QPen(QColor(now.grid_strong), 0)))
        said = []
        for k, (title, values) in enumerate(self._curves):
            ink = QColor(now.data[k])
            pen = QPen(ink, 0)
            plot.plot(
                np.arange(len(values)), values, pen=pen, symbol=_SYMBOLS[k], symbolSize=_SIZES[k],
                symbolBrush=ink, symbolPen=None, antialias=True,
            )  # fmt: skip
            largest = float(np.abs(values).max())
            mean = float(np.abs(values).mean())
            text = _("{title}: at most {largest:.3f} px, on average {mean:.3f} px")
            mark = "●" if k == 0 else "■"
            said.append(
                f'<span style="color:{now.data[k]}">{mark}</span> '
                + text.format(title=title, largest=largest, mean=mean)
            )
        self.caption.setText("<br>".join(said) or _("This figure has no pixels yet."))
        self._place_cursor()

    def _place_cursor(self) -> None:
        if self._plot is None:
            return
        import pyqtgraph

        if self._line is None:
            self._line = pyqtgraph.InfiniteLine(angle=90, pen=QPen(QColor(tokens().text), 0))
            self._plot.addItem(self._line)
        self._line.setVisible(self._cursor is not None)
        if self._cursor is not None:
            self._line.setValue(self._cursor)

    def _chosen(self, x: float) -> None:
        if self._curves:
            last = len(self._curves[0][1]) - 1
            self.pixel_wanted.emit(min(last, max(0, round(x))))
