"""The page Hidden surfaces: every method on one scene, what each shows, where it errs, and what it costs."""

from collections.abc import Sequence
from functools import partial

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QAction, QGuiApplication, QHideEvent, QKeyEvent, QKeySequence, QShowEvent
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from workbench.algorithms.visibility import painter
from workbench.document.samples.arena import READY
from workbench.document.subjects import Subject
from workbench.exchange.diagrams import Derivation
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.panel import Cell, DockPart, KeysWhileSeen, Said
from workbench.panels.space.arena.bar import ArenaBar
from workbench.panels.space.arena.derivation import derivation
from workbench.panels.space.arena.growth_dock import GrowthDock
from workbench.panels.space.arena.question_dock import QuestionDock
from workbench.panels.space.arena.telling import describe, picture_of, sentence_of, table_of
from workbench.panels.space.arena.tile import Pixels, TileState
from workbench.panels.space.arena.tile_grid import TileGrid
from workbench.panels.space.arena.work import ArenaJob, ArenaWorker, Preparing, Told, Twice
from workbench.panels.stage.invitation import Invitation
from workbench.panels.stage.plain_page import PlainPage
from workbench.rendering.scene.arena import MethodRun, methods_for
from workbench.rendering.scene.growth import Growth
from workbench.rendering.scene.render import DeviceTriangles
from workbench.rendering.scene.spaces import Measures
from workbench.rendering.subjects.visibility import (
    KIND,
    fault_of,
    is_of_the_scene,
    method_of,
    scene_size,
    window_of,
)
from workbench.session.session import Session
from workbench.widgets.look.tokens import theme_changed

SLUG, STEPPED_ON = "arena", "visibility"
_SETTLE_MS = 120
_LEAST_LETTERS = 14


