"""Object space against image space: the course's table, with numbers of this scene."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from workbench.exchange.tables import Table
from workbench.language import _
from workbench.rendering.scene.spaces import Measures, SpaceRow, space_rows
from workbench.widgets.look.in_sight import InSight
from workbench.widgets.tables.feature_table import FeatureTable

_LOW_PX = 260


class QuestionDock(QWidget):
    """``seen``: it came in sight, so what it tells is to be measured."""

    seen = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.table = FeatureTable(
            _("Object space and image space"), _("Choose a row to read what has to be added to it")
        )
        self.table.currentCellChanged.connect(lambda *_cells: self._tell())
        self.note = QLabel()
        self.note.setWordWrap(True)
        self.note.setContentsMargins(10, 4, 10, 4)
        self.note.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.table, 1)
        column.addWidget(self.note)
        self.rows: tuple[SpaceRow, ...] = ()
        self.in_sight = InSight(self)
        self.in_sight.changed.connect(self._come_in_sight)

    def _come_in_sight(self, seen: bool) -> None:
        if seen:
            self._show()
            self.seen.emit()

    def show_measures(self, measures: Measures) -> None:
        """Show what is measured by now."""
        self.rows = space_rows(measures)
        if self.in_sight.now:
            self._show()

    def _show(self) -> None:
        rows = [(row.feature, row.object_space, row.image_space) for row in self.rows]
        headings = ("", _("Object space"), _("Image space"))
        self.table.show_rows(headings, rows, [row.but for row in self.rows])
        if self.table.currentRow() < 0 and rows:
            self.table.setCurrentCell(0, 0)
        self._tell()

    def _tell(self) -> None:
        """What has to be added; where the dock is low the tip of the row alone says it."""
        number = self.table.currentRow()
        but = self.rows[number].but if 0 <= number < len(self.rows) else ""
        self.note.setText(f"<b>{_('But:')}</b> {but}")
        self.note.setVisible(bool(but) and self.height() > _LOW_PX)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The note needs height."""
        super().resizeEvent(event)
        self._tell()

    def content(self) -> list[tuple[str, Table]]:
        """Title and content of the table, for export."""
        columns = _("feature"), _("object space"), _("image space"), _("but")
        rows = [tuple(row) for row in self.rows]
        return [(_("Object space and image space"), Table(columns, rows, formulas=False))]
