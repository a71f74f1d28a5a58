"""A plot over the steps of a run whose library is loaded when it is first seen."""

from typing import Any

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QColor, QPen, QShowEvent
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from workbench.widgets.look.tokens import theme_changed, tokens


class LatePlot(QWidget):
    """A caption over a pyqtgraph plot. ``shown``: it came into view.

    A plot says in ``_begin`` what it holds, in ``_restyle`` how that looks in the theme, and in ``_chosen``
    what a click at x means.
    """

    shown = Signal()

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMinimumHeight(90)
        self.setAccessibleName(name)
        self._plot: Any = None
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(4, 4, 8, 4)
        self.caption = QLabel()
        self.caption.setProperty("role", "caption")
        self.caption.setWordWrap(True)
        self._column.addWidget(self.caption)
        theme_changed.connect(self._take_theme)

    def _begin(self) -> None:
        """Put lines on the new plot."""

    def _restyle(self) -> None:
        """Show everything in the theme's colours."""

    def _chosen(self, x: float) -> None:
        """The plot was clicked at x."""

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
        self._begin()
        self._column.addWidget(self._plot, 1)
        self._restyle()

    def _take_theme(self) -> None:
        if self._plot is not None:
            self._restyle()

    def _label_axes(self, left: str, bottom: str) -> None:
        """Background and axes in the theme's colours."""
        now = tokens()
        self._plot.setBackground(QColor(now.surface))
        for side, text in (("left", left), ("bottom", bottom)):
            axis = self._plot.getAxis(side)
            axis.setPen(QPen(QColor(now.muted), 1))
            axis.setTextPen(QPen(QColor(now.muted), 1))
            self._plot.setLabel(side, text, color=now.muted)

    def _clicked(self, event: Any) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._chosen(self._plot.getPlotItem().vb.mapSceneToView(event.scenePos()).x())
