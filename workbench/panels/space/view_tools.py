"""The tools beside the pictures of a scene: what is shown, zoom, and from where it is looked at."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple, Protocol

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QFrame, QMenu, QToolButton, QVBoxLayout, QWidget

from workbench.language import _
from workbench.widgets.look.action_button import SIDE_PX, ActionButton
from workbench.widgets.look.icons import set_icon

_BAR_PX = 44


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


class Viewing(Protocol):
    """What the tools ask of a page."""

    def show_beside(self, which: str) -> None:
        """Show "both" views, the "eye" or the "outside" alone."""

    def next_shows(self) -> None:
        """From faces and edges to edges, to edges without hidden lines, to faces, and back."""

    def next_mode(self) -> None:
        """Handles to move, to turn, to scale, or none."""

    def zoom(self, factor: float) -> None:
        """Show the view with the focus larger."""

    def fit(self) -> None:
        """Show all of the scene."""

    def go_home(self) -> None:
        """Back to the view of the document."""

    def face(self, side: str) -> None:
        """Stand before a side."""

    def glance(self, slug: str) -> None:
        """See the scene by another projection."""

    def switch(self) -> None:
        """Exchange perspective and parallel."""

    def switch_trackball(self) -> None:
        """Turn freely, or on a turntable."""

    def switch_z(self) -> None:
        """Let z of the view coordinates point to the eye, or into the picture."""

    def keep(self) -> None:
        """Write the view into the document."""


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
        self.look_from = self._added(column, QToolButton())
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
                self._added(column, ActionButton(action, name=tool.title))
            else:
                self.menu.addAction(action)
        column.addStretch(1)

    def add_named_views(self, commands: Sequence[QAction], views: QMenu) -> None:
        """Put what can be done with named views, and a menu of them, below the other ways to look."""
        self.menu.addSeparator()
        self.menu.addMenu(views)
        self.menu.addActions(list(commands))
        self.actions_by_name.update((action.objectName().partition(".")[2], action) for action in commands)

    @staticmethod
    def _added(column: QVBoxLayout, button: QToolButton) -> QToolButton:
        button.setFixedSize(SIDE_PX, SIDE_PX)
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


def tools_of(page: "Viewing") -> list[Tool]:
    """What a page with a picture and an outside view offers, in order."""
    sides = (
        ("front", _("Look from the front"), "(1)"),
        ("back", _("Look from the back"), "(Ctrl+1)"),
        ("right", _("Look from the right"), "(3)"),
        ("left", _("Look from the left"), "(Ctrl+3)"),
        ("top", _("Look from above"), "(7)"),
        ("bottom", _("Look from below"), "(Ctrl+7)"),
    )
    return [
        Tool("both", _("Picture and outside view"), "columns", "", partial(page.show_beside, "both")),
        Tool("picture", _("The picture alone"), "image", "", partial(page.show_beside, "eye")),
        Tool("outside", _("The outside view alone"), "cube", "", partial(page.show_beside, "outside")),
        Tool(
            "faces",
            _("Faces and edges, all edges, edges without hidden lines, or faces"),
            "circle-half",
            "",
            page.next_shows,
        ),
        Tool(
            "handles",
            _("Handles of the object: move, turn, scale"),
            "arrows-out-cardinal",
            "",
            page.next_mode,
        ),
        Tool("zoom_in", _("Zoom in"), "magnifying-glass-plus", "Ctrl++", partial(page.zoom, 1.25)),
        Tool("zoom_out", _("Zoom out"), "magnifying-glass-minus", "Ctrl+-", partial(page.zoom, 0.8)),
        Tool("fit", _("Fit the scene"), "frame-corners", "Ctrl+0", page.fit),
        Tool("home", _("Back to the view of the document"), "house-simple", "", page.go_home),
        *(Tool(side, title, "", key, partial(page.face, side)) for side, title, key in sides),
        Tool("isometric", _("Look from (1, 1, 1), isometric"), "", "", partial(page.glance, "isometric")),
        Tool("switch", _("Perspective or parallel"), "", "(5)", page.switch),
        Tool("trackball", _("Rotate freely, like a trackball"), "", "", page.switch_trackball, False),
        Tool("z_towards_eye", _("z towards the eye, as in the book"), "", "", page.switch_z, False),
        Tool("keep", _("Keep this view"), "", "", page.keep),
    ]
