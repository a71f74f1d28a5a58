"""What threads hand over to the interface: they only fill a queue, and a timer of the interface empties it.

A thread that emits a signal of an object which is being destroyed ends the process. No thread here knows one.
"""

from collections.abc import Callable
from functools import partial
from queue import Empty, SimpleQueue
from typing import Any

from PySide6.QtCore import QElapsedTimer, QObject, Qt, QTimer, Signal

from workbench.engine.background import Thread
from workbench.session.collecting import collect_here

_LOOK_MS = 1
_LONG_LOOK_MS = 32
_PATIENCE = 16  # what has taken this many times as long is looked for as rarely


class Answers(QObject):
    """``arrived`` sends, on the thread this lives on, what each work gives, and what it tells meanwhile.

    ``tell`` is for any thread while a work goes on, and holds nothing of Qt.
    """

    arrived = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        collect_here()
        self._queue: SimpleQueue[tuple[Any, bool]] = SimpleQueue()  # what is said, whether it is the last
        self.tell: Callable[[Any], None] = partial(_tell, self._queue)
        self._awaited = 0
        self._since = QElapsedTimer()
        self._timer = QTimer(self, interval=_LOOK_MS, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._look)

    def ask(
        self,
        work: Callable[[], Any],
        name: str,
        stop: Callable[[], None] = lambda: None,
        daemon: bool = True,
    ) -> Thread:
        """Do ``work`` on a thread called ``name``; None is no answer.

        ``stop`` asks it to end, and is called from another thread. Neither may hold anything of Qt. Where the
        system gives no more threads, this one does it.
        """
        put = self._queue.put

        def run() -> None:
            answer = None
            try:
                answer = work()
            finally:
                put((answer, True))

        self._awaited += 1
        self._since.start()
        self._timer.start(_LOOK_MS)
        thread = Thread(run, name, stop, daemon)
        try:
            thread.start()
        except RuntimeError:
            thread.run()
        return thread

    def _look(self) -> None:
        """Send one answer, if there is one: each has a turn of its own."""
        try:
            answer, last = self._queue.get_nowait()
        except Empty:
            rare = min(max(_LOOK_MS, self._since.elapsed() // _PATIENCE), _LONG_LOOK_MS)
            if rare != self._timer.interval():
                self._timer.setInterval(rare)
            return
        self._awaited -= last
        if not self._awaited:
            self._timer.stop()
        if answer is not None:
            self.arrived.emit(answer)


def _tell(queue: SimpleQueue[tuple[Any, bool]], what: Any) -> None:
    queue.put((what, False))
