"""The docks of the Curves panel: basis functions with knots and weights, curvature, hodograph, switches."""

import time
from collections.abc import Callable

import numpy as np
from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtWidgets import QWidget

from workbench.algorithms import curves
from workbench.algorithms.curves import Pieces, piece_points
from workbench.algorithms.numerals import with_minus
from workbench.document.curves.pieces import fault_of, parameter_at, share_at
from workbench.document.model import B_SPLINES, Curve
from workbench.language import _
from workbench.panels.curves.basis import MOST, NOTHING, Basis, basis_of
from workbench.panels.curves.compare import MEASURED_DEGREE, compared, measures, rows, why_none
from workbench.panels.curves.crossings import crossing_words
from workbench.panels.curves.focus import CurveFocus
from workbench.panels.curves.insight import CurveInsight
from workbench.panels.curves.joints import joint_point, joints
from workbench.panels.curves.shape import device_pieces
from workbench.panels.panel import DockPart
from workbench.widgets.canvas.drawing import data_ink
from workbench.widgets.plots.basis_plot import BasisPlot
from workbench.widgets.plots.curvature_plot import CurvaturePlot
from workbench.widgets.plots.hodograph_plot import HodographPlot
from workbench.widgets.tables.continuity_table import ContinuityTable
from workbench.widgets.tables.measure_table import MeasureTable

PER_PIECE, MOST_SAMPLES = 48, 4000
_MOST_MARKS = 200
# While something is dragged the docks follow at most so often.
THROTTLE_MS, REST_MS = 60, 300
LIVE_MS = 6.0


