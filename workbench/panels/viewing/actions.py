"""The commands of View: its tools, the zoom as changes of the window, copying."""

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QFrame, QVBoxLayout

from workbench.language import _
from workbench.panels.stage.actions import PanelCommand
from workbench.panels.viewing.gestures import tools
from workbench.widgets.look.action_button import ActionButton
from workbench.widgets.look.icons import set_icon

if TYPE_CHECKING:
    from workbench.panels.viewing.panel import ViewingPanel


def view_actions(panel: "ViewingPanel", bar: QFrame) -> dict[str, QAction]:
    """The actions of ``panel`` by name; tools and zoom have buttons in ``bar``."""
    column = QVBoxLayout(bar)
    column.setContentsMargins(6, 8, 6, 8)
    column.setSpacing(4)
    made: dict[str, QAction] = {}
    for tool in tools():
        choose = partial(panel.choose_tool, tool.name)
        action = made[tool.name] = _action(panel, (tool.name, tool.title, tool.icon, tool.key, choose))
        action.setCheckable(True)
        action.setToolTip(f"{tool.tip} ({tool.key})")
        column.addWidget(ActionButton(action))
    column.addStretch(1)
    zooms: tuple[PanelCommand, ...] = (
        ("zoom_in", _("Zoom in: a smaller window"), "magnifying-glass-plus", "Ctrl++", lambda: panel.zoom(1)),
        (
            "zoom_out",
            _("Zoom out: a larger window"),
            "magnifying-glass-minus",
            "Ctrl+-",
            lambda: panel.zoom(-1),
        ),
        ("fit", _("A window around everything"), "frame-corners", "Ctrl+0", panel.fit),
    )
    for command in zooms:
        made[command[0]] = _action(panel, command)
        column.addWidget(ActionButton(made[command[0]]))
    made["copy_picture"] = _action(
        panel, ("copy_picture", _("Copy picture"), "clipboard", "Ctrl+Shift+C", panel.copy)
    )
    return made


def _action(panel: "ViewingPanel", row: PanelCommand) -> QAction:
    name, text, picture, key, do = row
    action = QAction(text, panel)
    action.setObjectName(f"{panel.slug}.{name}")
    action.setShortcut(QKeySequence(key))
    action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
    action.setToolTip(f"{text} ({action.shortcut().toString()})")
    action.triggered.connect(lambda _checked=False: do())
    set_icon(action, picture)
    panel.addAction(action)
    return action
