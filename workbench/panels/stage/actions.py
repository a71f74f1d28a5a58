"""The commands of a panel of figures in one table: what each is called, its icon, its key, what it does."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QRect, Qt
from PySide6.QtGui import QAction, QColor, QCursor, QIcon, QKeySequence, QPainter, QPen, QPixmap
from PySide6.QtWidgets import QMenu

from workbench.language import _
from workbench.widgets.look.icons import set_icon
from workbench.widgets.look.tokens import colour, theme_changed, tokens

if TYPE_CHECKING:
    from workbench.panels.stage.panel import FigurePanel

PanelCommand = tuple[str, str, str, str, Callable[[], object]]


class FigureActions(QObject):
    """Makes the actions of a panel: ``made`` has them by name. Commands are in the canvas's menu too, the
    ``transforms`` in a menu of their own there.
    """

    def __init__(
        self, panel: "FigurePanel", commands: Sequence[PanelCommand], transforms: Sequence[PanelCommand]
    ) -> None:
        super().__init__(panel)
        self._panel = panel
        self.made: dict[str, QAction] = {}
        for row in self._tools():
            self._add(row).setCheckable(True)
        for row in self._zooms():
            self._add(row)
        panel.canvas.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        for row in (*self._commands(), *commands):
            panel.canvas.addAction(self._add(row))
        if transforms:
            menu = QMenu(_("Transform"), panel.canvas)
            menu.addActions([self._add(row) for row in transforms])
            panel.canvas.addAction(menu.menuAction())

    def _tools(self) -> list[PanelCommand]:
        panel = self._panel
        return [(t.name, t.title, t.icon, t.key, partial(panel.choose_tool, t.name)) for t in panel.tools]

    def _zooms(self) -> list[PanelCommand]:
        canvas = self._panel.canvas
        return [
            ("zoom_in", _("Zoom in"), "magnifying-glass-plus", "Ctrl++", lambda: canvas.zoom(1)),
            ("zoom_out", _("Zoom out"), "magnifying-glass-minus", "Ctrl+-", lambda: canvas.zoom(-1)),
            ("fit", _("Fit the picture"), "frame-corners", "Ctrl+0", canvas.fit),
            ("actual", _("Cells of one pixel"), "number-square-one", "Ctrl+1", canvas.actual_size),
        ]

    def _commands(self) -> list[PanelCommand]:
        panel = self._panel
        return [
            ("why", _("Why this pixel?"), "question", "Y", panel.ask_why),
            ("delete", _("Delete"), "trash", "Del", panel.delete_selected),
            ("duplicate", _("Duplicate"), "copy", "Ctrl+D", panel.duplicate_selected),
            ("select_all", _("Select all"), "selection-all", "Ctrl+A", panel.select_all),
            ("group", _("Group"), "link-simple", "Ctrl+G", panel.group_selected),
            ("ungroup", _("Ungroup"), "link-break", "Ctrl+Shift+G", panel.ungroup_selected),
            ("forwards", _("Bring forwards"), "arrow-line-up", "Ctrl+]", panel.bring_forwards),
            ("backwards", _("Send backwards"), "arrow-line-down", "Ctrl+[", panel.send_backwards),
        ]

    def _add(self, row: PanelCommand) -> QAction:
        name, text, icon, key, do = row
        action = QAction(text, self._panel)
        action.setObjectName(f"{self._panel.slug}.{name}")
        if key:
            action.setShortcut(QKeySequence(key))
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        action.setToolTip(f"{text} ({action.shortcut().toString()})" if key else text)
        action.triggered.connect(lambda _checked=False: do())
        self.made[name] = action
        if icon == "ellipse":
            self._paint_ellipse()
            theme_changed.connect(self._paint_ellipse)
        else:
            set_icon(action, icon)
        self._panel.addAction(action)
        return action

    def _paint_ellipse(self) -> None:
        """The icon family has no ellipse; this one has its stroke."""
        pixmap = QPixmap(64, 64)
        pixmap.fill(Qt.GlobalColor.transparent)
        painter = QPainter(pixmap)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(tokens().text), 4))
        painter.drawEllipse(8, 18, 48, 28)
        painter.end()
        self.made["ellipse"].setIcon(QIcon(pixmap))


def tool_cursor(icon: QIcon) -> QCursor:
    """A cross with the tool's icon at its lower right; both with an edge that shows on any colour."""
    now, density = tokens(), 2
    pixmap = QPixmap(32 * density, 32 * density)
    pixmap.setDevicePixelRatio(density)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for ink, width in ((now.canvas, 3.0), (now.text, 1.0)):
        painter.setPen(QPen(QColor(ink), width))
        for x0, y0, x1, y1 in ((8, 1, 8, 6), (8, 10, 8, 15), (1, 8, 6, 8), (10, 8, 15, 8)):
            painter.drawLine(x0, y0, x1, y1)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour(now.raised, 220))
    painter.drawRoundedRect(14, 14, 18, 18, 4, 4)
    icon.paint(painter, QRect(16, 16, 14, 14))
    painter.end()
    return QCursor(pixmap, 8, 8)