class ArenaPage(PlainPage, QWidget):
    """``hover_text``: what is under the pointer or said in passing; ``zoom_text``: how far the work is."""

    hover_text = Signal(str)
    zoom_text = Signal(str)
    _due = Signal()

    usual = Subject(KIND, entry=painter.__name__)
    example = READY[0]

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.session = session
        self._waiting = False
        self._timing = False
        self._job: ArenaJob | None = None
        self._device: DeviceTriangles | None = None
        self._pictures: dict[str, Pixels] = {}
        self.measures = Measures()
        self.problem = ""
        self.bar, self.grid = ArenaBar(), TileGrid()
        self.question, self.growth = QuestionDock(), GrowthDock()
        self.worker = ArenaWorker(self)
        self._settle = QTimer(self, interval=_SETTLE_MS, singleShot=True)
        self._settle.timeout.connect(self._run)
        self.sentence = QLabel()
        self.sentence.setWordWrap(True)
        self.sentence.setContentsMargins(12, 4, 12, 6)
        self.sentence.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.bar)
        column.addWidget(self.grid, 1)
        column.addWidget(self.sentence)
        self.empty = Invitation(
            self.grid,
            _("This sheet has no scene."),
            partial(session.open_example, self.example),
            _("Show three bars in a ring"),
        )
        self.setFocusProxy(self.grid)
        self._actions = self._made_actions()
        KeysWhileSeen(self, self._actions)
        self._connect()

    def _made_actions(self) -> list[QAction]:
        rows = (
            ("measure", _("Measure times"), "Ctrl+M", self.measure_times),
            ("step", _("Step this method"), "Ctrl+Return", lambda: self.step_method(self.chosen)),
            ("why", _("Why this pixel?"), "Y", self.ask_why),
        )
        made = []
        for name, text, key, do in rows:
            action = QAction(text, self)
            action.setObjectName(f"arena.{name}")
            action.setShortcut(QKeySequence(key))
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            action.triggered.connect(lambda _checked=False, do=do: do())
            self.addAction(action)
            made.append(action)
        self.grid.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self.grid.addActions(made)
        return made

    def _connect(self) -> None:
        session, bar = self.session, self.bar
        bar.scene_wanted.connect(session.open_example)
        bar.columns_wanted.connect(self._give_columns)
        bar.marks.toggled.connect(self._show_tiles)
        bar.measure.clicked.connect(lambda: self.stop() if self.worker.busy else self.measure_times())
        self._due.connect(self.refresh, Qt.ConnectionType.QueuedConnection)
        for told in (session.changed, session.state_changed):
            told.connect(self.refresh_soon)
        theme_changed.connect(self._show_tiles)
        self.grid.chosen.connect(self.choose)
        self.grid.stepped.connect(self.step_method)
        self.grid.pointed.connect(self._point)
        self.grid.asked.connect(self._ask_about)
        self.question.seen.connect(self._measure_if_not_yet)
        self.growth.seen.connect(self._measure_if_not_yet)
        self.worker.told.connect(self._take)
        self.worker.ended.connect(self._end)

    # What Space asks of a page

    def docks(self) -> Sequence[DockPart]:
        """The table of the two spaces, and how the time grows."""
        right = Qt.DockWidgetArea.RightDockWidgetArea
        return (
            ("question_7", _("Object and image space"), self.question, right),
            ("growth", _("Growth"), self.growth, right),
        )

    def commands(self) -> Sequence[QAction]:
        """Its commands."""
        return self._actions

    def said(self) -> Said:
        """What is said in passing, and how far the work is."""
        return Said(self.hover_text, self.zoom_text)

    def tables(self) -> Sequence[tuple[str, Table]]:
        """What every method did, and the table of the two spaces."""
        if not self.measures.runs:
            return ()
        return (
            (_("Hidden surfaces"), table_of(self.grid.tiles.values())),
            *self.question.content(),
            *self.growth.content(),
        )

    def copy(self) -> bool:
        """Put the pictures on the clipboard."""
        QGuiApplication.clipboard().setPixmap(self.grid.tiles_grabbed())
        self.hover_text.emit(_("The pictures are on the clipboard."))
        return True

    def derivation(self) -> Derivation | None:
        """The two spaces as a page; None where there is no scene."""
        return None if self._job is None else derivation(self._device, self.measures)

    def point_at(self, cell: Cell | None) -> None:
        """Ring a pixel in all pictures."""
        self.grid.point_at(cell)

    # What is shown

    @property
    def chosen(self) -> str:
        """The method that is spoken of, and that the step bar steps."""
        return method_of(self.session.sheet, self.session.subject) if self._here else ""

    @property
    def _here(self) -> bool:
        return self.session.state.workspace == SLUG and is_of_the_scene(self.session.subject)

    def refresh_soon(self, *_arguments: object) -> None:
        """Show the session as it is when all that happens now has happened; unseen, when it is seen, but what
        was measured of another scene is forgotten at once, since its docks stay beside other pages."""
        if not self.isVisible():
            if self._job is not None and self._job.scene is not self.session.sheet.scene:
                self._begin(None)
        elif not self._waiting:
            self._waiting = True
            self._due.emit()

    def refresh(self) -> None:
        """Show the session as it is now; another scene is run as soon as nothing more is changed."""
        self._waiting = False
        if not self.isVisible() or not self._here:
            return
        session = self.session
        sheet, subject, fault = session.sheet, session.subject, fault_of(session.sheet)
        self.empty.sentence.setText(fault)
        self.empty.setVisible(bool(fault))
        self.bar.measure.setEnabled(not fault)
        self.bar.show_sizes(sheet, scene_size(sheet, subject)[0])
        if fault or sheet.scene is None:
            self._begin(None)
        else:
            methods = methods_for(sheet.scene.camera)
            job = ArenaJob(sheet.scene, scene_size(sheet, subject), window_of(sheet), methods)
            if job != self._job:
                self._begin(job)
        self._tell()

    def _begin(self, job: ArenaJob | None) -> None:
        """Forget what was of another scene."""
        self.stop()
        self._job, self.measures, self.problem, self._device = job, Measures(), "", None
        self._pictures = {}
        if job is not None:
            self.grid.show_methods(job.methods, job.size)
            self._settle.start()
        else:
            self.grid.show_methods((), (3, 2))
        self._show_measures()
        self._show_tiles()

    @property
    def _coarse(self) -> Subject:
        """The subject but for its method: the size alone."""
        columns = scene_size(self.session.sheet, self.session.subject)[0]
        return Subject(KIND, arguments={"columns": columns})

    def _run(self) -> None:
        if self._job is not None:
            self.worker.run(self._job)
        self._tell()

    # Measuring

    def measure_times(self) -> None:
        """Time every method, after the pictures where those are not there yet."""
        if self._job is None or self._device is None:
            return
        self._timing = True
        if not self._settle.isActive() and not self.worker.busy:
            self.measures = self.measures._replace(growth={}, twice={})
            self.worker.time(self._job)
        self._tell()

    def _measure_if_not_yet(self) -> None:
        if self.isVisible() and not self.measures.growth:
            self.measure_times()

    def stop(self) -> None:
        """Leave what is being measured; what is done stays."""
        self._settle.stop()
        self._timing = False
        self.worker.cancel()
        self._tell()

    def _take(self, told: Told) -> None:
        measures = self.measures
        if isinstance(told, DeviceTriangles):
            self._device = told
        elif isinstance(told, MethodRun):
            measures = measures._replace(runs={**measures.runs, told.method: told})
        elif isinstance(told, Twice):
            measures = measures._replace(twice={**measures.twice, told.run.method: told.run})
        elif isinstance(told, Growth):
            measures = measures._replace(growth={**measures.growth, told.method: told})
        if isinstance(told, Preparing):
            self.zoom_text.emit(_("Compiling {done} of {total}").format(done=told.done, total=told.total))
        self.measures = measures
        if isinstance(told, MethodRun | Growth):
            self._show_tile(told.method)
            self._show_measures()
        self._tell()

    def _show_measures(self) -> None:
        self.question.show_measures(self.measures)
        self.growth.show_growth(self.measures.growth, self.chosen)

    def _end(self, problem: str) -> None:
        self.problem = problem
        timed = bool(self.measures.growth) or problem
        looked_at = self.question.in_sight.now or self.growth.in_sight.now
        if not timed and (self._timing or looked_at):
            self.measure_times()
        else:
            self._timing = False
        self._tell()

    # Telling

    def _tell(self) -> None:
        """The sentence, how far the work is, and what the button does."""
        job, measures, busy = self._job, self.measures, self.worker.busy
        self.grid.choose(self.chosen)
        self.grid.keep(self.session.state.asked(SLUG))
        self.growth.show_growth(measures.growth, self.chosen)
        self.bar.show_busy(busy)
        if job is None:
            self.sentence.setText("")
            if self.isVisible():
                self.zoom_text.emit("")
            return
        all_of = len(job.methods)
        if self._timing and measures.runs:
            self.zoom_text.emit(_("{n} of {all} timed").format(n=len(measures.growth), all=all_of))
        elif len(measures.runs) < all_of:
            self.zoom_text.emit(_("{n} of {all} run").format(n=len(measures.runs), all=all_of))
        else:
            self.zoom_text.emit(f"{job.size[0]} × {job.size[1]} px")
        run = measures.runs.get(self.chosen)
        waiting = _("The methods are being run.") if busy else ""
        self.sentence.setText(self.problem or (waiting if run is None else sentence_of(run)))

    def _show_tiles(self, *_what: object) -> None:
        self._pictures = {}
        for method in self.grid.tiles:
            self._show_tile(method)

    def _show_tile(self, method: str) -> None:
        run, growth = self.measures.runs.get(method), self.measures.growth.get(method)
        if run is not None and self._device is not None and method not in self._pictures:
            self._pictures[method] = picture_of(run, self._device, self.bar.marks.isChecked())
        self.grid.tiles[method].show_state(TileState(self._pictures.get(method), run, growth))

    def _point(self, cell: Cell | None) -> None:
        scene, device = self.session.sheet.scene, self._device
        if cell is None or scene is None or device is None:
            self.hover_text.emit("")
        else:
            self.hover_text.emit(describe(self.measures.runs, scene, device, *cell))

    # The hand

    def choose(self, method: str) -> None:
        """Speak of a method, and step it in the step bar."""
        if method and method != self.chosen:
            self.session.choose(method)

    def ask_why(self) -> None:
        """Ask why the pixel that is pointed at is as it is."""
        if self.grid.pointed_cell is None:
            self.hover_text.emit(_("Point at a pixel first, then ask why it is as it is."))
        else:
            self._ask_about(self.grid.pointed_cell)

    def _ask_about(self, cell: tuple[int, int]) -> None:
        self.session.update_state(pixel=cell, pixel_of=SLUG)
        self.session.why_asked.emit()

    def step_method(self, method: str) -> None:
        """Step a method on the page Visibility, the first wrong pixel pointed at."""
        if not method:
            return
        session, coarse = self.session, self._coarse
        run = self.measures.runs.get(method)
        wrong = [] if run is None else np.argwhere(run.different).tolist()
        session.visit(STEPPED_ON, coarse)
        pixel = (wrong[0][1], wrong[0][0]) if wrong else None
        subject = replace(coarse, entry=method)
        session.update_state(subject=subject, step=0, pixel=pixel, pixel_of=STEPPED_ON)

    def _give_columns(self, columns: int) -> None:
        subject = self.session.state.subject
        self.session.update_state(
            subject=replace(subject, arguments={**subject.arguments, "columns": columns}), step=0
        )

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Escape stops what is measured."""
        if event.key() == Qt.Key.Key_Escape and self.worker.busy:
            self.stop()
        else:
            super().keyPressEvent(event)

    def showEvent(self, event: QShowEvent) -> None:
        """Show what happened while it was hidden."""
        super().showEvent(event)
        self.refresh_soon()

    def hideEvent(self, event: QHideEvent) -> None:
        """Nothing is measured unseen."""
        super().hideEvent(event)
        self.stop()
        if self._job is not None and len(self.measures.runs) < len(self._job.methods):
            self._job = None
