"""Does jobs of comparison on a thread of its own; an answer to anything but the last question is dropped."""

from functools import partial

from PySide6.QtCore import QObject, Signal

from workbench.engine.compiled import Stop, Stopped
from workbench.rendering.work import Job, Outcome, outcome_of
from workbench.session.answers import Answers

_Answer = tuple[int, Outcome | None, str]


class CompareWorker(QObject):
    """``answered`` sends the outcome of the last job asked for, ``failed`` one sentence about it."""

    answered = Signal(object)
    failed = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._token = 0
        self._stop: Stop | None = None
        self._answers = Answers(self)
        self._answers.arrived.connect(self._take)

    @property
    def busy(self) -> bool:
        """Whether an answer is awaited."""
        return self._stop is not None

    def ask(self, job: Job) -> None:
        """Do ``job``; what was asked before is stopped."""
        self.cancel()
        token, stop = self._token, Stop()
        self._stop = stop
        self._answers.ask(partial(_compared, token, job, stop), "compare", stop.set)

    def cancel(self) -> None:
        """The last question is not of interest any more."""
        self._token += 1
        if self._stop is not None:
            self._stop.set()
            self._stop = None

    def _take(self, answer: _Answer) -> None:
        token, outcome, problem = answer
        if token != self._token:
            return
        self._stop = None
        if outcome is not None:
            self.answered.emit(outcome)
        else:
            self.failed.emit(problem)


def _compared(token: int, job: Job, stop: Stop) -> _Answer | None:
    try:
        return token, outcome_of(job, stop), ""
    except Stopped:
        return None
    except Exception as error:
        return token, None, str(error)
