"""Has the readings that a workspace needs compiled meanwhile, and says in the status bar how far that is."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from workbench.language import _
from workbench.paths import CACHE, cache_folder
from workbench.session.answers import Answers

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from workbench.engine.background import Thread
    from workbench.engine.warm import Progress
    from workbench.engine.warm import Warming as Child
    from workbench.shell.window import MainWindow


_MODULES = {"scanning": ("workbench.display.face_kernels",)}
"""By topic, where there are compiled texts beside those of the entries."""


class Warming(QObject):
    """One child process at a time, followed by a thread; the interface only takes what they report."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._asked: set[str] = set()
        self._waiting: list[str] = []
        self._followed: _Followed | None = None
        self._thread: Thread | None = None
        self._stopped = False
        self._answers = Answers(self)
        self._answers.arrived.connect(self._take)

    @property
    def busy(self) -> bool:
        """Whether anything is being prepared."""
        return self._followed is not None

    def prepare(self, workspace: str) -> None:
        """Prepare the algorithms of a workspace, once."""
        topics = self._window.workspace(workspace).topics
        if workspace in self._asked or not topics:
            return
        self._asked.add(workspace)
        self._waiting += topics
        self._next()

    def stop(self) -> None:
        """End what is still running; what is finished is kept."""
        self._stopped = True
        if self._followed is not None:
            self._followed.stop()
        if self._thread is not None:
            self._thread.end()

    def _next(self) -> None:
        if self._followed is None and self._waiting and not self._stopped:
            topics, self._waiting = self._waiting, []
            self._followed = _Followed(topics)
            work = partial(self._followed.work, self._answers.tell)
            self._thread = self._answers.ask(work, "warming", self._followed.stop)

    def _take(self, told: Progress | tuple[str, str]) -> None:
        if isinstance(told, tuple):
            self._followed = None
            self._window.status.preparing(*told)
            self._next()
        else:
            text = _("Preparing algorithm {done} of {total}").format(done=told.done, total=told.total)
            self._window.status.preparing(text)


class _Followed:
    """A child process that prepares topics. Of Qt it knows nothing."""

    def __init__(self, topics: Sequence[str]) -> None:
        self._topics = topics
        self._child: Child | None = None
        self._stopped = False

    def stop(self) -> None:
        """End it; from any thread."""
        self._stopped = True
        if self._child is not None:
            self._child.stop()

    def work(self, tell: Callable[[Progress], None]) -> tuple[str, str]:
        """Prepare, telling how far that is; what ``readiness`` says then, whatever happened."""
        from workbench.engine.background import report

        try:
            self._compile(tell)
        except Exception:
            report()
        return readiness()

    def _compile(self, tell: Callable[[Progress], None]) -> None:
        from workbench.algorithms import catalogue
        from workbench.engine import compiled
        from workbench.engine.warm import Warming as Child
        from workbench.engine.warm import load, load_module

        if not self._stopped and compiled.available():
            slugs = [entry.slug for entry in catalogue.entries() if entry.topic in self._topics]
            modules = [module for topic in self._topics for module in _MODULES.get(topic, ())]

            def told(progress: Progress) -> None:
                if progress.slug in modules:
                    load_module(progress.slug, lambda: self._stopped)
                tell(progress)

            # What was compiled before is at hand first: only then is it asked what was not.
            for module in modules:
                load_module(module, lambda: self._stopped)
            for slug in slugs:
                load(slug, lambda: self._stopped)
            self._child = Child(slugs, modules=modules)
            if self._stopped:
                self._child.stop()
            else:
                self._child.follow(told)
            for slug in slugs:
                load(slug, lambda: self._stopped)


def readiness() -> tuple[str, str]:
    """What the status bar says once everything is prepared that can be, "" when all is well; and why."""
    from workbench.engine import compiled, kernel_files

    if not compiled.available():
        return _("Running without the compiler: large pictures take longer."), ""
    room = kernel_files.room()
    if not room.reason:
        return "", ""
    why = _(
        "The cache folder {folder} is not used ({reason}): make it writable, for you alone, or name another "
        "one in {variable}."
    ).format(folder=cache_folder(), reason=room.reason, variable=CACHE)
    if room.folder is None:
        return _("Compiled algorithms cannot be kept: large pictures take longer."), why
    return _("Compiled algorithms are kept only until you quit."), why
