"""What is being read for a session: what is short at once, all else beside the interface, one at a time."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

from PySide6.QtCore import QObject, Signal

from workbench.document.errors import DocumentError
from workbench.document.storage.content import Stopped
from workbench.engine.background import report
from workbench.exchange.reading import Job, Reading, read_at_once
from workbench.language import _, reason_of
from workbench.session.answers import Answers

Prepare = Callable[[Any], object]  # given a Result


@dataclass(frozen=True, slots=True, eq=False)
class _Wish:
    reading: Reading
    take: Callable[[Any], object]
    refuse: Callable[[str], object]


class _Said(NamedTuple):
    """Of a reading: the ``share`` that is done, or its end: what came of it, or ``problem``, one sentence."""

    of: Reading
    share: float | None = None
    result: object = None
    problem: str = ""


class Incoming(QObject):
    """``began`` sends what is read, ``progressed`` the share that is done; ``ended`` comes in any case."""

    began = Signal(str)
    progressed = Signal(float)
    ended = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._wish: _Wish | None = None
        self._answers = Answers(self)
        self._answers.arrived.connect(self._take)

    @property
    def busy(self) -> bool:
        """Whether something is being read."""
        return self._wish is not None

    def read(
        self,
        job: Job,
        name: str,
        take: Callable[[Any], object],
        refuse: Callable[[str], object],
        prepare: Prepare = lambda result: result,
    ) -> bool:
        """Read what is called ``name``; whether that was done at once. What was being read before is dropped.

        ``take`` is given what ``prepare`` makes of the result, on a thread beside if need be, which is why it
        holds nothing of Qt and may raise DocumentError; ``refuse`` one sentence.
        """
        self.cancel()
        try:
            result = read_at_once(job)
            prepared = None if result is None else _prepared(prepare, result)
        except ValueError as error:
            refuse(reason_of(error))
            return True
        if result is not None:
            take(prepared)
            return True
        wish = self._wish = _Wish(Reading(job), take, refuse)
        self.began.emit(name)
        work = partial(_read, wish.reading, prepare, self._answers.tell)
        self._answers.ask(work, "read", wish.reading.stop)
        return False

    def cancel(self) -> None:
        """Leave what is being read; nothing of it is taken."""
        wish, self._wish = self._wish, None
        if wish is not None:
            wish.reading.stop()
            self.ended.emit()

    def _take(self, said: _Said) -> None:
        wish = self._wish
        if wish is None or said.of is not wish.reading:
            return
        if said.share is not None:
            self.progressed.emit(said.share)
            return
        self._wish = None
        self.ended.emit()
        if said.problem:
            wish.refuse(said.problem)
        else:
            wish.take(said.result)


def _prepared(prepare: Prepare, result: object) -> object:
    try:
        return prepare(result)
    except DocumentError as problem:
        raise ValueError(problem.short) from None


def _read(reading: Reading, prepare: Prepare, tell: Callable[[_Said], None]) -> _Said | None:
    try:
        result = reading.follow(lambda share: tell(_Said(reading, share=share)))
        return _Said(reading, result=_prepared(prepare, result))
    except Stopped:
        return None
    except (ValueError, OSError) as error:
        return _Said(reading, problem=reason_of(error))
    except Exception:
        report()
    return _Said(
        reading, problem=_("Something in the program failed while this was being read; try another file.")
    )
