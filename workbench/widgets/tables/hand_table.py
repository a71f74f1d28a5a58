"""The hand table as the course writes it, one row for each step, filled only where it is looked at."""

from collections.abc import Sequence
from functools import partial
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QElapsedTimer,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
    QTimer,
    Signal,
)
from PySide6.QtGui import QAction, QResizeEvent
from PySide6.QtWidgets import QTableView, QVBoxLayout, QWidget

from workbench.algorithms.entry import Entry
from workbench.algorithms.numerals import with_minus
from workbench.engine.observation import Steps
from workbench.engine.recording import Recording
from workbench.exchange.run_tables import hand
from workbench.exchange.tables import Table, shown, typeset
from workbench.language import _
from workbench.session.answers import Answers
from workbench.session.run import Run
from workbench.widgets.look.empty_view import EmptyView
from workbench.widgets.look.tokens import colour, theme, tokens
from workbench.widgets.look.type_faces import cell_font, keep_code_font
from workbench.widgets.tables.table_columns import FittedColumns, WholeRows
from workbench.widgets.tables.table_copies import RowsTable, chosen_rows, put_on_clipboard, rows_copied

Index = QModelIndex | QPersistentModelIndex
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_AT_ONCE = 500
_GROW_MS = 200


class HandModel(QAbstractTableModel):
    """The steps of a run as rows; a row is evaluated when it is shown."""

    def __init__(self, run: Run, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._run = run
        self._rows = 0
        self._current = 0

    def reset(self) -> None:
        """Another run."""
        self.beginResetModel()
        self._rows = self._run.tellable
        self._current = 0
        self.endResetModel()

    def update(self) -> None:
        """Take in what was recorded since, and mark the current step."""
        rows = self._run.tellable
        if rows > self._rows:
            self.beginInsertRows(QModelIndex(), self._rows, rows - 1)
            self._rows = rows
            self.endInsertRows()
        elif rows < self._rows:
            self.beginRemoveRows(QModelIndex(), rows, self._rows - 1)
            self._rows = rows
            self.endRemoveRows()
        current = self._run.step_number
        if current != self._current:
            # A run that is told only so far, or is another, has fewer rows than it had
            first, last = (min(max(step - 1, 0), self._rows - 1) for step in sorted((current, self._current)))
            self._current = current
            if self._rows:
                self.dataChanged.emit(self.index(first, 0), self.index(last, len(self.columns) - 1))

    @property
    def columns(self) -> tuple[str, ...]:
        """The headings as the entry writes them."""
        return self._run.entry.columns if self._run.entry is not None else ()

    @property
    def current(self) -> int:
        """The step that is marked."""
        return self._current

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """Steps recorded so far."""
        return 0 if parent.isValid() else self._rows

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """As many as the entry declares."""
        return 0 if parent.isValid() else len(self.columns)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Headings with real subscripts."""
        if orientation != Qt.Orientation.Horizontal or section >= len(self.columns):
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return typeset(self.columns[section])
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _RIGHT
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """One cell."""
        number = index.row() + 1
        if role == Qt.ItemDataRole.DisplayRole:
            steps = self._run.steps
            if steps is None or number > len(steps):
                return None
            row = steps.row(number)
            return with_minus(shown(row[index.column()])) if index.column() < len(row) else ""
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _RIGHT
        now = tokens()
        if role == Qt.ItemDataRole.BackgroundRole and number == self._current:
            return colour(now.selected)
        if role == Qt.ItemDataRole.ForegroundRole:
            return colour(now.muted if number > self._current else now.text)
        if role == Qt.ItemDataRole.FontRole:
            return cell_font(number == self._current)
        return None


class HandTable(QWidget):
    """The hand table of a run. ``copied``: a sentence, when it is on the clipboard."""

    copied = Signal(str)
    example_wanted = Signal()

    def __init__(self, run: Run, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._run = run
        self.model = HandModel(run, self)
        self.view = RowsTable()
        self.view.setModel(self.model)
        self.view.setAccessibleName(_("Hand table"))
        self.view.setToolTip(_("One row for each step; click a row to go there, drag to choose several"))
        self.view.setShowGrid(False)
        self.view.setSelectionBehavior(QTableView.SelectionBehavior.SelectRows)
        self.view.setSelectionMode(QTableView.SelectionMode.ContiguousSelection)
        self.view.setTabKeyNavigation(False)
        self.view.verticalHeader().hide()
        self.view.verticalHeader().setDefaultSectionSize(22)
        keep_code_font(self.view.horizontalHeader(), 12)
        FittedColumns(self.view)
        self.view.setItemDelegate(WholeRows(self.view))
        self.view.clicked.connect(self._go_to)
        self.copy_action = QAction(_("Copy table"), self)
        self.copy_action.setToolTip(_("Copy the hand table; it pastes as a table"))
        self.copy_action.triggered.connect(self.copy_all)
        self.view.addAction(self.copy_action)
        self.view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self.state = EmptyView(self.view, _("Every step becomes a row here."))
        self.state.wanted.connect(self.example_wanted)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.state)
        self.setFocusProxy(self.view)
        self._copies = Answers(self)
        self._copies.arrived.connect(self._take_copy)
        run.changed.connect(self._take_run)
        for signal in (run.moved, run.asked):
            signal.connect(self.refresh)
        run.grown.connect(self._grow)
        self._grown = QElapsedTimer()
        self._grown.start()
        # The view has its own new size, and a place for new rows, only once the layout has been done.
        self._placed = QTimer(self)
        self._placed.setSingleShot(True)
        self._placed.timeout.connect(self._show_current)
        self.view.horizontalScrollBar().rangeChanged.connect(self._placed.start)
        theme.changed.connect(self.view.viewport().update)
        self._take_run()

    def _take_run(self) -> None:
        stood = self.model.current
        self.model.reset()
        self.state.set_empty(self._run.entry is None)
        self.refresh()
        if stood and not self.model.current:
            self.view.scrollToTop()

    def _grow(self) -> None:
        """Take in new rows, of a long table now and then: it is slow to grow."""
        if self._run.done or self._grown.elapsed() > _GROW_MS or self.model.rowCount() < _AT_ONCE:
            self._grown.restart()
            self.refresh()

    def refresh(self) -> None:
        """Follow the run: new rows, the current one in sight."""
        before, rows = self.model.current, self.model.rowCount()
        self.model.update()
        if self.model.current != before:
            self._show_current()
            if not self.model.current:
                self.view.scrollToTop()
            if self.model.rowCount() > rows:
                self._placed.start()  # a table that has just grown can be scrolled that far only later

    def _go_to(self, index: Index) -> None:
        """A click goes to its step and selects nothing; of several rows it ends the choice."""
        if len(chosen_rows(self.view)) == 1:
            self.view.clearSelection()
            self._run.go_to_step(index.row() + 1)

    def _show_current(self) -> None:
        current = self.model.current
        if current and current <= self.model.rowCount():
            self.view.scrollTo(self.model.index(current - 1, 0))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The current row stays in sight, also when the table first gets its place."""
        super().resizeEvent(event)
        self._placed.start()

    def copy(self) -> None:
        """Put the selected rows on the clipboard, or with none selected the whole table."""
        self._copy(chosen_rows(self.view) or range(self.model.rowCount()))

    def copy_all(self) -> None:
        """Put the whole table on the clipboard, as text with tabs and as HTML."""
        self._copy(range(self.model.rowCount()))

    def _copy(self, rows: Sequence[int]) -> None:
        entry, recording = self._run.entry, self._run.recording
        if entry is None or recording is None:
            return
        if len(rows) <= _AT_ONCE:
            self._take_copy(_table(entry, recording, rows))
            return
        self.copied.emit(_("Copying {rows:,} rows ...").format(rows=len(rows)))
        self._copies.ask(partial(_table, entry, recording, rows), "copy")

    def _take_copy(self, table: Table) -> None:
        put_on_clipboard(table)
        self.copied.emit(rows_copied(len(table.rows)))


def _table(entry: Entry, recording: Recording, rows: Sequence[int]) -> Table:
    return hand(Steps(entry, recording), rows).computed()
