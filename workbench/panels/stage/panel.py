"""What the panels of figures share: a canvas with tools, a floating card, gestures, selection and keys."""

from collections.abc import Sequence
from dataclasses import replace

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QAction, QCursor, QHideEvent, QKeyEvent, QShowEvent
from PySide6.QtWidgets import QFrame, QHBoxLayout, QVBoxLayout, QWidget

from workbench.document.edits import move_figures, remove_figures
from workbench.document.model import AnyFigure
from workbench.document.subjects import Subject
from workbench.language import _
from workbench.panels.panel import KeysWhileSeen, Said
from workbench.panels.stage.actions import FigureActions, PanelCommand, tool_cursor
from workbench.panels.stage.chosen import ChosenFigures
from workbench.panels.stage.gesture import HandleDrag, Modifiers, Tool
from workbench.panels.stage.invitation import Invitation
from workbench.panels.stage.outline import figure_at, prepare
from workbench.panels.stage.pointed import Pointed
from workbench.panels.stage.tools import FigureTool, SelectTool
from workbench.rendering import device_map
from workbench.session.session import Session
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.look.action_button import ActionButton
from workbench.widgets.look.plain_keys import is_plain
from workbench.widgets.look.tokens import theme_changed

REACH_PX = 6
NUDGE = "nudge"
# Arrow keys that follow one another within this time are one gesture, and one step of undo.
NUDGING_MS = 600
TOOL_BAR_PX = 44
CARD_GAP_PX = 8


