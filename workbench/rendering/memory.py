"""Arrays that are dear to make, kept by what they are made of: those asked for last, up to a size."""

from collections import OrderedDict
from collections.abc import Callable, Hashable
from threading import Lock
from typing import Any

from numpy.typing import NDArray

_BESIDE = 600
"""Bytes that one array takes beside its numbers: its key, and its place here."""


class Memory:
    """Arrays by key, read-only, together no larger than ``most_bytes``; for several threads."""

    def __init__(self, most_bytes: int) -> None:
        self._most = most_bytes
        self._kept: OrderedDict[Hashable, NDArray[Any]] = OrderedDict()
        self._bytes = 0
        self._lock = Lock()

    def get(self, key: Hashable, make: Callable[[], NDArray[Any]]) -> NDArray[Any]:
        """The array of this key, made now if it is not there."""
        with self._lock:
            kept = self._kept.get(key)
            if kept is not None:
                self._kept.move_to_end(key)
                return kept
        array = make()
        array.setflags(write=False)
        with self._lock:
            before = self._kept.pop(key, None)  # another thread may have been faster
            self._bytes += _size(array) - (0 if before is None else _size(before))
            self._kept[key] = array
            while self._bytes > self._most and len(self._kept) > 1:
                self._bytes -= _size(self._kept.popitem(last=False)[1])
        return array

    def clear(self) -> None:
        """Forget all."""
        with self._lock:
            self._kept.clear()
            self._bytes = 0


def _size(array: NDArray[Any]) -> int:
    return array.nbytes + _BESIDE
