"""The persistence of every phosphor: times, law, where it was read, and what is uncertain."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLabel, QTableView, QVBoxLayout, QWidget

from workbench.display.flicker import smears
from workbench.display.phosphor import Phosphor, doubts, names, source_text
from workbench.exchange.tables import Table
from workbench.language import _
from workbench.widgets.look.spans import span_text
from workbench.widgets.tables.structure_table import StructureModel
from workbench.widgets.tables.table_columns import FittedColumns
from workbench.widgets.tables.table_copies import CopiedTable


def _row(name: str) -> tuple[str, ...]:
    phosphor = Phosphor.named(name)
    return (
        name,
        *(span_text(phosphor.time_to(share)) for share in (0.1, 0.01, 0.001)),
        doubts(phosphor) or "\N{EN DASH}",
        phosphor.decay_source,
        phosphor.decay_kind.replace("_", " "),
        phosphor.colour_name.replace("-", "\N{NON-BREAKING HYPHEN}"),
        _("smears") if smears(phosphor) else "",
    )


def persistence_table() -> Table:
    """One row for each phosphor."""
    columns = (
        _("phosphor"),
        _("to 10 %"),
        _("to 1 %"),
        _("to 0.1 %"),
        _("uncertain"),
        _("source"),
        _("law"),
        _("colour"),
        _("motion"),
    )
    return Table(columns, [_row(name) for name in names()], formulas=False)


class PhosphorTable(QWidget):
    """``chosen`` sends the phosphor whose row is picked."""

    chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.table = persistence_table()
        self.view = CopiedTable()
        model = StructureModel(self.view)
        model.take((self.table.columns, tuple(self.table.rows)))
        self.view.setModel(model)
        self.view.setAccessibleName(_("Persistence of every phosphor"))
        self.view.setToolTip(_("Press Enter or double-click to put a phosphor on the tube."))
        self.view.setShowGrid(False)
        self.view.setTabKeyNavigation(False)
        self.view.verticalHeader().hide()
        self.view.verticalHeader().setDefaultSectionSize(22)
        self.view.setSelectionBehavior(QTableView.SelectionBehavior.SelectRows)
        FittedColumns(self.view)
        # A longer note beneath takes room from the rows
        self.view.verticalScrollBar().rangeChanged.connect(lambda *_range: self._see())
        self.view.activated.connect(lambda index: self.chosen.emit(self.table.rows[index.row()][0]))
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.note.setProperty("role", "caption")
        self.note.setContentsMargins(8, 4, 8, 4)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.view, 1)
        column.addWidget(self.note)

    def mark(self, name: str) -> None:
        """Mark the row of the phosphor on the tube, and say where its decay was read."""
        number = [row[0] for row in self.table.rows].index(name)
        if self.view.currentIndex().row() != number:
            self.view.selectRow(number)
        phosphor = Phosphor.named(name)
        said = [f"{name}: {source_text(phosphor.decay_source)}", phosphor.note]
        self.note.setText(" ".join(filter(None, said)))

    def _see(self) -> None:
        """Keep the marked row in sight."""
        self.view.scrollTo(self.view.currentIndex())
