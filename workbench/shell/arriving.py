"""Brings workspaces: their modules on a thread, then their panels, one in each turn of the event loop."""

from __future__ import annotations

from contextlib import suppress
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from workbench.language import _

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from workbench.shell.slices import Slices
    from workbench.shell.window import MainWindow
    from workbench.shell.workspaces import Workspace


class Arriving(QObject):
    """Enters a workspace as soon as its panels are made; who goes elsewhere meanwhile is not called back."""

    _imported = Signal(str)

    def __init__(self, window: MainWindow, slices: Slices) -> None:
        super().__init__(window)
        self._window = window
        self._coming: dict[str, Workspace] = {}
        self._awaited: tuple[str, str, Callable[[], object]] = "", "", lambda: None
        self._imported.connect(lambda slug: slices.add(self._make(slug)))

    def enter(self, workspace: Workspace, then: Callable[[], object]) -> None:
        """Begin to make the panels of a workspace, unless that is under way; show it and do ``then``."""
        slug = workspace.slug
        self._awaited = slug, self._window.place, then
        if slug in self._coming:
            return
        from workbench.engine.background import thread

        self._coming[slug] = workspace
        self._window.bar.set_waiting(slug, True)
        self._window.say_status(_("Preparing {title}").format(title=workspace.title))
        try:
            thread(partial(self._import, workspace), "imports").start()
        except RuntimeError:  # the system gives no more threads now
            self._imported.emit(slug)

    def _import(self, workspace: Workspace) -> None:
        with suppress(Exception):  # the same failure is said where the panel is made
            for module in workspace.modules:
                import_module(module)
        self._imported.emit(workspace.slug)

    def _make(self, slug: str) -> Iterator[None]:
        try:
            yield from self._window.prepare(slug)
        finally:
            del self._coming[slug]
            self._window.bar.set_waiting(slug, False)
        awaited, place, then = self._awaited
        if (slug, self._window.place) == (awaited, place):
            self._window.enter(slug, then)
