"""Two things beside each other, feature by feature, in words; the feature is half bold."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QHeaderView, QTableWidget, QTableWidgetItem, QWidget

_AIR_PX = 6


class FeatureTable(QTableWidget):
    """A column for the feature, and one for each of the two."""

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
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        # Not within the layout: rows that grow may bring a scroll bar, which narrows the columns again
        self._fitting = QTimer(self, singleShot=True, interval=0)
        self._fitting.timeout.connect(self._fit_rows)
        header.sectionResized.connect(lambda *_section: self._fitting.start())

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
        self._fitting.start()

    def _fit_rows(self) -> None:
        """As high as their words, and some air."""
        self.resizeRowsToContents()
        for row in range(self.rowCount()):
            self.setRowHeight(row, self.rowHeight(row) + _AIR_PX)
