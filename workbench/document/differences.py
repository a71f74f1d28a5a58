"""Where two lists of frozen values differ: what an edit leaves is the same object, and is not looked at."""

from itertools import islice
from operator import is_
from typing import Any


def between(old: tuple[Any, ...], new: tuple[Any, ...]) -> tuple[int, int, int]:
    """(start, old_end, new_end): outside of ``old[start:old_end]`` and ``new[start:new_end]`` all is shared.

    ``old[:start]`` are the objects ``new[:start]``, and ``old[old_end:]`` the objects ``new[new_end:]``.
    """
    if old is new:
        return len(old), len(old), len(new)
    most = min(len(old), len(new))
    start = _shared(map(is_, old, new), most)
    end = _shared(islice(map(is_, reversed(old), reversed(new)), most - start), most - start)
    return start, len(old) - end, len(new) - end


def _shared(same: Any, most: int) -> int:
    """How many of ``same``, ``most`` truths, come before the first that is false."""
    first = bytes(same).find(0)
    return most if first < 0 else first
