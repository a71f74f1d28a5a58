"""What a frozen value holds in memory beyond another one, of which it may share most."""

from sys import getsizeof
from typing import Any

import msgspec

from workbench.document.differences import between

# Of a longer list so many entries are weighed, evenly spread, and their weight stands for the others. The
# lists within them share this number, but of each at least the second one is weighed.
_MOST, _LEAST = 256, 16


def weight(value: Any, other: Any = None, most: int = _MOST) -> int:
    """Bytes that ``value`` holds and ``other`` does not; of long lists that differ everywhere an estimate."""
    if value is other:
        return 0
    if isinstance(value, msgspec.Struct):
        inner = sum(
            weight(part, known, most)
            for name in value.__struct_fields__
            if (part := getattr(value, name)) is not (known := getattr(other, name, None))
        )
        return getsizeof(value) + inner
    if isinstance(value, tuple):
        return getsizeof(value) + _entries(value, other if isinstance(other, tuple) else (), most)
    return getsizeof(value)


def _entries(values: tuple[Any, ...], others: tuple[Any, ...], most: int) -> int:
    start, end, others_end = between(values, others)
    known = {_name(at, entry): entry for at, entry in enumerate(others[start:others_end], start)}
    step = max(-(-(end - start) // most), 1)
    chosen = range(start, end, step)
    inner = max(most // max(len(chosen), 1), _LEAST)
    total = sum(weight(values[at], known.get(_name(at, values[at])), inner) for at in chosen)
    return total * (end - start) // max(len(chosen), 1)


def _name(at: int, entry: Any) -> Any:
    """What an entry of a list is found by in the other one: its id, or else its place."""
    return getattr(entry, "id", at)
