"""Plots how far each painted pixel lies from the ideal curve; the library for it is loaded when seen."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QColor, QPen, QShowEvent
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from workbench.language import _
from workbench.widgets.tokens import theme_changed, tokens

Curves = Sequence[tuple[str, NDArray[np.float64]]]
_SYMBOLS, _SIZES = ("o", "s"), (9, 5)


class DistancePlot(QWidget):
    """Distance over the number of the pixel, for one or two algorithms; a line marks the pixel painted last.

    ``pixel_wanted`` sends the number of a pixel that was clicked, ``shown`` that the plot came into view.
    """

    pixel_wanted = Signal(int)
    shown = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMinimumHeight(90)
        self.setAccessibleName(_("Distance from the ideal curve"))
        self._plot: Any = None
        self._curves: list[tuple[str, NDArray[np.float64]]] = []
        self._cursor: int | None = None
        self._line: Any = None
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(4, 4, 8, 4)
        self.caption = QLabel(_("Select a figure to see how far its pixels lie from the ideal curve."))
        self.caption.setProperty("role", "caption")
        self.caption.setWordWrap(True)
        self._column.addWidget(self.caption)
        theme_changed.connect(self._draw)

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

    def showEvent(self, event: QShowEvent) -> None:
        """Load the plot when it is seen for the first time, in a turn of its own."""
        super().showEvent(event)
        if self._plot is None:
            QTimer.singleShot(0, self._make)
        self.shown.emit()

    def _make(self) -> None:
        """The plot, unless another dock has come before it meanwhile."""
        if self._plot is not None or not self.isVisible():
            return
        import pyqtgraph

        self._plot = pyqtgraph.PlotWidget()
        self._plot.setMenuEnabled(False)
        for side in ("left", "bottom"):
            self._plot.getAxis(side).enableAutoSIPrefix(False)
        self._plot.hideButtons()
        self._plot.setMouseEnabled(x=False, y=False)
        self._plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._plot.scene().sigMouseClicked.connect(self._clicked)
        self._column.addWidget(self._plot, 1)
        self._draw()

    def _draw(self) -> None:
        if self._plot is None:
            return
        import pyqtgraph

        now = tokens()
        plot = self._plot
        plot.clear()
        plot.setBackground(QColor(now.surface))
        self._line = None
        plot.setVisible(bool(self._curves))
        for side, text in (("left", _("distance (px)")), ("bottom", _("pixel k"))):
            axis = plot.getAxis(side)
            axis.setPen(QPen(QColor(now.muted), 1))
            axis.setTextPen(QPen(QColor(now.muted), 1))
            plot.setLabel(side, text, color=now.muted)
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
        self.caption.setText("&nbsp;&nbsp; ".join(said) or _("This figure has no pixels yet."))
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

    def _clicked(self, event: Any) -> None:
        if self._curves and event.button() == Qt.MouseButton.LeftButton:
            at = self._plot.getPlotItem().vb.mapSceneToView(event.scenePos()).x()
            last = len(self._curves[0][1]) - 1
            self.pixel_wanted.emit(min(last, max(0, round(at))))
