"""The Draw panel: lines, circles, ellipses, polylines on a pixel canvas, drawn, typed and compared."""

from dataclasses import replace
from functools import partial
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import (
    QAction,
    QHideEvent,
    QKeyEvent,
    QShowEvent,
)
from PySide6.QtWidgets import QFrame, QHBoxLayout, QSplitter, QToolButton, QVBoxLayout, QWidget

from workbench.document.edits import Edit, duplicate_figures, move_figures, remove_figures, reorder
from workbench.document.errors import DocumentError
from workbench.document.model import AnyFigure
from workbench.language import _
from workbench.panels.draw_actions import DrawActions
from workbench.panels.draw_card import ParameterCard
from workbench.panels.draw_empty import EmptyState
from workbench.panels.draw_export import Exporter
from workbench.panels.draw_gesture import HandleDrag, Tool
from workbench.panels.draw_tools import (
    CircleTool,
    EllipseTool,
    FigureTool,
    LineTool,
    PolylineTool,
    SelectTool,
)
from workbench.panels.draw_view import DrawView
from workbench.rendering import device_map
from workbench.session.session import Session
from workbench.widgets.canvas_surface import CanvasSurface
from workbench.widgets.distance_plot import DistancePlot
from workbench.widgets.pixel_canvas import PixelCanvas
from workbench.widgets.tokens import theme_changed

REACH_PX = 6
TOOL_BAR_PX = 44
CARD_GAP_PX = 8


