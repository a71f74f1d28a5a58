"""Brings workspaces: their modules, then their panels, one in each turn of the event loop."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from workbench.language import _
from workbench.shell.importing import import_each

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from workbench.shell.slices import Slices
    from workbench.shell.window import MainWindow
    from workbench.shell.workspaces import Workspace


class Arriving(QObject):
    """Enters a workspace as soon as its panels are made; who goes elsewhere meanwhile is not called back."""

    def __init__(self, window: MainWindow, slices: Slices) -> None:
        super().__init__(window)
        self._window = window
        self._coming: dict[str, Workspace] = {}
        self._awaited: tuple[str, str, Callable[[], object]] = "", "", lambda: None
        self._slices = slices

    def enter(self, workspace: Workspace, then: Callable[[], object]) -> None:
        """Begin to make the panels of a workspace, unless that is under way; show it and do ``then``."""
        slug = workspace.slug
        self._awaited = slug, self._window.place, then
        if slug in self._coming:
            return
        self._coming[slug] = workspace
        self._window.bar.set_waiting(slug, True)
        self._window.say_status(_("Preparing {title}").format(title=workspace.title))
        self._slices.add(self._make(workspace))

    def _make(self, workspace: Workspace) -> Iterator[None]:
        slug = workspace.slug
        try:
            yield from import_each(workspace.modules)
            yield from self._window.prepare(slug)
        finally:
            del self._coming[slug]
            self._window.bar.set_waiting(slug, False)
        awaited, place, then = self._awaited
        if (slug, self._window.place) == (awaited, place):
            self._window.enter(slug, then)
