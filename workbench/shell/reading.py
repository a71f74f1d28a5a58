"""Source and tables side by side in half of the window, to read an algorithm while it is stepped."""

from collections.abc import Collection, Mapping, Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QSplitter, QTabWidget, QToolButton, QWidget

from workbench.language import _
from workbench.widgets.look.icons import set_icon

SOURCE, HAND_TABLE = "source", "hand_table"
_BESIDE = (SOURCE, "about")
_TABLES = (HAND_TABLE, "variables")
_NARROW_PX = 1100
_SHARES = (0.62, 0.38)
_TABLE_SHARES = (560, 440)


class Reading(QSplitter):
    """The ``middle`` of a workspace, and beside it source and tables, side by side in ``room`` pixels.

    ``parts``: title and widget of each view by the name of its dock; where they came from takes them back.
    In a narrow window the tables are tabs under the source. ``ended``: the button was pressed again.
    """

    ended = Signal()

    def __init__(self, middle: QWidget, parts: Mapping[str, tuple[str, QWidget]], room: int) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self.setChildrenCollapsible(False)
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
        narrow = room < _NARROW_PX
        half = QSplitter(Qt.Orientation.Vertical if narrow else Qt.Orientation.Horizontal)
        source = self._tabs(parts, _BESIDE)
        source.setCornerWidget(self.button)
        half.addWidget(source)
        if narrow:
            half.addWidget(self._tabs(parts, _TABLES))
            half.setSizes([room, room])
        else:
            tables = QSplitter(Qt.Orientation.Vertical)
            for name in _TABLES:
                tables.addWidget(self._tabs(parts, (name,)))
            tables.setSizes(_TABLE_SHARES)
            half.addWidget(tables)
            half.setSizes([round(room / 2 * share) for share in _SHARES])
        for each in (half, *half.findChildren(QSplitter)):
            each.setChildrenCollapsible(False)
        self.addWidget(half)
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
    return {*_BESIDE, *_TABLES} <= {*names}
