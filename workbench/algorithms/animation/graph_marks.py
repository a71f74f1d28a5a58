"""What is drawn of a value over the frames: its keys and how it has gone so far."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import MOST_SPOTS, Mark, Points, Spot, Stroke


def graph_marks(keys: Points, emitted: NDArray[np.float64]) -> Iterator[Mark]:
    """The ``keys`` (n, 2) and what is ``emitted`` (m, 2) so far, as (frame, value), the last one ringed."""
    yield Stroke(keys, "muted", "hair", "dash")
    if len(emitted) > 1:
        yield Stroke(np.asarray(emitted, np.float64), "data1", "medium")
    if len(emitted) <= MOST_SPOTS:
        for frame, value in emitted.tolist():
            yield Spot(frame, value, "data1", "dot", "small")
    for frame, value in keys.tolist() if len(keys) <= MOST_SPOTS else ():
        yield Spot(frame, value, "text", "square", "medium")
    if len(emitted):
        frame, value = emitted[-1].tolist()
        yield Spot(frame, value, "accent", "ring", "large")
