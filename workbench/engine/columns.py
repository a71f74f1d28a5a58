"""Growing columns: the values one variable took, and everything that was emitted."""

from array import array
from bisect import bisect_right
from collections.abc import Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from workbench.engine.containers import Log

MISSING: Any = type("Missing", (), {"__repr__": lambda self: "<missing>"})()
_CODES = {int: "q", float: "d"}


class Column:
    """One variable at one depth: the stamps at which it changed and its value from then on."""

    __slots__ = ("_kind", "_stamps", "_values")

    def __init__(self) -> None:
        self._kind: type | None = None
        self._stamps = array("I")
        self._values: Any = None

    def put(self, stamp: int, value: Any) -> None:
        """Append a change; numbers of one type stay packed."""
        kind = type(value)
        if self._values is None:
            self._kind = kind if kind in _CODES else None
            self._values = array(_CODES[kind]) if self._kind else []
        elif self._kind is not None and kind is not self._kind:
            self._unpack()
        try:
            self._values.append(value)
        except OverflowError:
            self._unpack()
            self._values.append(value)
        self._stamps.append(stamp)

    def _unpack(self) -> None:
        self._values = list(self._values)
        self._kind = None

    def read(self, since: int, stamp: int) -> Any:
        """The value at ``stamp`` of a frame that began at ``since``; MISSING before its first binding."""
        at = bisect_right(self._stamps, stamp) - 1
        if at < 0 or self._stamps[at] < since:
            return MISSING
        value = self._values[at]
        return value.read(stamp) if isinstance(value, Log) else value

    def changed_at(self, stamp: int) -> bool:
        """Whether a change, or one of the list or array it is bound to, bears exactly this stamp."""
        at = bisect_right(self._stamps, stamp) - 1
        if at < 0:
            return False
        value = self._values[at]
        return self._stamps[at] == stamp or (isinstance(value, Log) and value.changed_at(stamp))


class _Tuples(Sequence[tuple[Any, ...]]):
    def __eq__(self, other: object) -> bool:
        if isinstance(other, Sequence) and not isinstance(other, str):
            return len(self) == len(other) and all(a == b for a, b in zip(self, other, strict=True))
        return NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return repr(list(self))


class Emissions(_Tuples):
    """Everything emitted so far, packed by component; safe to read while another thread appends."""

    def __init__(self) -> None:
        self._events = array("I")
        self._kinds: tuple[type | None, ...] | None = None
        self._parts: tuple[Any, ...] = ()
        self._count = 0

    def add(self, item: tuple[Any, ...], events: int) -> None:
        """Append ``item``, emitted after ``events`` line events; ValueError when its length differs."""
        kinds = tuple(map(type, item))
        if kinds != self._kinds and self._kinds != (None,) * len(kinds):
            self._fit(item, kinds)
        try:
            for column, part in zip(self._parts, item, strict=True):
                column.append(part)
        except OverflowError:
            self._parts = tuple(
                [*part[: self._count], value] for part, value in zip(self._parts, item, strict=True)
            )
            self._kinds = (None,) * len(item)
        self._events.append(events)
        self._count += 1

    def _fit(self, item: tuple[Any, ...], kinds: tuple[type, ...]) -> None:
        if self._kinds is None:
            self._parts = tuple(array(_CODES[kind]) if kind in _CODES else [] for kind in kinds)
            self._kinds = tuple(kind if kind in _CODES else None for kind in kinds)
        elif len(kinds) != len(self._parts):
            raise ValueError(f"{item!r} was emitted after tuples of {len(self._parts)} values.")
        else:
            fits = [old is None or old is kind for old, kind in zip(self._kinds, kinds, strict=True)]
            self._parts = tuple(
                part if fit else list(part) for part, fit in zip(self._parts, fits, strict=True)
            )
            self._kinds = tuple(old if fit else None for old, fit in zip(self._kinds, fits, strict=True))

    def __len__(self) -> int:
        return self._count

    @overload
    def __getitem__(self, index: int) -> tuple[Any, ...]: ...
    @overload
    def __getitem__(self, index: slice) -> list[tuple[Any, ...]]: ...
    def __getitem__(self, index: int | slice) -> Any:
        if isinstance(index, slice):
            first, last, step = index.indices(self._count)
            return list(zip(*(part[first:last:step] for part in self._parts), strict=True))
        if not -self._count <= index < self._count:
            raise IndexError(index)
        index %= self._count
        return tuple(part[index] for part in self._parts)

    def count_at(self, event: int) -> int:
        """How many were emitted before the line of ``event`` ran."""
        return bisect_right(self._events, event)

    def events(self, first: int = 0, last: int | None = None) -> NDArray[np.uint32]:
        """(n,) number of line events before each emission."""
        return np.frombuffer(self._events[first : self._count if last is None else last], np.uint32)

    def array(self, first: int = 0, last: int | None = None) -> NDArray[Any]:
        """(n, k) array of emissions ``first`` to ``last`` (left out): integers, or floats if any is one."""
        last = self._count if last is None else min(last, self._count)
        if not self._parts:
            return np.empty((0, 0), np.int64)
        return np.stack([np.array(part[first:last]) for part in self._parts], axis=-1)


class EmittedSoFar(_Tuples):
    """The first ``count`` emissions, without a copy."""

    __slots__ = ("_all", "_count")

    def __init__(self, emissions: Emissions, count: int) -> None:
        self._all = emissions
        self._count = count

    def __len__(self) -> int:
        return self._count

    @overload
    def __getitem__(self, index: int) -> tuple[Any, ...]: ...
    @overload
    def __getitem__(self, index: slice) -> list[tuple[Any, ...]]: ...
    def __getitem__(self, index: int | slice) -> Any:
        if isinstance(index, slice):
            first, last, step = index.indices(self._count)
            return (
                [self._all[at] for at in range(first, last, step)] if step < 0 else self._all[first:last:step]
            )
        if not -self._count <= index < self._count:
            raise IndexError(index)
        return self._all[index % self._count]
