"""Threads that end before the interpreter does.

Python abandons daemon threads wherever they are when it ends: inside compiled code, or inside Qt, which then
takes the process down. These are told to stop, and waited for, while everything still stands.
"""

import atexit
import threading
from collections.abc import Callable

from workbench.engine.turns import interface

PATIENCE_S = 5.0

_running: dict[threading.Thread, Callable[[], None]] = {}


def thread(work: Callable[[], None], name: str, stop: Callable[[], None] = lambda: None) -> threading.Thread:
    """A thread for ``work``, not started yet. ``stop`` asks the work to end, and is called from another."""

    def run() -> None:
        _running[made] = stop
        try:
            work()
        finally:
            del _running[made]

    made = threading.Thread(target=run, name=name, daemon=True)
    return made


@atexit.register
def end_all(patience_s: float = PATIENCE_S) -> bool:
    """Ask all that run to stop, and wait up to ``patience_s`` for each; False when one still goes on."""
    interface.rests()  # who waits for them has nothing that goes before
    running = list(_running.items())
    for _thread, stop in running:
        stop()
    for one, _stop in running:
        one.join(patience_s)
    return not any(one.is_alive() for one, _stop in running)
