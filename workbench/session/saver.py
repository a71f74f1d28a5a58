"""Writes the file of a session behind its back, since a disk may take its time."""

import threading
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QObject, Qt, Signal

from workbench.document.errors import DocumentError
from workbench.document.storage.files import Stored, write
from workbench.engine.turns import short_turns
from workbench.language import _
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
    _written = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._thread: threading.Thread | None = None
        self._outcome: Saved | None = None
        self._written.connect(self._deliver, Qt.ConnectionType.QueuedConnection)

    @property
    def busy(self) -> bool:
        """Whether a write is under way, or its end not yet told."""
        return self._thread is not None or self._outcome is not None

    def start(self, stored: Stored, path: Path) -> None:
        """Write ``stored``; what was begun before is waited for."""
        self.wait()
        # No daemon: the process does not end in the middle of it.
        thread = threading.Thread(target=self._write, args=(stored, path), name="save")
        try:
            thread.start()
        except RuntimeError:  # the system gives no more threads; this one will do
            self._write(stored, path)
        else:
            self._thread = thread

    def wait(self) -> None:
        """Come back when nothing is being written, and its end was told."""
        if self._thread is not None:
            self._thread.join()
        self._deliver()

    def _write(self, stored: Stored, path: Path) -> None:
        problem = _("Something in the program failed; save under another name.")
        try:
            with short_turns:
                write(stored, path)
            problem = ""
        except DocumentError as error:
            problem = str(error)
        finally:  # whatever it was, its end is told
            self._outcome = Saved(stored, path, None if problem else stamp(path), problem)
            with suppress(RuntimeError):  # nobody is there any more
                self._written.emit()

    def _deliver(self) -> None:
        outcome, self._outcome = self._outcome, None
        if outcome is not None:
            if self._thread is not None:
                self._thread.join()
                self._thread = None
            self.saved.emit(outcome)
