"""The display list: a table to read, to type into, to insert, delete and put in order."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QModelIndex, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QHBoxLayout, QLabel, QTableView, QVBoxLayout, QWidget

from workbench.language import _
from workbench.panels.display.vector.list_model import ListModel
from workbench.widgets.look.action_button import ActionButton
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.type_faces import keep_code_font
from workbench.widgets.tables.table_columns import FittedColumns, WholeRows
from workbench.widgets.tables.table_copies import put_on_clipboard


class ListTable(QWidget):
    """``address_chosen`` sends the instruction that somebody goes to; ``wanted`` the name of a change to it:
    "stroke", "jump", "delete", "earlier" or "later".
    """

    address_chosen = Signal(int)
    wanted = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.model = ListModel(self)
        self.view = QTableView()
        self.view.setModel(self.model)
        self.view.setAccessibleName(_("Display list"))
        self.view.setToolTip(
            _("Click an instruction to let the beam go there; double-click a number to type another")
        )
        self.view.setShowGrid(False)
        self.view.setSelectionBehavior(QTableView.SelectionBehavior.SelectRows)
        self.view.setSelectionMode(QTableView.SelectionMode.SingleSelection)
        self.view.setTabKeyNavigation(False)
        self.view.verticalHeader().hide()
        self.view.verticalHeader().setDefaultSectionSize(22)
        keep_code_font(self.view.horizontalHeader(), 12)
        self.view.setItemDelegate(WholeRows(self.view))
        FittedColumns(self.view)
        self.view.viewport().installEventFilter(self)
        self.view.clicked.connect(lambda index: self.address_chosen.emit(index.row()))
        self.view.selectionModel().currentRowChanged.connect(self._current_changed)
        self.summary = QLabel()
        self.summary.setProperty("role", "caption")
        self.summary.setWordWrap(True)
        self.summary.setContentsMargins(4, 0, 4, 0)
        bar = QHBoxLayout()
        bar.setContentsMargins(4, 0, 4, 0)
        bar.setSpacing(2)
        self.changes: list[QAction] = []
        for name, text, picture, key in (
            ("stroke", _("Insert a stroke after it"), "plus", "Ins"),
            ("jump", _("Insert a jump and a stroke"), "arrow-bend-down-right", "Shift+Ins"),
            ("delete", _("Delete the instruction"), "trash", "Del"),
            ("earlier", _("Draw the stroke earlier"), "arrow-up", "Alt+Up"),
            ("later", _("Draw the stroke later"), "arrow-down", "Alt+Down"),
        ):
            bar.addWidget(ActionButton(self._action(name, text, picture, key)))
        bar.addStretch(1)
        self.copy_action = QAction(_("Copy the list"), self)
        self.copy_action.triggered.connect(self.copy)
        self.view.addAction(self.copy_action)
        self.view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addLayout(bar)
        column.addWidget(self.summary)
        column.addWidget(self.view, 1)
        self.setFocusProxy(self.view)
        self.setMinimumWidth(240)

    def _action(self, name: str, text: str, picture: str, key: str) -> QAction:
        action = QAction(text, self)
        action.setObjectName(f"vector.{name}")
        action.setShortcut(QKeySequence(key))
        action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        action.setToolTip(f"{text} ({key})")
        set_icon(action, picture)
        action.triggered.connect(lambda _checked=False: self.wanted.emit(name))
        self.view.addAction(action)
        self.changes.append(action)
        return action

    @property
    def address(self) -> int:
        """The instruction that is chosen; -1 for none."""
        return self.view.currentIndex().row()

    def show_address(self, address: int) -> None:
        """Mark the instruction that is run, and bring it in sight; -1 marks none."""
        if address == self.model.current and address in (-1, self.address):  # another list has none chosen
            return
        self.model.mark(address)
        if address >= 0:
            index = self.model.index(address, max(self.view.currentIndex().column(), 0))
            self._quietly(lambda: self.view.setCurrentIndex(index))
            self._bring_in_sight()
        else:
            self.view.scrollToTop()

    def _bring_in_sight(self) -> None:
        index = self.model.index(self.model.current, 0)
        if index.isValid():
            self.view.scrollTo(index)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """The instruction that is run stays in sight when the list becomes lower."""
        if event.type() == QEvent.Type.Resize:
            QTimer.singleShot(0, self, self._bring_in_sight)  # once it has that height
        return False

    def _quietly(self, act: Callable[[], object]) -> None:
        chosen = self.view.selectionModel()
        chosen.blockSignals(True)
        act()
        chosen.blockSignals(False)
        self.view.viewport().update()

    def _current_changed(self, now: QModelIndex, before: QModelIndex) -> None:
        """The keys choose an instruction as a click does."""
        if now.isValid() and before.isValid() and self.view.hasFocus():
            self.address_chosen.emit(now.row())

    def copy(self) -> None:
        """Put the whole list on the clipboard; it pastes as a table."""
        put_on_clipboard(self.model.content())
