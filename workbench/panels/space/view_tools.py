"""The tools beside the pictures of a scene: what is shown, zoom, and from where it is looked at."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QFrame, QMenu, QToolButton, QVBoxLayout, QWidget

from workbench.language import _
from workbench.widgets.look.icons import set_icon

_BAR_PX, _BUTTON_PX = 44, 32


class Tool(NamedTuple):
    """A command: its name, title, icon, key, and what it does; one without an icon is in the menu
    *Look from*. A ``key`` in brackets is one of the views' own, which is only named. ``checked`` is what a
    command that is switched on and off begins with."""

    name: str
    title: str
    icon: str
    key: str
    do: Callable[[], object]
    checked: bool | None = None


class ViewTools(QFrame):
    """A bar of buttons; ``actions_by_name`` has all commands, also those of its menu."""

    def __init__(self, tools: Sequence[Tool], parent: QWidget) -> None:
        super().__init__(parent)
        self.setFixedWidth(_BAR_PX)
        self.actions_by_name: dict[str, QAction] = {}
        column = QVBoxLayout(self)
        column.setContentsMargins(6, 4, 6, 4)
        column.setSpacing(2)
        self.menu = QMenu(self)
        self.look_from = self._button(column)
        set_icon(self.look_from, "compass")
        words = _("Look from a side, and keep or recall a view")
        self.look_from.setToolTip(words)
        self.look_from.setAccessibleName(words)
        self.look_from.setMenu(self.menu)
        self.look_from.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        for tool in tools:
            action = self._action(tool, parent)
            if tool.icon:
                set_icon(action, tool.icon)
                button = self._button(column)
                button.setDefaultAction(action)
                button.setAccessibleName(tool.title)
            else:
                self.menu.addAction(action)
        column.addStretch(1)

    @staticmethod
    def _button(column: QVBoxLayout) -> QToolButton:
        button = QToolButton()
        button.setFixedSize(_BUTTON_PX, _BUTTON_PX)
        column.addWidget(button)
        return button

    def _action(self, tool: Tool, owner: QWidget) -> QAction:
        own = tool.key.startswith("(")
        key = tool.key.strip("()")
        action = QAction(f"{tool.title} ({key})" if own else tool.title, owner)
        action.setObjectName(f"space.{tool.name}")
        action.setToolTip(f"{tool.title} ({key})" if key else tool.title)
        if key and not own:
            action.setShortcut(key)
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        if tool.checked is not None:
            action.setCheckable(True)
            action.setChecked(tool.checked)
        action.triggered.connect(lambda _checked=False: tool.do())
        self.actions_by_name[tool.name] = action
        owner.addAction(action)
        return action
