"""What takes long says so meanwhile, and can be ended."""

import os
import sys
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from workbench.engine.background import Thread

AFTER_S, EVERY_S = 5.0, 30.0
_INTERRUPTED = 130  # the exit status, as everywhere


def telling(work: Callable[[], Any], sentence: str) -> Any:
    """What ``work`` gives, or raises. While it lasts, ``sentence`` is told now and then on standard error.

    It runs on another thread, so that Ctrl+C is heard beside compiled code, and ends the process.
    """
    results: list[Any] = []
    failures: list[BaseException] = []

    def run() -> None:
        try:
            results.append(work())
        except BaseException as failure:
            failures.append(failure)

    thread = Thread(run, "work")
    thread.start()
    try:
        thread.join(AFTER_S)
        while not thread.ended:
            with suppress(OSError):
                print(sentence, file=sys.stderr, flush=True)
            thread.join(EVERY_S)
    except KeyboardInterrupt:
        # Compiled code hears of no stop, and at its end the interpreter would wait for the thread.
        os._exit(_INTERRUPTED)
    if failures:
        raise failures[0]
    return results[0]
