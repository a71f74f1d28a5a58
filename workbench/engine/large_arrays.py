"""Lets the memory of large arrays go back to the system as soon as they are gone."""

import ctypes
import sys

_MMAP_THRESHOLD, _ARENA_MAX = -3, -8  # M_MMAP_THRESHOLD and M_ARENA_MAX of malloc.h
_LARGE = 128 * 2**10
_HEAPS = 2


def give_back_large_arrays() -> None:
    """Take every array of 128 kB or more from the system itself, the others from two heaps for all threads.

    The C library of GNU raises that limit to 32 MB as it goes. What lasts comes to lie in the holes that
    arrays leave, and keeps them from being given back: 40 MB more after 3,000 events of use at a limit of
    2 MB. It also keeps a heap for each thread, in which what is freed between two arrays stays: an hour of
    threads that come and go leaves tens of megabytes. Elsewhere nothing happens.
    """
    if sys.platform == "linux":
        mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
        if mallopt is not None:
            mallopt(_MMAP_THRESHOLD, _LARGE)
            mallopt(_ARENA_MAX, _HEAPS)
