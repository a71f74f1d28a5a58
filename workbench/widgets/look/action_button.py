"""A tool button that does an action, and looks as the action says."""

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QToolButton, QWidget


class ActionButton(QToolButton):
    """In place of ``setDefaultAction``, by which Qt 6.11 keeps 144 bytes at each change of an action."""

    def __init__(self, action: QAction, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.action = action
        self.setAccessibleName(action.text())
        self.addAction(action)  # its shortcut works where the button is
        action.changed.connect(self._follow)
        self._follow()

    def _follow(self) -> None:
        action = self.action
        self.setText(action.iconText().replace("&", "&&"))
        self.setIcon(action.icon())
        self.setToolTip(action.toolTip())
        self.setStatusTip(action.statusTip())
        self.setCheckable(action.isCheckable())
        self.setChecked(action.isChecked())
        self.setEnabled(action.isEnabled())

    def nextCheckState(self) -> None:
        """The action does what it does, and whether the button is down follows from it."""
        self.action.trigger()
