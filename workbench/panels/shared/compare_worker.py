"""Does jobs of comparison on a thread of its own; an answer to anything but the last question is dropped."""

from contextlib import suppress
from functools import partial

from PySide6.QtCore import QObject, Signal

from workbench.engine import background
from workbench.engine.compiled import Stop, Stopped
from workbench.rendering.work import Job, Outcome, outcome_of


class CompareWorker(QObject):
    """``answered`` sends the outcome of the last job asked for, ``failed`` one sentence about it."""

    answered = Signal(object)
    failed = Signal(str)
    _done = Signal(int, object, str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._token = 0
        self._stop: Stop | None = None
        self._done.connect(self._take)

    @property
    def busy(self) -> bool:
        """Whether an answer is awaited."""
        return self._stop is not None

    def ask(self, job: Job) -> None:
        """Do ``job``; what was asked before is stopped."""
        self.cancel()
        token, stop = self._token, Stop()
        self._stop = stop
        background.thread(partial(self._work, token, job, stop), "compare", stop.set).start()

    def cancel(self) -> None:
        """The last question is not of interest any more."""
        self._token += 1
        if self._stop is not None:
            self._stop.set()
            self._stop = None

    def _work(self, token: int, job: Job, stop: Stop) -> None:
        outcome, problem = None, ""
        try:
            outcome = outcome_of(job, stop)
        except Stopped:
            return
        except Exception as error:
            problem = str(error)
        # Whoever asked may be gone by now.
        with suppress(RuntimeError):
            self._done.emit(token, outcome, problem)

    def _take(self, token: int, outcome: Outcome | None, problem: str) -> None:
        if token != self._token:
            return
        self._stop = None
        if outcome is not None:
            self.answered.emit(outcome)
        else:
            self.failed.emit(problem)
