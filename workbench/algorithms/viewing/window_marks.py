"""What is drawn of the window-to-viewport transformation of a point.

The ink tells the plane: ``data2`` is for what lies on the device, the others for what lies in the world.
"""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import Ink, Mark, Points, Spot, Stroke, Word, along, closed
from workbench.algorithms.numerals import numeral


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The window with the point, the viewport, and the point's place in it once it is known."""
    x, y, *sides = (float(value) for value in arguments)
    yield Stroke(_frame(*sides[:4]), "data1", "medium")
    yield Stroke(_frame(*sides[4:]), "data2", "medium", "dash")
    yield from _placed("P", x, y, sides[0], sides[1], "data1")
    if len(emitted):
        xv, yv = emitted[-1].tolist()
        yield from _placed("P′", xv, yv, sides[4], sides[5], "data2")


def _placed(name: str, x: float, y: float, left: float, bottom: float, ink: Ink) -> Iterator[Mark]:
    """A point with its coordinates and its distances from the left and lower side of its rectangle."""
    yield Stroke(along((left, y), (x, y)), ink, "thin", "dash")
    yield Stroke(along((x, bottom), (x, y)), ink, "thin", "dash")
    yield Spot(x, y, ink, "dot" if name == "P′" else "ring", "large")
    yield Word(f"{name} ({numeral(x)}, {numeral(y)})", x, y, ink, 1, -1, True, True)


def carried(x: float, y: float, width: float, height: float, ink: Ink) -> Iterator[Mark]:
    """The window with its corner at the origin, and its point, on the way to the viewport."""
    yield Stroke(_frame(0.0, 0.0, width, height), ink, "thin")
    yield Spot(x, y, ink, "dot")


def _frame(xmin: float, ymin: float, xmax: float, ymax: float) -> Points:
    return closed(np.array([(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)], np.float64))
