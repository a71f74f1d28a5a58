"""Unsaved work outlives a crash: a recovery file per session, written behind its back, and a lock beside it.

The lock is held by the operating system for as long as the process lives, so that a file whose lock is free
belongs to nobody any more and can be offered. Blobs are files of their own beside it, each written once.
No Qt here.
"""

import os
import re
import secrets
import stat
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import msgspec
from msgspec.structs import replace

from workbench.document.errors import DocumentError
from workbench.document.storage.blobs import MAX_BLOB_BYTES
from workbench.document.storage.content import read_content
from workbench.document.storage.files import MAX_BYTES, Stored, all_blobs, read, with_blobs, write
from workbench.document.storage.saving import replace_file, sweep
from workbench.engine.background import Thread
from workbench.engine.turns import short_turns
from workbench.language import _, legible
from workbench.paths import recovery_folder, try_writing
from workbench.session.origins import path_of
from workbench.session.stamps import Stamp, stamp

# A write starts this long after the first change that is not yet written, so that with the time of the write
# itself the file is at most five seconds behind; but it rests this many times as long as the last one took.
DELAY_S = 2.0
REST = 20

_DOCUMENT = ".gwb"
_LOCK = ".lock"
_BLOB = ".blob"
_STEM = re.compile(r"[0-9]+-[0-9a-f]{8}(?=\.)")
_NO_NAME = "0-00000000.gwb"


@dataclass(frozen=True, slots=True)
class Recoverable:
    """Work that a dead process left: its recovery file, the file it came from if any, when it was kept.

    ``origin_stamp`` is the state in which that process knew its file.
    """

    path: Path
    origin: Path | None
    name: str
    kept_at: float
    origin_stamp: Stamp | None = None

    @property
    def origin_changed(self) -> bool:
        """Whether the file that it came from is another by now than the one it was made from."""
        now = None if self.origin is None else stamp(self.origin)
        if now is None:
            return False
        return now != self.origin_stamp if self.origin_stamp else now[0] / 1e9 > self.kept_at

    def read(self) -> Stored:
        """What was kept; raises DocumentError."""
        return self.completed(read(self.path))

    def completed(self, stored: Stored) -> Stored:
        """What was read of the file, with the blobs beside it; raises DocumentError."""
        beside = {path.suffixes[0][1:]: path for path in _blobs_beside(self.path)}
        blobs = dict(stored.blobs)
        for digest in stored.blobs_beside:
            if digest not in beside:
                sentence = _("A file that belongs to {path} is missing; open another copy.")
                raise DocumentError("blobs_beside", sentence.format(path=self.path))
            blobs[digest] = read_content(beside[digest], MAX_BLOB_BYTES)
        return with_blobs(stored, blobs)

    def discard(self) -> None:
        """Forget this work."""
        _discard(self.path)
        with suppress(OSError):
            _remove(self.path.with_suffix(_LOCK))


class RecoveryFile:
    """The recovery file of one session, written on a thread of its own from frozen values.

    ``keep`` costs its caller nothing but a lock. What cannot be written is tried again until it can:
    ``trouble`` is a sentence meanwhile, else "".
    """

    def __init__(self, folder: Path | None = None, delay_s: float = DELAY_S) -> None:
        self._folder = recovery_folder() if folder is None else folder
        self._delay_s = delay_s
        self.trouble = ""
        self._on_disk = False  # whether a part of what is kept may be there
        self._lock_file: int | None = None
        self.path = self._folder / _NO_NAME
        self._state = threading.Condition()
        self._wanted: Stored | None = None
        self._changes = self._kept = 0
        self._flushes = self._flushed = 0
        self._closing = False
        self._afterwards: list[Callable[[], object]] = []
        self._trying(self._hold_name)
        self._thread = Thread(self._run, "recovery", self._end)
        self._thread.start()

    def keep(self, stored: Stored | None, then: Callable[[], object] | None = None) -> None:
        """Write ``stored`` soon; None when there is nothing unsaved any more, and the file is removed.

        ``then`` is called once, on the writing thread, when that or a later call is done, or at a clean end.
        """
        with self._state:
            self._wanted = stored
            self._changes += 1
            if then is not None:
                self._afterwards.append(then)
            self._state.notify_all()

    def flush(self) -> bool:
        """Try now to write what is waiting, and come back when that has ended; whether all is kept."""
        with self._state:
            self._flushes += 1
            mine = self._flushes
            self._state.notify_all()
            self._state.wait_for(lambda: self._flushed >= mine or self._closing)
            return self._kept == self._changes

    def close(self) -> None:
        """End cleanly: the recovery file and its lock are removed."""
        self._end()
        self._thread.finish()
        self._give_up_name()
        self._call(self._afterwards)

    def _run(self) -> None:
        try:
            self._work()
        finally:
            self._end()  # whoever waits for it does not wait for ever

    def _end(self) -> None:
        with self._state:
            self._closing = True
            self._state.notify_all()

    def _work(self) -> None:
        next_s = 0.0
        while True:
            with self._state:
                self._state.wait_for(self._has_work)
                self._state.wait_for(self._hurries, max(self._delay_s, next_s - time.monotonic()))
                if self._closing:
                    return
                wanted, changes, flushes = self._wanted, self._changes, self._flushes
                afterwards = self._afterwards[:]
            began_s = time.monotonic()
            nothing = changes == self._kept or (wanted is None and not self._on_disk)
            kept = nothing or self._trying(partial(self._write, wanted))
            if kept:
                self._call(afterwards)
            ended_s = time.monotonic()
            next_s = max(next_s, ended_s + REST * (ended_s - began_s))
            with self._state:
                if kept:
                    self._kept = changes
                self._flushed = flushes
                self._state.notify_all()

    def _call(self, afterwards: list[Callable[[], object]]) -> None:
        for each in list(afterwards):
            each()
            self._afterwards.remove(each)

    def _has_work(self) -> bool:
        return self._changes > self._kept or self._flushes > self._flushed or self._closing

    def _hurries(self) -> bool:
        """Whether to act at once; what has failed waits, even where there is only something to remove."""
        nothing_unsaved = self._wanted is None and not self.trouble
        return nothing_unsaved or self._flushes > self._flushed or self._closing

    def _trying(self, act: Callable[[], None]) -> bool:
        """Whether ``act`` did not fail. Nothing that it raises ends the thread: the next time may do."""
        try:
            with short_turns:
                act()
        except Exception as error:
            self.trouble = self._complaint(error)
            return False
        self.trouble = ""
        return True

    def _complaint(self, error: Exception) -> str:
        if isinstance(error, OSError):
            sentence = _(
                "Unsaved work is not kept, as {folder} cannot be written ({reason}). "
                "This is tried again automatically; save often until then."
            )
            return sentence.format(folder=self._folder, reason=error.strerror or error)
        sentence = _(
            "Unsaved work is not kept: {reason} This is tried again automatically; save often until then."
        )
        return sentence.format(reason=error if isinstance(error, DocumentError) else f"{error!r}.")

    def _write(self, wanted: Stored | None) -> None:
        if wanted is None:
            _remove(self.path)
            self._on_disk = False
            return
        self._hold_name()
        self._on_disk = True
        beside = all_blobs(wanted)
        blobs = {_blob_path(self.path, digest): content for digest, content in beside.items()}
        kept = set(_blobs_beside(self.path))
        for path in blobs.keys() - kept:
            replace_file(path, blobs[path])
        write(replace(wanted, blobs={}, blobs_beside=tuple(beside)), self.path)
        for path in kept.difference(blobs):
            _remove(path)

    def _hold_name(self) -> None:
        """Have a name in the folder that no other session has; raises OSError."""
        if self._lock_file is not None and self.path.with_suffix(_LOCK).exists():
            return
        self._give_up_name()
        try_writing(self._folder)
        sweep(self._folder)
        self.path, self._lock_file = _fresh(self._folder)

    def _give_up_name(self) -> None:
        if self._lock_file is not None:
            _discard(self.path)
            held, self._lock_file = self._lock_file, None
            with suppress(OSError):
                _drop_lock(self.path.with_suffix(_LOCK), held)


