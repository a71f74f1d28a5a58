"""Whose turn it is: an interface goes before the threads that run Python texts beside it.

Only one thread runs Python at a time. Beside one that never rests, each call between Python and a toolkit may
wait for its turn, and laying out a table makes hundreds of them.
"""

import sys
import threading
from collections.abc import Sequence
from importlib.abc import MetaPathFinder
from types import ModuleType

_TURN_S = 0.0001
_PATIENCE_S = 0.05


class _Interface:
    """Makes other threads wait while the interface works."""

    def __init__(self) -> None:
        self._rests = threading.Event()
        self._rests.set()

    def works(self) -> None:
        """Others wait from their next look on."""
        self._rests.clear()

    def rests(self) -> None:
        """Others go on."""
        self._rests.set()

    def wait(self) -> None:
        """Called by other threads, often: wait while it works, but not for long.

        It may have been left so, and from then on it counts as resting.
        """
        if threading.current_thread() is not threading.main_thread() and not self._rests.wait(_PATIENCE_S):
            self._rests.set()


class _ShortTurns:
    """Makes threads take turns often while any recorder runs, so that an interface need not wait."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._running = 0
        self._before = 0.0

    def __enter__(self) -> None:
        with self._lock:
            if not self._running:
                self._before = sys.getswitchinterval()
                sys.setswitchinterval(min(self._before, _TURN_S))
            self._running += 1

    def __exit__(self, *_raised: object) -> None:
        with self._lock:
            self._running -= 1
            if not self._running:
                sys.setswitchinterval(self._before)


class _ImportsInTurn(MetaPathFinder):
    """While entered, the interface is waited for before each module that another thread imports."""

    def __enter__(self) -> None:
        sys.meta_path.insert(0, self)

    def __exit__(self, *_raised: object) -> None:
        sys.meta_path.remove(self)

    def find_spec(self, _name: str, _path: Sequence[str] | None, _target: ModuleType | None = None) -> None:
        """Find nothing: the others do."""
        interface.wait()


interface = _Interface()
short_turns = _ShortTurns()
imports_in_turn = _ImportsInTurn()
