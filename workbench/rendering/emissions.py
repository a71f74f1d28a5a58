"""What the calls of algorithms emit, kept by value: the same call is run once.

The plain reading serves for short runs and until a kernel is ready; nothing here compiles.
"""

from collections import deque
from collections.abc import Callable, Iterator
from functools import lru_cache
from hashlib import blake2b
from threading import Lock
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry
from workbench.engine.limited import collect_limited
from workbench.rendering.mapping import Call

Emitted = NDArray[np.float64] | NDArray[np.int64]
Function = Callable[..., Iterator[tuple[Any, ...]]]

_LONG_RUN = 4096
"""Emitted pixels from which a compiled kernel is worth its call and the look whether it is ready."""

_MOST_COLUMNS = 3
"""Of a row, as of a span; where nothing is emitted there is no row to tell."""


_MANY_CALLS = 64
"""Calls from which one run of a kernel for all of them is worth it."""

_KEPT, _KEPT_ROWS = 64, 4_000_000
"""Tables of calls of which everything emitted is kept, and how much of it: the last ones asked for."""

_RECENT = 8
"""The last made are looked through for one that is nearly the same: a drag changes a few rows of one."""


def _expected_length(arguments: tuple[Any, ...]) -> int:
    sizes = [abs(a) for a in arguments if isinstance(a, int)]
    arrays = [a for a in arguments if isinstance(a, np.ndarray)]
    images = [a.size for a in arrays]
    rows = [int(np.ptp(a[:, 1])) for a in arrays if a.dtype == np.float64 and a.ndim == 2 and len(a)]
    return max([4 * size for size in sizes + rows] + images, default=0)


def _run(function: Function, compilable: bool, arguments: tuple[Any, ...], limit: int) -> Emitted:
    given = tuple(a.copy() if isinstance(a, np.ndarray) else a for a in arguments)
    rows: Emitted
    if limit:
        return _as_rows(collect_limited(function, limit, *given).rows)
    if compilable and _expected_length(given) > _LONG_RUN:
        from workbench.engine.compiled import collect, loaded, ready

        if loaded() and ready(function, "collect"):
            rows = collect(function, *given, compiling=False)
            return rows
    return _as_rows(list(function(*given)))


def _as_rows(listed: list[tuple[Any, ...]]) -> Emitted:
    return np.array(listed) if listed else np.empty((0, _MOST_COLUMNS), dtype=np.int64)


@lru_cache(maxsize=4096)
def _remembered(function: Function, compilable: bool, arguments: tuple[Any, ...]) -> Emitted:
    rows = _run(function, compilable, arguments, 0)
    rows.setflags(write=False)
    return rows


class _ByContent:
    """An array as a key: equal when its content is."""

    __slots__ = ("array", "digest")

    def __init__(self, array: NDArray[Any]) -> None:
        self.array = array
        self.digest = blake2b(np.ascontiguousarray(array).data, digest_size=16).digest()

    def __hash__(self) -> int:
        return hash(self.digest)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _ByContent) and self.digest == other.digest


@lru_cache(maxsize=64)
def _remembered_on_image(
    function: Function, compilable: bool, arguments: tuple[Any, ...], limit: int
) -> Emitted:
    plain = tuple(a.array if isinstance(a, _ByContent) else a for a in arguments)
    rows = _run(function, compilable, plain, limit)
    rows.setflags(write=False)
    return rows


def emitted(call: Call) -> Emitted:
    """Everything a call emits, one row each; read-only and remembered."""
    function, compilable = call.entry.function, not call.entry.compiles
    if any(isinstance(a, np.ndarray) for a in call.arguments):
        keys = tuple(_ByContent(a.copy()) if isinstance(a, np.ndarray) else a for a in call.arguments)
        return _remembered_on_image(function, compilable, keys, call.recursion_limit)
    return _remembered(function, compilable, call.arguments)


class _Batch(NamedTuple):
    """A table of calls (n, parameters), all they emitted, and where in that each one ends (n,)."""

    table: NDArray[np.int64]
    rows: Emitted
    ends: NDArray[np.int64]


