"""What an algorithm draws of a step, brought from the frame of its arguments to the device."""

import math
from collections.abc import Iterable

import numpy as np

from workbench.algorithms.marks import Frame, Mark, Matrix, Points, Ray, Region, Spot, Stroke, Word
from workbench.document.model import Sheet
from workbench.rendering.mapping import DeviceMap, device_map

_SAME = DeviceMap(1.0, 1.0, 0.0, 0.0)


def on_device(sheet: Sheet, frame: Frame, marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """The marks in device coordinates, rays as strokes to the edge of the sheet's picture; no matrices.

    The view plane of a scene is its sheet's world, so ``"view"`` is mapped as ``"world"`` is.
    """
    scale = _SAME if frame == "device" else device_map(sheet)
    return tuple(_mapped(sheet, scale, mark) for mark in marks if not isinstance(mark, Matrix))


def _mapped(sheet: Sheet, scale: DeviceMap, mark: Mark) -> Mark:
    match mark:
        case Ray():
            x, y = scale.point(mark.x, mark.y)
            dx, dy = scale.sx * mark.dx, scale.sy * mark.dy
            least = mark.least / math.hypot(mark.dx, mark.dy)
            ahead = max(_way_out(sheet, x, y, dx, dy), least)
            back = max(_way_out(sheet, x, y, -dx, -dy), least) if mark.both_ways else 0.0
            ends = np.array([(x - back * dx, y - back * dy), (x + ahead * dx, y + ahead * dy)], np.float64)
            return Stroke(ends, mark.ink, mark.weight, mark.pattern)
        case Stroke() | Region() if scale is not _SAME:
            points: Points = scale.points(mark.points)
            return mark._replace(points=points)
        case Spot() | Word() if scale is not _SAME:
            x, y = scale.point(mark.x, mark.y)
            return mark._replace(x=x, y=y)
    return mark


def _way_out(sheet: Sheet, x: float, y: float, dx: float, dy: float) -> float:
    """How many times (dx, dy) it is from a place to the edge of the picture; 0 where that lies behind."""
    ways = [
        ((size - 0.5 if step > 0.0 else -0.5) - at) / step
        for at, step, size in ((x, dx, sheet.width_px), (y, dy, sheet.height_px))
        if step != 0.0
    ]
    return max(min(ways), 0.0)
