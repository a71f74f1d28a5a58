"""What is drawn of the window-to-viewport transformation of a point.

The ink tells the plane: ``data2`` is for what lies on the device, the others for what lies in the world.
"""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import Ink, Mark, Points, Spot, Stroke, Word, closed


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The window with the point, the viewport, and the point's place in it once it is known."""
    x, y, *sides = (float(value) for value in arguments)
    yield Stroke(_frame(*sides[:4]), "data1", "medium")
    yield Stroke(_frame(*sides[4:]), "data2", "medium", "dash")
    if len(emitted):
        xv, yv = emitted[-1].tolist()
        yield Spot(xv, yv, "data2", "dot")
        yield Word("P′", xv, yv, "data2", 1, 1, True)
    yield Spot(x, y, "data1", "ring")
    yield Word("P", x, y, "data1", -1, 1, True)


def carried(x: float, y: float, width: float, height: float, ink: Ink) -> Iterator[Mark]:
    """The window with its corner at the origin, and its point, on the way to the viewport."""
    yield Stroke(_frame(0.0, 0.0, width, height), ink, "thin")
    yield Spot(x, y, ink, "dot")


def _frame(xmin: float, ymin: float, xmax: float, ymax: float) -> Points:
    return closed(np.array([(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)], np.float64))
