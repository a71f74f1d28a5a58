"""What threads hand over to the interface: they only fill a queue, and a timer of the interface empties it.

A thread that emits a signal of an object which is being destroyed ends the process. No thread here knows one.
"""

from collections.abc import Callable
from queue import Empty, SimpleQueue
from typing import Any

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from workbench.engine import background
from workbench.session.collecting import collect_here

_LOOK_MS = 2


class Answers(QObject):
    """``arrived`` sends, on the thread this lives on, what each work gives."""

    arrived = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        collect_here()
        self._queue: SimpleQueue[Any] = SimpleQueue()
        self._awaited = 0
        self._timer = QTimer(self, interval=_LOOK_MS, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._look)

    def ask(self, work: Callable[[], Any], name: str, stop: Callable[[], None] = lambda: None) -> None:
        """Do ``work`` on a thread called ``name``; None is no answer.

        ``stop`` asks it to end, and is called from another thread. Neither may hold anything of Qt.
        """
        put = self._queue.put

        def run() -> None:
            answer = None
            try:
                answer = work()
            finally:
                put(answer)

        self._awaited += 1
        self._timer.start()
        try:
            background.thread(run, name, stop).start()
        except RuntimeError:  # the system gives no more threads; this one will do
            run()

    def _look(self) -> None:
        try:
            answer = self._queue.get_nowait()
        except Empty:
            return
        self._awaited -= 1
        if not self._awaited:
            self._timer.stop()
        if answer is not None:
            self.arrived.emit(answer)
