"""The counts of a comparison as a table: one row for each number, one column for each algorithm."""

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt
from PySide6.QtWidgets import QWidget

from workbench.language import _
from workbench.panels.shared.compare_work import ComparedCount
from workbench.widgets.look.tokens import colour, tokens
from workbench.widgets.look.type_faces import code_font

Index = QModelIndex | QPersistentModelIndex


class CompareModel(QAbstractTableModel):
    """Label, first and second; ``stale`` greys them while others are awaited."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.titles: tuple[str, str] = ("", "")
        self.rows: list[ComparedCount] = []
        self.stale = False

    def take(self, titles: tuple[str, str], rows: list[ComparedCount]) -> None:
        """Show other rows."""
        self.beginResetModel()
        self.titles, self.rows, self.stale = titles, rows, False
        self.endResetModel()

    def grey(self) -> None:
        """What is shown waits for something newer."""
        if not self.stale and self.rows:
            self.stale = True
            self.dataChanged.emit(self.index(0, 0), self.index(len(self.rows) - 1, self.columnCount() - 1))

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """One for each number compared."""
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        """The label, and one or two algorithms."""
        return 0 if parent.isValid() else 3 if self.titles[1] else 2

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> object:
        """The titles of the algorithms."""
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return ("", _("◪ First"), _("⬔ Second"))[section]
        if role == Qt.ItemDataRole.ToolTipRole and section:
            return self.titles[section - 1]
        if role == Qt.ItemDataRole.ForegroundRole and section:
            return colour(tokens().data[section - 1])
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        """One cell."""
        value = self.rows[index.row()][index.column()]
        if role == Qt.ItemDataRole.DisplayRole:
            if isinstance(value, int):
                return f"{value:,}".replace(",", "\N{NARROW NO-BREAK SPACE}")
            return "" if value is None else value
        if role == Qt.ItemDataRole.TextAlignmentRole:
            side = Qt.AlignmentFlag.AlignRight if index.column() else Qt.AlignmentFlag.AlignLeft
            return side | Qt.AlignmentFlag.AlignVCenter
        if role == Qt.ItemDataRole.FontRole and index.column():
            return code_font(12)
        if role == Qt.ItemDataRole.ForegroundRole:
            return colour(tokens().muted if self.stale or not index.column() else tokens().text)
        return None
