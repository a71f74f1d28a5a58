"""The hodograph: the first derivative of a curve as a curve of its own."""

from typing import Any

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QWidget

from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.parameter_axis import LEFT_PX, RIGHT_PX, ROW_PX, Array, number_text, same
from workbench.widgets.plots.plot import pen_of
from workbench.widgets.plots.scrubbed_plot import LINE_PX, ScrubbedPlot

_ROOM = 1.1
_GRAB_PX = 8
_SPOT_PX = 10


class HodographPlot(ScrubbedPlot):
    """Its axes have one scale, their origin is marked; an arrow from there is the derivative at u.

    ``u_dragged`` sends the u of the place of the hodograph nearest to the pointer.
    """

    marked_by_line = False

    def __init__(self, parent: QWidget | None = None) -> None:
        self._us: Array = np.zeros(0)
        self._points: Array = np.zeros((0, 2))
        self._box = QRectF(-0.5, -0.5, 1.0, 1.0)
        self._line: Any = None
        self._arrow: Any = None
        self._axes: list[Any] = []
        super().__init__(_("Hodograph"), parent)
        self.setToolTip(_("The first derivative as a curve; drag along it to move u"))
        self.setMinimumSize(140, 110)

    def set_hodograph(self, us: Array, points: Array) -> None:
        """Plot ``points`` (m, 2), derivatives in px per unit of u at ``us`` (m,) ascending; nan leaves a gap.
        Kept, not copied.
        """
        if same(us, self._us) and same(points, self._points):
            return
        self._us, self._points = us, points
        seen = np.vstack([points[np.isfinite(points).all(axis=1)], np.zeros((1, 2))])
        low, high = seen.min(axis=0), seen.max(axis=0)
        reach = np.maximum((high - low) * _ROOM, 1e-9)
        self._box = QRectF(*((low + high - reach) / 2).tolist(), *reach.tolist())
        if len(us) > 1:
            self._whole = float(us[0]), float(us[-1])
        self.show_anew()

    @property
    def empty(self) -> bool:
        """Whether there is no curve."""
        return len(self._us) < 2

    @property
    def words(self) -> str:
        """What is said instead."""
        return _("Select a curve: its first derivative is drawn here.")

    def derivative_at(self, u: float) -> tuple[float, float]:
        """The derivative at u, between the given ones."""
        x, y = (float(np.interp(u, self._us, self._points[:, axis])) for axis in (0, 1))
        return x, y

    @property
    def reading(self) -> str:
        """u and the derivative there."""
        if self.empty or self.u is None:
            return super().reading
        x, y = self.derivative_at(self.u)
        return _("{u}: ({x}, {y}), speed {speed} px per unit of u").format(
            u=super().reading, x=number_text(x), y=number_text(y), speed=number_text(float(np.hypot(x, y)))
        )

    @property
    def heading(self) -> str:
        """The reading, or the unit."""
        return self.reading or _("First derivative (px per unit of u)")

    def numbers(self) -> Table | None:
        """The parameter and the derivative there."""
        if self.empty:
            return None
        rows = [
            (f"{u:.6g}", f"{x:.6g}", f"{y:.6g}")
            for u, (x, y) in zip(self._us.tolist(), self._points.tolist(), strict=True)
        ]
        return Table(("u", "x'", "y'"), rows, formulas=False)

    def sizeHint(self) -> QSize:
        """About a square."""
        return QSize(220, 200)

    # Places

    @property
    def area(self) -> QRectF:
        """All but the words above and the numbers of the axes."""
        return QRectF(
            LEFT_PX,
            self.head_px,
            max(1.0, self.width() - LEFT_PX - RIGHT_PX),
            max(1.0, self.height() - self.head_px - ROW_PX),
        )

    @property
    def _seen(self) -> QRectF:
        """The derivatives in sight; y upwards."""
        if self._plot is not None:
            seen: QRectF = self._plot.getPlotItem().vb.viewRect()
            return seen
        scale = min(self.area.width() / self._box.width(), self.area.height() / self._box.height())
        seen = QRectF(0, 0, self.area.width() / scale, self.area.height() / scale)
        seen.moveCenter(self._box.center())
        return seen

    @property
    def scale(self) -> float:
        """Logical pixels for one px per unit of u, the same on both axes."""
        return self.area.width() / self._seen.width()

    def place_of(self, x: float, y: float) -> QPointF:
        """Where a derivative is painted, in logical pixels of the widget."""
        middle, scale, centre = self.area.center(), self.scale, self._seen.center()
        return QPointF(middle.x() + (x - centre.x()) * scale, middle.y() - (y - centre.y()) * scale)

    def over_u(self, place: QPointF) -> bool:
        """Whether a place of the widget is over the tip of the arrow."""
        if self.u is None or self.empty:
            return False
        return (self.place_of(*self.derivative_at(self.u)) - place).manhattanLength() <= _GRAB_PX

    def u_under(self, place: QPointF) -> float:
        """The parameter of the nearest place of the hodograph."""
        middle, scale, centre = self.area.center(), self.scale, self._seen.center()
        x = centre.x() + (place.x() - middle.x()) / scale
        y = centre.y() - (place.y() - middle.y()) / scale
        start, leg = self._points[:-1], np.diff(self._points, axis=0)
        length = np.maximum((leg**2).sum(axis=1), 1e-300)
        share = np.clip((((x, y) - start) * leg).sum(axis=1) / length, 0, 1)
        away = ((start + share[:, None] * leg - (x, y)) ** 2).sum(axis=1)
        nearest = int(np.where(np.isfinite(away), away, np.inf).argmin())
        return float(self._us[nearest] + share[nearest] * (self._us[nearest + 1] - self._us[nearest]))

    # Drawing

    def show_all(self) -> None:
        """Undo every zoom."""
        if self._plot is not None:
            self._plot.setRange(self._box, padding=0)

    def _begin(self) -> None:
        import pyqtgraph

        super()._begin()
        self._plot.setAspectLocked(True)
        self._plot.setMouseEnabled(x=True, y=True)
        self._plot.getAxis("left").setWidth(LEFT_PX)
        self._plot.getAxis("bottom").setHeight(ROW_PX)
        self._plot.showGrid(x=True, y=True, alpha=0.6)
        for side in ("left", "bottom"):
            self._plot.getAxis(side).setStyle(maxTickLevel=0)
        self._axes = [pyqtgraph.InfiniteLine(0, angle=angle) for angle in (0, 90)]
        self._line = pyqtgraph.PlotCurveItem(connect="finite", antialias=True)
        self._arrow = pyqtgraph.PlotCurveItem(antialias=True)
        self._spots.setSize(_SPOT_PX)
        self._lay(*self._axes, self._line, kept=True)
        self._lay(self._arrow)

    def _restyle(self) -> None:
        now = tokens()
        for axis in self._axes:
            axis.setPen(pen_of(now.muted))
        self._line.setPen(pen_of(now.data[0], LINE_PX))
        self._arrow.setPen(pen_of(now.text, LINE_PX))
        self._spots.setPen(pen_of(now.surface, 1.5))
        self._spots.setBrush(QColor(now.text))
        super()._restyle()

    def _draw(self) -> None:
        self._line.setData(*self._points.T)
        self.show_all()

    def _mark(self) -> None:
        if self._spots is None:
            return
        tip = np.full(2, np.nan) if self.empty or self.u is None else np.array(self.derivative_at(self.u))
        there = np.array([[0.0, 0.0], tip]) if np.isfinite(tip).all() else np.zeros((0, 2))
        self._arrow.setData(*there.T)
        self._spots.setData(pos=there[1:])
