"""The Compare dock: two algorithms on the same input, their counts side by side, and where they differ."""

import numpy as np
from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QAction, QResizeEvent, QShowEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QSizePolicy,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from workbench.algorithms import catalogue
from workbench.document.errors import DocumentError
from workbench.document.subjects import Subject
from workbench.engine.recording import Recording
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.panels.panel import DockPart, PlainPanel, Said
from workbench.panels.shared.compare_table import CompareModel
from workbench.panels.shared.compare_work import table_rows
from workbench.panels.shared.compare_worker import CompareWorker
from workbench.panels.stage.picture import packed
from workbench.rendering.subjects.registry import compared, comparing, own_entry, rivals
from workbench.rendering.work import Job, Outcome
from workbench.session.run import Run
from workbench.session.session import Session
from workbench.widgets.canvas.overlay import Overlay
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.fields.choice_box import ChoiceBox
from workbench.widgets.look.empty_view import EmptyView
from workbench.widgets.look.tips import tell_choice
from workbench.widgets.look.tokens import theme_changed, tokens
from workbench.widgets.tables.table_copies import put_on_clipboard, rows_copied

ROW_PX = 20
_REST_MS = 150
_TALL_PX, _NARROW_PX, _LEAST_PX = 400, 330, 48


class CompareView(QWidget):
    """Chooses two algorithms and shows what each does with the same figures. ``said``: in passing."""

    said = Signal(str)
    example_wanted = Signal()

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._asked: tuple[object, ...] = ()
        self._was_whole = False
        self.outcome: Outcome | None = None
        self.worker = CompareWorker(self)
        self.worker.answered.connect(self._show)
        self.worker.failed.connect(self._failed)
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(_REST_MS)
        self._rest.timeout.connect(self._ask)
        self._make()
        self._runs = session.run, session.followers[0]
        for signal in (session.changed, session.state_changed, *(run.grown for run in self._runs)):
            signal.connect(self.refresh)
        session.run.moved.connect(self._tell_progress)
        theme_changed.connect(self._show_difference)

    def _make(self) -> None:
        self.first, self.second = ChoiceBox(2), ChoiceBox(2)
        for box, name, tip, choose in (
            (self.first, _("First algorithm"), _("The algorithm that is stepped"), self._choose_first),
            (
                self.second,
                _("Second algorithm"),
                _("The algorithm it is compared with, in step"),
                self._choose_second,
            ),
        ):
            box.setAccessibleName(name)
            box.setToolTip(tip)
            box.setMinimumWidth(_LEAST_PX)
            tell_choice(box)
            box.activated.connect(choose)
        self.whole = QCheckBox(_("Whole sheet"))
        self.whole.setToolTip(_("Count over every figure of the sheet that the algorithm can draw"))
        self.whole.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.whole.toggled.connect(self.refresh)
        self.model = CompareModel(self)
        self.table = QTableView()
        self.table.setModel(self.model)
        self.table.setAccessibleName(_("Counts side by side"))
        self.table.setToolTip(_("How much work each algorithm does; Ctrl+C copies the table"))
        self.table.setShowGrid(False)
        self.table.setSelectionMode(QTableView.SelectionMode.NoSelection)
        self.table.setTabKeyNavigation(False)
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setMinimumSectionSize(ROW_PX)
        self.table.verticalHeader().setDefaultSectionSize(ROW_PX)
        header = self.table.horizontalHeader()
        header.setHighlightSections(False)
        header.setMinimumSectionSize(_LEAST_PX)
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.table.setHorizontalScrollMode(QTableView.ScrollMode.ScrollPerPixel)
        self.copy_action = QAction(_("Copy comparison"), self)
        self.copy_action.setToolTip(_("Copy the counts; they paste as a table"))
        self.copy_action.triggered.connect(self.copy)
        self.table.addAction(self.copy_action)
        self.table.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self.difference = PixelCanvas()
        self.difference.setAccessibleName(_("Where the two differ"))
        self.difference.setMinimumSize(90, 60)
        self.difference.takes_handles = False
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.note.setProperty("role", "muted")
        choosing = QHBoxLayout()
        choosing.setSpacing(8)
        choosing.addWidget(self.first, 1)
        choosing.addWidget(self.second, 1)
        choosing.addWidget(self.whole)
        self._found = QBoxLayout(QBoxLayout.Direction.LeftToRight)
        self._found.setSpacing(8)
        self._found.addWidget(self.table, 5)
        self._found.addWidget(self.difference, 3)
        body = QWidget()
        column = QVBoxLayout(body)
        column.setContentsMargins(8, 6, 8, 6)
        column.setSpacing(6)
        column.addLayout(choosing)
        column.addLayout(self._found, 1)
        column.addWidget(self.note)
        self.state = EmptyView(body, _("Draw a figure, and the algorithms for it are compared here."))
        self.state.wanted.connect(self.example_wanted)
        outer = QVBoxLayout(self)
        outer.setContentsMargins(0, 0, 0, 0)
        outer.addWidget(self.state)
        # Less than its parts would like: in a narrow window the canvas needs the room more.
        self.setMinimumWidth(200)
        self.setFocusProxy(self.first)

    # What is compared

    def _entries(self) -> tuple[str, str, tuple[str, ...]]:
        """The first algorithm, the second if one is chosen that fits, and all that would fit."""
        session = self._session
        now, others = own_entry(session.sheet, session.subject), rivals(session.sheet, session.subject)
        second = session.state.compare if session.state.compare in others else ""
        if self._of_sheet and not second and others:
            second = others[0]
        return now, second, others

    @property
    def _subject(self) -> Subject:
        return compared(self._session.subject)

    @property
    def _of_sheet(self) -> bool:
        return comparing(self._subject).of_sheet

    def refresh(self) -> None:
        """Show what is chosen; ask for the counts when something they depend on is another."""
        if not self.isVisible():
            return
        session = self._session
        now, second, others = self._entries()
        self.state.set_empty(not now)
        if not now:
            self._asked = ()
            return
        if self._of_sheet and not self._was_whole:
            self._was_whole = True
            self.whole.setChecked(True)
        own = [slug for slug in others if slug in session.choices_of(self._subject)]
        self._fill(self.first, sorted((now, *own), key=_order), now, "")
        none = _("Compare with ...") if others else _("No other algorithm")
        self._fill(self.second, list(others), second, "" if self._of_sheet and others else none)
        self.second.setEnabled(bool(others))
        done = tuple(run.recording if run.done else None for run in self._runs)
        asked = (session.sheet, self._subject, now, second, self.whole.isChecked(), *done)
        if asked != self._asked:
            self._asked = asked
            self.model.grey()
            self.worker.cancel()
            self._rest.start()

    def _fill(self, box: QComboBox, slugs: list[str], now: str, none: str) -> None:
        wanted = [("", none)] if none else []
        wanted += [(slug, _(catalogue.get(slug).title)) for slug in slugs]
        if [(box.itemData(k), box.itemText(k)) for k in range(box.count())] != wanted:
            box.clear()
            for slug, title in wanted:
                box.addItem(title, slug)
        box.setCurrentIndex(max(0, box.findData(now)))

    def _ask(self) -> None:
        now, second, _others = self._entries()
        if not now:
            return
        sheet, subject = self._session.sheet, self._subject
        if self.whole.isChecked():
            self.worker.ask(Job(sheet, comparing(subject).alike(sheet, subject), now, second))
            return
        lead, follower = self._runs
        self.worker.ask(
            Job(sheet, (subject,), now, second, (_recorded(lead, now), _recorded(follower, second)))
        )

    def _choose_first(self, index: int) -> None:
        slug, session = self.first.itemData(index), self._session
        before = self._entries()[0]
        if slug == before:
            return
        try:
            session.choose(slug, self._subject)
        except DocumentError as problem:  # another figure is active since the list was opened
            self.note.setText(problem.short)
            return
        if session.state.compare == slug:
            session.update_state(compare=before)

    def _choose_second(self, index: int) -> None:
        self._session.update_state(compare=self.second.itemData(index))

    # What came of it

    def _show(self, outcome: Outcome) -> None:
        self.outcome = outcome
        second = outcome.second.title if outcome.second is not None else ""
        self.model.take((outcome.first.title, second), table_rows(outcome))
        self._show_difference()
        self._tell_progress()

    def _show_difference(self) -> None:
        outcome = self.outcome
        room = self.height() >= _TALL_PX or self.width() >= _NARROW_PX
        self.difference.setVisible(room and outcome is not None and outcome.classes is not None)
        if outcome is None or outcome.classes is None:
            return
        paper = packed(tokens().canvas)
        self.difference.set_picture(np.full(outcome.classes.shape, paper, np.uint32), paper)
        self.difference.set_overlay(Overlay(classes=outcome.classes))

    def _tell_progress(self) -> None:
        """Where the two runs are, which go in step."""
        outcome, session = self.outcome, self._session
        if outcome is None or not self.isVisible():
            return
        said = [work.stopped for work in (outcome.first, outcome.second) if work is not None and work.stopped]
        _now, second, others = self._entries()
        if outcome.second is None and second:
            said.append(_("Counting the work of both ..."))
        elif outcome.second is None:
            said += [_("Choose a second algorithm to see both side by side.")] if others else []
        else:
            said.append(_summary(outcome))
        here = [_position(run) for run in self._runs if run.entry is not None]
        if len(here) == 2 and session.run.position:
            said.append(_("Now in step: {first}; {second}.").format(first=here[0], second=here[1]))
        self.note.setText(" ".join(said))

    def _failed(self, problem: str) -> None:
        self.note.setText(
            _("The work could not be counted: {problem}. The picture is kept.").format(problem=problem)
        )

    def content(self) -> Table:
        """What it shows, one row for each count."""
        titles = ("", *self.model.titles)[: self.model.columnCount()]
        rows = [tuple("" if v is None else v for v in row[: len(titles)]) for row in self.model.rows]
        return Table(titles, rows, formulas=False)

    def copy(self) -> None:
        """Put the table on the clipboard, as text with tabs and as HTML."""
        table = self.content()
        put_on_clipboard(table)
        self.said.emit(rows_copied(len(table.rows)))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The difference picture stands where there is room: under the table, beside it, or not at all."""
        super().resizeEvent(event)
        tall, narrow = self.height() >= _TALL_PX, self.width() < _NARROW_PX
        direction = QBoxLayout.Direction
        self._found.setDirection(direction.TopToBottom if tall or narrow else direction.LeftToRight)
        self._show_difference()

    def showEvent(self, event: QShowEvent) -> None:
        """What was not followed unseen is made up for."""
        super().showEvent(event)
        self.refresh()


def _order(slug: str) -> int:
    return [entry.slug for entry in catalogue.entries()].index(slug)


def _recorded(run: Run, slug: str) -> Recording | None:
    """What a run has recorded, when it is that of ``slug`` and done."""
    if run.entry is None or run.recording is None or run.entry.slug != slug or not run.done:
        return None
    return run.recording


def _summary(outcome: Outcome) -> str:
    if outcome.only_first == outcome.only_second == outcome.ties == 0:
        return _("Both give the same {n} pixels.").format(n=outcome.both)
    return _("{both} pixels are the same, {first} only the first paints, {second} only the second.").format(
        both=outcome.both, first=outcome.only_first, second=outcome.only_second
    )


def _position(run: Run) -> str:
    entry = run.entry
    assert entry is not None
    step = run.step
    return _("{title} after step {n} of {total}").format(
        title=_(entry.title), n=step.number if step is not None else 0, total=run.total_text
    )


class ComparePanel(PlainPanel, QWidget):
    """The Compare dock of a workspace. ``hover_text``: what is to be said in passing."""

    hover_text = Signal(str)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.title = _("Compare")
        self._session = session
        self.view = CompareView(session)
        self.view.said.connect(self.hover_text)
        self.view.example_wanted.connect(self.show_example)

    @property
    def center(self) -> QWidget:
        """The panel has a dock only."""
        return self

    def docks(self) -> list[DockPart]:
        """The comparison, on the right."""
        return [("compare", self.title, self.view, Qt.DockWidgetArea.RightDockWidgetArea)]

    def actions(self) -> list[QAction]:
        """What this panel adds to the window's commands."""
        return [self.view.copy_action]

    def said(self) -> Said:
        """What was copied."""
        return Said(self.hover_text)

    def tables(self) -> list[tuple[str, Table]]:
        """Title and content of the comparison, while there is one."""
        table = self.view.content()
        return [(_("Comparison"), table)] if table.rows else []

    def show_example(self) -> None:
        """Open lines to compare."""
        self._session.open_example(comparing(self._session.subject).example)
