"""A plot over a curve's parameter, on the axis that those above and below it have too."""

from typing import Any, overload

from PySide6.QtCore import QPointF, QRectF, Signal
from PySide6.QtGui import QColor, QPen
from PySide6.QtWidgets import QWidget

from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.parameter_axis import (
    GRAB_PX,
    LEFT_PX,
    RIGHT_PX,
    ROW_PX,
    TICKS_PX,
    Array,
    tick_text,
    ticks,
)
from workbench.widgets.plots.plot import pen_of
from workbench.widgets.plots.scrubbed_plot import ScrubbedPlot

_LEVELS_PX = 22
_FOOT_PX = 5


class ParameterPlot(ScrubbedPlot):
    """Its horizontal axis is u. ``view_changed`` sends the least and the greatest u in sight.

    Its range of heights is fixed by what is plotted, with ``over_px`` free above: only u is zoomed and moved.
    """

    view_changed = Signal(float, float)
    over_px = 0

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        self._view = (0.0, 1.0)
        self._numbered = True
        self._shades: list[Any] = []
        self._grid: Any = None
        self._ruled: object = None
        super().__init__(name, parent)

    @property
    def heights(self) -> tuple[float, float]:
        """The least and the greatest height plotted."""
        return 0.0, 1.0

    @property
    def whole(self) -> tuple[float, float]:
        """The least and the greatest parameter there is to see."""
        return self._whole

    @property
    def range(self) -> tuple[float, float]:
        """The least and the greatest parameter in sight."""
        return self._view

    def set_range(self, low: float, high: float) -> None:
        """There is something to see from low to high: show all of it, unless this is known."""
        whole = (low, high) if high > low else (low - 0.5, low + 0.5)
        if whole != self._whole:
            self._whole = whole
            if self._plot is not None:
                self._limit()
            self.show_all()

    def show_view(self, low: float, high: float) -> None:
        """Bring the parameters from low to high into sight, as far as there is something to see."""
        least, greatest = self._whole
        view = max(low, least), min(high, greatest)
        if view == self._view or not view[1] > view[0]:
            return
        if self._plot is None:
            self._see(view)
        else:
            self._plot.setXRange(*view, padding=0)

    def show_all(self) -> None:
        """Undo every zoom."""
        self.show_view(*self._whole)

    def set_domain(self, domain: tuple[float, float] | None) -> None:
        """Where the curve is, when that is less than what is shown; what lies beyond is shaded."""
        if domain != self._domain:
            self._domain = domain
            self.show_anew()

    def set_numbered(self, numbered: bool) -> None:
        """Whether the axis has its numbers, when nothing below says them."""
        if numbered != self._numbered:
            self._numbered = numbered
            self.show_anew()

    def _limit(self) -> None:
        low, high = self._whole
        self._plot.setLimits(xMin=low, xMax=high)

    def _see(self, view: tuple[float, float]) -> None:
        if view != self._view:
            self._view = view
            self.show_anew()
            self.view_changed.emit(*view)

    # Places

    @property
    def area(self) -> QRectF:
        """Where the plot lies in the widget, in logical pixels."""
        foot = ROW_PX if self._numbered else _FOOT_PX
        return QRectF(
            LEFT_PX,
            self.head_px,
            max(1.0, self.width() - LEFT_PX - RIGHT_PX),
            max(1.0, self.height() - self.head_px - foot),
        )

    def x_of(self, u: float) -> float:
        """The place of a parameter, in logical pixels of the widget."""
        low, high = self._view
        return self.area.left() + (u - low) / (high - low) * self.area.width()

    def u_at(self, x: float) -> float:
        """The parameter at a place of the widget, wherever it lies."""
        low, high = self._view
        return low + (x - self.area.left()) / self.area.width() * (high - low)

    def _top(self) -> float:
        """The height at the upper edge: that of ``over_px`` above the greatest."""
        low, high = self.heights
        tall = self.area.height()
        return low + (high - low) * tall / max(tall - self.over_px, 1.0)

    @overload
    def y_of(self, height: float) -> float: ...
    @overload
    def y_of(self, height: Array) -> Array: ...
    def y_of(self, height: float | Array) -> float | Array:
        """The places of heights, in logical pixels of the widget."""
        low = self.heights[0]
        return self.area.bottom() - (height - low) / (self._top() - low) * self.area.height()

    def u_under(self, place: QPointF) -> float:
        """The parameter at the pointer."""
        return self.u_at(place.x())

    def over_u(self, place: QPointF) -> bool:
        """Whether a place of the widget is over the line at u."""
        return self.u is not None and not self.empty and abs(place.x() - self.x_of(self.u)) <= GRAB_PX

    # Drawing

    def _begin(self) -> None:
        import pyqtgraph

        super()._begin()
        self._plot.getAxis("left").setWidth(LEFT_PX)
        self._plot.showGrid(x=False, y=False)
        self._grid = pyqtgraph.PlotCurveItem(connect="pairs")  # the axes' own is drawn anew with every line
        self._grid.setZValue(-2)
        self._lay(self._grid, kept=True)
        self._shades = [pyqtgraph.LinearRegionItem(movable=False) for _side in range(2)]
        for shade in self._shades:
            shade.setZValue(-1)
        self._lay(*self._shades, kept=True)
        self._limit()
        self._plot.setXRange(*self._view, padding=0)
        self._plot.getPlotItem().vb.sigXRangeChanged.connect(lambda _box, view: self._see(tuple(view)))

    def _restyle(self) -> None:
        self._ruled = None
        self._grid.setPen(pen_of(tokens().grid))
        shade = QColor(tokens().grid)
        shade.setAlpha(140)
        for region in self._shades:
            region.setBrush(shade)
            for line in region.lines:
                line.setPen(QPen(QColor(0, 0, 0, 0)))
        super()._restyle()

    def _draw(self) -> None:
        """Range, ticks and shades, unless they are those."""
        ruled = self._view, self._whole, self.domain, self.heights, self._numbered, self.size()
        if ruled != self._ruled:
            self._ruled = ruled
            self._rule()

    def _rule(self) -> None:
        (low, high), top = self.heights, self._top()
        self._plot.setYRange(low, top, padding=0)
        bottom = self._plot.getAxis("bottom")
        bottom.setStyle(showValues=self._numbered)
        bottom.setHeight(ROW_PX if self._numbered else _FOOT_PX)
        rounds = ticks(*self._view, max(2, int(self.area.width() // TICKS_PX)))
        levels = ticks(low, high, max(2, int(self.area.height() / _LEVELS_PX)))
        for side, places in (("bottom", rounds), ("left", levels)):
            self._plot.getAxis(side).setTicks([[(place, tick_text(place)) for place in places]])
        ends = [x for place in rounds for x in (place, place)] + [*self._view] * len(levels)
        self._grid.setData(ends, [low, top] * len(rounds) + [y for level in levels for y in (level, level)])
        sides = (self._whole[0], self.domain[0]), (self.domain[1], self._whole[1])
        for shade, (start, end) in zip(self._shades, sides, strict=True):
            shade.setVisible(end > start)
            shade.setRegion((start, end))