class FigurePanel(ChosenFigures, QWidget):
    """Canvas, tools and card over one session. ``hover_text`` and ``zoom_text`` are for a status bar.

    A panel makes its card and what it shows, then calls ``begin``; it says in ``show_now`` what is shown,
    and in ``describe`` what a cell is called. ``slug`` is its workspace's, and begins the names of its
    actions; ``first_tool`` is what an empty sheet takes up, ``usual`` what is stepped here at first.
    ``transforms`` have a menu of their own, and the first one a button under the first tool.
    """

    hover_text = Signal(str)
    zoom_text = Signal(str)
    _due = Signal()

    slug = ""
    first_tool = "line"
    usual = Subject()

    def __init__(self, session: Session, tools: Sequence[Tool], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self._waiting = False
        self._served: tuple[object, bool] = (None, False)
        self.tools = list(tools)
        self.tool = self.tools[0]
        self.handle_drag = HandleDrag(session)
        self._nudging = QTimer(self, singleShot=True, interval=NUDGING_MS)
        self._nudging.timeout.connect(self._end_nudging)
        self.canvas = PixelCanvas()
        self._actions: dict[str, QAction] = {}
        self.transforms: list[PanelCommand] = []

    def begin(
        self, middle: QWidget, card: QWidget, invitation: str, commands: Sequence[PanelCommand]
    ) -> None:
        """Put ``card`` over the canvas and ``middle``, which holds the canvas, beside the tools; connect.

        ``invitation`` is what an empty sheet says, ``commands`` are listed after those that all panels have.
        """
        left = round(self.canvas.area.left / self.canvas.devicePixelRatioF())
        card.move(left + CARD_GAP_PX, CARD_GAP_PX)
        self._card = card
        self.leave_room(False)
        self.empty = Invitation(self.canvas, invitation, self.show_example)
        self._bar = QFrame()
        self._bar.setFixedWidth(TOOL_BAR_PX)
        column = QVBoxLayout(self._bar)
        column.setContentsMargins(6, 8, 6, 8)
        column.setSpacing(4)
        whole = QHBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        whole.addWidget(self._bar)
        whole.addWidget(middle, 1)
        self.setFocusProxy(self.canvas)
        self._actions = FigureActions(self, commands, self.transforms).made
        names = [tool.name for tool in self.tools]
        for name in (*names[:1], *(row[0] for row in self.transforms[:1]), *names[1:]):
            column.addWidget(ActionButton(self._actions[name]))
        column.addStretch(1)
        for name in ("zoom_in", "zoom_out", "fit"):
            column.addWidget(ActionButton(self._actions[name]))
        self._connect_canvas()
        self.choose_tool("select" if self.session.sheet.figures else self.first_tool)
        KeysWhileSeen(self, self._actions.values())

    # What a panel says of itself

    def show_now(self) -> None:
        """Bring everything that is shown up to date with the session."""
        raise NotImplementedError

    def show_example(self) -> None:
        """Open the panel's own example."""
        raise NotImplementedError

    @property
    def invitation(self) -> str:
        """What an empty sheet says with the tool that is taken, in place of what it usually says."""
        return "" if self.tool.name == self.first_tool else self.tool.invitation

    def serves(self, figure: AnyFigure) -> bool:
        """Whether this workspace is about figures of such a kind."""
        return True

    def _serves_here(self) -> bool:
        """Whether the sheet has any figure of that kind; looked at once for each list of figures."""
        figures = self.session.sheet.figures
        if self._served[0] is not figures:
            self._served = figures, any(map(self.serves, figures))
        return self._served[1]

    def describe(self, x: int, y: int) -> str:
        """What is said of a cell that is pointed at."""
        return f"({x}, {y})"

    def _say_zoom(self, *_percent: float) -> None:
        if self.isVisible():
            self.zoom_text.emit(self.canvas.zoom_words)

    def clicked(self, x: int, y: int) -> None:
        """A cell was clicked."""

    # What the window places

    @property
    def center(self) -> QWidget:
        """What fills the middle of the workspace."""
        return self

    def actions(self) -> list[QAction]:
        """Every command of this panel."""
        return list(self._actions.values())

    def said(self) -> Said:
        """What is under the pointer or said in passing, and the zoom."""
        return Said(self.hover_text, self.zoom_text)

    def point_at(self, cell: tuple[int, int] | None) -> None:
        """Point at a pixel that the sentence names, until the run moves; None when no longer."""
        self.canvas.point_at(cell)

    def _connect_canvas(self) -> None:
        session, canvas = self.session, self.canvas
        session.run.moved.connect(lambda: canvas.point_at(None))
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        session.unfolding.prepare_by(prepare)
        for told in (session.changed, session.state_changed, session.unfolding.grown, theme_changed):
            told.connect(self.refresh_soon)
        for run in (session.run, *session.followers):
            for signal in (run.changed, run.moved, run.grown, run.asked):
                signal.connect(self.refresh_soon)
        session.changed.connect(self._take_tool_when_empty)
        session.changed.connect(self._leave_overtaken)
        session.opened.connect(self._take_hold)
        session.path_changed.connect(self._take_run)
        canvas.pressed.connect(self._press)
        canvas.moved.connect(self._move)
        canvas.released.connect(self._release)
        canvas.handle_pressed.connect(self._press_handle)
        canvas.handle_dragged.connect(self._drag_handle)
        canvas.handle_released.connect(self._release_handle)
        canvas.cell_clicked.connect(self.clicked)
        canvas.double_clicked.connect(lambda x, y, _modifiers: self.pick_alone(x, y))
        self._pointed = Pointed(canvas, self.describe, self.hover_text)
        canvas.arrow.connect(self._arrow)
        canvas.cancelled.connect(self.let_go)
        canvas.view_changed.connect(self.refresh_soon)
        canvas.set_describer(self.describe)
        for tool in (*self.tools, self.handle_drag):
            tool.failed.connect(self.hover_text)

    def leave_room(self, folded: bool) -> None:
        """The picture fits beside the card, or, when that is ``folded``, in all of the canvas."""
        self.canvas.set_covered(0 if folded else self._card.width() + CARD_GAP_PX)

    # Tools

    def choose_tool(self, name: str) -> None:
        """Take up the tool of this name."""
        self.tool.cancel()
        self.session.hold_runs(False)
        self.tool = next(tool for tool in self.tools if tool.name == name)
        for tool in self.tools:
            self._actions[tool.name].setChecked(tool is self.tool)
        crossed = self.tool.shape == Qt.CursorShape.CrossCursor
        icon = self._actions[name].icon()
        self.canvas.set_shape(tool_cursor(icon) if crossed else QCursor(self.tool.shape))
        if isinstance(self.tool, FigureTool) and self.session.state.selection:
            self.session.update_state(selection=())
        self.refresh()

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened, once; unseen, when it is seen."""
        if not self._waiting and self.isVisible():
            self._waiting = True
            self._due.emit()

    def refresh(self) -> None:
        """Show the session as it is now."""
        self._waiting = False
        self._say_zoom()
        self.show_now()
        self.empty.low = bool(self.session.sheet.figures)
        self.empty.say(self.invitation)
        self.empty.setVisible(not self.gesturing and not self._serves_here())
        chosen = self.selected() if self.isVisible() else []
        for name in {"cut", "delete", "duplicate", "forwards", "backwards"} & self._actions.keys():
            self._actions[name].setEnabled(bool(chosen))
        self._actions["group"].setEnabled(len(chosen) > 1)
        self._actions["ungroup"].setEnabled(any(figure.group for figure in chosen))
        self._pointed.refresh()

    def _take_run(self) -> None:
        """Step what is stepped here, when this panel comes to be seen, or another document under it."""
        if self.isVisible():
            self.session.visit(self.slug, self.usual)

    def _take_tool_when_empty(self) -> None:
        """An empty sheet asks for something to be drawn, so that is what a drag does."""
        asks = self.isVisible() and not self.gesturing and not self.session.sheet.figures
        if asks and isinstance(self.tool, SelectTool):
            self.choose_tool(self.first_tool)

    def _take_hold(self) -> None:
        """What is opened is taken hold of; a tool that drew on something else would draw on it."""
        self._end_gesture()
        if self.tool.name != "select":
            self.choose_tool("select")
        self._take_tool_when_empty()

    def _press(self, x: float, y: float, modifiers: Modifiers) -> None:
        if self._answering:
            return
        self._take_run()  # which is another one after a pixel was asked about
        self.session.hold_runs(True)
        self.tool.press(x, y, modifiers, self._reach)
        self._after_gesture()

    @property
    def _reach(self) -> float:
        """How near counts as on a figure, device pixels."""
        return max(0.75, REACH_PX * self.devicePixelRatioF() / self.canvas.view.cell)

    def _move(self, x: float, y: float, _modifiers: Modifiers) -> None:
        drawing = self.tool.busy
        self.tool.move(x, y)
        if drawing and not self.tool.busy:
            self._end_gesture()
        elif self.tool.busy or self.tool.band is not None:
            self._after_gesture()
        elif isinstance(self.tool, FigureTool):
            self.canvas.set_overlay(replace(self.canvas.overlay, snap=self.tool.snap))

    def _release(self, x: float, y: float, _modifiers: Modifiers) -> None:
        if not self._answering:
            self.tool.release(x, y)
        self.session.hold_runs(self.tool.busy)
        self._after_gesture()

    def _after_gesture(self) -> None:
        # While corners are clicked, a handle of the figure that grows must not catch the click.
        self.canvas.takes_handles = not self.tool.busy
        self.canvas.set_tag(self.tool.tag)
        self.refresh_soon()

    def _press_handle(self, address: str, _modifiers: Modifiers) -> None:
        self.session.hold_runs(True)
        self.handle_drag.press(address)

    def _drag_handle(self, _address: str, x: float, y: float) -> None:
        self.handle_drag.drag(x, y)
        self.canvas.set_tag(self.handle_drag.tag)
        self.refresh_soon()

    def _release_handle(self, _address: str) -> None:
        self.handle_drag.release()
        self.session.hold_runs(False)
        self.canvas.set_tag("")
        self.refresh()

    @property
    def _answering(self) -> bool:
        """Whether a click on the canvas answers what is asked."""
        return self.session.run.waiting and not self.session.run.options

    @property
    def gesturing(self) -> bool:
        """Whether something is being drawn or dragged."""
        return self.tool.busy or self.handle_drag.busy

    def let_go(self) -> None:
        """Escape: what is being drawn, else the selection, else the tool."""
        if self.gesturing:
            self._end_gesture()
        elif self.session.state.selection:
            self.session.update_state(selection=())
        else:
            self.choose_tool("select")
        self.refresh_soon()

    def _leave_overtaken(self) -> None:
        if self.tool.overtaken or self.handle_drag.overtaken:
            self._end_gesture()

    def _end_gesture(self) -> None:
        """Take back what is being drawn or dragged: it is of the sheet on which it was begun."""
        self.tool.cancel()
        self.handle_drag.cancel()
        self.session.hold_runs(False)
        self._after_gesture()

    # Commands

    def delete_selected(self) -> None:
        """Remove the selected figures; what is being drawn is taken back."""
        if self.gesturing:
            self._end_gesture()
        elif ids := [figure.id for figure in self.selected()]:
            self.apply(remove_figures(ids), _("Delete"))

    def select_all(self) -> None:
        """Select every figure of the sheet."""
        self.choose_tool("select")
        self.session.update_state(selection=tuple(figure.id for figure in self.session.sheet.figures))

    def pick_alone(self, x: float, y: float) -> None:
        """Select what is at a device point without its group."""
        figure = figure_at(self.session.shown, x, y, self._reach)
        if figure is not None and figure.group and isinstance(self.tool, SelectTool):
            self.session.update_state(selection=(figure.id,), active=figure.id)

    def ask_why(self) -> None:
        """Ask why the pixel that is pointed at is as it is."""
        cell = self.canvas.pointed_cell
        if cell is None:
            self.hover_text.emit(_("Point at a pixel first, then ask why it is as it is."))
        else:
            self.session.update_state(pixel=cell)
            self.session.why_asked.emit()

    def _arrow(self, dx: int, dy: int, modifiers: Modifiers) -> None:
        """Arrows nudge what is selected; with nothing selected they step."""
        if ids := [figure.id for figure in self.selected()]:
            far = 10 if modifiers & Qt.KeyboardModifier.ShiftModifier else 1
            scale = device_map(self.session.sheet)
            edit = move_figures(ids, dx * far / scale.sx, dy * far / scale.sy)
            self.apply(edit, _("Nudge"), f"{NUDGE} {' '.join(ids)}")
            self._nudging.start()
        elif dx > 0:
            self.session.run.forward()
        elif dx < 0:
            self.session.run.back()

    def _end_nudging(self) -> None:
        self.session.end_merge(f"{NUDGE} {' '.join(figure.id for figure in self.selected())}")

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Keys that the canvas left: Home, End and Space for the run, Enter for the tool, Delete."""
        key, run = event.key(), self.session.run
        plain = not event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        keys = {Qt.Key.Key_Home: run.first, Qt.Key.Key_End: run.last, Qt.Key.Key_Space: run.toggle_play}
        if plain and key in keys:
            keys[Qt.Key(key)]()
        elif is_plain(event) and key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.tool.finish()
            self.session.hold_runs(self.gesturing)
            self._after_gesture()
        elif is_plain(event) and key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.delete_selected()
        else:
            super().keyPressEvent(event)

    def showEvent(self, event: QShowEvent) -> None:
        """What is being drawn here holds the runs, and what happened while it was hidden is shown."""
        super().showEvent(event)
        self.session.hold_runs(self.gesturing)
        self._take_run()
        self._take_tool_when_empty()
        self.refresh()

    def hideEvent(self, event: QHideEvent) -> None:
        """What is being drawn waits for its panel, the runs of the others do not."""
        super().hideEvent(event)
        self.session.hold_runs(False)
