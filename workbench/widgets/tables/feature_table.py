"""Two things beside each other, feature by feature, in words; the feature is half bold."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QAction, QFontMetrics, QResizeEvent
from PySide6.QtWidgets import QHeaderView, QTableWidget, QTableWidgetItem, QWidget

from workbench.language import _
from workbench.widgets.tables.table_copies import chosen_part, put_on_clipboard

_AIR_PX = 6
_MOST_OF_WIDTH = 0.34
_SIDE_PX = 4


class FeatureTable(QTableWidget):
    """A column for the feature, and one for each of the two. Narrow, it breaks the feature."""

    def __init__(self, name: str, tip: str, parent: QWidget | None = None) -> None:
        super().__init__(0, 3, parent)
        self.setAccessibleName(name)
        self.setToolTip(tip)
        self.setWordWrap(True)
        self.setShowGrid(False)
        self.setEditTriggers(QTableWidget.EditTrigger.NoEditTriggers)
        self.setSelectionMode(QTableWidget.SelectionMode.SingleSelection)
        self.setTabKeyNavigation(False)
        self.verticalHeader().hide()
        header = self.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Fixed)
        # Not within the layout: rows that grow may bring a scroll bar, which narrows the columns again
        self._fitting = QTimer(self, singleShot=True, interval=0)
        self._fitting.timeout.connect(self._fit_rows)
        header.sectionResized.connect(lambda *_section: self._fitting.start())
        self.copy_action = QAction(_("Copy table"), self)
        self.copy_action.setToolTip(_("Copy the comparison; it pastes as a table"))
        self.copy_action.triggered.connect(self.copy_all)
        self.addAction(self.copy_action)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)

    def show_rows(
        self, headings: tuple[str, str, str], rows: Sequence[tuple[str, str, str]], tips: Sequence[str]
    ) -> None:
        """Show these; each row has a tip, or its cells tell themselves."""
        self.setHorizontalHeaderLabels(headings)
        self.setRowCount(len(rows))
        for number, (row, tip) in enumerate(zip(rows, tips, strict=True)):
            for column, text in enumerate(row):
                item = QTableWidgetItem(text)
                item.setToolTip(tip or text)
                if not column:
                    font = item.font()
                    font.setBold(True)
                    item.setFont(font)
                self.setItem(number, column, item)
        self._fit_features()
        self._fitting.start()

    def copy(self) -> None:
        """Put the row that is chosen on the clipboard with the headings, or with none chosen all."""
        put_on_clipboard(chosen_part(self))

    def copy_all(self) -> None:
        """Put every row on the clipboard."""
        self.clearSelection()
        self.copy()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The two columns of words need the most of a narrow table."""
        self._fit_features()
        super().resizeEvent(event)

    def _fit_features(self) -> None:
        """The first column: as wide as its words, but on one line only where there is room."""
        least = self._widest_word()
        most = max(least, round(_MOST_OF_WIDTH * self.viewport().width()))
        self.horizontalHeader().resizeSection(0, min(self.sizeHintForColumn(0), most))

    def _widest_word(self) -> int:
        """The room that the longest word of a feature needs."""
        items = [item for row in range(self.rowCount()) if (item := self.item(row, 0)) is not None]
        widths = [
            QFontMetrics(item.font()).horizontalAdvance(word)
            for item in items
            for word in item.text().split()
        ]
        return max(widths, default=0) + 2 * _SIDE_PX

    def _fit_rows(self) -> None:
        """As high as their words, and some air."""
        self.resizeRowsToContents()
        for row in range(self.rowCount()):
            self.setRowHeight(row, self.rowHeight(row) + _AIR_PX)
