"""Lines, polylines and curves as tables of segments: mapped, clipped and cut all at once.

A row is (x0, y0, x1, y1), device coordinates. What lies inside a window is not changed by clipping, so that
only the others are given to a text, one by one; the rows are the same as if all were, and in the same order.
"""

from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.document.model import Curve, Line, Polyline, Sheet
from workbench.rendering.curves import polyline_of
from workbench.rendering.limits import clip_segment
from workbench.rendering.mapping import Box, device_map

Segment = tuple[float, float, float, float]
Table = NDArray[np.float64]
Lines = Line | Polyline | Curve


FEW = 16
"""Points up to which segments are reckoned one by one, which is sooner done then than to lay out a table."""


def few(figure: Lines) -> bool:
    """Whether a figure has so few segments that no table is made of them."""
    return not isinstance(figure, Curve) and len(figure.points_world) <= FEW


def few_segments(sheet: Sheet, figure: Lines) -> list[Segment]:
    """The rows of ``segment_table`` of a figure that has ``few`` of them."""
    scale = device_map(sheet)
    points = [scale.point(point.x, point.y) for point in figure.points_world]
    if isinstance(figure, Polyline) and figure.closed and len(points) > 2:
        points.append(points[0])
    return [(*a, *b) for a, b in pairwise(points)]


def segment_table(sheet: Sheet, figure: Lines) -> Table:
    """The segments (n, 4) that a figure is made of, not clipped; of a curve the chords that stand for it."""
    if isinstance(figure, Curve):
        return _chain(polyline_of(sheet, figure))
    scale = device_map(sheet)
    points = figure.points_world
    world = np.array([[p.x for p in points], [p.y for p in points]], np.float64)
    corners = np.stack([scale.sx * world[0] + scale.tx, scale.sy * world[1] + scale.ty], axis=1)
    if isinstance(figure, Polyline) and figure.closed and len(corners) > 2:
        corners = np.vstack([corners, corners[:1]])
    return _chain(corners)


def _chain(corners: Table) -> Table:
    """The segments from each corner (n, 2) to the next one."""
    return np.hstack([corners[:-1], corners[1:]]) if len(corners) > 1 else np.empty((0, 4))


def inside(table: Table, window: Box) -> NDArray[np.bool_]:
    """Which segments (n,) have both ends in the window, its edges included."""
    xmin, ymin, xmax, ymax = window
    low, high = np.array([xmin, ymin, xmin, ymin]), np.array([xmax, ymax, xmax, ymax])
    found: NDArray[np.bool_] = np.all((table >= low) & (table <= high), axis=1)
    return found


@lru_cache(maxsize=16_384)
def clipped_segment(slug: str, segment: Segment, window: Box) -> tuple[Segment, ...]:
    """What a line clipper keeps of a segment: one segment or none; remembered."""
    return tuple(
        (float(x0), float(y0), float(x1), float(y1))
        for x0, y0, x1, y1 in catalogue.get(slug).function(*segment, *window)
    )


def clipped_table(slug: str, table: Table, window: Box) -> Table:
    """What a line clipper keeps of each segment (n, 4)."""
    kept = inside(table, window)
    if kept.all():
        return table
    rows: list[Segment] = []
    for whole, segment in zip(kept.tolist(), table.tolist(), strict=True):
        if whole:
            rows.append(segment)
        else:
            rows += clipped_segment(slug, tuple(segment), window)
    return _table(rows)


def cut_table(table: Table, window: Box) -> Table:
    """What of each segment (n, 4) lies in a rectangle; without those of which nothing does."""
    kept = inside(table, window)
    if kept.all():
        return table
    parts = (
        (x0, y0, x1, y1) if whole else clip_segment(x0, y0, x1, y1, *window)
        for whole, (x0, y0, x1, y1) in zip(kept.tolist(), table.tolist(), strict=True)
    )
    return _table([part for part in parts if part is not None])


def rounded(table: Table) -> NDArray[np.int64]:
    """The nearest pixels of both ends (n, 4), by the rule of ``round_half_up``."""
    nearest: NDArray[np.int64] = np.floor(table + 0.5).astype(np.int64)
    return nearest


def _table(rows: list[Segment]) -> Table:
    return np.array(rows, np.float64).reshape(-1, 4)
