"""Clipping before scan conversion: the clip window of a sheet's first view, and the chosen clippers at work.

Coordinates are those of the device, not rounded. Lines and polygons are clipped by the texts of the
catalogue; the pixels of all other figures are left out where their centres lie outside the window.
"""

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.document.model import LINE_CLIPPERS, POLYGON_CLIPPERS, AnyFigure, Circle, Polygon, Sheet
from workbench.rendering.curves import polylines_of
from workbench.rendering.emissions import emitted
from workbench.rendering.limits import clip_ring, polygon_reach, reach
from workbench.rendering.mapping import Box, Call, device_map, device_rings, figure_map
from workbench.rendering.rounds import Area, Lines, Round, is_area, is_lines
from workbench.rendering.segments import (
    Segment,
    Segments,
    clipped,
    clipped_segment,
    cut,
    rounded,
    segments,
)

__all__ = [
    "Segment",
    "Segments",
    "clip_box",
    "clipped_segment",
    "clipper_calls",
    "clipper_of",
    "clippers_of",
    "drawn_rings",
    "line_ends",
    "ring_strokes",
    "rings_of",
    "segments_of",
    "visible_rings",
    "visible_segments",
]

Ring = NDArray[np.float64]


def clip_box(sheet: Sheet) -> Box | None:
    """The clip window (xmin, ymin, xmax, ymax) in device coordinates; None where nothing is clipped."""
    scale, window = device_map(sheet), sheet.first_view.clip_world
    if window is None:
        return None
    x0, y0 = scale.point(window.xmin, window.ymin)
    x1, y1 = scale.point(window.xmax, window.ymax)
    return min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1)


def clipper_of(sheet: Sheet, figure: AnyFigure) -> str:
    """The slug of the algorithm that clips this figure, a circle of radius 0 as a point; empty for none."""
    if is_lines(figure):
        return sheet.lines_clipped_with
    if is_area(figure):
        return sheet.polygons_clipped_with
    return next(iter(clippers_of(figure)), "")


def clippers_of(figure: AnyFigure) -> tuple[str, ...]:
    """The slugs that can clip this figure, a circle of radius 0 as a point; empty for none."""
    if is_lines(figure):
        return LINE_CLIPPERS
    if isinstance(figure, Circle) and figure.radius_world == 0:
        return catalogue.clipping("point")
    return POLYGON_CLIPPERS if is_area(figure) else ()


def clipper_calls(sheet: Sheet, figure: AnyFigure, clipper: str | None = None) -> list[Call]:
    """The runs that clip a figure, one per segment, ring or point, by the sheet's clipper or by another.

    None for figures that are clipped pixel by pixel, or without a clip window. Raises LookupError when the
    catalogue has no such algorithm.
    """
    window, slug = clip_box(sheet), clipper or clipper_of(sheet, figure)
    if window is None or not slug:
        return []
    entry = catalogue.get(slug)
    if is_lines(figure):
        return [Call(entry, (*segment, *window)) for segment in segments_of(sheet, figure)]
    if is_area(figure):
        return [Call(entry, (ring, *window)) for ring in rings_of(sheet, [figure])[0]]
    scale = figure_map(sheet, figure)
    return [Call(entry, (*scale.point(point.x, point.y), *window)) for point in figure.points_world]


def segments_of(sheet: Sheet, figure: Lines) -> list[Segment]:
    """The segments (x0, y0, x1, y1) that a figure is made of, device coordinates."""
    return [(x0, y0, x1, y1) for x0, y0, x1, y1 in segments(sheet, [figure]).table.tolist()]


def visible_segments(sheet: Sheet, figures: Sequence[Lines]) -> Segments:
    """What of each segment of some figures is left to be drawn, device coordinates."""
    window, whole = clip_box(sheet), segments(sheet, figures)
    return whole if window is None else clipped(sheet.lines_clipped_with, whole, window)


def line_ends(sheet: Sheet, figures: Sequence[Lines]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The ends (n, 4), rounded, of each segment that a line's algorithm is to draw, and whose it is (n,)."""
    near = cut(visible_segments(sheet, figures), reach(sheet.width_px, sheet.height_px))
    return rounded(near.table), near.of


def rings_of(sheet: Sheet, figures: Sequence[Area]) -> tuple[list[Ring], NDArray[np.int64]]:
    """The rings (k, 2) of some figures, device coordinates, and whose each is (n,), ascending."""
    polygons: dict[int, Polygon] = {}
    rounds: dict[int, Round] = {}
    for k, figure in enumerate(figures):
        if isinstance(figure, Polygon):
            polygons[k] = figure
        else:
            rounds[k] = figure
    rings, of = device_rings(sheet, list(polygons.values()))
    if not rounds:
        return rings, of
    rings += [ring[:-1] for ring in polylines_of(sheet, list(rounds.values()))]
    whose = np.append(np.array(list(polygons), np.int64)[of], list(rounds))
    order = np.argsort(whose, kind="stable")
    return [rings[k] for k in order.tolist()], whose[order]


def visible_rings(sheet: Sheet, figures: Sequence[Area]) -> tuple[list[Ring], NDArray[np.int64]]:
    """The rings (k, 2) of some figures that are left to be drawn, device coordinates, and whose each is."""
    rings, of = rings_of(sheet, figures)
    window = clip_box(sheet)
    if window is None:
        return rings, of
    entry = catalogue.get(sheet.polygons_clipped_with)
    return _replaced(rings, of, window, lambda ring: emitted(Call(entry, (ring, *window))).astype(float))


def drawn_rings(sheet: Sheet, figures: Sequence[Area]) -> tuple[list[Ring], NDArray[np.int64]]:
    """The rings that the algorithm of polygons is to fill, and whose each is (n,), ascending.

    What lies far outside the picture is cut off, since each of its rows would be walked.
    """
    size = sheet.width_px, sheet.height_px
    return _replaced(
        *visible_rings(sheet, figures), polygon_reach(*size), lambda ring: clip_ring(ring, *size)
    )


def _replaced(
    rings: list[Ring], of: NDArray[np.int64], window: Box, clip: Callable[[Ring], NDArray[np.float64]]
) -> tuple[list[Ring], NDArray[np.int64]]:
    """Rings with those clipped that do not lie inside a window, which alone are changed; areas only."""
    xmin, ymin, xmax, ymax = window
    whole = [ring for ring in rings if len(ring) > 2]
    kept = of[[len(ring) > 2 for ring in rings]]
    if not whole:
        return whole, kept
    corners = np.concatenate(whole)
    beyond = ((corners < (xmin, ymin)) | (corners > (xmax, ymax))).any(axis=1)
    outside = np.logical_or.reduceat(beyond, np.cumsum([0, *map(len, whole[:-1])])).tolist()
    if not any(outside):
        return whole, kept
    parts = [clip(ring) if out else ring for ring, out in zip(whole, outside, strict=True)]
    areas = [len(ring) > 2 for ring in parts]
    return [ring for ring, area in zip(parts, areas, strict=True) if area], kept[areas]


def ring_strokes(ring: Ring) -> list[Segment]:
    """The sides of a ring, back to its first corner."""
    closed = np.concatenate([ring, ring[:1]])
    return [(*a, *b) for a, b in pairwise([(float(x), float(y)) for x, y in closed])]
