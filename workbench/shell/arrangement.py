"""The docks of the workspaces: made from panels, arranged, remembered with a version, and put back.

A dock that several workspaces have, such as the tube, is one dock, which each of them puts where it wants it.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

from PySide6.QtCore import QByteArray, Qt
from PySide6.QtWidgets import QDockWidget, QMainWindow, QTabWidget, QWidget

from workbench.language import _
from workbench.shell.dock_tabs import DockTabs
from workbench.shell.settings import Settings

VERSION = 2
_LOW_PX, _HIGH_PX = 600, 860
_SIDE_SHARE = 0.36
_SHARES = (0.58, 0.42)
_AREAS = {
    "left": Qt.DockWidgetArea.LeftDockWidgetArea,
    "right": Qt.DockWidgetArea.RightDockWidgetArea,
    "top": Qt.DockWidgetArea.TopDockWidgetArea,
    "bottom": Qt.DockWidgetArea.BottomDockWidgetArea,
}

DockPart = tuple[str, str, QWidget, str | Qt.DockWidgetArea]


@dataclass
class _Set:
    """The docks of one workspace, with the area each belongs in at first."""

    docks: list[QDockWidget] = field(default_factory=list)
    areas: dict[str, Qt.DockWidgetArea] = field(default_factory=dict)
    lower: tuple[str, ...] = ()


class Arrangements:
    """Shows the docks of one workspace at a time on ``window``, as they were left."""

    def __init__(self, window: QMainWindow, settings: Settings) -> None:
        self._window = window
        self._settings = settings
        self._sets: dict[str, _Set] = {}
        self._docks: dict[str, QDockWidget] = {}
        self.current = ""
        self.tabs = DockTabs(window, lambda: self.docks(self.current))
        window.setDockOptions(
            QMainWindow.DockOption.AllowTabbedDocks
            | QMainWindow.DockOption.AllowNestedDocks
            | QMainWindow.DockOption.GroupedDragging
        )
        window.setTabPosition(Qt.DockWidgetArea.AllDockWidgetAreas, QTabWidget.TabPosition.North)

    def add(self, workspace: str, parts: Sequence[DockPart], lower: Sequence[str] = ()) -> None:
        """Give a workspace the docks of a panel's parts, hidden until it is shown; they are made once.

        Those named in ``lower`` begin in the lower half of the right side, the others where their part says.
        """
        held = self._sets.setdefault(workspace, _Set())
        held.lower = tuple(lower)
        for name, title, widget, area in parts:
            where = _AREAS["right"] if name in lower else _AREAS[area] if isinstance(area, str) else area
            if name not in self._docks:
                self._docks[name] = self._make(name, title, widget, where)
            held.docks.append(self._docks[name])
            held.areas[name] = where

    def _make(self, name: str, title: str, widget: QWidget, where: Qt.DockWidgetArea) -> QDockWidget:
        dock = QDockWidget(title, self._window)
        dock.setObjectName(name)
        dock.setWidget(widget)
        dock.toggleViewAction().setToolTip(_("Show or hide {title}").format(title=title))
        self.tabs.follow(dock)
        self._window.addDockWidget(where, dock)
        dock.hide()
        return dock

    def has(self, workspace: str) -> bool:
        """Whether the docks of a workspace were made."""
        return workspace in self._sets

    def docks(self, workspace: str) -> list[QDockWidget]:
        """The docks of a workspace, in the order of its panels."""
        return list(self._sets[workspace].docks) if workspace in self._sets else []

    def bring_forward(self, name: str) -> None:
        """Bring a dock before those that it shares its place with."""
        self._docks[name].raise_()

    def show(self, workspace: str) -> bool:
        """Show the docks of one workspace; False when what was remembered could not be used."""
        self.leave()
        self.current = workspace
        if workspace not in self._sets:
            return True
        kept = self._settings.arrangement(workspace)
        if kept is None:
            self.reset()
            return True
        if self._restored(kept):
            return True
        self._settings.forget_arrangement(workspace)
        self.reset()
        return False

    def leave(self) -> None:
        """Remember the present arrangement and hide its docks."""
        if self.current in self._sets:
            self._settings.keep_arrangement(self.current, self._window.saveState(VERSION))
            for dock in self._sets[self.current].docks:
                dock.hide()
        self.current = ""

    def reset(self) -> None:
        """Put the docks of the current workspace where they were at first."""
        held = self._sets.get(self.current)
        if held is None:
            return
        for dock in held.docks:
            dock.setFloating(False)
            self._window.removeDockWidget(dock)
        by_area: dict[Qt.DockWidgetArea, list[QDockWidget]] = {}
        for dock in held.docks:
            by_area.setdefault(held.areas[dock.objectName()], []).append(dock)
        for area, docks in by_area.items():
            self._place(area, docks, held.lower)

    def _place(self, area: Qt.DockWidgetArea, docks: list[QDockWidget], below: Sequence[str]) -> None:
        """Put docks where they begin.

        A side column is one group of tabs in a very low window, two in a low one, all stacked in a high one.
        """
        window, sideways = self._window, area in (_AREAS["left"], _AREAS["right"])
        along = Qt.Orientation.Vertical if sideways else Qt.Orientation.Horizontal
        upper = [dock for dock in docks if dock.objectName() not in below]
        lower = sorted(
            (dock for dock in docks if dock not in upper), key=lambda d: below.index(d.objectName())
        )
        for dock in (*upper, *lower):
            window.addDockWidget(area, dock, along)
            dock.show()
        groups = [group for group in (upper, lower) if group]
        if window.height() < _LOW_PX:
            groups = [[*upper, *lower]]
        if sideways and window.height() < _HIGH_PX:
            for group in groups:
                for dock in group[1:]:
                    window.tabifyDockWidget(group[0], dock)
                group[0].raise_()
            if len(groups) == 2:
                shares = [round(window.height() * share) for share in _SHARES]
                window.resizeDocks([group[0] for group in groups], shares, along)
        if sideways:
            shown = [group[0] for group in groups]
            window.resizeDocks(
                shown, [round(window.width() * _SIDE_SHARE)] * len(shown), Qt.Orientation.Horizontal
            )

    def _restored(self, kept: QByteArray) -> bool:
        """Take a remembered arrangement; it is bad when Qt refuses it or another workspace's docks show."""
        if not self._window.restoreState(kept, VERSION):
            return False
        mine = self.docks(self.current)
        for dock in self._docks.values():
            if dock not in mine:
                dock.hide()
        return True
