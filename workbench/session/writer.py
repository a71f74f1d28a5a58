"""Writes files beside the interface, which goes on meanwhile, sees how far that is, and may cancel it."""

import threading
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from PySide6.QtCore import QObject, Qt, Signal, SignalInstance

from workbench.engine import background
from workbench.engine.turns import interface, short_turns
from workbench.exchange.writing import Cancelled, FileFormat, write
from workbench.language import _, reason_of

T = TypeVar("T")
_LOOK_S = 0.05


@dataclass(frozen=True, slots=True)
class Outcome:
    """How a writing ended: the files and the content, ``cancelled``, or ``problem``, a sentence."""

    paths: tuple[Path, ...] = ()
    content: Any = None
    cancelled: bool = False
    problem: str = ""


class _Asked:
    """Something to be done on the interface's thread, and its answer."""

    def __init__(self, do: Callable[[], Any]) -> None:
        self._do = do
        self.done = threading.Event()
        self.answer: Any = None
        self.error: Exception | None = None

    def act(self) -> None:
        try:
            self.answer = self._do()
        except Exception as error:
            self.error = error
        self.done.set()


class Writer(QObject):
    """One writing at a time. ``told(done, parts)`` and ``ended(Outcome)`` come on its own thread."""

    told = Signal(int, int)
    ended = Signal(object)
    _asked = Signal(object)
    _over = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._cancelled = threading.Event()
        self._thread: threading.Thread | None = None
        self._asked.connect(_Asked.act, Qt.ConnectionType.QueuedConnection)
        self._over.connect(self._end, Qt.ConnectionType.QueuedConnection)

    @property
    def busy(self) -> bool:
        """Whether something is being written, or its end not yet told."""
        return self._thread is not None

    def start(self, file_format: FileFormat, make: Callable[[], Any], path: Path) -> None:
        """Write what ``make`` gives, called on the writing thread; only while nothing else is written."""
        assert self._thread is None
        self._cancelled.clear()
        self._thread = background.thread(partial(self._work, file_format, make, path), "write", self.cancel)
        try:
            self._thread.start()
        except RuntimeError:  # the system gives no more threads
            self._thread = None
            sentence = _("{name} was not written: too much is going on; close other programs and try again.")
            self.ended.emit(Outcome(problem=sentence.format(name=path.name)))

    def cancel(self) -> None:
        """End the writing; nothing is written. From any thread."""
        self._cancelled.set()

    def ask(self, do: Callable[[], T]) -> T:
        """What ``do`` gives on the interface's thread; called from the writing one. Raises Cancelled."""
        if threading.current_thread() is not self._thread:
            return do()
        asked = _Asked(do)
        self._emit(self._asked, asked)
        while not asked.done.wait(_LOOK_S):
            self._look()
        if asked.error is not None:
            raise asked.error
        return asked.answer  # type: ignore[no-any-return]

    def _emit(self, signal: SignalInstance, *what: object) -> None:
        try:
            signal.emit(*what)
        except RuntimeError:  # nobody is there any more
            self.cancel()

    def _look(self) -> None:
        if self._cancelled.is_set():
            raise Cancelled

    def _told(self, done: int, parts: int) -> None:
        self._look()
        interface.wait()
        self._emit(self.told, done, parts)

    def _work(self, file_format: FileFormat, make: Callable[[], Any], path: Path) -> None:
        failed = _("Something in the program failed, so {name} was not written.").format(name=path.name)
        outcome = Outcome(problem=failed)
        try:
            with short_turns:
                content = make()
                outcome = Outcome(tuple(write(file_format, content, path, self._told)), content)
        except Cancelled:
            outcome = Outcome(cancelled=True)
        except (ValueError, OSError) as error:
            outcome = Outcome(problem=reason_of(error))
        finally:  # whatever it was, its end is told
            self._emit(self._over, outcome)

    def _end(self, outcome: Outcome) -> None:
        assert self._thread is not None
        self._thread.join()
        self._thread = None
        self.ended.emit(outcome)
