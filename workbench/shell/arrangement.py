"""The docking areas of the workspaces: made, shown one at a time, remembered, and put back."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from PySide6.QtWidgets import QDockWidget, QStackedWidget, QWidget

from workbench.panels.panel import DockPart
from workbench.shell.dock_area import DockArea
from workbench.shell.reading import Reading
from workbench.shell.settings import Settings
from workbench.widgets.look.split import reset_splits


@dataclass
class _Workspace:
    """What the area of a workspace is made of, and the area; ``arranged`` once its docks have a place."""

    middle: QWidget
    parts: Sequence[DockPart]
    lower: Sequence[str]
    area: DockArea
    arranged: bool = False

    def new_area(self) -> DockArea:
        """An area in place of the one that is there: Qt arranges docks well only once."""
        self.area = DockArea(self.middle, self.lower)
        for part in self.parts:
            self.area.add(part)
        self.arranged = False
        return self.area


class Arrangements:
    """The areas on ``stack``, of which it shows one at a time, as it was left."""

    def __init__(self, stack: QStackedWidget, settings: Settings) -> None:
        self._stack = stack
        self._settings = settings
        self._workspaces: dict[str, _Workspace] = {}
        self._page: Reading | None = None
        self.current = ""

    def add(
        self, slug: str, middle: QWidget, parts: Sequence[DockPart], lower: Sequence[str] = ()
    ) -> Iterator[None]:
        """Make the area of a workspace, a dock in each step; it stays hidden until it is shown.

        Everything in it takes the style of the window as it comes in, which would be long all at once.
        """
        area = DockArea(middle, lower)
        self._stack.addWidget(area)
        for part in parts:
            yield
            area.add(part)
        self._workspaces[slug] = _Workspace(middle, parts, lower, area)

    def area(self, slug: str) -> DockArea | None:
        """The area of a workspace, once it was made."""
        return self._workspaces[slug].area if slug in self._workspaces else None

    def docks(self, slug: str) -> list[QDockWidget]:
        """The docks of a workspace, in the order of its panels."""
        return list(self._workspaces[slug].area.docks) if slug in self._workspaces else []

    def bring_forward(self, name: str) -> None:
        """Show a dock of the current workspace, if it has it, before those that it shares its place with."""
        self.stop_reading()
        area = self._workspaces[self.current].area
        if name in {dock.objectName() for dock in area.docks}:
            area.bring_forward(name)

    # Reading

    @property
    def reading(self) -> bool:
        """Whether source and tables have half of the window."""
        return self._page is not None

    def read(self) -> None:
        """Give source and tables half of the window, in place of the docks, which stay as they are."""
        if self._page is None:
            area = self._workspaces[self.current].area
            focus = self._stack.window().focusWidget()
            self._page = area.read()
            self._page.ended.connect(self.stop_reading)
            self._stack.addWidget(self._page)
            self._stack.setCurrentWidget(self._page)
            if focus is not None and self._page.isAncestorOf(focus) and focus.isVisibleTo(self._page):
                focus.setFocus()
            else:
                area.host.setFocus()

    def stop_reading(self) -> None:
        """Bring the docks back; nothing happens where nothing is read."""
        if self._page is None:
            return
        page, self._page = self._page, None
        area = self._workspaces[self.current].area
        self._stack.setUpdatesEnabled(False)
        try:
            self._stack.setCurrentWidget(area)
            area.stop_reading()
        finally:
            self._stack.setUpdatesEnabled(True)
        self._stack.removeWidget(page)
        page.deleteLater()

    def show(self, slug: str) -> bool:
        """Show the area of a workspace; False when what was remembered could not be used."""
        self.leave()
        self.current = slug
        workspace = self._workspaces[slug]
        self._stack.setUpdatesEnabled(False)
        try:
            usable = workspace.arranged or self._arrange(workspace)
            workspace.area.gather()
            self._stack.setCurrentWidget(workspace.area)
            workspace.area.wake()
        finally:
            self._stack.setUpdatesEnabled(True)
        return usable

    def leave(self) -> None:
        """Remember the present arrangement, and let its area rest."""
        if self.current:
            area = self._workspaces[self.current].area
            self.stop_reading()
            self._settings.keep_arrangement(self.current, area.arrangement)
            area.rest()
        self.current = ""

    def reset(self) -> None:
        """Put the docks of the current workspace, and the lines between parts, where they were at first."""
        slug = self.current
        if not slug:
            return
        reset_splits(self._workspaces[slug].area)
        self.leave()
        self._settings.forget_arrangement(slug)
        self._renew(self._workspaces[slug])
        self.show(slug)

    def _arrange(self, workspace: _Workspace) -> bool:
        """Give the docks of a new area their places; False when those remembered could not be used."""
        kept = self._settings.arrangement(self.current)
        workspace.area.resize(self._stack.size())  # it is not on the screen yet: nothing is laid out twice
        usable = kept is None or workspace.area.restore(kept)
        if not usable:
            self._settings.forget_arrangement(self.current)
            self._renew(workspace)
        if kept is None or not usable:
            workspace.area.place(self._stack.window().height())
        workspace.area.tabs.refresh()  # or docks would lose their titles, and be laid out anew, once seen
        workspace.arranged = True
        return usable

    def _renew(self, workspace: _Workspace) -> None:
        old = workspace.area
        area = workspace.new_area()
        self._stack.addWidget(area)
        area.gather()
        self._stack.setCurrentWidget(area)
        self._stack.removeWidget(old)
        old.deleteLater()
