"""Writes files beside the interface, which goes on meanwhile, sees how far that is, and may cancel it."""

import threading
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from PySide6.QtCore import QObject, Signal

from workbench.engine.background import report
from workbench.engine.turns import interface, short_turns
from workbench.exchange.writing import Cancelled, FileFormat, write
from workbench.language import _, reason_of
from workbench.session.answers import Answers

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


class _Told(NamedTuple):
    done: int
    parts: int


class Writer(QObject):
    """One writing at a time. ``told(done, parts)`` and ``ended(Outcome)`` come on its own thread."""

    told = Signal(int, int)
    ended = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._answers = Answers(self)
        self._answers.arrived.connect(self._take)
        self._writing = _Writing(self._answers.tell)
        self.ask = self._writing.ask
        self.busy = False

    def start(self, file_format: FileFormat, make: Callable[[], Any], path: Path) -> None:
        """Write what ``make`` gives, called on the writing thread; only while nothing else is written.

        What is not for that thread may be given to ``ask`` there. ``busy`` until the end is told.
        """
        assert not self.busy
        self.busy = True
        self._writing.cancelled.clear()
        work = partial(self._writing.work, file_format, make, path)
        self._answers.ask(work, "write", self._writing.cancelled.set)

    def cancel(self) -> None:
        """End the writing; nothing is written."""
        self._writing.cancelled.set()

    def _take(self, said: _Asked | _Told | Outcome) -> None:
        if isinstance(said, _Asked):
            said.act()
        elif isinstance(said, _Told):
            self.told.emit(*said)
        else:
            self.busy = False
            self.ended.emit(said)


class _Writing:
    """What is done on the writing thread. Of Qt it knows nothing."""

    def __init__(self, tell: Callable[[Any], None]) -> None:
        self._tell = tell
        self.cancelled = threading.Event()

    def ask(self, do: Callable[[], T]) -> T:
        """What ``do`` gives on the interface's thread. Raises Cancelled."""
        asked = _Asked(do)
        if threading.current_thread() is threading.main_thread():
            asked.act()
        else:
            self._tell(asked)
        while not asked.done.wait(_LOOK_S):
            self._look()
        if asked.error is not None:
            raise asked.error
        return asked.answer  # type: ignore[no-any-return]

    def work(self, file_format: FileFormat, make: Callable[[], Any], path: Path) -> Outcome:
        """Write; whatever becomes of it, its end is told. A failure goes where failures go."""
        try:
            with short_turns:
                content = make()
                return Outcome(tuple(write(file_format, content, path, self._told)), content)
        except Cancelled:
            return Outcome(cancelled=True)
        except (ValueError, OSError) as error:
            return Outcome(problem=reason_of(error))
        except Exception:
            report()
        failed = _("Something in the program failed, so {name} was not written.")
        return Outcome(problem=failed.format(name=path.name))

    def _look(self) -> None:
        if self.cancelled.is_set():
            raise Cancelled

    def _told(self, done: int, parts: int) -> None:
        self._look()
        interface.wait()
        self._tell(_Told(done, parts))
