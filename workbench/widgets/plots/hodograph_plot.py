"""The hodograph: the first derivative of a curve as a curve of its own."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPen
from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.widgets.canvas.polygons import unbroken
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.plots.parameter_plot import ROW_PX, Array, ParameterPlot, number_text, same, ticks

_ROOM = 1.1
_TICKS_PX = 48
_GRAB_PX = 8


class HodographPlot(ParameterPlot):
    """Its axes have one scale, their origin is marked; an arrow from there is the derivative at u.

    ``u_dragged`` sends the u of the place of the hodograph nearest to the pointer.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        self._us: Array = np.zeros(0)
        self._points: Array = np.zeros((0, 2))
        self._centre = (0.0, 0.0)
        self._reach = (1.0, 1.0)
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
        self._centre = tuple(((low + high) / 2).tolist())
        self._reach = tuple(np.maximum((high - low) * _ROOM, 1e-9).tolist())
        if len(us) > 1:
            self.set_range(float(us[0]), float(us[-1]))
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
        if self.empty or self._u is None:
            return super().reading
        x, y = self.derivative_at(self._u)
        return _("{u}: ({x}, {y}), speed {speed} px per unit of u").format(
            u=super().reading, x=number_text(x), y=number_text(y), speed=number_text(float(np.hypot(x, y)))
        )

    def sizeHint(self) -> QSize:
        """About a square."""
        return QSize(220, 200)

    @property
    def area(self) -> QRectF:
        """All but a line of words above."""
        return QRectF(self.rect()).adjusted(6, ROW_PX + 4, -6, -6)

    @property
    def scale(self) -> float:
        """Logical pixels for one px per unit of u, the same on both axes."""
        return min(self.area.width() / self._reach[0], self.area.height() / self._reach[1])

    def place_of(self, x: float, y: float) -> QPointF:
        """Where a derivative is painted."""
        middle, scale = self.area.center(), self.scale
        return QPointF(middle.x() + (x - self._centre[0]) * scale, middle.y() - (y - self._centre[1]) * scale)

    def over_u(self, place: QPointF) -> bool:
        """Whether a place of the widget is over the tip of the arrow."""
        if self._u is None or self.empty:
            return False
        return (self.place_of(*self.derivative_at(self._u)) - place).manhattanLength() <= _GRAB_PX

    def u_under(self, place: QPointF) -> float:
        """The parameter of the nearest place of the hodograph."""
        middle, scale = self.area.center(), self.scale
        x = self._centre[0] + (place.x() - middle.x()) / scale
        y = self._centre[1] - (place.y() - middle.y()) / scale
        start, leg = self._points[:-1], np.diff(self._points, axis=0)
        length = np.maximum((leg**2).sum(axis=1), 1e-300)
        share = np.clip((((x, y) - start) * leg).sum(axis=1) / length, 0, 1)
        away = ((start + share[:, None] * leg - (x, y)) ** 2).sum(axis=1)
        nearest = int(np.where(np.isfinite(away), away, np.inf).argmin())
        return float(self._us[nearest] + share[nearest] * (self._us[nearest + 1] - self._us[nearest]))

    def paint_kept(self, painter: QPainter) -> None:
        """Grid, axes through the origin, the curve, its first end ringed."""
        now, area = tokens(), self.area
        painter.setClipRect(area)
        half = area.width() / 2 / self.scale, area.height() / 2 / self.scale
        count = max(2, int(min(area.width(), area.height()) / _TICKS_PX))
        span = min(half)
        steps = ticks(-span, span, count)
        step = steps[1] - steps[0] if len(steps) > 1 else span
        for axis, reach in enumerate(half):
            middle = self._centre[axis]
            for k in range(int(np.ceil((middle - reach) / step)), int((middle + reach) // step) + 1):
                place = self.place_of(k * step, k * step)
                painter.setPen(QPen(colour(now.muted if k == 0 else now.grid), 1))
                if axis == 0:
                    x = round(place.x()) + 0.5
                    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()))
                else:
                    y = round(place.y()) + 0.5
                    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
        painter.setPen(QPen(colour(now.data[0]), 1.6))
        centre, scale = area.center(), self.scale
        xs = centre.x() + (self._points[:, 0] - self._centre[0]) * scale
        ys = centre.y() - (self._points[:, 1] - self._centre[1]) * scale
        for line in unbroken(xs, ys):
            painter.drawPolyline(line)
        painter.setClipping(False)
        self._paint_unit(painter, step)

    def _paint_unit(self, painter: QPainter, step: float) -> None:
        painter.setPen(colour(tokens().muted))
        text = _("grid: {step} px per unit of u").format(step=number_text(step))
        flags = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignBottom
        painter.drawText(self.area.adjusted(4, 0, -2, -1), flags, text)

    def paint_u(self, painter: QPainter, u: float) -> None:
        """An arrow from the origin to the derivative at u, and the reading."""
        now = tokens()
        x, y = self.derivative_at(u)
        if np.isfinite(x) and np.isfinite(y):
            tip, origin = self.place_of(x, y), self.place_of(0.0, 0.0)
            painter.setPen(QPen(colour(now.text), 1.5))
            painter.drawLine(origin, tip)
            painter.setPen(QPen(colour(now.surface), 1.5))
            painter.setBrush(colour(now.text))
            painter.drawEllipse(tip, 5, 5)
            painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(colour(now.muted))
        box = QRectF(6, 0, self.width() - 12, ROW_PX + 2)
        said = painter.fontMetrics().elidedText(self.reading, Qt.TextElideMode.ElideRight, int(box.width()))
        painter.drawText(box, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, said)
