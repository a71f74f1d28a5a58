"""Unsaved work outlives a crash: a recovery file per session, written behind its back, and a lock beside it.

The lock is held by the operating system for as long as the process lives, so that a file whose lock is free
belongs to nobody any more and can be offered. No Qt here.
"""

import os
import re
import secrets
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from workbench.document.errors import DocumentError
from workbench.document.files import Stored, read, write
from workbench.document.saving import sweep
from workbench.language import _
from workbench.paths import recovery_folder, try_writing

# A write starts this long after the first change that is not yet written, so that with the time of the write
# itself the file is at most five seconds behind.
DELAY_S = 2.0

_DOCUMENT = ".gwb"
_LOCK = ".lock"
_STEM = re.compile(r"[0-9]+-[0-9a-f]{8}")


@dataclass(frozen=True, slots=True)
class Recoverable:
    """Work that a dead process left: its recovery file, the file it came from if any, when it was kept."""

    path: Path
    origin: Path | None
    name: str
    kept_at: float

    def read(self) -> Stored:
        """What was kept; raises DocumentError."""
        return read(self.path)

    def discard(self) -> None:
        """Forget this work."""
        for ending in (_DOCUMENT, _LOCK):
            with suppress(OSError):
                self.path.with_suffix(ending).unlink()


class RecoveryFile:
    """The recovery file of one session, written on a thread of its own from frozen values.

    ``keep`` costs its caller nothing but a lock. ``failed`` is called on the writing thread with the sentence
    when a write fails; the next change tries again.
    """

    def __init__(
        self,
        folder: Path | None = None,
        delay_s: float = DELAY_S,
        failed: Callable[[str], None] = lambda sentence: None,
    ) -> None:
        folder = recovery_folder() if folder is None else folder
        try_writing(folder)
        sweep(folder)
        self.path, self._lock_file = _fresh(folder)
        self._delay_s = delay_s
        self._failed = failed
        self._state = threading.Condition()
        self._wanted: Stored | None = None
        self._changed = False
        self._hurry = False
        self._closing = False
        self._idle = True
        self._thread = threading.Thread(target=self._work, name="recovery", daemon=True)
        self._thread.start()

    def keep(self, stored: Stored | None) -> None:
        """Write ``stored`` soon; None when there is nothing unsaved any more, and the file is removed."""
        with self._state:
            self._wanted = stored
            self._changed = True
            self._idle = False
            self._state.notify_all()

    def flush(self) -> None:
        """Write now what is waiting, and come back when it is done."""
        with self._state:
            self._hurry = True
            self._state.notify_all()
            self._state.wait_for(lambda: self._idle or not self._thread.is_alive())
            self._hurry = False

    def close(self) -> None:
        """End cleanly: the recovery file and its lock are removed."""
        with self._state:
            self._closing = True
            self._state.notify_all()
        self._thread.join()
        _remove(self.path)
        os.close(self._lock_file)
        _remove(self.path.with_suffix(_LOCK))

    def _work(self) -> None:
        while True:
            with self._state:
                self._state.wait_for(lambda: self._changed or self._closing)
                self._state.wait_for(lambda: self._hurry or self._closing, self._delay_s)
                if self._closing:
                    return
                wanted, self._changed = self._wanted, False
            self._write(wanted)
            with self._state:
                self._idle = not self._changed
                self._state.notify_all()

    def _write(self, wanted: Stored | None) -> None:
        try:
            if wanted is None:
                _remove(self.path)
            else:
                write(wanted, self.path)
        except DocumentError as error:
            self._failed(_("Unsaved work could not be kept safe: {reason}").format(reason=error))


def recoverable(folder: Path | None = None) -> list[Recoverable]:
    """The work that dead processes left, newest first. What nothing was kept of is cleared away."""
    folder = recovery_folder() if folder is None else folder
    found: list[Recoverable] = []
    if not os.path.isdir(folder) or not os.access(folder, os.R_OK | os.W_OK | os.X_OK):
        return found
    sweep(folder)
    files = [file for ending in (_DOCUMENT, _LOCK) for file in folder.glob(f"*{ending}")]
    stems = {file.stem for file in files if _STEM.fullmatch(file.stem)}
    for lock in (folder / (stem + _LOCK) for stem in sorted(stems)):
        try:
            descriptor = _locked(lock)
        except OSError:
            continue  # its process lives
        try:
            path = lock.with_suffix(_DOCUMENT)
            if path.exists():
                found.append(_described(path))
            else:
                _remove(lock)
        finally:
            os.close(descriptor)
    return sorted(found, key=lambda work: -work.kept_at)


def _described(path: Path) -> Recoverable:
    kept_at = path.stat().st_mtime
    try:
        stored = read(path)
    except DocumentError:
        return Recoverable(path, None, _("Damaged"), kept_at)
    origin = Path(stored.origin) if stored.origin else None
    return Recoverable(path, origin, origin.name if origin else stored.document.sheets[0].name, kept_at)


def _fresh(folder: Path) -> tuple[Path, int]:
    """A new recovery file's path, and a descriptor that holds its lock."""
    while True:
        path = folder / f"{os.getpid()}-{secrets.token_hex(4)}{_DOCUMENT}"
        lock = path.with_suffix(_LOCK)
        try:
            descriptor = _locked(lock)
        except OSError:
            if lock.exists():
                continue  # another process took it for a dead one's, between its making and its locking
            raise
        if lock.exists():
            return path, descriptor
        os.close(descriptor)


def _remove(path: Path) -> None:
    with suppress(FileNotFoundError):
        path.unlink()


if sys.platform == "win32":
    import msvcrt

    def _locked(path: Path) -> int:
        """A descriptor of ``path`` that holds its lock; raises OSError when another process holds it."""
        descriptor = os.open(path, os.O_RDWR | os.O_CREAT)
        try:
            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        except OSError:
            os.close(descriptor)
            raise
        return descriptor

else:
    import fcntl

    def _locked(path: Path) -> int:
        """A descriptor of ``path`` that holds its lock; raises OSError when another process holds it."""
        descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            os.close(descriptor)
            raise
        return descriptor
