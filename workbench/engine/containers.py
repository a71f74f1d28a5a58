"""Lists and small arrays as logs of their changes, one log per object, so that any earlier state can be read.

A *stamp* is twice an event's number; the odd stamp before it belongs to a frame that was left just then.
"""

from array import array
from bisect import bisect_right
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice
from operator import is_
from typing import Any

import numpy as np
from numpy.typing import NDArray

LARGEST_ARRAY = 4096
LARGEST_VIEW = 64
_ATOMS = frozenset((int, float, bool, str, bytes, complex, type(None), range))
_BETWEEN_KEYFRAMES = 256
_CHUNK = 512
_PUSH = 0xFFFFFFFF


@dataclass(frozen=True, slots=True)
class LeftOut:
    """Stands for an array of more than ``LARGEST_ARRAY`` items that can be written, which is not recorded."""

    shape: tuple[int, ...]
    dtype: str

    def __str__(self) -> str:
        return f"{' x '.join(map(str, self.shape))} {self.dtype}"


@lru_cache(maxsize=256)
def _left_out(shape: tuple[int, ...], dtype: np.dtype[Any]) -> LeftOut:
    return LeftOut(shape, str(dtype))


def is_fixed(value: Any) -> bool:
    """Whether ``value`` can never change: a number, a text, a tuple of such."""
    if type(value) in _ATOMS:
        return True
    if isinstance(value, tuple):
        return _ATOMS.issuperset(map(type, value)) or all(map(is_fixed, value))
    return isinstance(value, np.generic | LeftOut)


def snapshot(value: Any) -> Any:
    """``value`` as it is now, sharing nothing that can change; what is no value becomes its text."""
    if is_fixed(value):
        return value
    if isinstance(value, list):
        return [snapshot(item) for item in value]
    if isinstance(value, tuple):
        items = [snapshot(item) for item in value]
        return type(value)._make(items) if hasattr(value, "_make") else tuple(items)
    if isinstance(value, np.ndarray):
        return value.copy() if value.size <= LARGEST_ARRAY else _left_out(value.shape, value.dtype)
    if isinstance(value, dict):
        return {key: snapshot(item) for key, item in value.items()}
    if isinstance(value, set | frozenset):
        return set(value)
    return f"<{type(value).__name__}>"


