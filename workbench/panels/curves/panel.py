"""The Curves panel: curves of every kind drawn, shaped by hand, looked into and compared."""

from collections.abc import Callable

from msgspec.structs import replace
from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QCursor, QKeyEvent, QShowEvent
from PySide6.QtWidgets import QMenu, QWidget

from workbench.document.curves.pieces import fault_of, share_at
from workbench.document.model import AnyFigure, Curve
from workbench.document.subjects import Subject
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.curves.boxing import CurveBoxing
from workbench.panels.curves.card import CurveCard
from workbench.panels.curves.commands import NUDGE
from workbench.panels.curves.docks import CurveDocks
from workbench.panels.curves.exchange import CurveExchange
from workbench.panels.curves.focus import CurveFocus
from workbench.panels.curves.freehand import FreehandTool, ProbeTool
from workbench.panels.curves.insight import switches
from workbench.panels.curves.menu import canvas_menu
from workbench.panels.curves.operations import CurveOperations
from workbench.panels.curves.pen import PenTool
from workbench.panels.curves.shape import prepare
from workbench.panels.curves.tools import CurveSelectTool
from workbench.panels.curves.view import CurveView
from workbench.panels.panel import DockPart
from workbench.panels.stage.actions import PanelCommand
from workbench.panels.stage.clipboard import figures_held
from workbench.panels.stage.gesture import Modifiers
from workbench.panels.stage.stepped import SteppedPanel
from workbench.session.session import Session
from workbench.widgets.look.plain_keys import is_plain

EXAMPLE = "curve-interpolation"


