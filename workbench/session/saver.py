"""Writes the file of a session behind its back, since a disk may take its time."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from workbench.document.errors import DocumentError
from workbench.document.storage.files import Stored, write
from workbench.engine.background import Thread, report
from workbench.engine.turns import short_turns
from workbench.language import _
from workbench.session.answers import Answers
from workbench.session.stamps import Stamp, stamp


@dataclass(frozen=True, slots=True)
class Saved:
    """How a save ended: what was written where, and ``problem``, a sentence, when it was not."""

    stored: Stored
    path: Path
    stamp: Stamp | None
    problem: str = ""


class Saver(QObject):
    """One write at a time. ``saved(Saved)`` comes on the thread this lives on."""

    saved = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._write: _Write | None = None
        self._thread: Thread | None = None
        self._answers = Answers(self)
        self._answers.arrived.connect(self._deliver)

    @property
    def busy(self) -> bool:
        """Whether a write is under way, or its end not yet told."""
        return self._write is not None

    def start(self, stored: Stored, path: Path) -> None:
        """Write ``stored``; what was begun before is waited for."""
        self.wait()
        self._write = _Write(stored, path)
        # No daemon: the process does not end in the middle of it.
        self._thread = self._answers.ask(self._write.work, "save", daemon=False)

    def wait(self) -> None:
        """Come back when nothing is being written, and its end was told."""
        if self._thread is not None:
            self._thread.finish()
        self._deliver(self._write)

    def _deliver(self, write: _Write | None) -> None:
        if write is None or write is not self._write:
            return  # it was waited for
        self._write = self._thread = None
        assert write.outcome is not None
        self.saved.emit(write.outcome)


class _Write:
    """One write, and how it ended."""

    def __init__(self, stored: Stored, path: Path) -> None:
        self._stored = stored
        self._path = path
        self.outcome: Saved | None = None

    def work(self) -> _Write:
        """Write; this one again, also where the program fails, which goes where failures go."""
        problem = _("Something in the program failed; save under another name.")
        try:
            with short_turns:
                write(self._stored, self._path)
            problem = ""
        except DocumentError as error:
            problem = str(error)
        except Exception:
            report()
        now = None if problem else stamp(self._path)
        self.outcome = Saved(self._stored, self._path, now, problem)
        return self
