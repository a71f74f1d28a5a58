"""What is being read for a session: what is short at once, all else beside the interface, one at a time."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, Signal, SignalInstance

from workbench.document.storage.content import Stopped
from workbench.engine import background
from workbench.exchange.reading import Job, Reading, read_at_once
from workbench.language import _, reason_of

Prepare = Callable[[Any], object]  # given a Result


@dataclass(frozen=True, slots=True, eq=False)
class _Wish:
    reading: Reading
    take: Callable[[Any], object]
    refuse: Callable[[str], object]
    prepare: Prepare


class Incoming(QObject):
    """``began`` sends what is read, ``progressed`` the share that is done; ``ended`` comes in any case."""

    began = Signal(str)
    progressed = Signal(float)
    ended = Signal()
    _told = Signal(object, float)
    _done = Signal(object, object, str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._wish: _Wish | None = None
        self._told.connect(self._tell)
        self._done.connect(self._take)

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

        ``take`` is given what ``prepare`` makes of the result, on a thread beside if need be; ``refuse`` one
        sentence.
        """
        self.cancel()
        try:
            result = read_at_once(job)
            prepared = None if result is None else prepare(result)
        except ValueError as error:
            refuse(reason_of(error))
            return True
        if result is not None:
            take(prepared)
            return True
        wish = self._wish = _Wish(Reading(job), take, refuse, prepare)
        self.began.emit(name)
        background.thread(partial(self._work, wish), "read", wish.reading.stop).start()
        return False

    def cancel(self) -> None:
        """Leave what is being read; nothing of it is taken."""
        wish, self._wish = self._wish, None
        if wish is not None:
            wish.reading.stop()
            self.ended.emit()

    def _work(self, wish: _Wish) -> None:
        result, sentence = None, ""
        try:
            result = wish.prepare(wish.reading.follow(partial(_emit, self._told, wish)))
        except Stopped:
            return
        except (ValueError, OSError) as error:
            sentence = reason_of(error)
        except Exception:
            failed = _("Something in the program failed while this was read; try another file.")
            _emit(self._done, wish, None, failed)
            raise
        _emit(self._done, wish, result, sentence)

    def _tell(self, wish: _Wish, share: float) -> None:
        if wish is self._wish:
            self.progressed.emit(share)

    def _take(self, wish: _Wish, result: object, sentence: str) -> None:
        if wish is not self._wish:
            return
        self._wish = None
        self.ended.emit()
        if sentence:
            wish.refuse(sentence)
        else:
            wish.take(result)


def _emit(signal: SignalInstance, *what: object) -> None:
    with suppress(RuntimeError):  # who asked is gone
        signal.emit(*what)
