"""Arrays that are costly to make, kept by what they are made of: those asked for last, up to a size."""

from collections import OrderedDict
from collections.abc import Callable, Hashable, Iterable, Sequence
from functools import partial
from threading import Lock
from typing import Any, Generic, TypeVar
from weakref import WeakSet

from numpy.typing import NDArray

T = TypeVar("T")

_BESIDE = 600
"""Bytes that each array takes beside its numbers: its key, and its place here."""


_memories: "WeakSet[Memory[Any]]" = WeakSet()


def _arrays_of(value: Any) -> Iterable[NDArray[Any]]:
    return value if isinstance(value, tuple) else (value,)


class Memory(Generic[T]):
    """Arrays, or tuples of them, by key: read-only, no larger than ``most_bytes``, for several threads.

    ``arrays_of`` gives those of any other value. The last one stays, whatever its size.
    """

    def __init__(
        self, most_bytes: int, arrays_of: Callable[[T], Iterable[NDArray[Any]]] = _arrays_of
    ) -> None:
        self._arrays_of = arrays_of
        self._most = most_bytes
        self._kept: OrderedDict[Hashable, T] = OrderedDict()
        self._bytes = 0
        self._lock = Lock()
        _memories.add(self)

    def get(self, key: Hashable, make: Callable[[], T]) -> T:
        """What has this key, made now if it is not there."""
        with self._lock:
            kept = self._kept.get(key)
            if kept is not None:
                self._kept.move_to_end(key)
                return kept
        new = make()
        for array in self._arrays_of(new):
            array.setflags(write=False)
        with self._lock:
            if key in self._kept:  # another thread was faster
                self._bytes -= self._size(self._kept[key])
            self._kept[key] = new
            self._bytes += self._size(new)
            while self._bytes > self._most and len(self._kept) > 1:
                self._bytes -= self._size(self._kept.popitem(last=False)[1])
        return new

    def get_all(self, keys: Sequence[Hashable], make: Callable[[list[int]], Iterable[T]]) -> list[T]:
        """What has each of these keys; ``make`` is given the places of all that are not there, at once."""
        with self._lock:
            kept = [self._kept.get(key) for key in keys]
            for key, value in zip(keys, kept, strict=True):
                if value is not None:
                    self._kept.move_to_end(key)
        missing = [k for k, value in enumerate(kept) if value is None]
        made = dict(zip(missing, make(missing), strict=True)) if missing else {}
        return [
            self.get(keys[k], partial(made.__getitem__, k)) if value is None else value
            for k, value in enumerate(kept)
        ]

    def _size(self, value: T) -> int:
        return sum(array.nbytes + _BESIDE for array in self._arrays_of(value))

    def clear(self) -> None:
        """Forget all."""
        with self._lock:
            self._kept.clear()
            self._bytes = 0


def forget() -> None:
    """Forget what every memory keeps, as when the document that it was made of is closed."""
    for memory in list(_memories):
        memory.clear()
