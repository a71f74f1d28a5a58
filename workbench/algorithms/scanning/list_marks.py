"""What is drawn of the run of a display list: what the frame has drawn, what is to come, and the beam."""

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import MOST_SPOTS, Mark, Spot, Stroke, Word, along
from workbench.algorithms.scanning.operations import DRAW, MOVE


def list_marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterable[Mark]:
    """The strokes of this frame, those to come, and the beam."""
    strokes = _strokes_of(arguments[0])
    first = max(len(emitted) - MOST_SPOTS // 2, 0)
    for k, ends in enumerate(strokes[first : first + MOST_SPOTS], first):
        if k < len(emitted):
            yield Stroke(ends, "data1", "medium")
        else:
            yield Stroke(ends, "muted", "hair", "dot")
    if ended or "y" not in now:
        return
    if now.get("operation") == MOVE and "y0" in now:
        yield Stroke(along((now["x0"], now["y0"]), (now["x"], now["y"])), "data2", "thin", "dash")
    lit = now.get("operation") == DRAW
    yield Spot(now["x"], now["y"], "accent", "dot" if lit else "ring", "large")
    if "address" in now:
        yield Word(str(now["address"]), now["x"], now["y"], "accent", 1, 1, carded=True)


def _strokes_of(program: NDArray[Any]) -> list[NDArray[np.float64]]:
    """The ends (2, 2) of everything that the list draws; the beam begins where it ends."""
    places = np.asarray(program, np.float64)[:, 1:3]
    return [np.stack([places[k - 1], places[k]]) for k in np.flatnonzero(program[:, 0] == DRAW)]
