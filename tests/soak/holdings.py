"""What the process holds, by kind, to tell a leak from what is loaded once and from what the allocator keeps.

Kernels are what is loaded of compiled texts, one for each kind of arguments: each takes half a megabyte or
more for as long as the process lives, so that memory grows with them and then no more.
"""

import ctypes
import functools
import gc
import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from PySide6.QtGui import QImage, QPixmapCache
from PySide6.QtWidgets import QApplication

from workbench.document.weight import weight

_Cache = type(functools.cache(len))
_LIBC = ctypes.CDLL(None) if sys.platform == "linux" else None
_TRIM = getattr(_LIBC, "malloc_trim", None)
_ALLOCATED = getattr(_LIBC, "mallinfo2", None)


class _Mallinfo(ctypes.Structure):
    """``struct mallinfo2`` of the C library."""

    _fields_ = [
        (name, ctypes.c_size_t)
        for name in (
            *("arena", "ordblks", "smblks", "hblks", "hblkhd"),
            *("usmblks", "fsmblks", "uordblks", "fordblks", "keepcost"),
        )
    ]


if _ALLOCATED is not None:
    _ALLOCATED.restype = _Mallinfo


@dataclass(frozen=True, slots=True)
class Holdings:
    """Megabytes where no other unit is said."""

    resident: float  # for itself: pages of library files aside
    allocated: float  # by the C library, in use
    arenas: float  # of the C library, in use or not
    blocks: int  # thousands, of Python
    objects: int  # thousands, of Python, that can hold others and are not frozen
    widgets: int
    kernels: int
    kept: int  # results in all the caches of functions, before those with a bound were emptied
    pictures: float  # in the memories of what is costly to draw
    arrays: float  # all of them, each base once
    images: float  # all pictures of Qt that Python holds

    def __str__(self) -> str:
        return ", ".join(f"{each.name} {getattr(self, each.name):.6g}" for each in fields(self))


def edited(session: Any) -> str:
    """What the document weighs, and what the steps of undo hold beyond it."""
    document, steps = weight(session.document), session.undo_stack
    return f"document {document / 1e6:.1f} MB, undo {steps.held / 1e6:.1f} MB in {steps.count()} steps"


def arenas() -> float:
    """Megabytes that the C library has of the system, in use or not."""
    info = _ALLOCATED() if _ALLOCATED is not None else _Mallinfo()
    return float(info.arena + info.hblkhd) / 1e6


def holdings() -> Holdings:
    """What the process holds now; caches that have a bound are emptied, garbage is collected, and what was
    freed is given back."""
    from workbench import memory

    caches = _caches()
    kept = sum(cache.cache_info().currsize for cache in caches)
    for cache in caches:
        if cache.cache_info().maxsize is not None:
            cache.cache_clear()
    QPixmapCache.clear()
    for _again in range(3):
        gc.collect()
    if _TRIM is not None:
        _TRIM(0)
    with open("/proc/self/statm") as numbers:
        _size, resident, of_files, *_rest = map(int, numbers.read().split())
    info = _ALLOCATED() if _ALLOCATED is not None else _Mallinfo()
    return Holdings(
        (resident - of_files) * os.sysconf("SC_PAGESIZE") / 1e6,
        (info.uordblks + info.hblkhd) / 1e6,
        arenas(),
        sys.getallocatedblocks() // 1000,
        len(gc.get_objects()) // 1000,
        len(QApplication.allWidgets()),
        _kernels(),
        kept,
        sum(each._bytes for each in memory._memories) / 1e6,
        *_arrays_and_images(),
    )


_LEAVES = {str, int, float, bytes, bool, type(None)}  # most of all objects, and they hold nothing


def reached() -> Iterator[Any]:
    """All that Python holds but numbers and texts, each once: also what is hidden from the collector."""
    left: list[Any] = [*gc.get_objects(), *sys.modules.values()]
    seen: set[int] = set()
    for each in left:
        if type(each) not in _LEAVES and id(each) not in seen:
            seen.add(id(each))
            yield each
            left.extend(gc.get_referents(each))


def _arrays_and_images() -> tuple[float, float]:
    arrays = images = 0
    for each in reached():
        if issubclass(type(each), np.ndarray) and each.base is None:
            arrays += each.nbytes
        elif issubclass(type(each), QImage):
            images += each.sizeInBytes()
    return arrays / 1e6, images / 1e6


def _caches() -> list[Any]:
    """The caches of functions, by name, as what is loaded at the beginning is hidden from the collector."""
    modules = [vars(module) for name, module in list(sys.modules.items()) if name.startswith("workbench.")]
    return list({id(c): c for names in modules for c in names.values() if type(c) is _Cache}.values())


def _kernels() -> int:
    """How many compiled readings, one for each kind of arguments, are in memory."""
    from workbench.engine import compiled

    kernels = [
        each
        for kept in gc.get_referents(compiled._kernel)
        if isinstance(kept, dict)
        for each in kept.values()
        if isinstance(each, compiled.Kernel)
    ]
    drivers = [
        value for each in kernels if True in each.modules for value in vars(each.modules[True]).values()
    ]
    return sum(len(driver.overloads) for driver in drivers if hasattr(driver, "overloads"))
