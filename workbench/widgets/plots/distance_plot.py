"""Plots how far each painted pixel lies from the ideal curve."""

from collections.abc import Sequence
from html import escape
from itertools import pairwise, zip_longest
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Signal
from PySide6.QtGui import QColor, QPen
from PySide6.QtWidgets import QWidget

from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.plot import Plot

Curves = Sequence[tuple[str, NDArray[np.float64]]]
_SYMBOLS, _SIZES = ("o", "s"), (9, 5)
MOST_SYMBOLS = 1_000  # more run into one another
MOST_DRAWN = 4_000


def peaks(values: NDArray[np.float64]) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Numbers and values to draw: all, or the least and the greatest of each stretch of very many."""
    if len(values) <= MOST_DRAWN:
        return np.arange(len(values)), values
    ends = np.linspace(0, len(values), MOST_DRAWN // 2 + 1).astype(np.int64)
    stretches = [slice(a, b) for a, b in pairwise(ends.tolist())]
    extremes = {s.start + int(at) for s in stretches for at in (values[s].argmin(), values[s].argmax())}
    numbers = np.array(sorted(extremes), np.int64)
    return numbers, values[numbers]


class DistancePlot(Plot):
    """Distance over the number of the pixel, for one or two algorithms; a line marks the pixel painted last.

    ``pixel_wanted`` sends the number of a pixel that was clicked.
    """

    pixel_wanted = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Distance from the ideal curve"), parent)
        self._curves: list[tuple[str, NDArray[np.float64]]] = []
        self._lines: list[Any] = []
        self.say(_("Select a figure to see how far its pixels are from the ideal curve."))

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
        self.place_cursor(pixel)

    def _begin(self) -> None:
        import pyqtgraph

        self._zero = pyqtgraph.InfiniteLine(0, angle=0)
        self._plot.addItem(self._zero)

    def _restyle(self) -> None:
        self._label_axes(_("px"), _("pixel k"))
        self._draw()

    def _draw(self) -> None:
        if self._plot is None:
            return
        now = tokens()
        plot = self._plot
        for line in self._lines:
            plot.removeItem(line)
        self._lines = []
        plot.setVisible(bool(self._curves))
        self._zero.setPen(QPen(QColor(now.grid_strong), 0))
        said, plain = [], []
        for k, (title, values) in enumerate(self._curves):
            ink = QColor(now.data[k])
            pen = QPen(ink, 0)
            few = len(values) <= MOST_SYMBOLS
            line = plot.plot(
                *peaks(values), pen=pen, symbol=_SYMBOLS[k] if few else None,
                symbolSize=_SIZES[k], symbolBrush=ink, symbolPen=None, antialias=few,
            )  # fmt: skip
            self._lines.append(line)
            largest = float(np.abs(values).max())
            mean = float(np.abs(values).mean())
            text = _("{title}: at most {largest:.3f} px, on average {mean:.3f} px")
            mark = "●" if k == 0 else "■"
            plain.append(text.format(title=title, largest=largest, mean=mean))
            said.append(f'<span style="color:{now.data[k]}">{mark}</span> {escape(plain[-1])}')
        self.say("<br>".join(said) or _("This figure has no pixels yet."), "; ".join(plain))

    @property
    def reach(self) -> tuple[float, float] | None:
        """The first and the last pixel of the first algorithm."""
        return (0.0, len(self._curves[0][1]) - 1.0) if self._curves else None

    def numbers(self) -> Table | None:
        """The number of the pixel and each distance."""
        if not self._curves:
            return None
        columns = [[f"{value:.6g}" for value in values] for _title, values in self._curves]
        rows = [(str(k), *row) for k, row in enumerate(zip_longest(*columns, fillvalue=""))]
        return Table((_("pixel k"), *(title for title, _values in self._curves)), rows, formulas=False)

    def _chosen(self, x: float) -> None:
        self.pixel_wanted.emit(round(x))
