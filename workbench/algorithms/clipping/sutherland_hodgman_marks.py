"""What is drawn of Sutherland and Hodgman's clipping."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.clipping.window_marks import degenerate_marks, edge_mark
from workbench.algorithms.marks import (
    MOST_SPOTS,
    MOST_WORDS,
    Mark,
    Points,
    Region,
    Spot,
    Stroke,
    Word,
    closed,
)


def marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The polygon that this stage takes, what it has handed on so far, the side and the edge it is at."""
    given, *window = arguments
    if not len(given):
        return
    yield Stroke(closed(np.asarray(given, np.float64)), "muted", "hair", "dot")
    if ended or "edge" not in now:
        kept = _points(emitted.tolist() if ended else now.get("polygon", ()))
        if len(kept) > 1:
            yield Region(kept, "data1")
            yield Stroke(closed(kept), "data1", "medium")
            yield from degenerate_marks(kept.tolist(), window)
        return
    polygon, clipped = _points(now["polygon"]), _points(now.get("clipped", ()))
    yield edge_mark(window, now["edge"])
    if len(polygon):
        yield Stroke(closed(polygon), "data2", "thin", "dash")
    if now.get("i", len(polygon)) < len(polygon):
        yield Stroke(polygon[[now["i"] - 1, now["i"]]], "data2", "bold")
    if len(clipped) > 1:
        yield Region(clipped, "data1")
        yield Stroke(clipped, "data1", "medium")
    for number, (x, y) in enumerate(clipped.tolist() if len(clipped) <= MOST_SPOTS else ()):
        yield Spot(x, y, "data1", "square")
        if len(clipped) <= MOST_WORDS:
            yield Word(str(number), x, y, "text", 1, 1)


def _points(corners: Any) -> Points:
    return np.array(corners, np.float64).reshape(-1, 2)