def recoverable(folder: Path | None = None) -> list[Recoverable]:
    """The work that dead processes left, newest first. What nothing was kept of is cleared away."""
    folder = recovery_folder() if folder is None else folder
    found: list[Recoverable] = []
    if not os.path.isdir(folder) or not os.access(folder, os.R_OK | os.W_OK | os.X_OK):
        return found
    with suppress(OSError):
        sweep(folder)
    for stem in sorted({match.group() for match in map(_STEM.match, os.listdir(folder)) if match}):
        with suppress(OSError, DocumentError):  # its process lives, or it cannot be read now, or is no file
            work = _left(folder / (stem + _DOCUMENT))
            if work is not None:
                found.append(work)
    return sorted(found, key=lambda work: -work.kept_at)


def _left(path: Path) -> Recoverable | None:
    """The work in a recovery file whose process is dead; raises OSError or DocumentError."""
    lock = path.with_suffix(_LOCK)
    if os.path.lexists(lock) and not stat.S_ISREG(os.lstat(lock).st_mode):
        return _described(path)  # no process can hold this
    descriptor = _locked(lock)
    end = partial(os.close, descriptor)
    try:
        if path.exists():
            return _described(path)
        _discard(path)
        end = partial(_drop_lock, lock, descriptor)
        return None
    finally:
        end()


class _SheetName(msgspec.Struct):
    name: str


class _SheetNames(msgspec.Struct):
    sheets: list[_SheetName]


class _Description(msgspec.Struct):
    """What of a recovery file is told before it is read."""

    document: _SheetNames
    origin: str | None = None
    origin_stamp: Stamp | None = None


# Made here, by the thread that imports: as in ``document.storage.files``.
_description_decoder = msgspec.json.Decoder(_Description)


def _described(path: Path) -> Recoverable:
    kept_at = path.stat().st_mtime
    try:
        told = _description_decoder.decode(read_content(path, MAX_BYTES))
        name = told.document.sheets[0].name
    except (msgspec.DecodeError, UnicodeDecodeError, IndexError):
        return Recoverable(path, None, _("Damaged"), kept_at)
    origin = path_of(told.origin)
    called = legible(origin.name if origin else name)
    return Recoverable(path, origin, called, kept_at, told.origin_stamp)


def _blob_path(path: Path, digest: str) -> Path:
    """Where a blob is kept that belongs to the recovery file ``path``."""
    return path.with_suffix(f".{digest}{_BLOB}")


def _blobs_beside(path: Path) -> list[Path]:
    return sorted(path.parent.glob(f"{path.stem}.*{_BLOB}"))


def _discard(path: Path) -> None:
    """Remove a recovery file and its blobs, as far as they can be removed; its lock stays."""
    for file in (path, *_blobs_beside(path)):
        with suppress(OSError):
            _remove(file)


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


def _drop_lock(lock: Path, descriptor: int) -> None:
    """Remove a lock while it is held; on Windows, where nothing goes that is open, right after that."""
    try:
        if sys.platform != "win32":
            _remove(lock)
    finally:
        os.close(descriptor)
    if sys.platform == "win32":
        _remove(lock)


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
