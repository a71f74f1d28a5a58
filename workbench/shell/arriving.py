"""Brings workspaces: their modules on a thread, then their panels, one in each turn of the event loop."""

from __future__ import annotations

from contextlib import suppress
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from workbench.language import _
from workbench.session.answers import Answers

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

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
        self._answers = Answers(self)
        self._answers.arrived.connect(lambda slug: slices.add(self._make(slug)))

    def enter(self, workspace: Workspace, then: Callable[[], object]) -> None:
        """Begin to make the panels of a workspace, unless that is under way; show it and do ``then``."""
        slug = workspace.slug
        self._awaited = slug, self._window.place, then
        if slug in self._coming:
            return
        self._coming[slug] = workspace
        self._window.bar.set_waiting(slug, True)
        self._window.say_status(_("Preparing {title}").format(title=workspace.title))
        self._answers.ask(partial(_imported, slug, workspace.modules), "imports")

    def _make(self, slug: str) -> Iterator[None]:
        try:
            yield from self._window.prepare(slug)
        finally:
            del self._coming[slug]
            self._window.bar.set_waiting(slug, False)
        awaited, place, then = self._awaited
        if (slug, self._window.place) == (awaited, place):
            self._window.enter(slug, then)


def _imported(slug: str, modules: Sequence[str]) -> str:
    with suppress(Exception):  # the same failure is said where the panel is made
        for module in modules:
            import_module(module)
    return slug
