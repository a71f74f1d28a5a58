"""Has the readings that a workspace needs compiled meanwhile, and says in the status bar how far that is."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from workbench.language import _
from workbench.paths import CACHE, cache_folder

if TYPE_CHECKING:
    from collections.abc import Sequence

    from workbench.engine.warm import Progress
    from workbench.engine.warm import Warming as Child
    from workbench.shell.window import MainWindow


class Warming(QObject):
    """One child process at a time, followed by a thread; the interface only reads what they report."""

    _progressed = Signal(int, int)
    _ended = Signal(str, str)

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._asked: set[str] = set()
        self._waiting: list[str] = []
        self._thread: threading.Thread | None = None
        self._child: Child | None = None
        self._stopped = False
        self._progressed.connect(self._tell)
        self._ended.connect(self._end)

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
        if self._child is not None:
            self._child.stop()
        if self._thread is not None:
            self._thread.join()

    def _next(self) -> None:
        if self._thread is None and self._waiting and not self._stopped:
            topics, self._waiting = self._waiting, []
            thread = threading.Thread(target=self._work, args=(topics,), name="warming", daemon=True)
            try:
                thread.start()
            except RuntimeError:  # the system gives no more threads now
                self._waiting = topics
            else:
                self._thread = thread

    def _work(self, topics: Sequence[str]) -> None:
        try:
            self._compile(topics)
        finally:  # whatever happens, what waits has its turn
            self._ended.emit(*readiness())

    def _compile(self, topics: Sequence[str]) -> None:
        from workbench.algorithms import catalogue
        from workbench.engine import compiled
        from workbench.engine.warm import Warming as Child
        from workbench.engine.warm import load

        if not self._stopped and compiled.available():
            slugs = [entry.slug for entry in catalogue.entries() if entry.topic in topics]
            self._child = Child(slugs)
            if self._stopped:
                self._child.stop()
            else:
                self._child.follow(self._report)
            for slug in slugs:
                load(slug, lambda: self._stopped)

    def _report(self, progress: Progress) -> None:
        self._progressed.emit(progress.done, progress.total)

    def _tell(self, done: int, total: int) -> None:
        self._window.status.preparing(
            _("Preparing algorithm {done} of {total}").format(done=done, total=total)
        )

    def _end(self, text: str, reason: str) -> None:
        if self._thread is not None:
            self._thread.join()
        self._thread, self._child = None, None
        self._window.status.preparing(text, reason)
        self._next()


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
        return _("Nothing compiled can be kept: large pictures take longer."), why
    return _("What is compiled is kept only until you quit."), why
