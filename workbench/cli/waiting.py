"""What takes long says so meanwhile, and can be ended."""

import sys
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from workbench.engine.background import Thread

AFTER_S, EVERY_S = 5.0, 30.0


def telling(work: Callable[[], Any], sentence: str) -> Any:
    """What ``work`` gives, or raises. While it lasts, ``sentence`` is told now and then on standard error.

    It runs on another thread, so that Ctrl+C is heard beside compiled code.
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
    thread.join(AFTER_S)
    while not thread.ended:
        with suppress(OSError):
            print(sentence, file=sys.stderr, flush=True)
        thread.join(EVERY_S)
    if failures:
        raise failures[0]
    return results[0]
