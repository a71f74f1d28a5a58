"""What the calls of algorithms emit, kept by value: the same call is run once.

The plain reading serves until a kernel is at hand; nothing here compiles or loads.
"""

from hashlib import blake2b
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.engine.at_hand import at_hand
from workbench.engine.limited import collect_limited
from workbench.memory import Memory
from workbench.rendering.mapping import Call

Emitted = NDArray[np.float64] | NDArray[np.int64]

_MOST_COLUMNS = 3
"""Of a row, as of a span; where nothing is emitted there is no row to tell."""

_memory: Memory[Emitted] = Memory(48 << 20)


def emitted(call: Call) -> Emitted:
    """Everything a call emits, one row each; read-only and remembered."""
    content = call.arguments
    if np.ndarray in map(type, content):
        content = tuple(_content(a) if isinstance(a, np.ndarray) else a for a in content)
    return _memory.get((call.entry.function, content, call.recursion_limit), lambda: _run(call))


def _content(array: NDArray[Any]) -> tuple[Any, ...]:
    """An array as a key: equal when its content is."""
    return array.shape, array.dtype, blake2b(np.ascontiguousarray(array).data, digest_size=16).digest()


def _run(call: Call) -> Emitted:
    function = call.entry.function
    given = tuple(a.copy() if isinstance(a, np.ndarray) else a for a in call.arguments)
    if call.recursion_limit:
        return _as_rows(collect_limited(function, call.recursion_limit, *given).rows)
    if at_hand(function, "collect"):
        from workbench.engine.compiled import collect

        return collect(function, *given, compiling=False)
    return _as_rows(list(function(*given)))


def _as_rows(listed: list[tuple[Any, ...]]) -> Emitted:
    return np.array(listed) if listed else np.empty((0, _MOST_COLUMNS), dtype=np.int64)
