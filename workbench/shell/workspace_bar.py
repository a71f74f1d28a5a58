"""The bar along the top: Home and the workspaces, the current one underlined; a drop-down when narrow."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLayout, QToolButton, QWidget

from workbench.language import _

if TYPE_CHECKING:
    from collections.abc import Sequence

    from PySide6.QtCore import QSize
    from PySide6.QtGui import QAction, QResizeEvent

HEIGHT_PX = 36


class WorkspaceBar(QFrame):
    """``chosen`` carries the slug of what was pressed. Commands stand at the right end."""

    chosen = Signal(str)

    def __init__(self, places: Sequence[tuple[str, str, str]], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("workspaces")
        self.setFixedHeight(HEIGHT_PX)
        self.setAccessibleName(_("Workspaces"))
        self._places = list(places)
        self._tabs: dict[str, QToolButton] = {}
        self._current = ""
        self._folded: QToolButton | None = None
        self._commands: list[QToolButton] = []
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(4, 0, 6, 0)
        self._row.setSpacing(0)
        self._row.setSizeConstraint(QLayout.SizeConstraint.SetNoConstraint)
        for slug, title, tooltip in places:
            tab = QToolButton(self)
            tab.setObjectName("workspaceTab")
            tab.setText(title)
            tab.setToolTip(tooltip)
            tab.setAccessibleName(title)
            tab.setCheckable(True)
            tab.setFixedHeight(HEIGHT_PX)
            tab.clicked.connect(partial(self._choose, slug))
            self._row.addWidget(tab)
            self._tabs[slug] = tab
        self._row.addStretch(1)

    def show_current(self, slug: str) -> None:
        """Mark where one is; a page that is no workspace marks none."""
        self._current = slug
        for each, tab in self._tabs.items():
            tab.setChecked(each == slug)
        self._name_folded()

    def set_waiting(self, slug: str, waiting: bool) -> None:
        """Tell that a workspace is being prepared."""
        self._tabs[slug].setAccessibleDescription(_("being prepared") if waiting else "")

    def add_commands(self, actions: Sequence[tuple[QAction, str]]) -> None:
        """Put commands with their icons at the right end."""
        from PySide6.QtCore import QSize

        from workbench.widgets.look.action_button import ActionButton
        from workbench.widgets.look.icons import set_icon

        for action, name in actions:
            set_icon(action, name)
            button = ActionButton(action, self)
            button.setIconSize(QSize(20, 20))
            self._row.addWidget(button)
            self._commands.append(button)
        self._fold()

    @property
    def folded(self) -> bool:
        """Whether the workspaces are a drop-down now."""
        return self._folded is not None and not self._folded.isHidden()

    def minimumSizeHint(self) -> QSize:
        return super().minimumSizeHint() * 0  # narrower than its tabs: they fold

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fold()

    def _choose(self, slug: str, _checked: bool = False) -> None:
        self.show_current(self._current)  # a press does not mark; arriving does
        self.chosen.emit(slug)

    def _fold(self) -> None:
        needed = sum(button.sizeHint().width() for button in (*self._tabs.values(), *self._commands)) + 24
        narrow = needed > self.width()
        if narrow and self._folded is None:
            self._make_folded()
        if self._folded is not None:
            self._folded.setVisible(narrow)
            for tab in self._tabs.values():
                tab.setVisible(not narrow)

    def _make_folded(self) -> None:
        from PySide6.QtWidgets import QMenu

        self._folded = QToolButton(self)
        self._folded.setObjectName("workspaceTab")
        self._folded.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self._folded.setToolTip(_("Change the workspace"))
        menu = QMenu(self._folded)
        for slug, title, _tooltip in self._places:
            menu.addAction(title).triggered.connect(partial(self._choose, slug))
        self._folded.setMenu(menu)
        self._row.insertWidget(0, self._folded)
        self._name_folded()

    def _name_folded(self) -> None:
        if self._folded is not None:
            title = next(
                (title for slug, title, _tip in self._places if slug == self._current), _("Workspaces")
            )
            self._folded.setText(title + "  \u25be")
            self._folded.setAccessibleName(_("Workspace: {title}").format(title=title))
