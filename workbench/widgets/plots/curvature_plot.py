"""The curvature of a curve over its parameter."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPen
from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.widgets.canvas.polygons import unbroken
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.plots.parameter_plot import (
    LEFT_PX,
    RIGHT_PX,
    ROW_PX,
    Array,
    ParameterPlot,
    number_text,
    same,
    tick_text,
    ticks,
)

_USUAL = 98
_ROOM = 1.25


class CurvaturePlot(ParameterPlot):
    """Curvature in 1/px over u, positive to the left of the direction of travel. ``u_dragged`` as ever."""

    def __init__(self, parent: QWidget | None = None) -> None:
        self._us: Array = np.zeros(0)
        self._curvature: Array = np.zeros(0)
        self._joints: tuple[float, ...] = ()
        self._inflections: tuple[float, ...] = ()
        self._limit = 1.0
        self._beyond = False
        super().__init__(_("Curvature"), parent)
        self.setToolTip(_("Curvature along the curve; drag to move u. Joints are dashed, inflections ringed"))
        self.setMinimumSize(160, 84)

    def set_curvature(
        self, us: Array, values: Array, joints: Sequence[float] = (), inflections: Sequence[float] = ()
    ) -> None:
        """Plot ``values`` (m,) in 1/px over ``us`` (m,) ascending; nan leaves a gap. A joint stands twice in
        ``us`` where the curvature jumps. ``joints`` and ``inflections`` are parameters. Kept, not copied.
        """
        marks = tuple(map(float, joints)), tuple(map(float, inflections))
        if (
            same(us, self._us)
            and same(values, self._curvature)
            and marks == (self._joints, self._inflections)
        ):
            return
        self._us, self._curvature = us, values
        self._joints, self._inflections = marks
        known = np.abs(values[np.isfinite(values)])
        usual = float(np.percentile(known, _USUAL)) * _ROOM if len(known) else 0.0
        greatest = float(known.max()) if len(known) else 0.0
        # One cusp must not make a line of all the rest.
        self._limit = (greatest if greatest <= 2 * usual else usual) or 1.0
        self._beyond = (bool(len(known)) and greatest > self._limit) or bool(np.isinf(values).any())
        if len(us) > 1:
            self.set_range(float(us[0]), float(us[-1]))
        self.show_anew()

    @property
    def empty(self) -> bool:
        """Whether there is no curvature."""
        return len(self._us) < 2

    @property
    def words(self) -> str:
        """What is said instead."""
        return _("Select a curve: its curvature is plotted here.")

    def curvature_at(self, u: float) -> float:
        """The curvature at u, between the given ones; nan where there is none."""
        return float(np.interp(u, self._us, self._curvature))

    @property
    def reading(self) -> str:
        """u, the curvature there and its radius."""
        if self.empty or self._u is None:
            return super().reading
        bent = self.curvature_at(self._u)
        if not np.isfinite(bent):
            return _("{u}: no curvature here").format(u=super().reading)
        radius = number_text(1 / abs(bent)) + " px" if bent else _("infinite")
        return _("{u}: curvature {value} 1/px, radius {radius}").format(
            u=super().reading, value=number_text(bent), radius=radius
        )

    @property
    def heading(self) -> str:
        """What stands above the plot."""
        said = self.reading or _("Curvature (1/px)")
        return _("{what}; peaks are cut off").format(what=said) if self._beyond else said

    def sizeHint(self) -> QSize:
        """A thin plot."""
        return QSize(420, 110)

    @property
    def area(self) -> QRectF:
        """Room for the reading above and numbers below."""
        return super().area.adjusted(0, ROW_PX, 0, -ROW_PX + 4)

    def _ys(self, values: Array) -> Array:
        area = self.area
        placed: Array = area.center().y() - np.clip(values / self._limit, -1, 1) * area.height() / 2
        return placed

    def paint_kept(self, painter: QPainter) -> None:
        """Axes, joints, the line, inflections."""
        now, area = tokens(), self.area
        self.paint_axis(painter)
        flags = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        for level in ticks(-self._limit, self._limit, max(2, int(area.height() / 22))):
            y = round(float(self._ys(np.array(level)))) + 0.5
            painter.setPen(QPen(colour(now.muted if level == 0 else now.grid), 1))
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
            painter.setPen(colour(now.muted))
            painter.drawText(QRectF(0, y - ROW_PX / 2, LEFT_PX - 5, ROW_PX), flags, tick_text(level))
        for u in self.tick_values():
            box = QRectF(self.x_of(u) - 30, area.bottom() + 1, 60, ROW_PX)
            painter.drawText(box, Qt.AlignmentFlag.AlignHCenter, tick_text(u))
        painter.setPen(QPen(colour(now.field_edge), 1, Qt.PenStyle.DashLine))
        for u in self._joints:
            painter.drawLine(QPointF(self.x_of(u), area.top()), QPointF(self.x_of(u), area.bottom()))
        painter.setPen(QPen(colour(now.data[0]), 1.6))
        low, high = self.range
        x = area.left() + (self._us - low) / (high - low) * area.width()
        bounded = np.nan_to_num(self._curvature, nan=np.nan, posinf=2 * self._limit, neginf=-2 * self._limit)
        for line in unbroken(x, self._ys(bounded)):
            painter.drawPolyline(line)
        painter.setPen(QPen(colour(now.text), 1.5))
        painter.setBrush(colour(now.surface))
        for u in self._inflections:
            painter.drawEllipse(QPointF(self.x_of(u), float(self._ys(np.array(0.0)))), 4, 4)
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def paint_marks(self, painter: QPainter) -> None:
        """u, with the curvature there in words and as a spot."""
        super().paint_marks(painter)
        now = tokens()
        said = self.heading
        painter.setPen(colour(now.muted))
        box = QRectF(6, 0, self.width() - 6 - RIGHT_PX, ROW_PX + 2)
        said = painter.fontMetrics().elidedText(said, Qt.TextElideMode.ElideRight, int(box.width()))
        painter.drawText(box, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, said)
        if self._u is not None and np.isfinite(self.curvature_at(self._u)):
            painter.setPen(QPen(colour(now.surface), 1))
            painter.setBrush(colour(now.data[0]))
            y = float(self._ys(np.array(self.curvature_at(self._u))))
            painter.drawEllipse(QPointF(self.x_of(self._u), y), 4, 4)
            painter.setBrush(Qt.BrushStyle.NoBrush)
