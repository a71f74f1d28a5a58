"""A tool button that does an action, and looks as the action says."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QToolButton, QWidget

SIDE_PX = 32


class ActionButton(QToolButton):
    """The icon of an action on a square, or in another ``style`` its words too, with the room that they take.

    A screen reader says ``name``, or where there is none what the action is called now. This is in place of
    ``setDefaultAction``, by which Qt 6.11 keeps 144 bytes at each change of an action.
    """

    def __init__(
        self,
        action: QAction,
        parent: QWidget | None = None,
        style: Qt.ToolButtonStyle = Qt.ToolButtonStyle.ToolButtonIconOnly,
        name: str = "",
    ) -> None:
        super().__init__(parent)
        self.action = action
        self._name = name
        self.setToolButtonStyle(style)
        if style == Qt.ToolButtonStyle.ToolButtonIconOnly:
            self.setFixedSize(SIDE_PX, SIDE_PX)
        self.addAction(action)  # its shortcut works where the button is
        action.changed.connect(self._follow)
        self._follow()

    def _follow(self) -> None:
        action = self.action
        self.setAccessibleName(self._name or action.text())
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
