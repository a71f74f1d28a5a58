"""The algorithm's own structures at this step, such as a stack or an edge table, as live tables."""

from typing import Any

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, QSize, Qt, Signal
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QTableView, QVBoxLayout, QWidget

from workbench.algorithms.numerals import with_minus
from workbench.engine.observation import Table
from workbench.exchange.tables import shown, typeset
from workbench.language import _, ngettext
from workbench.session.run import Run
from workbench.widgets.look.tokens import colour, theme, tokens
from workbench.widgets.look.type_faces import code_font
from workbench.widgets.tables.table_columns import FittedColumns
from workbench.widgets.tables.table_copies import CopiedTable

Index = QModelIndex | QPersistentModelIndex
_ROW_PX = 22
_HEADING_PX = 14
_LEAST_ROWS = 2
_RING_PX = 2  # on each side, for the focus


class StructureModel(QAbstractTableModel):
    """Rows of one structure, the newest of a stack at the foot."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.table: Table = ((), ())

    def take(self, table: Table) -> None:
        """Show other rows."""
        if table != self.table:
            self.beginResetModel()
            self.table = table
            self.endResetModel()

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """Rows of the structure."""
        return 0 if parent.isValid() else len(self.table[1])

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """Its fields."""
        return 0 if parent.isValid() else len(self.table[0])

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Its headings; rows are counted from 0."""
        if role == Qt.ItemDataRole.DisplayRole:
            return typeset(self.table[0][section]) if orientation == Qt.Orientation.Horizontal else section
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """One cell."""
        if role == Qt.ItemDataRole.DisplayRole:
            row = self.table[1][index.row()]
            value = row[index.column()] if index.column() < len(row) else ""
            return with_minus(shown(value))
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        return code_font(12) if role == Qt.ItemDataRole.FontRole else None


class _FewRows(CopiedTable):
    def sizeHint(self) -> QSize:
        """As low as it may be; the room that there is makes it higher."""
        return QSize(super().sizeHint().width(), self.minimumHeight())


class StructureTable(QWidget):
    """A titled table for each structure of the step; without ``parts`` when the algorithm declares none.

    ``changed``: the algorithm declares others.
    """

    changed = Signal()

    def __init__(self, run: Run, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._run = run
        self._column = QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(0)
        self.parts: dict[str, tuple[QLabel, QTableView, StructureModel]] = {}
        run.changed.connect(self._take_run)
        run.moved.connect(self.refresh)
        run.grown.connect(self.refresh)
        theme.changed.connect(self.update)
        self._take_run()

    def _take_run(self) -> None:
        entry = self._run.entry
        titles = list(dict.fromkeys(t for view in entry.views for t in view.tables)) if entry else []
        others = titles != list(self.parts)
        if others:
            for label, view, _model in self.parts.values():
                label.deleteLater()
                view.deleteLater()  # and with it its model
            self.parts = {title: self._part(title) for title in titles}
        self.refresh()
        if others:
            self.changed.emit()

    def _part(self, title: str) -> tuple[QLabel, QTableView, StructureModel]:
        label = QLabel(_(title))
        label.setProperty("role", "caption")
        label.setContentsMargins(8, 4, 8, 0)
        label.setWordWrap(True)
        label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        view = _FewRows()
        model = StructureModel(view)
        view.setModel(model)
        view.setAccessibleName(_(title))
        view.setToolTip(_("{title} at this step").format(title=_(title)))
        view.setShowGrid(False)
        view.setTabKeyNavigation(False)
        view.verticalHeader().hide()
        view.verticalHeader().setDefaultSectionSize(_ROW_PX)
        heading = view.horizontalHeader().fontMetrics().height() + _HEADING_PX
        bar = view.horizontalScrollBar().sizeHint().height()
        view.setMinimumHeight(heading + _LEAST_ROWS * _ROW_PX + bar + 2 * _RING_PX)
        FittedColumns(view)
        view.setSelectionBehavior(QTableView.SelectionBehavior.SelectRows)
        view.setSelectionMode(QTableView.SelectionMode.ContiguousSelection)
        self._column.addWidget(label)
        self._column.addWidget(view, 1)
        for each in (label, view):
            each.show()
        return label, view, model

    def paintEvent(self, event: QPaintEvent) -> None:
        """The ground of a panel."""
        QPainter(self).fillRect(event.rect(), colour(tokens().surface))

    def refresh(self) -> None:
        """Read the structures of the step."""
        step = self._run.step if self.parts else None
        for title, (label, view, model) in self.parts.items():
            table = step.tables.get(title, (model.table[0], ())) if step is not None else ((), ())
            model.take(table)
            count = len(table[1])
            rows = ngettext("{n} row", "{n} rows", count).format(n=count)
            label.setText(f"{_(title)}, {rows}")
            if count:
                view.scrollToBottom()
