"""The curvature of a curve over its parameter."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QWidget

from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.tokens import tokens
from workbench.widgets.plots.parameter_axis import Array, number_text, same
from workbench.widgets.plots.parameter_plot import ParameterPlot
from workbench.widgets.plots.plot import pen_of
from workbench.widgets.plots.scrubbed_plot import LINE_PX

_USUAL = 98
_ROOM = 1.25


class CurvaturePlot(ParameterPlot):
    """Curvature in 1/px over u, positive to the left of the direction of travel. ``u_dragged`` as ever."""

    def __init__(self, parent: QWidget | None = None) -> None:
        self._us: Array = np.zeros(0)
        self._curvature: Array = np.zeros(0)
        self._joints: tuple[float, ...] = ()
        self._inflections: tuple[float, ...] = ()
        self._limit_height = 1.0
        self._beyond = False
        self._line: Any = None
        self._zero: Any = None
        self._joint_lines: Any = None
        self._rings: Any = None
        super().__init__(_("Curvature"), parent)
        self.setToolTip(_("Curvature along the curve; drag to move u. Joints are dashed, inflections ringed"))
        self.setMinimumSize(160, 84)

    def set_curvature(
        self,
        us: Array,
        values: Array,
        joints: Sequence[float] = (),
        inflections: Sequence[float] = (),
        whole: tuple[float, float] | None = None,
    ) -> None:
        """Plot ``values`` (m,) in 1/px over ``us`` (m,) ascending; nan leaves a gap. A joint stands twice in
        ``us`` where the curvature jumps. ``joints`` and ``inflections`` are parameters. Kept, not copied.
        The axis is that of ``us``, or ``whole``.
        """
        if len(us) > 1:
            self.set_range(*(whole or (float(us[0]), float(us[-1]))))
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
        self._limit_height = (greatest if greatest <= 2 * usual else usual) or 1.0
        self._beyond = (bool(len(known)) and greatest > self._limit_height) or bool(np.isinf(values).any())
        self.show_anew()

    @property
    def empty(self) -> bool:
        """Whether there is no curvature."""
        return len(self._us) < 2

    @property
    def words(self) -> str:
        """What is said instead."""
        return _("Select a curve: its curvature is plotted here.")

    @property
    def heights(self) -> tuple[float, float]:
        """As far to both sides of 0."""
        return -self._limit_height, self._limit_height

    def curvature_at(self, u: float) -> float:
        """The curvature at u, between the given ones; nan where there is none."""
        return float(np.interp(u, self._us, self._curvature))

    @property
    def reading(self) -> str:
        """u, the curvature there and its radius."""
        if self.empty or self.u is None:
            return super().reading
        bent = self.curvature_at(self.u)
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

    def numbers(self) -> Table | None:
        """The parameter and the curvature there."""
        if self.empty:
            return None
        rows = [(f"{u:.6g}", f"{value:.6g}") for u, value in zip(self._us, self._curvature, strict=True)]
        return Table(("u", _("curvature (1/px)")), rows, formulas=False)

    def sizeHint(self) -> QSize:
        """A thin plot."""
        return QSize(420, 110)

    def _begin(self) -> None:
        import pyqtgraph

        super()._begin()
        self._zero = pyqtgraph.InfiniteLine(0, angle=0)
        self._joint_lines = pyqtgraph.PlotCurveItem(connect="pairs")
        self._line = pyqtgraph.PlotCurveItem(connect="finite", antialias=True)
        self._rings = pyqtgraph.ScatterPlotItem(size=8)
        self._lay(self._zero, self._joint_lines, self._line, self._rings, kept=True)

    def _restyle(self) -> None:
        now = tokens()
        self._zero.setPen(pen_of(now.muted))
        self._joint_lines.setPen(pen_of(now.field_edge, 0, Qt.PenStyle.DashLine))
        self._line.setPen(pen_of(now.data[0], LINE_PX))
        self._rings.setPen(pen_of(now.text, 1.5))
        self._rings.setBrush(QColor(now.surface))
        self._spots.setPen(pen_of(now.surface, 1))
        self._spots.setBrush(QColor(now.data[0]))
        super()._restyle()

    def _bounded(self, values: Array) -> Array:
        """Within the heights; what is not a number stays none."""
        bounded: Array = np.clip(values, *self.heights)
        return bounded

    def _draw(self) -> None:
        super()._draw()
        self._line.setData(self._us, self._bounded(self._curvature))
        joints = np.repeat(np.array(self._joints), 2)
        self._joint_lines.setData(joints, np.tile(np.array(self.heights), len(self._joints)))
        self._rings.setData(np.array(self._inflections), np.zeros(len(self._inflections)))

    def _mark(self) -> None:
        if self._spots is None:
            return
        here = [] if self.empty or self.u is None else [(self.u, self.curvature_at(self.u))]
        self._spots.setData(pos=[(u, self._bounded(np.array(bent))) for u, bent in here if np.isfinite(bent)])
