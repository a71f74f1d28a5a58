"""Threads take turns often while a recorder runs."""

import sys
import threading

_TURN_S = 0.0005


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


short_turns = _ShortTurns()
