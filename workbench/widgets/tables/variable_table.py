"""The variables at the cursor; those that this step changed are marked."""

from typing import Any

import numpy as np
from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QHeaderView, QTableView, QVBoxLayout, QWidget

from workbench.algorithms.numerals import with_minus
from workbench.engine.containers import LeftOut, same
from workbench.exchange.tables import shown
from workbench.language import _, ngettext
from workbench.session.run import Run
from workbench.widgets.look.empty_view import EmptyView
from workbench.widgets.look.tokens import colour, theme, tokens
from workbench.widgets.look.type_faces import cell_font
from workbench.widgets.tables.table_columns import PADDING_PX
from workbench.widgets.tables.table_copies import CopiedTable

Index = QModelIndex | QPersistentModelIndex
_LONGEST = 8
_SIDES = tuple(
    side | Qt.AlignmentFlag.AlignVCenter for side in (Qt.AlignmentFlag.AlignLeft, Qt.AlignmentFlag.AlignRight)
)


def value_text(value: Any) -> str:
    """A variable's value in one line."""
    if isinstance(value, LeftOut):
        return _("{size} array, not recorded").format(size=" × ".join(str(n) for n in reversed(value.shape)))
    if isinstance(value, np.ndarray) and value.size > _LONGEST:
        return _("{size} array").format(size=shown(value))
    if isinstance(value, np.ndarray):
        return shown(value.tolist())
    if isinstance(value, list | set | dict) and len(value) > _LONGEST:
        return ngettext("{count:,} item", "{count:,} items", len(value)).format(count=len(value))
    if isinstance(value, bool):
        return str(value)
    return with_minus(shown(value)) if isinstance(value, int | float) else shown(value)


class VariableModel(QAbstractTableModel):
    """One row per variable: its name, its value."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.names: list[str] = []
        self.values: dict[str, Any] = {}
        self.changed_names: frozenset[str] = frozenset()

    def take(self, values: dict[str, Any], changed: frozenset[str]) -> None:
        """Show other values; rows keep their places where they can."""
        if list(values) != self.names:
            self.beginResetModel()
            self.names, self.values, self.changed_names = list(values), values, changed
            self.endResetModel()
            return
        before, marked = self.values, self.changed_names
        self.values, self.changed_names = values, changed
        for row, name in enumerate(self.names):
            if name in marked | changed or not same(before[name], values[name]):
                self.dataChanged.emit(self.index(row, 0), self.index(row, 1))

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """How many variables."""
        return 0 if parent.isValid() else len(self.names)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """Name and value."""
        return 0 if parent.isValid() else 2

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """The headings."""
        if orientation == Qt.Orientation.Horizontal and role == Qt.ItemDataRole.DisplayRole:
            return (_("Variable"), _("Value"))[section]
        if orientation == Qt.Orientation.Horizontal and role == Qt.ItemDataRole.TextAlignmentRole:
            return _SIDES[section]
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Text, alignment and the mark of a change."""
        name = self.names[index.row()]
        changed = name in self.changed_names
        if role == Qt.ItemDataRole.DisplayRole:
            return value_text(self.values[name]) if index.column() else _marked(name, changed)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _SIDES[index.column()]
        if role == Qt.ItemDataRole.ForegroundRole:
            return colour(tokens().accent if changed else tokens().text)
        if role == Qt.ItemDataRole.FontRole:
            return cell_font(changed)
        if role == Qt.ItemDataRole.ToolTipRole and index.column():
            return shown(self.values[name])[:400] if isinstance(self.values[name], list) else None
        if role == Qt.ItemDataRole.AccessibleTextRole:
            text = value_text(self.values[name]) if index.column() else name
            return _("{text}, changed").format(text=text) if changed else text
        return None


def _marked(name: str, changed: bool) -> str:
    return f"{'●' if changed else ' '} {name}"


class VariableTable(QWidget):
    """A table of the run's variables."""

    example_wanted = Signal()

    def __init__(self, run: Run, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._run = run
        self.model = VariableModel(self)
        self.view = CopiedTable()
        self.view.setModel(self.model)
        self.view.setAccessibleName(_("Variables"))
        self.view.setToolTip(_("The variables at this step; those that it changed are marked"))
        self.view.setShowGrid(False)
        self.view.setSelectionBehavior(QTableView.SelectionBehavior.SelectRows)
        self.view.verticalHeader().hide()
        self.view.verticalHeader().setDefaultSectionSize(22)
        self.view.setTabKeyNavigation(False)
        header = self.view.horizontalHeader()
        header.setHighlightSections(False)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Fixed)
        header.setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)
        self.state = EmptyView(self.view, _("The variables of the algorithm are shown here."))
        self.state.wanted.connect(self.example_wanted)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.state)
        self.setFocusProxy(self.view)
        self.model.modelReset.connect(self._fit_names)
        run.changed.connect(self.refresh)
        run.moved.connect(self.refresh)
        run.grown.connect(self.refresh)
        theme.changed.connect(self.view.viewport().update)
        self.refresh()

    def _fit_names(self) -> None:
        """Give the names their width; asking the view for it would ask the model for every role of each."""
        metrics = QFontMetrics(cell_font(True))
        names = [_("Variable"), *(_marked(name, True) for name in self.model.names)]
        self.view.setColumnWidth(0, max(map(metrics.horizontalAdvance, names)) + PADDING_PX)

    def refresh(self) -> None:
        """Read the variables at the cursor."""
        self.state.set_empty(self._run.entry is None)
        self.model.take(self._run.variables, self._run.changed_names)

    def point_at(self, name: str) -> None:
        """Select a variable, as when it is named in the sentence."""
        if name in self.model.names:
            self.view.selectRow(self.model.names.index(name))
            self.view.scrollTo(self.model.index(self.model.names.index(name), 0))
