"""Plots how deep a stack is over the steps of a run."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QPen
from PySide6.QtWidgets import QWidget

from workbench.exchange.tables import Table
from workbench.language import _, ngettext
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
        self._begin_at = self._cursor = self._now = 0
        self._limit = 0
        self._calls = False
        self._whole = True
        self._say()

    @property
    def depths(self) -> NDArray[np.int64]:
        """(n,) the depths shown, after the steps ``begin_at`` to ``begin_at`` + n - 1."""
        return self._depths

    @property
    def begin_at(self) -> int:
        """The step after which the first depth was."""
        return self._begin_at

    def show_depths(
        self,
        depths: NDArray[np.int64],
        calls: bool,
        limit: int = 0,
        *,
        begin_at: int = 0,
        whole: bool = True,
    ) -> None:
        """Plot these depths, of ``calls`` under way or of a stack; a ``limit`` that is near is marked.

        The first is that after step ``begin_at``; ``whole``: they are those of all steps of the run.
        """
        shown = (calls, limit, begin_at, whole)
        known = (self._calls, self._limit, self._begin_at, self._whole)
        if shown != known or not np.array_equal(depths, self._depths):
            self._depths = depths.copy()
            self._calls, self._limit, self._begin_at, self._whole = shown
            self._draw()
            self._say()

    def show_cursor(self, step: int, now: int) -> None:
        """Mark this step; the depth is ``now`` there, be it counted yet or not."""
        if (step, now) != (self._cursor, self._now):
            self._cursor, self._now = step, now
            self.place_cursor(step)
            self._say()

    def _say(self) -> None:
        count = len(self._depths)
        if not count:
            self.say(_("Choose a seed fill: how deep its stack is at each step is plotted here."))
            return
        deepest = int(self._depths.max())
        first = self._begin_at + int(np.argmax(self._depths))
        if self._whole and self._calls:
            text = ngettext(
                "{now} call active; at most {deepest}, first at step {first}.",
                "{now} calls active; at most {deepest}, first at step {first}.",
                self._now,
            )
        elif self._whole:
            text = _("{now} on the stack; at most {deepest}, first after step {first}.")
        elif self._calls:
            text = ngettext(
                "{now} call active. Counted so far, from step {begin} to {end}: at most {deepest}, first at "
                "step {first}.",
                "{now} calls active. Counted so far, from step {begin} to {end}: at most {deepest}, first at "
                "step {first}.",
                self._now,
            )
        else:
            text = _(
                "{now} on the stack. Counted so far, from step {begin} to {end}: at most {deepest}, first "
                "after step {first}."
            )
        numbers = {
            "now": self._now,
            "deepest": deepest,
            "first": first,
            "begin": self._begin_at,
            "end": self._begin_at + count - 1,
        }
        self.say(text.format(**{name: f"{number:,}" for name, number in numbers.items()}))

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
        self._curve.setData(self._begin_at + chosen, self._depths[chosen])
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
        """The first and the last step that is counted."""
        count = len(self._depths)
        return (float(self._begin_at), self._begin_at + count - 1.0) if count else None

    def numbers(self) -> Table | None:
        """Step and depth."""
        rows = [(str(step), str(depth)) for step, depth in enumerate(self._depths.tolist(), self._begin_at)]
        return Table((_("step"), _("depth")), rows, formulas=False) if rows else None

    def _chosen(self, x: float) -> None:
        self.step_wanted.emit(round(x))
