"""Plots how deep a stack is over the steps of a run."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QPen
from PySide6.QtWidgets import QWidget

from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.plot import Plot

MOST_POINTS = 4000


class DepthPlot(Plot):
    """Depth over the number of the step; a line marks the present step.

    ``step_wanted`` sends a step that was clicked.
    """

    step_wanted = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(_("Depth of the stack"), parent)
        self._curve: Any = None
        self._limit_line: Any = None
        self._depths: NDArray[np.int64] = np.zeros(0, np.int64)
        self._cursor = 0
        self._limit = 0
        self._calls = False
        self._say()

    @property
    def depths(self) -> NDArray[np.int64]:
        """(n,) the depths shown, after steps 0 to n - 1."""
        return self._depths

    def show_depths(self, depths: NDArray[np.int64], calls: bool, limit: int = 0) -> None:
        """Plot these depths, of ``calls`` under way or of a stack; a ``limit`` that is near is marked."""
        if (calls, limit) != (self._calls, self._limit) or not np.array_equal(depths, self._depths):
            self._depths, self._calls, self._limit = depths.copy(), calls, limit
            self._draw()
            self._say()

    def show_cursor(self, step: int) -> None:
        """Mark this step."""
        if step != self._cursor:
            self._cursor = step
            self.place_cursor(step)
            self._say()

    def _say(self) -> None:
        count = len(self._depths)
        if not count:
            self.say(_("Choose a seed fill: how deep its stack is at each step is plotted here."))
            return
        deepest = int(self._depths.max())
        first = int(np.argmax(self._depths))
        now = int(self._depths[min(self._cursor, count - 1)])
        text = (
            _("{now} calls active; at most {deepest}, first at step {first}.")
            if self._calls
            else _("{now} on the stack; at most {deepest}, first after step {first}.")
        )
        self.say(text.format(now=f"{now:,}", deepest=f"{deepest:,}", first=f"{first:,}"))

    def _begin(self) -> None:
        import pyqtgraph

        self._curve = self._plot.plot([], [], antialias=True)
        self._limit_line = pyqtgraph.InfiniteLine(angle=0)
        self._lay(self._limit_line)

    def _restyle(self) -> None:
        now = tokens()
        self._label_axes(_("depth"), _("step"))
        self._curve.setPen(QPen(QColor(now.data[0]), 0))
        self._limit_line.setPen(QPen(QColor(now.error), 0, Qt.PenStyle.DashLine))
        self._draw()

    def _draw(self) -> None:
        if self._plot is None:
            return
        count = len(self._depths)
        self._plot.setVisible(count > 0)
        chosen = np.arange(count)
        if count > MOST_POINTS:
            # The greatest of each stretch, so that no peak is lost.
            stretches = np.array_split(chosen, MOST_POINTS)
            chosen = np.array([part[np.argmax(self._depths[part])] for part in stretches])
        self._curve.setData(chosen, self._depths[chosen])
        near = bool(self._limit) and count > 0 and int(self._depths.max()) > self._limit / 2
        self._limit_line.setVisible(near)
        if near:
            self._limit_line.setValue(self._limit)
            self._plot.setYRange(0, self._limit * 1.05)
        else:
            self._plot.enableAutoRange()
        self.place_cursor(self._cursor)

    @property
    def reach(self) -> tuple[float, float] | None:
        """The first and the last step."""
        return (0.0, len(self._depths) - 1.0) if len(self._depths) else None

    def numbers(self) -> Table | None:
        """Step and depth."""
        rows = [(str(step), str(depth)) for step, depth in enumerate(self._depths.tolist())]
        return Table((_("step"), _("depth")), rows, formulas=False) if rows else None

    def _chosen(self, x: float) -> None:
        self.step_wanted.emit(round(x))
