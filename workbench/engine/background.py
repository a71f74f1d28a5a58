"""Threads that nobody waits for until they run, and that end before the interpreter does.

Python's own ``start`` waits until the new thread runs, for ever where that dies of want of memory before
(https://github.com/python/cpython/issues/140746). An interface cannot wait so.

Python abandons daemon threads wherever they are when it ends: inside compiled code, or inside Qt, which then
takes the process down. These are told to stop, and waited for, while everything still stands.
"""

import atexit
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

from workbench.engine.turns import interface

PATIENCE_S = 5.0
_STACK_BYTES = 256 * 2**20

_stack_size = threading.Lock()  # there is one for all threads
_started: dict["Thread", Callable[[], None]] = {}


def _nothing() -> None:
    """What is left to do once it is done."""


class Thread(threading.Thread):
    """A thread for ``work``. ``stop`` asks it to end, and is called from another one.

    The interpreter ends without one that does not stop in time, unless that is no ``daemon``.
    """

    def __init__(
        self,
        work: Callable[[], None],
        name: str,
        stop: Callable[[], None] = lambda: None,
        daemon: bool = True,
    ) -> None:
        super().__init__(name=name, daemon=daemon)
        self._work = work
        self._stop_work = stop
        self._claim = threading.Lock()
        self._ended = threading.Event()
        # What ``start`` waits for
        self._started.wait = lambda _timeout=None: True  # type: ignore[attr-defined]

    @property
    def ended(self) -> bool:
        """Whether the work is done, or has failed."""
        return self._ended.is_set()

    def start(self) -> None:
        """Begin; RuntimeError where the system gives no more threads now."""
        _started[self] = self._stop_work
        try:
            super().start()
        except RuntimeError:
            del _started[self]
            raise

    def run(self) -> None:
        """Do the work, unless another thread does or did."""
        if not self._claim.acquire(blocking=False):
            return
        try:
            self._work()
        finally:
            _started.pop(self, None)
            self._work = self._stop_work = _nothing  # what they hold is free to go
            self._ended.set()

    def finish(self) -> None:
        """Come back when the work is done. Where the thread has not begun, it is done here."""
        self.run()
        self.join()

    def end(self) -> None:
        """Come back when the work is done. Where the thread has not begun, it is not done any more."""
        self.give_up()
        self.join()

    def give_up(self) -> None:
        """Where the thread has not begun, do nothing any more."""
        if self.daemon and self._claim.acquire(blocking=False):
            _started.pop(self, None)
            self._ended.set()

    def join(self, timeout: float | None = None) -> None:
        """Wait for the end, at most ``timeout`` seconds."""
        if self._ended.wait(timeout):
            with suppress(RuntimeError):  # it never came to run, or it is this one
                super().join(timeout)


def report() -> None:
    """Tell of the exception that is being handled where those go that end a thread."""
    threading.excepthook(threading.ExceptHookArgs((*sys.exc_info(), threading.current_thread())))


@contextmanager
def large_stacks() -> Iterator[None]:
    """Threads that are started meanwhile have a stack for generators that nest deep."""
    with _stack_size:
        before = threading.stack_size(_STACK_BYTES)
        try:
            yield
        finally:
            threading.stack_size(before)


@atexit.register
def end_all(patience_s: float = PATIENCE_S) -> bool:
    """Ask all that run to stop, and wait up to ``patience_s`` for each; False when one still goes on."""
    interface.rests()  # who waits for them has nothing that goes before
    started = list(_started.items())
    for one, stop in started:
        one.give_up()
        stop()
    for one, _stop in started:
        one.join(patience_s)
    return all(one.ended for one, _stop in started)
