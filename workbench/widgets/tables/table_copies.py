"""Tables on the clipboard: what is selected, or with nothing selected all of it, as text and as HTML."""

from PySide6.QtCore import QEvent, QMimeData, Qt
from PySide6.QtGui import QGuiApplication, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QTableView

from workbench.exchange.tables import Table, to_html, to_tsv
from workbench.language import ngettext


def put_on_clipboard(table: Table) -> None:
    """Put a table on the clipboard; it pastes as a table."""
    data = QMimeData()
    data.setText(to_tsv(table))
    data.setHtml(to_html(table))
    QGuiApplication.clipboard().setMimeData(data)


def rows_copied(count: int) -> str:
    """The sentence that says how many rows were copied."""
    return ngettext("{n:,} row copied.", "{n:,} rows copied.", count).format(n=count)


def chosen_rows(view: QTableView) -> list[int]:
    """The numbers of the rows with a selected cell, from the top."""
    ranges = view.selectionModel().selection().toList()
    return sorted({row for part in ranges for row in range(part.top(), part.bottom() + 1)})


class RowsTable(QTableView):
    """A table that answers the key that selects all itself, where several of its rows can be selected."""

    def event(self, event: QEvent) -> bool:
        """That key is the table's own here, not the canvas's."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride:
            several = self.selectionMode() == QTableView.SelectionMode.ContiguousSelection
            if several and event.matches(QKeySequence.StandardKey.SelectAll):
                event.accept()
                return True
        return super().event(event)


def chosen_part(view: QTableView) -> Table:
    """The selected rows under their headings as they are read, or with none selected all."""
    model, across = view.model(), Qt.Orientation.Horizontal
    columns = range(model.columnCount())
    headings = tuple(str(model.headerData(column, across) or "") for column in columns)
    rows = chosen_rows(view) or range(model.rowCount())
    cells = [tuple(model.index(row, column).data() for column in columns) for row in rows]
    return Table(headings, cells, formulas=False)


class CopiedTable(RowsTable):
    """Is copied as it is read."""

    def copy(self) -> None:
        """Put the selected rows on the clipboard with the headings, or with none selected all."""
        put_on_clipboard(chosen_part(self))
