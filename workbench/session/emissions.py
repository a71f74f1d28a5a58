"""Emitted rows as pixels: which were painted, which rows touch one, and where in a run that was."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Emits
from workbench.engine.recording import Recording

_MOST_HITS = 4096
_PIXELS = ("pixels", "coverage", "fragments")


def painted(rows: NDArray[Any], emits: Emits, size: tuple[int, int]) -> NDArray[np.bool_]:
    """(height, width) which pixels the ``rows`` (n, k) paint, in a picture of ``size`` (width, height).

    Points and segments are no pixels and paint nothing.
    """
    width, height = size
    found = np.zeros((height, width), bool)
    if not len(rows):
        return found
    if emits == "spans":
        for y, left, right in rows[:, :3].astype(int):
            if 0 <= y < height:
                found[y, max(left, 0) : max(right + 1, 0)] = True
    elif emits in _PIXELS:
        x, y = rows[:, 0].astype(int), rows[:, 1].astype(int)
        inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        found[y[inside], x[inside]] = True
    return found


def touching(rows: NDArray[Any], emits: Emits, x: int, y: int) -> NDArray[np.int64]:
    """Numbers of the ``rows`` (n, k) that touch the pixel (x, y)."""
    if len(rows) and emits == "spans":
        return np.flatnonzero((rows[:, 0] == y) & (rows[:, 1] <= x) & (x <= rows[:, 2]))
    if len(rows) and emits in _PIXELS:
        return np.flatnonzero((rows[:, 0] == x) & (rows[:, 1] == y))
    return np.zeros(0, np.int64)


def event_touching(recording: Recording, emits: Emits, after: int, x: int, y: int) -> int | None:
    """The next line event behind ``after`` that emits pixel (x, y), or else the first; None without any."""
    hits = touching(recording.emitted.array(), emits, x, y)
    if not len(hits):
        return None
    events = [recording.event_at(int(hit)) for hit in hits[:_MOST_HITS]]
    return next((event for event in events if event > after), events[0])


def event_on_line(recording: Recording, start: int, line: int, function: str = "") -> int | None:
    """The first event from ``start`` on at this line of the source file, in ``function`` if one is named."""
    found = recording.lines[start:] == line
    names = [text.name for text in recording.texts]
    if function and function not in names:  # it is of the run before, whose text is still in sight
        return None
    if function:
        found = found & (recording.codes[start : start + len(found)] == names.index(function))
    return start + int(np.argmax(found)) if found.any() else None
