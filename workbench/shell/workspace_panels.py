"""The panels of the workspaces, made step by step where one is first wanted; several may share one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from workbench.shell.workspaces import join, panel_class

if TYPE_CHECKING:
    from collections.abc import Iterator

    from workbench.panels.panel import Panel
    from workbench.shell.window import MainWindow


class WorkspacePanels:
    """Those of ``window``, which must have its session before any is made."""

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self._ready: dict[str, list[Panel]] = {}
        self._by_name: dict[str, Panel] = {}
        self._makers: dict[str, Iterator[None]] = {}

    def of(self, slug: str) -> list[Panel]:
        """The panels of a workspace, empty before all of them are there."""
        return list(self._ready.get(slug, []))

    def prepare(self, slug: str) -> Iterator[None]:
        """Make the panels of a workspace step by step; who asks later goes on where the first stopped."""
        if slug not in self._ready:
            yield from self._makers.setdefault(slug, self._make(slug))

    def _make(self, slug: str) -> Iterator[None]:
        window = self._window
        workspace = window.workspace(slug)
        for name in workspace.panels:
            if name not in self._by_name:
                panel = yield from panel_class(name).making(window.session)
                self._take(self._by_name.setdefault(name, panel))
                yield
        panels = [self._by_name[name] for name in workspace.panels]
        docks = [dock for each in panels for dock in each.docks()]
        yield from window.arrangements.add(slug, panels[0].center, docks, workspace.lower)
        yield
        join(panels)
        self._ready[slug] = panels

    def _take(self, panel: Panel) -> None:
        """Let a new panel's commands, step bar and words be the window's."""
        for action in panel.actions():
            self._window.addAction(action)
        if panel.step_bar is not None:
            self._window.steps.addWidget(panel.step_bar)
        self._window.status.listen(panel)
