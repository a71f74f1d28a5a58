"""The window that is clipped to, and the line of the course's example, as the clipping texts take them; and
what holds of every text that clips lines.

A point on the window's edge is inside. A window without area, a polygon of fewer than three points and
numbers that are not finite are refused before they come here, by the document's check; the command line
refuses the numbers alone. The texts come to an end on such windows and polygons too, and on a line of no
length.
"""

import math
from random import Random
from typing import Any

import numpy as np

from workbench.algorithms.entry import Parameter

_LOW, _HIGH = -1e12, 1e12

# Polylines and curves are clipped as the segments that they are made of.
LINES = ("line", "polyline", "curve")

WINDOW = (
    Parameter("xmin", "x_{min}", "float", 0.0, _LOW, _HIGH, "px", "left edge of the window"),
    Parameter("ymin", "y_{min}", "float", 0.0, _LOW, _HIGH, "px", "bottom edge of the window"),
    Parameter("xmax", "x_{max}", "float", 30.0, _LOW, _HIGH, "px", "right edge of the window"),
    Parameter("ymax", "y_{max}", "float", 20.0, _LOW, _HIGH, "px", "top edge of the window"),
)

LINE = (
    Parameter("x0", "x_0", "float", 10.0, _LOW, _HIGH, "px", "first end point, column"),
    Parameter("y0", "y_0", "float", 30.0, _LOW, _HIGH, "px", "first end point, row"),
    Parameter("x1", "x_1", "float", 40.0, _LOW, _HIGH, "px", "second end point, column"),
    Parameter("y1", "y_1", "float", 0.0, _LOW, _HIGH, "px", "second end point, row"),
)

POINT = (
    Parameter("x", "x", "float", 12.0, _LOW, _HIGH, "px", "column of the point"),
    Parameter("y", "y", "float", 20.0, _LOW, _HIGH, "px", "row of the point"),
)

NO_LINE_LAW = (
    "A line that passes a corner of the window by less than a rounding is told rightly: it may be lost, "
    "or found though it misses."
)


def window(chance: Random) -> tuple[float, float, float, float]:
    """A window on whole numbers; of two one has no area."""
    xmin, ymin = float(chance.randint(-9, 9)), float(chance.randint(-9, 9))
    width, height = chance.randint(1, 12), chance.randint(1, 12)
    match chance.randint(0, 5):
        case 0:
            width = 0
        case 1:
            height = 0
        case 2:
            width = height = 0
    return xmin, ymin, xmin + width, ymin + height


def point_and_window(chance: Random) -> tuple[float, ...]:
    """A point, often on an edge of the window or a digit beside it."""
    box = window(chance)
    return *_near(chance, box), *box


def line_and_window(chance: Random) -> tuple[float, ...]:
    """A line with such ends; some have no length, some pass through a corner, some run along an edge."""
    box = window(chance)
    start, end = _near(chance, box), _near(chance, box)
    match chance.randint(0, 5):
        case 0:
            end = start
        case 1:
            corner = chance.choice(box[::2]), chance.choice(box[1::2])
            end = 2.0 * corner[0] - start[0], 2.0 * corner[1] - start[1]
        case 2:
            end = end[0], start[1]
        case 3:
            end = start[0], end[1]
    return *start, *end, *box


def polygon_and_window(chance: Random) -> tuple[Any, ...]:
    """A polygon of up to seven such corners; of none, one or two points too."""
    box = window(chance)
    corners = [_near(chance, box) for _corner in range(chance.randint(0, 7))]
    return np.array(corners, np.float64).reshape(-1, 2), *box


def _near(chance: Random, box: tuple[float, float, float, float]) -> tuple[float, float]:
    return _beside(chance, box[0], box[2]), _beside(chance, box[1], box[3])


def _beside(chance: Random, low: float, high: float) -> float:
    edge = chance.choice((low, high))
    match chance.randint(0, 5):
        case 0:
            return edge
        case 1:
            # Beside 0 as far off as beside 1: products of smaller numbers would vanish
            return (
                math.nextafter(edge, chance.choice((-99.0, 99.0)))
                if edge
                else chance.choice((-1, 1)) * 2.0**-52
            )
        case 2:
            return (low + high) / 2
        case 3:
            return chance.uniform(-20.0, 30.0)
    return chance.randint(-36, 36) / chance.choice((1, 4))
