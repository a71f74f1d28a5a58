"""The page Random scan: the display list of the sheet, run by a display processor, and how long it takes."""

from collections.abc import Sequence
from dataclasses import replace as replace_setup

from msgspec.structs import replace
from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QGuiApplication, QKeyEvent, QKeySequence, QResizeEvent, QShowEvent
from PySide6.QtWidgets import (
    QLabel,
    QSizePolicy,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.language import _, ngettext
from workbench.panels.display.vector.architecture import architecture, told
from workbench.panels.display.vector.bar import VectorBar
from workbench.panels.display.vector.derivation import derivation
from workbench.panels.display.vector.list_changes import ListChanges
from workbench.panels.display.vector.list_table import ListTable
from workbench.panels.display.vector.numbers import rich, working
from workbench.panels.display.vector.run import VectorRun, vector_run
from workbench.panels.display.vector.storage_bar import StorageBar
from workbench.panels.panel import DockPart, KeysWhileSeen, Said
from workbench.panels.shared.tube_feed import setup_of
from workbench.panels.stage.invitation import Invitation
from workbench.panels.stage.plain_page import PlainPage
from workbench.rendering.subjects.random_scan import KIND, MOST_LINES, runs_a_list
from workbench.session.session import Session
from workbench.widgets.formulas.drawing_view import DrawingView
from workbench.widgets.look.empty_view import EmptyView
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.split import Split
from workbench.widgets.plots.refresh_plot import RefreshPlot
from workbench.widgets.stepping.step_bar import stepping_key
from workbench.widgets.tube.storage_view import StorageView
from workbench.widgets.tube.stroke_view import StrokeView

PAGE = "vector"
OVERLOADED = 900
_PLOT_PX, _LOW_PX = 150, 420


class VectorPage(PlainPage, QWidget):
    """``hover_text``: what is said in passing."""

    hover_text = Signal(str)
    _due = Signal()

    usual = Subject(KIND)
    example = "house"

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self._waiting = False
        self._run: VectorRun | None = None
        self._fed: object = None
        self._system_due = QTimer(self, singleShot=True)
        self.bar = VectorBar(session)
        self.table = ListTable()
        self.tube, self.storage = StrokeView(), StorageView()
        self.storage_bar = StorageBar(self.storage)
        self.plot = RefreshPlot()
        self.plot.setFixedHeight(_PLOT_PX)
        self.changes = ListChanges(session, self.hover_text.emit)
        self.architecture = DrawingView(
            _("Architecture of a random-scan system"),
            _("Which parts work in this instruction; it is exported with the derivation of this page"),
        )
        self.system = EmptyView(
            self.architecture,
            _("The display list of this sheet runs through the system on the page Random scan."),
            _("Go to Random scan"),
        )
        self.system.button.setToolTip(_("Run the display list, instruction by instruction"))
        self.system.set_empty(True)
        self.sums = QLabel()
        self.note = QLabel()
        self._lay_out()
        self.nothing = Invitation(
            self.table, _("This sheet draws no strokes, so the display list is empty."), self._show_example
        )
        self._actions = self._made_actions()
        KeysWhileSeen(self, self.commands())
        self._connect()

    def _lay_out(self) -> None:
        for label in (self.sums, self.note):
            label.setWordWrap(True)
            label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.note.setProperty("role", "muted")
        self.sums.setProperty("role", "caption")
        self.glass = QStackedWidget()
        self.glass.addWidget(self.tube)
        storing = QWidget()
        column = QVBoxLayout(storing)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.storage, 1)
        column.addWidget(self.storage_bar)
        self.glass.addWidget(storing)
        left, right = QWidget(), QWidget()
        list_column, tube_column = QVBoxLayout(left), QVBoxLayout(right)
        for column in (list_column, tube_column):
            column.setContentsMargins(0, 0, 0, 0)
            column.setSpacing(4)
        list_column.addWidget(self.table, 1)
        list_column.addWidget(self.sums)
        tube_column.addWidget(self.glass, 1)
        tube_column.addWidget(self.note)
        tube_column.addWidget(self.plot)
        halves = Split(Qt.Orientation.Horizontal)
        halves.addWidget(left)
        halves.addWidget(right)
        halves.setSizes([400, 520])
        whole = QVBoxLayout(self)
        whole.setContentsMargins(8, 4, 8, 6)
        whole.setSpacing(4)
        whole.addWidget(self.bar)
        whole.addWidget(halves, 1)
        self.setFocusProxy(self.table)

    def _made_actions(self) -> list[QAction]:
        rows = (
            ("overload", _("Overload the display list"), "lightning", "Shift+O", self.overload),
            ("own_list", _("Draw the picture of the sheet"), "image", "Shift+P", self.draw_sheet),
            ("keep_order", _("Keep this order"), "sort-ascending", "Shift+K", self.keep_order),
            ("run_free", _("Let the list run freely"), "play-circle", "Shift+F", self.session.run.first),
        )
        actions = []
        for name, text, picture, key, act in rows:
            action = QAction(text, self)
            action.setObjectName(f"vector.{name}")
            action.setShortcut(QKeySequence(key))
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            set_icon(action, picture)
            action.triggered.connect(lambda _checked=False, act=act: act())
            self.addAction(action)
            self.tube.addAction(action)
            actions.append(action)
        self.tube.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        return actions

    def _connect(self) -> None:
        session = self.session
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        self._system_due.timeout.connect(self._show_system)
        for told_of in (session.changed, session.state_changed, session.ahead.arrived):
            told_of.connect(self.refresh_soon)
        for signal in (session.run.changed, session.run.moved, session.run.grown):
            signal.connect(self.refresh_soon)
        self.system.wanted.connect(self._visit)
        self.table.address_chosen.connect(self.go_to)
        self.table.wanted.connect(self._change)
        self.table.model.edited.connect(self._type)
        self.table.model.refused.connect(self.hover_text)
        self.tube.stroke_clicked.connect(self._go_to_stroke)
        self.storage.stroke_clicked.connect(self._go_to_stroke)
        self.plot.lines_wanted.connect(self.bar.give_lines)
        self.plot.held.connect(session.hold_runs)
        self.storage_bar.said.connect(self.hover_text)
        for view in (self.tube, self.storage):
            view.sight.changed.connect(self.refresh_soon)
        self.table.view.installEventFilter(self)

    def _visit(self) -> None:
        """Run the list here; the dock's button, which had the focus, goes with its sentence."""
        self.session.visit(PAGE, self.usual)
        self.setFocus()

    # What Display asks of a page

    def docks(self) -> Sequence[DockPart]:
        """The architecture of a random-scan system."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return (("random_scan_architecture", _("Random-scan system"), self.system, right),)

    def commands(self) -> list[QAction]:
        """Its commands, and the changes to the list."""
        return [*self._actions, *self.table.changes]

    def said(self) -> Said:
        """What is said in passing."""
        return Said(self.hover_text)

    def tables(self) -> Sequence[tuple[str, Table]]:
        """The list, and the rate against the number of lines."""
        tables = [(_("Display list"), self.table.model.content())] if self.table.model.rowCount() else []
        numbers = self.plot.numbers()
        return [*tables, (_("Refresh rate"), numbers)] if numbers else tables

    def copy(self) -> bool:
        """Put the tube, as it glows now, on the clipboard."""
        QGuiApplication.clipboard().setPixmap(self.glass.grab())
        self.hover_text.emit(_("The picture is on the clipboard."))
        return True

    def derivation(self) -> Derivation | None:
        """How a random-scan display works, with this list's numbers."""
        return None if self._run is None else derivation(self._run)

    # What is shown

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened; unseen, when it is seen."""
        if not self._waiting and self.isVisible():
            self._waiting = True
            self._due.emit()

    def refresh(self) -> None:
        """Show the session as it is now."""
        self._waiting = False
        if not self.isVisible() or self.session.state.workspace != PAGE:
            return
        self.bar.refresh()
        run = vector_run(self.session)
        if run is None:
            return
        self._run = run
        self.nothing.setVisible(not len(run.program))
        self.table.model.take(run.program, run.budget.time, self.session.sheet.palette, run.locked)
        self.table.show_address(run.address)
        n, strokes, jumps = len(run.program), len(run.program.strokes), run.program.moves
        self.table.summary.setText(
            _("{instructions}, {strokes}, {jumps}").format(
                instructions=ngettext("{n:,} instruction", "{n:,} instructions", n).format(n=n),
                strokes=ngettext("{n:,} stroke", "{n:,} strokes", strokes).format(n=strokes),
                jumps=ngettext("{n:,} jump", "{n:,} jumps", jumps).format(n=jumps),
            )
        )
        for action in self.table.changes:
            action.setEnabled(not run.locked)
            action.setToolTip(run.locked or f"{action.text()} ({action.shortcut().toString()})")
        self._show_tube(run)
        sums, seen = working(run.budget, run.stores)
        self.sums.setText("<br>".join(map(rich, sums)))
        words = [*seen, run.note]
        self.note.setText(" ".join(filter(None, words)))
        self.note.setVisible(any(words))
        self._share_height()
        self.plot.show_curve(run.curve, run.budget.lines, MOST_LINES)
        self._system_due.start()

    def _show_system(self) -> None:
        """In a turn of its own, as with a long list the page itself takes one."""
        if (run := self._run) is not None:
            self.architecture.show_drawing(architecture, run.working, told(run.working))
            self.system.set_empty(False)

    def _show_tube(self, run: VectorRun) -> None:
        self.glass.setCurrentIndex(int(run.stores))
        if run.stores:
            self._show_storage(run)
        elif self.tube.sight.now:
            self._show_strokes(run)

    def _show_strokes(self, run: VectorRun) -> None:
        """The whole list as it is refreshed, or of a frame that is stepped what it has drawn so far."""
        settings = self.session.state.tube
        # A part of a list is refreshed as seldom as all of it
        frame_ps = run.budget.time.frame_ps if run.steps else run.budget.shortest_ps
        setup = replace_setup(setup_of(settings), refresh_hz=1e12 / frame_ps, timing=run.budget.timing)
        strokes = run.strokes_now
        self.tube.set_ends(strokes.ends if not run.steps else run.program.strokes.ends)
        self.tube.set_trace(run.trace)
        self.tube.set_setup(setup)
        self.tube.set_slow_motion(settings.slow_motion)
        self.tube.set_paused(settings.paused)
        fed = run.program, len(strokes), setup
        if fed != self._fed:
            self._fed = fed
            self.tube.set_strokes(strokes.for_tube(), run.size)

    def _show_storage(self, run: VectorRun) -> None:
        self.storage.set_ends(run.program.strokes.ends)
        self.storage.take_list(run.program.strokes.for_tube(), run.size)
        self.storage_bar.refresh()

    # The hand

    def go_to(self, address: int) -> None:
        """Let the processor run to an instruction, and through it."""
        run = self.session.run
        if run.entry is not None and run.entry.slug == KIND:
            run.go_to_step(address + 1)

    def _go_to_stroke(self, stroke: int) -> None:
        if self._run is not None and stroke < len(self._run.program.strokes):
            self.go_to(self._run.program.address_of(stroke))

    def _change(self, name: str) -> None:
        if self._run is not None:
            self.changes.change(self._run, self.table.address, name)

    def _type(self, address: int, column: int, number: float) -> None:
        if self._run is not None:
            self.changes.type(self._run, address, column, number)

    def keep_order(self) -> None:
        """Write the order that makes jumps short into the sheet."""
        if self._run is not None and self.changes.keep_order(self._run):
            self._give(ordered=False)

    def overload(self) -> None:
        """So many test lines that any display flickers."""
        self._give(lines=OVERLOADED, length=float(self.session.sheet.width_px // 2))

    def draw_sheet(self) -> None:
        """No test lines."""
        self._give(lines=0)

    def _give(self, **given: object) -> None:
        subject = self.session.state.subject
        if runs_a_list(subject):
            arguments = {**subject.arguments, **given}
            self.session.update_state(subject=replace(subject, arguments=arguments), step=0)

    def _show_example(self) -> None:
        self.session.open_example(self.example)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Home, End and Space of the list are for the run."""
        if event.type() == QEvent.Type.KeyPress and isinstance(event, QKeyEvent):
            act = stepping_key(self.session.run, event)
            if act is not None:
                act()
                return True
        return super().eventFilter(watched, event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Where it is low, list and tube need the height that sum and plot have."""
        super().resizeEvent(event)
        self._share_height()

    def _share_height(self) -> None:
        low = self.height() < _LOW_PX
        self.sums.setVisible(not low)
        self.plot.setVisible(not low and not (self._run is not None and self._run.stores))

    def showEvent(self, event: QShowEvent) -> None:
        """Show what happened while it was hidden."""
        super().showEvent(event)
        self.refresh_soon()
