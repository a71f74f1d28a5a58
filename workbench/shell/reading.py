"""Source and tables side by side in half of the window, to read an algorithm while it is stepped."""

from collections.abc import Collection, Mapping, Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QTabWidget, QToolButton, QWidget

from workbench.language import _
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.split import Split

SOURCE, HAND_TABLE, VARIABLES = "source", "hand_table", "variables"
_BESIDE = (SOURCE, "about")
_NARROW_PX = 1100
_SHARES = (0.62, 0.38)
_STACKED_SHARES = (0.68, 0.32)
_TABLE_SHARES = (500, 500)


class Reading(Split):
    """The ``middle`` of a workspace, and beside it source and tables, side by side in ``room`` pixels.

    ``parts``: title and widget of each view by the name of its dock; where they came from takes them back.
    While the window is narrow the tables are tabs under the source. ``ended``: the button was pressed again.
    """

    ended = Signal()

    def __init__(self, middle: QWidget, parts: Mapping[str, tuple[str, QWidget]], room: int) -> None:
        super().__init__()
        self.addWidget(middle)
        middle.show()
        self.button = QToolButton()
        self.button.setText(_("Read"))
        self.button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.button.setCheckable(True)
        self.button.setChecked(True)
        self.button.setToolTip(_("Back to the docks as they were (R)"))
        set_icon(self.button, "book-open")
        self.button.clicked.connect(self.ended)
        self._half = Split()
        source = self._tabs(parts, _BESIDE)
        source.setCornerWidget(self.button)
        self._half.addWidget(source)
        self._tables = Split(Qt.Orientation.Vertical)
        self._variables = parts[VARIABLES]
        self._upper, self._lower = (self._tabs(parts, (name,)) for name in (HAND_TABLE, VARIABLES))
        self._tables.addWidget(self._upper)
        self._tables.addWidget(self._lower)
        self._half.addWidget(self._tables)
        self.addWidget(self._half)
        self._narrow = False
        self._arrange(room)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Arrange the tables anew where the window became narrow or wide."""
        super().resizeEvent(event)
        if self._narrow != (self.width() < _NARROW_PX):
            self._arrange(self.width())

    def _arrange(self, room: int) -> None:
        """Put the tables beside the source, or in a narrow window as tabs under it."""
        self._narrow = room < _NARROW_PX
        self._half.setOrientation(Qt.Orientation.Vertical if self._narrow else Qt.Orientation.Horizontal)
        title, variables = self._variables
        tabs = self._upper if self._narrow else self._lower
        if tabs.indexOf(variables) < 0:
            tabs.addTab(variables, title)
        self._lower.setVisible(not self._narrow)
        shares = _STACKED_SHARES if self._narrow else _SHARES
        self._half.setSizes([round(room * share) for share in shares])
        self._tables.setSizes(_TABLE_SHARES)
        self.setSizes([room // 2, room // 2])

    @staticmethod
    def _tabs(parts: Mapping[str, tuple[str, QWidget]], names: Sequence[str]) -> QTabWidget:
        tabs = QTabWidget()
        tabs.setDocumentMode(True)
        for name in names:
            title, widget = parts[name]
            tabs.addTab(widget, title)
        return tabs


def can_be_read(names: Collection[str]) -> bool:
    """Whether all views that are read are among the docks of these names."""
    return {*_BESIDE, HAND_TABLE, VARIABLES} <= {*names}
