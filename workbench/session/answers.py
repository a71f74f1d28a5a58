"""What threads hand over to the interface: they only fill a queue, and ring a bell for it to be emptied.

A thread that emits a signal of an object which is being destroyed ends the process. No thread here knows one.
"""

from collections.abc import Callable
from functools import partial
from queue import Empty, SimpleQueue
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal

from workbench.engine.background import Thread
from workbench.session.bell import bell
from workbench.session.collecting import collect_here


class Answers(QObject):
    """``arrived`` sends, on the thread this lives on, what each work gives, and what it tells meanwhile.

    ``tell`` is for any thread while a work goes on, and holds nothing of Qt.
    """

    arrived = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        collect_here()
        self._bell = bell()
        self._queue: SimpleQueue[tuple[Any, bool]] = SimpleQueue()  # what is said, whether it is the last
        self._say = partial(_say, self._queue, self._bell.ring)
        self.tell: Callable[[Any], None] = partial(self._say, last=False)
        self._awaited = 0

    @property
    def are_awaited(self) -> bool:
        """Whether a work goes on, or its answer has not been sent yet."""
        return self._awaited > 0

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
        say = self._say

        def run() -> None:
            answer = None
            try:
                answer = work()
            finally:
                say(answer, last=True)

        if not self._awaited:
            self._bell.rung.connect(self._look, Qt.ConnectionType.QueuedConnection)
        self._awaited += 1
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
            return
        self._awaited -= last
        if not self._awaited:
            self._bell.rung.disconnect(self._look)
        elif not self._queue.empty():
            self._bell.ring()
        if answer is not None:
            self.arrived.emit(answer)


def _say(queue: SimpleQueue[tuple[Any, bool]], ring: Callable[[], None], what: Any, last: bool) -> None:
    queue.put((what, last))
    ring()
