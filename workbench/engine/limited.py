"""A recursive text run to its end, or until its calls nest too deep: for those that are stepped only.

What is run is the lowered reading, in which an emission costs the same at any depth.
"""

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import ModuleType
from typing import Any

from workbench.engine.lowering import lower

Function = Callable[..., Any]
_STACK_BYTES = 256 * 2**20
_FRAMES_PER_CALL = 4
_SPARE_FRAMES = 500


@dataclass(frozen=True, slots=True)
class Limited:
    """Everything emitted, and the greatest depth (the entry's own call is 0).

    ``overflowed`` tells whether the calls would have nested deeper than they may.
    """

    rows: list[tuple[Any, ...]]
    deepest: int
    overflowed: bool


class _Frames:
    """Lets Python nest calls deeper while any run needs it, and takes that back behind the last one."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._needed: list[int] = []
        self._before = 0

    @contextmanager
    def for_depth(self, depth: int) -> Iterator[None]:
        needed = _FRAMES_PER_CALL * depth + _SPARE_FRAMES
        with self._lock:
            if not self._needed:
                self._before = sys.getrecursionlimit()
            self._needed.append(needed)
            self._set()
        try:
            yield
        finally:
            with self._lock:
                self._needed.remove(needed)
                self._set()

    def _set(self) -> None:
        limit = max([self._before, *self._needed])
        if limit != sys.getrecursionlimit():
            sys.setrecursionlimit(limit)


frames = _Frames()


@contextmanager
def large_stacks() -> Iterator[None]:
    """Threads that are started meanwhile have a stack for calls that nest deep."""
    before = threading.stack_size(_STACK_BYTES)
    try:
        yield
    finally:
        threading.stack_size(before)


def collect_limited(function: Function, limit: int, *args: Any) -> Limited:
    """Everything that ``function(*args)`` emits with its calls at most ``limit`` deep.

    Where they would go deeper the run ends; what was emitted until then is kept. An image among ``args`` is
    written in place where the text does so. Raises DialectError.
    """
    rows: list[tuple[Any, ...]] = []
    depth, deepest, overflowed = -1, 0, False

    def counted(reading: Function) -> Function:
        def call(*values: Any) -> None:
            nonlocal depth, deepest
            if depth >= limit:
                raise RecursionError(limit)
            depth += 1
            deepest = max(deepest, depth)
            reading(*values)
            depth -= 1

        return call

    lowered = lower(function)
    module = ModuleType(f"limited_{lowered.name}")
    vars(module).update(reading=counted, part=lambda plain: plain)
    exec(compile(lowered.text, f"<{lowered.name}>", "exec"), vars(module))
    vars(module)["emit"] = lambda _sink, *values: rows.append(values)

    def run() -> None:
        nonlocal overflowed
        try:
            getattr(module, lowered.name)(None, *args)
        except RecursionError:
            overflowed = True

    with frames.for_depth(limit):
        with large_stacks():
            thread = threading.Thread(target=run, name=f"run {lowered.name}", daemon=True)
            thread.start()
        thread.join()
    return Limited(rows, deepest, overflowed)