def _bytes(array: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Its bytes, not copied where they lie one after the other."""
    return np.ascontiguousarray(array).reshape(-1).view(np.uint8)


def same(a: Any, b: Any) -> bool:
    """Equality of snapshots, arrays included; a number and an equal one of another type differ."""
    if a is b:
        return True
    if type(a) is not type(b):
        return False
    if isinstance(a, np.ndarray):
        return bool(a.shape == b.shape and a.dtype == b.dtype and np.array_equal(_bytes(a), _bytes(b)))
    if isinstance(a, list | tuple):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key]) for key in a)
    return bool(a == b)


def _alike(equal: Iterable[bool], most: int) -> int:
    """How many of the first ``most`` are true before one is not."""
    pairs = list(islice(equal, most))
    return pairs.index(False) if False in pairs else most


class Log:
    """The states of one object while names are bound to it; ``read(stamp)`` gives the one of that time."""

    __slots__ = ("_stamps", "bindings", "deep", "object")

    def __init__(self, watched: Any, deep: bool) -> None:
        self.object: Any = watched
        self.deep = deep
        self.bindings = 0
        self._stamps = array("I")

    def check(self, stamp: int) -> None:
        """Record what changed since the last look."""
        raise NotImplementedError

    def store(self, stamp: int, index: Any) -> None:
        """Record that the element at ``index`` may have changed, and nothing else."""
        self.check(stamp)

    def read(self, stamp: int) -> Any:
        """The object's state at ``stamp``; not to be changed by the reader."""
        raise NotImplementedError

    def changed_at(self, stamp: int) -> bool:
        """Whether a change bears exactly this stamp."""
        at = bisect_right(self._stamps, stamp)
        return at > 0 and self._stamps[at - 1] == stamp


class WholeLog(Log):
    """States kept whole: sets, dictionaries, tuples that hold what can change."""

    __slots__ = ("_states",)

    def __init__(self, watched: Any) -> None:
        super().__init__(watched, deep=True)
        self._states = [snapshot(watched)]

    def check(self, stamp: int) -> None:
        state = snapshot(self.object)
        if not same(state, self._states[-1]):
            self._states.append(state)
            self._stamps.append(stamp)

    def read(self, stamp: int) -> Any:
        return self._states[bisect_right(self._stamps, stamp)]


class ListLog(Log):
    """A list as a log of splices with a keyframe every 256; keyframes share chunks that did not change."""

    __slots__ = ("_items", "_keyframes", "_low", "_shadow", "_starts", "_stops")

    def __init__(self, watched: list[Any]) -> None:
        fixed = all(map(is_fixed, watched))
        super().__init__(watched, deep=not fixed)
        self._shadow: list[Any] = list(watched) if fixed else snapshot(watched)
        self._starts = array("I")
        self._stops = array("I")
        self._items: list[Any] = []
        self._low = 0
        self._keyframes: list[list[list[Any]]] = [self._chunks([])]

    def _chunks(self, before: list[list[Any]]) -> list[list[Any]]:
        kept = before[: self._low // _CHUNK]
        self._low = len(self._shadow)
        first = len(kept) * _CHUNK
        return kept + [self._shadow[at : at + _CHUNK] for at in range(first, len(self._shadow), _CHUNK)]

    def _splice(self, stamp: int, start: int, stop: int, items: Any) -> None:
        """Log that [start:stop] became ``items``; with ``stop`` = _PUSH that one item was appended."""
        if len(self._stamps) % _BETWEEN_KEYFRAMES == 0 and self._stamps:
            self._keyframes.append(self._chunks(self._keyframes[-1]))
        if stop == _PUSH:
            self._shadow.append(items)
        else:
            self._shadow[start:stop] = items
            if start < self._low:
                self._low = start
        self._items.append(items)
        self._starts.append(start)
        self._stops.append(stop)
        self._stamps.append(stamp)

    def tail(self, stamp: int, pops: int) -> None:
        """Record what at most ``pops`` pops from the end and some appends did."""
        if self.deep:
            self.check(stamp)
            return
        now, shadow = self.object, self._shadow
        length, known = len(now), len(shadow)
        kept = min(max(known - pops, 0), length)
        while kept < known and kept < length and shadow[kept] is now[kept]:
            kept += 1
        if kept == known:
            if length == known:
                return
            if length == known + 1 and is_fixed(now[-1]):
                self._splice(stamp, known, _PUSH, now[-1])
                return
        self._replace(stamp, kept, known, now[kept:])

    def _replace(self, stamp: int, start: int, stop: int, items: list[Any]) -> None:
        if not all(map(is_fixed, items)):
            self.deep = True
            items = snapshot(items)
        self._splice(stamp, start, stop, tuple(items))

    def store(self, stamp: int, index: Any) -> None:
        now, shadow = self.object, self._shadow
        inside = type(index) is int and -len(now) <= index < len(now)
        if self.deep or not inside or len(now) != len(shadow):
            self.check(stamp)
            return
        if index < 0:
            index += len(now)
        if now[index] is not shadow[index]:
            self._replace(stamp, index, index + 1, now[index : index + 1])

    def check(self, stamp: int) -> None:
        now, shadow = self.object, self._shadow
        if self.deep:
            now = [snapshot(item) for item in now]
            equal: Callable[[Any, Any], bool] = same
        else:
            if len(now) == len(shadow) and all(map(is_, now, shadow)):
                return
            equal = is_
        shorter = min(len(now), len(shadow))
        start = _alike(map(equal, now, shadow), shorter)
        end = _alike(map(equal, reversed(now), reversed(shadow)), shorter - start)
        stop = len(shadow) - end
        if start < stop or len(now) != len(shadow):
            self._replace(stamp, start, stop, now[start : len(now) - end])

    def read(self, stamp: int) -> list[Any]:
        count = bisect_right(self._stamps, stamp)
        frame = min(count // _BETWEEN_KEYFRAMES, len(self._keyframes) - 1)
        state: list[Any] = []
        for chunk in self._keyframes[frame]:
            state.extend(chunk)
        for at in range(frame * _BETWEEN_KEYFRAMES, count):
            if self._stops[at] == _PUSH:
                state.append(self._items[at])
            else:
                state[self._starts[at] : self._stops[at]] = self._items[at]
        return state


class ArrayLog(Log):
    """A small array as the flat indexes and items that changed, with keyframes as large as the changes."""

    __slots__ = ("_bytes", "_indexes", "_items", "_keyframe_counts", "_keyframes")

    def __init__(self, watched: NDArray[Any]) -> None:
        super().__init__(watched, deep=False)
        self._bytes = bytearray(watched.tobytes())
        self._indexes = array("I")
        self._items = bytearray()
        self._keyframes = [bytes(self._bytes)]
        self._keyframe_counts = [0]

    def check(self, stamp: int) -> None:
        now = self.object.tobytes()
        if now == self._bytes:
            return
        dtype = self.object.dtype
        words = np.dtype((np.void, dtype.itemsize))
        changed = np.flatnonzero(np.frombuffer(now, words) != np.frombuffer(self._bytes, words))
        self._keep_frame()
        self._bytes[:] = now
        self._items += np.frombuffer(now, dtype)[changed].tobytes()
        self._indexes.frombytes(changed.astype(np.uint32).tobytes())
        self._stamps.extend([stamp] * len(changed))

    def _keep_frame(self) -> None:
        if len(self._stamps) - self._keyframe_counts[-1] > max(_BETWEEN_KEYFRAMES, self.object.size):
            self._keyframes.append(bytes(self._bytes))
            self._keyframe_counts.append(len(self._stamps))

    def store(self, stamp: int, index: Any) -> None:
        array = self.object
        place = index if type(index) is tuple else (index,)
        if len(place) != array.ndim or not all(
            type(part) is int and -size <= part < size for part, size in zip(place, array.shape, strict=True)
        ):
            self.check(stamp)
            return
        flat = 0
        for part, size in zip(place, array.shape, strict=True):
            flat = flat * size + (part if part >= 0 else part + size)
        item = array[index].tobytes()
        at = flat * len(item)
        if self._bytes[at : at + len(item)] == item:
            return
        self._keep_frame()
        self._bytes[at : at + len(item)] = item
        self._items += item
        self._indexes.append(flat)
        self._stamps.append(stamp)

    def read(self, stamp: int) -> NDArray[Any]:
        count = bisect_right(self._stamps, stamp)
        frame = bisect_right(self._keyframe_counts, count) - 1
        first = self._keyframe_counts[frame]
        dtype, size = self.object.dtype, self.object.dtype.itemsize
        state = np.frombuffer(self._keyframes[frame], dtype).copy()
        state[np.frombuffer(self._indexes[first:count], np.uint32)] = np.frombuffer(
            bytes(self._items[first * size : count * size]), dtype
        )
        return state.reshape(self.object.shape)


def _is_large(value: NDArray[Any]) -> bool:
    """An array of too many items to record, or a row of such a one."""
    whole = value.base if isinstance(value.base, np.ndarray) else value
    return value.size > LARGEST_ARRAY or (value.size > LARGEST_VIEW and whole.size > LARGEST_ARRAY)


def _may_change(value: NDArray[Any]) -> bool:
    """Whether an array, or the one that it is a part of, can be written."""
    return value.flags.writeable or (isinstance(value.base, np.ndarray) and _may_change(value.base))


class Containers:
    """The logs of all lists and arrays that a name of a live frame is bound to."""

    def __init__(self) -> None:
        self._logs: dict[int, Log] = {}
        self._arrays = 0

    def bind(self, value: Any, stamp: int, fresh: bool) -> Any:
        """What a column keeps for ``value``: a log of it; ``fresh`` looks for changes nobody has seen yet."""
        if isinstance(value, np.ndarray) and _is_large(value):
            return _left_out(value.shape, value.dtype) if _may_change(value) else value
        log = self._logs.get(id(value))
        if log is None:
            if isinstance(value, list):
                log = ListLog(value)
            elif isinstance(value, np.ndarray) and not value.dtype.hasobject:
                log = ArrayLog(value)
                self._arrays += 1
            elif isinstance(value, tuple | dict | set):
                log = WholeLog(value)
            else:
                return snapshot(value)
            self._logs[id(value)] = log
        elif fresh:
            log.check(stamp)
        log.bindings += 1
        return log

    def release(self, log: Log) -> None:
        """One name less is bound to the object; after the last one it is forgotten, its states are kept."""
        log.bindings -= 1
        if not log.bindings:
            self._logs.pop(id(log.object), None)
            self._arrays -= isinstance(log, ArrayLog)

    def tail(self, value: Any, stamp: int, pops: int) -> None:
        """A line appended to ``value`` or popped from its end."""
        log = self._logs.get(id(value))
        if isinstance(log, ListLog):
            log.tail(stamp, pops)
        self._check_deep(stamp)

    def store(self, value: Any, stamp: int, index: Any) -> None:
        """A line set the element of ``value`` at ``index``."""
        log = self._logs.get(id(value))
        if log is None or log.deep or (isinstance(log, ArrayLog) and self._arrays > 1):
            self.touch(value, stamp)
        else:
            log.store(stamp, index)
            self._check_deep(stamp)

    def touch(self, value: Any, stamp: int) -> None:
        """A line may have changed ``value``, or what it holds or shows."""
        if isinstance(value, np.ndarray):
            for log in tuple(self._logs.values()):
                if isinstance(log, ArrayLog):
                    log.check(stamp)
            self._check_deep(stamp)
        elif not is_fixed(value):
            own = self._logs.get(id(value))
            if own is None or own.deep:
                for log in tuple(self._logs.values()):
                    log.check(stamp)
            else:
                own.check(stamp)
                self._check_deep(stamp)

    def _check_deep(self, stamp: int) -> None:
        for log in self._logs.values():
            if log.deep:
                log.check(stamp)
