"""A recursive text run to its end, or until its calls nest too deep: for those that are stepped only.

What is run is the lowered reading, in which an emission costs the same at any depth. Plain functions that
call one another with plain arguments take no room on the stack of the thread, so that any thread will do.
"""

import functools
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import ModuleType
from typing import Any

from workbench.engine.lowered_files import lowered as lowered_text
from workbench.engine.texts import ENTER, LEAVE, READING

Function = Callable[..., Any]
_FRAMES_PER_CALL = 4
_SPARE_FRAMES = 500
_COUNTED = f"""
def call({{parameters}}):
    {ENTER}()
    {READING}({{passed}})
    {LEAVE}()
"""


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


def collect_limited(function: Function, limit: int, *args: Any) -> Limited:
    """Everything that ``function(*args)`` emits with its calls at most ``limit`` deep.

    Where they would go deeper the run ends; what was emitted until then is kept. An image among ``args`` is
    written in place where the text does so. Raises DialectError.
    """
    rows: list[tuple[Any, ...]] = []
    depth, deepest, overflowed = -1, 0, False

    def enter() -> None:
        nonlocal depth, deepest
        if depth >= limit:
            raise RecursionError(limit)
        depth += 1
        deepest = max(deepest, depth)

    def leave() -> None:
        nonlocal depth
        depth -= 1

    def counted(reading: Function) -> Function:
        code = reading.__code__
        placed, end = list(code.co_varnames[: code.co_argcount]), code.co_argcount + code.co_kwonlyargcount
        named = code.co_varnames[code.co_argcount : end]
        parameters = ", ".join([*placed, *("*" for _name in named[:1]), *named])
        passed = ", ".join([*placed, *(f"{name}={name}" for name in named)])
        around: dict[str, Any] = {READING: reading, ENTER: enter, LEAVE: leave}
        exec(_COUNTED.format(parameters=parameters, passed=passed), around)
        call: Function = around["call"]
        functools.update_wrapper(call, reading, ("__defaults__", "__kwdefaults__"), ())
        return call

    lowered = lowered_text(function)
    module = ModuleType(f"limited_{lowered.name}")
    vars(module).update(reading=counted, part=lambda plain: plain)
    exec(compile(lowered.text, f"<{lowered.name}>", "exec"), vars(module))
    vars(module)["emit"] = lambda _sink, *values: rows.append(values)

    with frames.for_depth(limit):
        try:
            getattr(module, lowered.name)(None, *args)
        except RecursionError:
            overflowed = True
    return Limited(rows, deepest, overflowed)