class CurveDocks(QObject):
    """Keeps the docks in step; ``refresh`` after anything changed, ``refresh_soon`` while it is dragged.

    ``knot_dragged``, ``knot_released``, ``knot_wanted``, ``knot_unwanted``, ``weight_dragged`` and
    ``weight_released`` are what a hand wants of the curve.
    """

    knot_dragged = Signal(str, float)
    knot_released = Signal(str)
    knot_wanted = Signal(float)
    knot_unwanted = Signal(str)
    weight_dragged = Signal(int, float)
    weight_released = Signal()
    smoothing_wanted = Signal(int, str)
    kind_wanted = Signal(str)

    def __init__(self, focus: CurveFocus, parent: QWidget) -> None:
        super().__init__(parent)
        self.focus = focus
        self.basis, self.curvature, self.hodograph = BasisPlot(), CurvaturePlot(), HodographPlot()
        self.insight, self.continuity = CurveInsight(focus), ContinuityTable()
        self._said_of: Curve | None = None
        self.continuity.joint_activated.connect(self._go_to_joint)
        self.continuity.joint_selected.connect(self._hover_joint)
        self.continuity.smoothing_wanted.connect(self.smoothing_wanted)
        self.measured = MeasureTable()
        self.measured.kind_activated.connect(self._choose_kind)
        self._basis: Basis = NOTHING
        self._pieces: Pieces | None = None
        self._u: float | None = None
        self._took_ms = 0.0
        self._made_for: tuple[object, ...] = ()
        for plot in (self.basis, self.curvature, self.hodograph):
            plot.u_dragged.connect(self._go_to)
        self.basis.curves.view_changed.connect(self.curvature.show_view)
        self.curvature.view_changed.connect(self.basis.curves.show_view)
        self.basis.hovered.connect(self._hover)
        self.basis.knot_dragged.connect(self.knot_dragged)
        self.basis.knot_released.connect(self.knot_released)
        self.basis.knot_wanted.connect(self.knot_wanted)
        self.basis.knot_unwanted.connect(self.knot_unwanted)
        self.basis.weight_dragged.connect(self._drag_weight)
        self.basis.weight_released.connect(lambda _number: self.weight_released.emit())
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.timeout.connect(self._refresh_in_turns)
        self._parts_left: list[Callable[[], None]] = []
        self._next = QTimer(self)
        self._next.setSingleShot(True)
        self._next.timeout.connect(self._show_next)
        self._kinds = QTimer(self)
        self._kinds.setSingleShot(True)
        self._kinds.setInterval(THROTTLE_MS)
        self._kinds.timeout.connect(self._show_kinds)

    def parts(self) -> list[DockPart]:
        """Name, title, widget and place of each dock."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return [
            ("basis", _("Basis functions"), self.basis, right),
            ("insight", _("Insight"), self.insight, right),
            ("kinds", _("Kinds compared"), self.measured, right),
            ("continuity", _("Continuity"), self.continuity, right),
            ("curvature", _("Curvature"), self.curvature, right),
            ("hodograph", _("Hodograph"), self.hodograph, right),
        ]

    @property
    def comparing(self) -> bool:
        """Whether the comparison of kinds is still to be shown."""
        return self._kinds.isActive()

    def refresh_soon(self) -> None:
        """Follow a drag, but not at every step of it; what takes long waits until the hand rests."""
        if self._took_ms >= LIVE_MS:
            self._later.start(REST_MS)
        elif not self._later.isActive():
            self._later.start(THROTTLE_MS)

    def refresh(self) -> None:
        """Everything that can be seen, from the session alone."""
        self._refresh_in_turns()
        while self._parts_left:
            self._show_next()

    def _refresh_in_turns(self) -> None:
        """Each part that can be seen in a turn of its own: a drag goes on between them."""
        self._later.stop()
        begun = time.perf_counter()
        curve = self.focus.curve
        if curve is not self._said_of:
            self._said_of = curve
            self.continuity.say("")
        self._pieces = None if curve is None else device_pieces(self.focus.session.shown, curve)
        self._u = None if curve is None or self._pieces is None else parameter_at(curve, self.focus.u)
        self._took_ms = (time.perf_counter() - begun) * 1e3
        parts: tuple[tuple[QWidget, Callable[[], None]], ...] = (
            (self.basis, self._show_basis),
            (self.curvature, self._show_curvature),
            (self.hodograph, self._show_hodograph),
            (self.continuity, self._show_joints),
            (self.measured, self._kinds.start),
            (self.insight, self._show_measures),
        )
        self._parts_left = [show for part, show in parts if part.isVisible()]
        self._next.start()

    def _show_next(self) -> None:
        begun = time.perf_counter()
        if self._parts_left:
            self._parts_left.pop(0)()
        self._took_ms += (time.perf_counter() - begun) * 1e3
        if self._parts_left:
            self._next.start()
        else:
            self._next.stop()

    def _show_kinds(self) -> None:
        """The comparison has a turn of its own: it measures several curves, and takes as long as the rest."""
        begun = time.perf_counter()
        curve = self.focus.curve
        found = () if curve is None else rows(self.focus.session.shown, curve)
        self.measured.set_rows(measures(), found, "" if found else why_none(curve))
        self._took_ms += (time.perf_counter() - begun) * 1e3

    def _show_basis(self) -> None:
        curve, u = self.focus.curve, self._u
        # Of a curve of few points all functions are shown, and then they do not depend on u.
        few = curve is not None and len(curve.points_world) <= MOST
        key = (curve, None if few else round(self.focus.u, 2))
        if key != self._made_for:
            self._made_for = key
            self._basis = NOTHING if curve is None else basis_of(curve, self.focus.u)
            made = self._basis
            inks = [data_ink(k) for k in made.numbers]
            movable = curve is not None and curve.spline in B_SPLINES
            self.basis.set_domain(made.domain)
            self.basis.set_functions(made.us, made.values, made.names, inks)
            self.basis.set_knots(list(made.knots), movable)
            named = [name.replace("R_", "P_") for name in made.names]
            self.basis.set_weights(made.weights, named if made.weights else (), inks if made.weights else ())
        self.basis.set_u(u)
        hovered = self.focus.hovered
        self.basis.highlight(self._basis.numbers.index(hovered) if hovered in self._basis.numbers else -1)

    def _show_curvature(self) -> None:
        pieces, u = self._pieces, self._u
        if pieces is None:
            self.curvature.set_curvature(np.zeros(0), np.zeros(0))
        else:
            us = _samples(pieces)
            self.curvature.set_curvature(
                us,
                curves.curvature(pieces, us),
                _inner(pieces),
                curves.inflections(pieces).tolist()[:_MOST_MARKS],
                self.basis.curves.whole if self.basis.isVisible() else None,
            )
        self.curvature.set_u(u)

    def _show_hodograph(self) -> None:
        pieces, u = self._pieces, self._u
        if pieces is None:
            self.hodograph.set_hodograph(np.zeros(0), np.zeros((0, 2)))
        else:
            us = _samples(pieces)
            self.hodograph.set_hodograph(us, curves.derivatives(pieces, us, 1)[1])
        self.hodograph.set_u(u)

    def _show_joints(self) -> None:
        curve = self.focus.curve
        self.continuity.set_joints([] if curve is None else joints(self.focus.session.shown, curve))

    def say_of_joint(self, text: str) -> None:
        """A sentence beneath the joints, that goes when the curve is another, as after undo."""
        self._said_of = self.focus.curve
        self.continuity.say(text)

    def _show_measures(self) -> None:
        lines = measures_of(self._pieces, self._u)
        if self._pieces is not None and "crossings" in self.focus.shown:
            lines.append((_("crosses itself"), crossing_words(self._pieces)))
        self.insight.say(lines)

    def _go_to_joint(self, number: int) -> None:
        self._go_to(self.continuity.model.joints[number].u)

    def _choose_kind(self, number: int) -> None:
        curve = self.focus.curve
        if curve is not None and number >= 0:
            there = [kind for kind in compared(curve) if not fault_of(curve, kind)]
            self.kind_wanted.emit(there[number])

    def _hover_joint(self, number: int) -> None:
        curve = self.focus.curve
        point = joint_point(curve, number) if curve is not None and number >= 0 else None
        self.focus.hover(-1 if point is None else point)

    def _go_to(self, u: float) -> None:
        curve = self.focus.curve
        if curve is not None and not fault_of(curve):
            self.focus.set_u(share_at(curve, u))
            self.focus.switch("construction", True)

    def _hover(self, number: int) -> None:
        self.focus.hover(self._basis.numbers[number] if 0 <= number < len(self._basis.numbers) else -1)

    def _drag_weight(self, number: int, value: float) -> None:
        if 0 <= number < len(self._basis.numbers):
            self.weight_dragged.emit(self._basis.numbers[number], value)


def _samples(pieces: Pieces) -> np.ndarray:
    """Parameters close together, each joint from both sides."""
    lengths = np.diff(pieces.knots)
    each = max(4, min(PER_PIECE, MOST_SAMPLES // max(len(lengths), 1)))
    share = np.linspace(0.0, 1.0, each)
    share[-1] = 1.0 - 1e-9
    inside = pieces.knots[:-1, None] + share * lengths[:, None]
    return inside[lengths > 0].reshape(-1)


def _inner(pieces: Pieces) -> list[float]:
    return [float(u) for u in np.unique(pieces.knots[1:-1])][:_MOST_MARKS]


def measures_of(pieces: Pieces | None, u: float | None) -> list[tuple[str, str]]:
    """What is said of the curve in words: what it is of, and the number; nothing where there is no curve."""
    if pieces is None or u is None:
        return []
    x, y = piece_points(pieces, u).tolist()
    bend = float(curves.curvature(pieces, u))
    _centre, radius = curves.osculating_circle(pieces, u)
    lines = [
        (_("at u = {u:.4g}").format(u=u), f"({x:.4g}, {y:.4g})"),
        (_("curvature"), _("{bend:.4g} 1/px, radius {radius:.4g} px").format(bend=bend, radius=radius)),
    ]
    if pieces.degree > MEASURED_DEGREE:
        lines.append((_("the whole"), _("not measured above degree {most}").format(most=MEASURED_DEGREE)))
    else:
        (x0, y0), (x1, y1) = (side.tolist() for side in curves.bounding_box(pieces))
        lines += [
            (_("length"), _("{length:.6g} px").format(length=curves.arc_length(pieces))),
            (_("inflections"), str(len(curves.inflections(pieces)))),
            (_("box"), f"({x0:.4g}, {y0:.4g}) \N{EN DASH} ({x1:.4g}, {y1:.4g})"),
        ]
    return [(with_minus(name), with_minus(value)) for name, value in lines]
