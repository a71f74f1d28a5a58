"""Clipping before scan conversion: a sheet's clip window, and the chosen clippers at work on its figures.

Coordinates are those of the device, not rounded. Lines and polygons are clipped by the texts of the
catalogue; the pixels of all other figures are left out where their centres lie outside the window.
"""

from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.document.model import AnyFigure, Circle, Curve, Line, Polygon, Polyline, Sheet
from workbench.geometry.conventions import round_half_up
from workbench.rendering.limits import clip_ring, clip_segment, reach
from workbench.rendering.mapping import Box, Call, device_map, device_rings
from workbench.rendering.segments import (
    Lines,
    Segment,
    Table,
    clipped_segment,
    clipped_table,
    cut_table,
    few,
    few_segments,
    rounded,
    segment_table,
)

__all__ = [
    "Segment",
    "clip_box",
    "clipped_segment",
    "clipper_calls",
    "clipper_of",
    "line_ends",
    "line_table",
    "polygon_values",
    "ring_strokes",
    "segments_of",
    "visible_rings",
    "visible_segments",
]

Ring = NDArray[np.float64]


def clip_box(sheet: Sheet) -> Box | None:
    """The clip window (xmin, ymin, xmax, ymax) in device coordinates; None where nothing is clipped."""
    if sheet.clip_world is None:
        return None
    scale, window = device_map(sheet), sheet.clip_world
    x0, y0 = scale.point(window.xmin, window.ymin)
    x1, y1 = scale.point(window.xmax, window.ymax)
    return min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1)


def clipper_of(sheet: Sheet, figure: AnyFigure) -> str:
    """The slug of the algorithm that clips this figure, a circle of radius 0 as a point; empty for none."""
    if isinstance(figure, Line | Polyline | Curve):
        return sheet.line_clipper
    if isinstance(figure, Circle) and figure.radius_world == 0:
        return "clip_point"
    return sheet.polygon_clipper if isinstance(figure, Polygon) else ""


def clipper_calls(sheet: Sheet, figure: AnyFigure, clipper: str | None = None) -> list[Call]:
    """The runs that clip a figure, one per segment, ring or point, by the sheet's clipper or by another.

    None for figures that are clipped pixel by pixel, or without a clip window. Raises LookupError when the
    catalogue has no such algorithm.
    """
    window, slug = clip_box(sheet), clipper or clipper_of(sheet, figure)
    if window is None or not slug:
        return []
    entry = catalogue.get(slug)
    if isinstance(figure, Line | Polyline | Curve):
        return [Call(entry, (*segment, *window)) for segment in segments_of(sheet, figure)]
    if isinstance(figure, Polygon):
        return [Call(entry, (ring, *window)) for ring in device_rings(sheet, figure)]
    scale = device_map(sheet)
    return [Call(entry, (*scale.point(point.x, point.y), *window)) for point in figure.points_world]


def segments_of(sheet: Sheet, figure: Lines) -> list[Segment]:
    """The segments (x0, y0, x1, y1) that a figure is made of, device coordinates."""
    if few(figure):
        return few_segments(sheet, figure)
    return [(x0, y0, x1, y1) for x0, y0, x1, y1 in segment_table(sheet, figure).tolist()]


def visible_segments(sheet: Sheet, figure: Lines, window: Box) -> list[Segment]:
    """What of each segment is left to be drawn and lies in a ``window``, device coordinates."""
    if not few(figure):
        return [
            (x0, y0, x1, y1) for x0, y0, x1, y1 in cut_table(visible_table(sheet, figure), window).tolist()
        ]
    clip, found = clip_box(sheet), few_segments(sheet, figure)
    if clip is not None:
        found = [part for segment in found for part in clipped_segment(sheet.line_clipper, segment, clip)]
    parts = (clip_segment(*segment, *window) for segment in found)
    return [part for part in parts if part is not None]


def visible_table(sheet: Sheet, figure: Lines) -> Table:
    """What of each segment (n, 4) is left to be drawn, device coordinates."""
    window, table = clip_box(sheet), segment_table(sheet, figure)
    return table if window is None else clipped_table(sheet.line_clipper, table, window)


def visible_rings(sheet: Sheet, figure: Polygon) -> list[Ring]:
    """The rings (n, 2) that are left to be drawn, device coordinates."""
    window = clip_box(sheet)
    if window is None:
        return device_rings(sheet, figure)
    function = catalogue.get(sheet.polygon_clipper).function
    clipped = (list(function(ring, *window)) for ring in device_rings(sheet, figure))
    return [np.array(ring, np.float64) for ring in clipped if len(ring) > 2]


def polygon_values(sheet: Sheet, figure: Polygon) -> dict[str, Any] | None:
    """What a polygon's algorithm is given, by name; None where nothing of it is left.

    What lies far outside the picture is cut off first, since each of its rows would be walked.
    """
    rings = [clip_ring(ring, sheet.width_px, sheet.height_px) for ring in visible_rings(sheet, figure)]
    rings = [ring for ring in rings if len(ring) > 2]
    if not rings:
        return None
    return {
        "vertices": np.concatenate(rings),
        "ring_ends": np.cumsum([len(ring) for ring in rings]).astype(np.int64),
        "closed": figure.closed_interior,
        "nonzero": figure.nonzero,
    }


def line_table(sheet: Sheet, figure: Lines) -> NDArray[np.int64]:
    """The ends (n, 4), rounded, of each segment that a line's algorithm is to draw."""
    return rounded(cut_table(visible_table(sheet, figure), reach(sheet.width_px, sheet.height_px)))


def line_ends(sheet: Sheet, figure: Lines) -> list[tuple[int, int, int, int]]:
    """The rows of ``line_table``."""
    if not few(figure):
        return [(x0, y0, x1, y1) for x0, y0, x1, y1 in line_table(sheet, figure).tolist()]
    near = visible_segments(sheet, figure, reach(sheet.width_px, sheet.height_px))
    nearest = round_half_up
    return [(nearest(x0), nearest(y0), nearest(x1), nearest(y1)) for x0, y0, x1, y1 in near]


def ring_strokes(ring: Ring) -> list[Segment]:
    """The sides of a ring, back to its first corner."""
    closed = np.concatenate([ring, ring[:1]])
    return [(*a, *b) for a, b in pairwise([(float(x), float(y)) for x, y in closed])]
