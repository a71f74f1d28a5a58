"""Basis functions, knots and weights of a curve above one another, on one parameter axis."""

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from workbench.language import _
from workbench.widgets.look.tokens import colour, theme, tokens
from workbench.widgets.plots.basis_curves import BasisCurves
from workbench.widgets.plots.knot_bar import KnotBar, Knots
from workbench.widgets.plots.parameter_axis import Array
from workbench.widgets.plots.weight_bars import WeightBars


class BasisPlot(QWidget):
    """The functions (``curves``), the knot bar (``knots``) beneath, the weights (``weights``) at the foot.

    ``u_dragged``: the u that a hand asks for, a parameter of the curve (not a share of it). ``hovered``: the
    number of the point that is pointed at, or -1. ``knot_dragged``, ``knot_released``, ``knot_wanted`` (a
    new one at u), ``weight_dragged``, ``weight_released``: what a hand wants. What is shown changes only by
    the methods, which repaint only what differs.
    """

    u_dragged = Signal(float)
    hovered = Signal(int)
    knot_dragged = Signal(str, float)
    knot_released = Signal(str)
    knot_wanted = Signal(float)
    knot_unwanted = Signal(str)
    weight_dragged = Signal(int, float)
    weight_released = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(_("Basis functions, knots and weights"))
        self.curves, self.knots, self.weights = BasisCurves(), KnotBar(), WeightBars()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.curves, 3)
        column.addWidget(self.knots)
        column.addWidget(self.weights, 2)
        self.knots.hide()
        self.weights.hide()
        self.setFocusProxy(self.curves)
        for part in (self.curves, self.knots):
            part.u_dragged.connect(self.u_dragged)
        self.curves.view_changed.connect(self.knots.set_range)
        for lit in (self.curves, self.weights):
            lit.hovered.connect(self._point_at)
        self.knots.knot_dragged.connect(self.knot_dragged)
        self.knots.knot_released.connect(self._knot_released)
        self.knots.knot_wanted.connect(self.knot_wanted)
        self.knots.knot_unwanted.connect(self.knot_unwanted)
        self.weights.weight_dragged.connect(self.weight_dragged)
        self.weights.weight_released.connect(self.weight_released)
        theme.changed.connect(self.update)

    def set_functions(self, us: Array, values: Array, names: Sequence[str], inks: Sequence[str] = ()) -> None:
        """Plot functions: ``us`` (m,) ascending, ``values`` (m, n), n names such as "N_{3}", and names of
        colours of the theme ("data1" to "data6" in turn when left out). Empty arrays show the empty state.
        """
        self.curves.set_functions(us, values, names, inks)
        self._fit()

    def set_knots(self, knots: Knots, movable: bool = True) -> None:
        """Show knots (id, u), ascending; none hides the bar. ``movable``: whether they can be dragged."""
        self.knots.set_knots(knots, movable)
        self.knots.setVisible(bool(self.knots.knots))
        self.curves.set_numbered(self.knots.isHidden())
        self._fit()

    def set_weights(
        self, weights: Sequence[float], names: Sequence[str] = (), inks: Sequence[str] = ()
    ) -> None:
        """Show weights above 0 of the points, with their names; none hides the bars."""
        self.weights.set_weights(weights, names or [f"P_{{{k}}}" for k in range(len(weights))], inks)
        self.weights.setVisible(bool(self.weights.weights))

    def set_domain(self, domain: tuple[float, float] | None) -> None:
        """Where the curve is, when that is less than what the knots or functions cover."""
        self.curves.set_domain(domain)
        self.knots.set_domain(domain)

    def set_u(self, u: float | None) -> None:
        """Mark a parameter; None marks none."""
        self.curves.set_u(u)
        self.knots.set_u(u)

    def highlight(self, number: int) -> None:
        """Light up the function and the weight of a point; -1 lights up none."""
        self.curves.highlight(number)
        self.weights.highlight(number)

    def _point_at(self, number: int) -> None:
        self.highlight(number)
        self.hovered.emit(number)

    def _knot_released(self, name: str) -> None:
        self._fit()
        self.knot_released.emit(name)

    def _fit(self) -> None:
        """Show all there is; the axis holds still while a knot is held."""
        if self.knots.holding:
            return
        ends = [u for _name, u in self.knots.knots]
        if not self.curves.empty:
            ends += self.curves.ends
        if ends:
            self.curves.set_range(min(ends), max(ends))

    def paintEvent(self, event: QPaintEvent) -> None:
        """The ground of a panel."""
        QPainter(self).fillRect(event.rect(), colour(tokens().surface))