class DrawPanel(QWidget):
    """Canvas, tools and card over one session. ``hover_text`` and ``zoom_text`` are for a status bar."""

    hover_text = Signal(str)
    zoom_text = Signal(str)
    _due = Signal()

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self._waiting = self._sharing = False
        self.title = _("Draw")
        self.tools: list[Tool] = [
            kind(session) for kind in (SelectTool, LineTool, CircleTool, EllipseTool, PolylineTool)
        ]
        self.tool = self.tools[0]
        self.handle_drag = HandleDrag(session)
        self.canvas = PixelCanvas()
        self.second = PixelCanvas()
        self.second.hide()
        self.card = ParameterCard(session, self.canvas)
        left = round(self.canvas.area.left / self.canvas.devicePixelRatioF())
        self.card.move(left + CARD_GAP_PX, CARD_GAP_PX)
        self._leave_room(False)
        self.empty = EmptyState(self.canvas, self.show_example)
        self.plot = DistancePlot()
        self.view = DrawView(session, self.canvas, self.second, self.card, self.plot)
        self.exporter = Exporter(self.view, self)
        self._make_layout()
        self._connect()
        self.choose_tool("select" if session.sheet.figures else "line")
        self.refresh()

    # What the window places

    @property
    def center(self) -> QWidget:
        """What fills the middle of the workspace."""
        return self

    def docks(self) -> list[tuple[str, str, QWidget, Qt.DockWidgetArea]]:
        """The plot of the distances."""
        title = _("Distance from the ideal curve")
        return [("distance", title, self.plot, Qt.DockWidgetArea.BottomDockWidgetArea)]

    def actions(self) -> list[QAction]:
        """Every command of this panel."""
        return list(self._actions.values())

    def show_example(self) -> None:
        """Open the picture with one line."""
        self.session.open_example("line")
        figures = self.session.sheet.figures
        if figures:
            self.session.update_state(active=figures[0].id)

    def _make_layout(self) -> None:
        self._split = QSplitter(Qt.Orientation.Horizontal)
        self._split.setChildrenCollapsible(False)
        self._split.addWidget(self.canvas)
        self._split.addWidget(self.second)
        self._bar = QFrame()
        self._bar.setFixedWidth(TOOL_BAR_PX)
        column = QVBoxLayout(self._bar)
        column.setContentsMargins(6, 8, 6, 8)
        column.setSpacing(4)
        whole = QHBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.setSpacing(0)
        whole.addWidget(self._bar)
        whole.addWidget(self._split, 1)
        self.setFocusProxy(self.canvas)
        self._actions = DrawActions(self).made
        for tool in self.tools:
            column.addWidget(self._button(self._actions[tool.name]))
        column.addStretch(1)
        for name in ("zoom_in", "zoom_out", "fit"):
            column.addWidget(self._button(self._actions[name]))

    def _button(self, action: QAction) -> QToolButton:
        button = QToolButton()
        button.setDefaultAction(action)
        button.setFixedSize(32, 32)
        button.setAccessibleName(action.text())
        return button

    def _connect(self) -> None:
        session, canvas = self.session, self.canvas
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        for told in (session.changed, session.state_changed, theme_changed):
            told.connect(self.refresh_soon)
        for run in (session.run, session.follower):
            for signal in (run.changed, run.moved, run.grown, run.asked):
                signal.connect(self.refresh_soon)
        session.run.moved.connect(self.view.forget_answers)
        session.changed.connect(self._take_line_when_empty)
        canvas.pressed.connect(self._press)
        canvas.moved.connect(self._move)
        canvas.released.connect(self._release)
        canvas.handle_pressed.connect(self._press_handle)
        canvas.handle_dragged.connect(self._drag_handle)
        canvas.handle_released.connect(self._release_handle)
        canvas.cell_clicked.connect(self._click)
        canvas.hovered.connect(lambda x, y: self.hover_text.emit(self.view.describe(x, y)))
        canvas.hover_left.connect(lambda: self.hover_text.emit(""))
        canvas.cursor_moved.connect(lambda x, y: self.hover_text.emit(self.view.describe(x, y)))
        canvas.arrow.connect(self._arrow)
        canvas.cancelled.connect(self.let_go)
        canvas.view_changed.connect(lambda percent: self.zoom_text.emit(f"{percent:.0f} %"))
        canvas.set_describer(self.view.describe)
        self.exporter.said.connect(self.hover_text)
        for tool in (*self.tools, self.handle_drag):
            tool.failed.connect(self.hover_text)
        self.card.side_by_side_changed.connect(self.refresh_soon)
        self.card.folded.connect(self._leave_room)
        self.card.algorithm_chosen.connect(self._choose_algorithm)
        self.plot.pixel_wanted.connect(self._go_to_emission)
        self.plot.shown.connect(self.refresh_soon)
        for one, other in ((canvas, self.second), (self.second, canvas)):
            one.view_changed.connect(partial(self._share_view, one, other))

    def _leave_room(self, folded: bool) -> None:
        self.canvas.set_covered(0 if folded else self.card.width() + CARD_GAP_PX)

    def _share_view(self, one: CanvasSurface, other: CanvasSurface, _percent: float) -> None:
        """Both pictures side by side show the same cells; the first one fits, with room for the card."""
        if self.second.isHidden() or self._sharing:
            return
        self._sharing = True
        if one is self.second and one.keeps_fit:
            one.look_like(other)
        else:
            other.look_like(one)
        self._sharing = False

    # Tools

    def choose_tool(self, name: str) -> None:
        """Take up the tool of this name."""
        self.tool.cancel()
        self.tool = next(tool for tool in self.tools if tool.name == name)
        for tool in self.tools:
            self._actions[tool.name].setChecked(tool is self.tool)
        self.canvas.set_shape(self.tool.shape)
        if isinstance(self.tool, FigureTool):
            self.session.update_state(selection=())
        self.refresh()

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened, once."""
        if not self._waiting:
            self._waiting = True
            self._due.emit()

    def refresh(self) -> None:
        """Show the session as it is now."""
        self._waiting = False
        self.view.refresh(self.tool, self.handle_drag)
        self.empty.setVisible(not self.session.sheet.figures and not self.gesturing)
        for name in ("delete", "duplicate", "forwards", "backwards"):
            self._actions[name].setEnabled(bool(self.session.state.selection))
        for name in ("save_run", "save_pixels"):
            self._actions[name].setEnabled(self.session.active_figure is not None)

    def _take_line_when_empty(self) -> None:
        """An empty sheet asks for a line to be dragged, so that is what a drag does."""
        if not self.session.sheet.figures and not self.gesturing and isinstance(self.tool, SelectTool):
            self.choose_tool("line")

    def _choose_algorithm(self, slug: str) -> None:
        if isinstance(self.tool, FigureTool):
            self.tool.algorithm = slug
            self.refresh()

    def _press(self, x: float, y: float, modifiers: Any) -> None:
        if self.session.run.waiting:
            return
        self._hold(True)
        reach = max(0.75, REACH_PX * self.devicePixelRatioF() / self.canvas.view.cell)
        self.tool.press(x, y, modifiers, reach)
        self._after_gesture()

    def _move(self, x: float, y: float, _modifiers: Any) -> None:
        self.tool.move(x, y)
        if self.tool.busy or self.tool.band is not None:
            self._after_gesture()
        elif isinstance(self.tool, FigureTool):
            self.canvas.set_overlay(replace(self.canvas.overlay, snap=self.tool.snap))

    def _release(self, x: float, y: float, _modifiers: Any) -> None:
        if not self.session.run.waiting:
            self.tool.release(x, y)
        self._hold(self.tool.busy)
        self._after_gesture()

    def _click(self, x: int, y: int) -> None:
        """With *Ask first* a click on a cell answers."""
        if self.view.answer((x, y)):
            self.refresh()

    def _go_to_emission(self, number: int) -> None:
        active = self.session.active_figure
        if active is not None:
            self.session.run.run_to_pixel(*self.view.emitted_cell(active, number))

    def _after_gesture(self) -> None:
        self.canvas.set_tag(self.tool.tag)
        self.refresh_soon()

    def _press_handle(self, address: str, _modifiers: Any) -> None:
        self._hold(True)
        self.handle_drag.press(address)

    def _drag_handle(self, _address: str, x: float, y: float) -> None:
        self.handle_drag.drag(x, y)
        self.canvas.set_tag(self.handle_drag.tag)
        self.refresh_soon()

    def _release_handle(self, _address: str) -> None:
        self.handle_drag.release()
        self._hold(False)
        self.canvas.set_tag("")
        self.refresh()

    def _hold(self, on: bool) -> None:
        """The recording waits while something is being drawn or dragged."""
        for run in (self.session.run, self.session.follower):
            if on:
                run.hold()
            else:
                run.go_on()

    @property
    def gesturing(self) -> bool:
        return self.tool.busy or self.handle_drag.busy

    def let_go(self) -> None:
        """Escape: what is being drawn, else the selection, else the tool."""
        if self.gesturing:
            self.tool.cancel()
            self.handle_drag.cancel()
            self._hold(False)
        elif self.session.state.selection:
            self.session.update_state(selection=())
        else:
            self.choose_tool("select")
        self._after_gesture()

    # Commands

    def _apply(self, edit: Edit, name: str) -> None:
        try:
            self.session.apply(edit, name)
        except DocumentError as problem:
            self.hover_text.emit(str(problem))

    def selected(self) -> list[AnyFigure]:
        """The selected figures of the sheet, from back to front."""
        chosen = set(self.session.state.selection)
        return [figure for figure in self.session.sheet.figures if figure.id in chosen]

    def delete_selected(self) -> None:
        """Remove the selected figures."""
        if ids := [figure.id for figure in self.selected()]:
            self._apply(remove_figures(ids), _("Delete"))

    def duplicate_selected(self) -> None:
        """Copy the selected figures; the copies are selected then."""
        if ids := [figure.id for figure in self.selected()]:
            known = {figure.id for figure in self.session.sheet.figures}
            self._apply(duplicate_figures(ids), _("Duplicate"))
            made = [f.id for f in self.session.sheet.figures if f.id not in known]
            if made:
                self.session.update_state(selection=tuple(made), active=made[-1])

    def select_all(self) -> None:
        """Select every figure of the sheet."""
        self.choose_tool("select")
        self.session.update_state(selection=tuple(figure.id for figure in self.session.sheet.figures))

    def shift_order(self, by: int) -> None:
        """Move the selected figure one place to the front (or back)."""
        chosen = self.selected()
        if len(chosen) == 1:
            figures = self.session.sheet.figures
            place = figures.index(chosen[0]) + by
            if 0 <= place < len(figures):
                self._apply(reorder(chosen[0].id, place), _("Change order"))

    def _arrow(self, dx: int, dy: int, modifiers: Any) -> None:
        """Arrows nudge what is selected; with nothing selected they step."""
        if chosen := self.selected():
            far = 10 if modifiers & Qt.KeyboardModifier.ShiftModifier else 1
            scale = device_map(self.session.sheet)
            ids = [figure.id for figure in chosen]
            self._apply(move_figures(ids, dx * far / scale.sx, dy * far / scale.sy), _("Nudge"))
        elif dx > 0:
            self.session.run.forward()
        elif dx < 0:
            self.session.run.back()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Keys that the canvas left: Home, End and Space for the run, Enter for the tool, Delete."""
        key = event.key()
        if key == Qt.Key.Key_Home:
            self.session.run.first()
        elif key == Qt.Key.Key_End:
            self.session.run.last()
        elif key == Qt.Key.Key_Space:
            self.session.run.toggle_play()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.tool.finish()
            self._after_gesture()
        elif key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.delete_selected()
        else:
            super().keyPressEvent(event)

    def showEvent(self, event: QShowEvent) -> None:
        """The keys of this panel work while it is seen."""
        super().showEvent(event)
        for action in self._actions.values():
            action.setEnabled(True)
        self.refresh()

    def hideEvent(self, event: QHideEvent) -> None:
        """And only then."""
        super().hideEvent(event)
        for action in self._actions.values():
            action.setEnabled(False)