class CurvesPanel(SteppedPanel):
    """Canvas, tools and card over one session; what is looked at is held by ``focus``."""

    slug = "curves"
    first_tool = "pen"
    usual = Subject("curve")
    card: CurveCard
    view: CurveView

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        self.focus = CurveFocus(session)
        self.select = CurveSelectTool(self.focus)
        self.pen = PenTool(self.focus)
        self.freehand, self.probe = FreehandTool(self.focus), ProbeTool(self.focus)
        super().__init__(session, [self.select, self.pen, self.freehand, self.probe], parent)
        self.title = _("Curves")
        self._export: list[QAction] = []
        self.canvas.takes_handles = False
        # Points behind the card could not be dragged.
        self.canvas.worthwhile = 0.6
        self.card = CurveCard(self.focus, self.canvas)
        self.beside = CurveDocks(self.focus, self)
        self.commands = CurveOperations(self.focus, self)
        self.commands.said.connect(self.hover_text)
        self.card.joint_chosen = self.commands.joint
        self.beside.knot_dragged.connect(self.commands.pull_knot)
        self.beside.weight_dragged.connect(self.commands.pull_weight)
        self.beside.kind_wanted.connect(self.commands.show_beside)
        self.beside.measured.copied.connect(self.hover_text)
        self.beside.measured.example_wanted.connect(self.show_example)
        self.beside.knot_wanted.connect(self._insert_knot)
        self.beside.knot_unwanted.connect(self.commands.remove_knot)
        self.beside.smoothing_wanted.connect(self._smooth)
        self.beside.knot_released.connect(self._let_go_of_plot)
        self.beside.weight_released.connect(self._let_go_of_plot)
        session.unfolding.prepare_by(prepare)
        self.view = CurveView(self.focus, self.canvas, self.second, self.card, self.beside)
        self.exchange = CurveExchange(self.focus, self._model, self)
        self.exchange.said.connect(self.hover_text)
        self.focus.changed.connect(self.refresh_soon)
        for _name, _title, dock, _area in self.beside.parts():
            dock.installEventFilter(self)
        self.start(
            _("Click points on the canvas one after another; Enter ends the curve."),
            [
                *self._show_rows(),
                ("snap", _("Snap to pixels"), "magnet", "N", self._toggle_snap),
                *self.commands.rows(),
                *self.exchange.rows(),
            ],
        )

        canvas = self.canvas
        canvas.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        canvas.customContextMenuRequested.connect(
            lambda place: canvas_menu(self._actions, canvas, self._export).popup(canvas.mapToGlobal(place))
        )
        canvas.double_clicked.connect(self._double_click)

    def make_boxing(self) -> CurveBoxing:
        """What transforms the chosen points, or what is selected."""
        return CurveBoxing(self.focus, self.canvas, self.select)

    def docks(self) -> list[DockPart]:
        """Basis functions, switches, curvature, hodograph."""
        return self.beside.parts()

    def offer_export(self, menu: QMenu) -> None:
        """As everywhere, in this panel's own menu."""
        self._export = [menu.menuAction()]

    def points(self) -> list[tuple[float, float]]:
        """The chosen points of the curve that is worked on, or all of them; none without a curve."""
        curve = self.focus.curve
        return [] if curve is None else self.exchange.places(curve)

    def tables(self) -> list[tuple[str, Table]]:
        """Title and content of each table beside the canvas."""
        measured = self.beside.measured
        return [(_("Measures of the curves"), measured.content())] if measured.model.kinds else []

    def _model(self) -> Curve:
        return replace(self.pen.model, colour=self.pen.next_colour())

    def show_now(self) -> None:
        """As everywhere, with what the probe has found."""
        self.view.refresh_probe(self.probe.drawn() if self.tool is self.probe else [])
        super().show_now()

    def _toggle_snap(self) -> None:
        self.focus.snaps = not self.focus.snaps
        self.hover_text.emit(
            _("Points now snap to pixels.") if self.focus.snaps else _("Points no longer snap.")
        )

    def _double_click(self, x: float, y: float, _modifiers: object) -> None:
        """On the curve, at u too, a point is inserted; on a point or a tangent nothing more happens."""
        curve = self.focus.selected
        if curve is None or self.tool is not self.select or self.select.on_grip(curve, x, y):
            return
        share = self.select.share_at(curve, x, y)
        self.select.cancel()
        if share is not None:
            self.commands.insert(curve, share)
        self._after_gesture()

    def _insert_knot(self, u: float) -> None:
        curve = self.focus.curve
        if curve is not None and not fault_of(curve):
            self.commands.insert(curve, share_at(curve, u))

    def _smooth(self, joint: int, kind: str) -> None:
        said = self.commands.smooth([joint], kind)
        self.refresh()
        self.beside.say_of_joint(said)

    def _let_go_of_plot(self, *_arguments: object) -> None:
        self.commands.let_go()
        self.refresh_soon()

    def delete_selected(self) -> None:
        """Remove the chosen points, or with none chosen what is selected."""
        if self.gesturing or not self.commands.remove():
            super().delete_selected()

    def copy(self) -> bool:
        """Put the chosen points on the clipboard; with all of them chosen, or none, the curve."""
        curve = self.focus.selected
        if curve is None or len(self.focus.numbers(curve)) in (0, len(curve.points_world)):
            return super().copy()
        self.exchange.copy()
        return True

    def paste(self) -> bool:
        """Figures come onto the sheet as everywhere, points and SVG as in the menu."""
        if figures_held():
            return super().paste()
        if not self.gesturing:
            self.exchange.paste()
        return True

    def select_all(self) -> None:
        """All points of the selected curve, or with none selected all figures."""
        curve = self.focus.selected
        if curve is None or self.tool is not self.select:
            super().select_all()
        else:
            self.focus.choose(point.id for point in curve.points_world)

    def _arrow(self, dx: int, dy: int, modifiers: Modifiers) -> None:
        """Arrows nudge the chosen points, Shift by ten; without any, as everywhere."""
        far = 10 if modifiers & Qt.KeyboardModifier.ShiftModifier else 1
        if self.commands.nudge(dx * far, dy * far):
            self._nudging.start()
        else:
            super()._arrow(dx, dy, modifiers)

    def _end_nudging(self) -> None:
        super()._end_nudging()
        self.session.end_merge(NUDGE)

    def _show_rows(self) -> list[PanelCommand]:
        keys = {"construction": ("triangle", "U"), "comb": ("chart-line", "K")}
        named = _("Show or hide: {what}")
        return [
            (f"show_{name}", named.format(what=title), *keys.get(name, ("eye", "")), self._switch(name))
            for name, title, _meaning in switches()
        ]

    def _switch(self, name: str) -> Callable[[], None]:
        return lambda: self.focus.switch(name, name not in self.focus.shown)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """A plot that comes to be seen is brought up to date."""
        if event.type() == QEvent.Type.Show:
            self.refresh_soon()
        return super().eventFilter(watched, event)

    def show_example(self) -> None:
        """Open a curve that is already drawn."""
        self.session.open_example(EXAMPLE)
        front = self.session.sheet.figures[-1].id
        self.session.update_state(active=front, selection=(front,))

    def serves(self, figure: AnyFigure) -> bool:
        """Curves."""
        return isinstance(figure, Curve)

    def showEvent(self, event: QShowEvent) -> None:
        """The curve that is worked on shows what can be dragged; without any the pen is taken up."""
        super().showEvent(event)
        curve = self.focus.curve
        if not self._serves_here() and self.tool is self.select:
            self.choose_tool(self.first_tool)
        elif curve is not None and self.tool is self.select and not self.session.state.selection:
            self.session.update_state(active=curve.id, selection=(curve.id,))

    # The pointer

    def _after_gesture(self) -> None:
        super()._after_gesture()
        # This panel finds what is under the pointer by itself, several points at once.
        self.canvas.takes_handles = False

    def _move(self, x: float, y: float, modifiers: Modifiers) -> None:
        self.select.modifiers = self.pen.modifiers = modifiers
        super()._move(x, y, modifiers)
        if self.select.held:
            self.canvas.set_tag(self.tool.tag)
        if self.tool is self.select and not self.canvas.dragging:
            over = self.select.over(x, y)
            curve = self.focus.selected
            number = self.select.point_at(curve, x, y) if curve is not None and over == "grip" else None
            self.focus.hover(-1 if number is None else number)
            shapes = {"grip": Qt.CursorShape.SizeAllCursor, "curve": Qt.CursorShape.PointingHandCursor}
            self.canvas.set_shape(QCursor(shapes.get(over, Qt.CursorShape.ArrowCursor)))

    @property
    def gesturing(self) -> bool:
        """Whether something is being drawn or dragged."""
        return super().gesturing or self.select.held

    def let_go(self) -> None:
        """Escape: what is being drawn, then the box, the chosen points, and on as everywhere."""
        if not self.gesturing and self.focus.points and not self.boxing.on:
            self.focus.choose(())
        else:
            super().let_go()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Backspace takes back the last point of the pen."""
        back = is_plain(event) and event.key() == Qt.Key.Key_Backspace
        if back and self.tool is self.pen and self.pen.back():
            self._after_gesture()
        else:
            super().keyPressEvent(event)

    def choose_tool(self, name: str) -> None:
        """Take up a tool; the points that were chosen are let go."""
        if name != "select":
            self.focus.choose(())
        super().choose_tool(name)