class _Kept:
    """The tables of one text by their content, the last one asked for last, and the last ones made."""

    def __init__(self) -> None:
        self.batches: dict[bytes, _Batch] = {}
        self._made: deque[bytes] = deque(maxlen=_RECENT)

    def take(self, key: bytes) -> _Batch | None:
        """The table with this content, if it is there."""
        found = self.batches.pop(key, None)
        if found is not None:
            self.batches[key] = found
        return found

    @property
    def recent(self) -> list[_Batch]:
        """The last ones made of those that are there."""
        return [self.batches[key] for key in self._made if key in self.batches]

    def put(self, key: bytes, batch: _Batch) -> None:
        """Keep a table, and let go of those that were not asked for the longest."""
        self.batches[key] = batch
        self._made.append(key)
        rows = sum(len(other.rows) for other in self.batches.values())
        while len(self.batches) > _KEPT or (rows > _KEPT_ROWS and len(self.batches) > 1):
            rows -= len(self.batches.pop(next(iter(self.batches))).rows)


_batches: dict[Function, _Kept] = {}
_keeping = Lock()


def emitted_by_all(entry: Entry, table: NDArray[np.int64]) -> tuple[Emitted, NDArray[np.int64]]:
    """Everything that calls with whole numbers, one a row of ``table`` (n, parameters), emit, in their order.

    Returns the rows, read-only, and for each call (n,) how many there are up to its end. Only calls that an
    earlier table did not have at the same place, counted from its begin or its end, are run.
    """
    key = table.tobytes()
    with _keeping:
        known = _batches.setdefault(entry.function, _Kept())
        found = known.take(key)
        recent = [] if found else known.recent
    if found is None:
        found = _made_from(entry, recent, table)
        with _keeping:
            known.put(key, found)
    return found.rows, found.ends


def _made_from(entry: Entry, recent: list[_Batch], table: NDArray[np.int64]) -> _Batch:
    """What a table emits, made from the recent one that is nearest to it."""
    best, front, back = _nearest(recent, table)
    middle, ends = _run_all(entry, table[front : len(table) - back])
    parts = [middle]
    if best is not None:
        after = len(best.table) - back
        head, tail = (int(best.ends[count - 1]) if count else 0 for count in (front, after))
        shift = head + len(middle) - tail
        parts = [best.rows[:head], middle, best.rows[tail:]]
        ends = np.concatenate([best.ends[:front], ends + head, best.ends[after:] + shift])
    rows: Emitted = np.concatenate([part for part in parts if len(part)] or parts[:1])
    rows.setflags(write=False)
    return _Batch(table, rows, ends)


def _nearest(recent: list[_Batch], table: NDArray[np.int64]) -> tuple[_Batch | None, int, int]:
    """The table with most rows in common, and how many they are at its begin and at its end."""
    found: tuple[_Batch | None, int, int] = (None, 0, 0)
    for batch in recent:
        shorter = min(len(batch.table), len(table))
        differs = (batch.table[:shorter] != table[:shorter]).any(axis=1)
        front = int(differs.argmax()) if differs.any() else shorter
        rest = shorter - front
        again = (batch.table[len(batch.table) - rest :] != table[len(table) - rest :]).any(axis=1)[::-1]
        back = int(again.argmax()) if again.any() else rest
        if front + back > found[1] + found[2]:
            found = batch, front, back
    return found


def _run_all(entry: Entry, table: NDArray[np.int64]) -> tuple[Emitted, NDArray[np.int64]]:
    """What each row of ``table`` emits, and the ends; by one kernel where it is ready, else one by one."""
    function, compilable = entry.function, not entry.compiles
    if compilable and len(table) >= _MANY_CALLS:
        from workbench.engine.compiled import collect_many, loaded, ready

        if loaded() and ready(function, "collect_many"):
            return collect_many(function, table, compiling=False)
    parts = [_remembered(function, compilable, tuple(row)) for row in table.tolist()]
    ends = np.cumsum([len(part) for part in parts], dtype=np.int64)
    whole: Any = np.concatenate(parts) if parts else _as_rows([])
    return whole, ends
