"""A sheet as a display list: what a random-scan tube draws, one stroke after the other.

Strokes are in device coordinates (pixels, float, not rounded: a vector tube has no pixels), clipped to the
viewport and to the clip window. Of a filled polygon, circle or ellipse the outline is drawn.
"""

import itertools
import math
from typing import NamedTuple

import numpy as np

from workbench.document.model import (
    AnyFigure,
    Circle,
    Curve,
    Ellipse,
    Line,
    Polygon,
    Polyline,
    SeedFill,
    Sheet,
)
from workbench.language import _
from workbench.rendering.clipping import clip_box, ring_strokes, visible_rings, visible_segments
from workbench.rendering.mapping import Box, box, device_map, device_radii
from workbench.rendering.pipeline import colour_of
from workbench.rendering.segments import Lines, Segment, Segments, cut

FLATNESS_PX = 0.05
"""Largest distance between a curve and the chords that stand for it."""


class Stroke(NamedTuple):
    """One straight movement of the lit beam, device coordinates in pixels; ``figure`` is an index."""

    x0: float
    y0: float
    x1: float
    y1: float
    colour: int
    figure: int


def _ellipse_chords(xc: float, yc: float, rx: float, ry: float, flatness: float) -> list[Segment]:
    largest = max(rx, ry)
    # The sagitta of a chord over the angle a is r (1 - cos(a / 2)).
    half_angle = math.acos(max(1.0 - flatness / largest, -1.0)) if largest > flatness else math.pi / 8
    count = max(8, 4 * math.ceil(math.pi / (4.0 * half_angle)))
    points = [
        (xc + rx * math.cos(2 * math.pi * k / count), yc + ry * math.sin(2 * math.pi * k / count))
        for k in range(count)
    ]
    points.append(points[0])
    return [(*a, *b) for a, b in itertools.pairwise(points)]


def _outline(sheet: Sheet, figure: AnyFigure, flatness: float) -> list[Segment]:
    if isinstance(figure, Polygon):
        return [stroke for ring in visible_rings(sheet, [figure])[0] for stroke in ring_strokes(ring)]
    scale = device_map(sheet)
    if isinstance(figure, Circle | Ellipse) and figure.points_world:
        centre = scale.point(figure.points_world[0].x, figure.points_world[0].y)
        return _ellipse_chords(*centre, *device_radii(sheet, figure), flatness)
    return []


def _segments(sheet: Sheet, flatness: float) -> Segments:
    """What the visible figures of a sheet are made of, and the index of the figure each segment is of."""
    lines: list[tuple[int, Lines]] = []
    rows: list[Segment] = []
    of: list[int] = []
    for index, figure in enumerate(sheet.figures):
        if figure.visible and isinstance(figure, Line | Polyline | Curve):
            lines.append((index, figure))
        elif figure.visible:
            rows += _outline(sheet, figure, flatness)
            of += [index] * (len(rows) - len(of))
    straight = visible_segments(sheet, [figure for _index, figure in lines])
    indexes = np.array([index for index, _figure in lines], np.int64)
    table = np.concatenate([straight.table, np.array(rows, np.float64).reshape(-1, 4)])
    whose = np.concatenate([indexes[straight.of], np.array(of, np.int64)])
    order = np.argsort(whose, kind="stable")
    return Segments(table[order], whose[order])


def _bounds(sheet: Sheet) -> Box:
    """What of the viewport the clip window leaves; lines and polygons have been clipped to it already."""
    view, clip = box(sheet.viewport_device), clip_box(sheet)
    if clip is None:
        return view
    return max(view[0], clip[0]), max(view[1], clip[1]), min(view[2], clip[2]), min(view[3], clip[3])


def display_list(sheet: Sheet, flatness_px: float = FLATNESS_PX) -> list[Stroke]:
    """The strokes of every visible figure from back to front; a seed fill has none (see ``unshown``)."""
    seen = cut(_segments(sheet, flatness_px), _bounds(sheet))
    colours = np.array([colour_of(sheet, figure) for figure in sheet.figures], np.int64)[seen.of]
    columns = *seen.table.T.tolist(), colours.tolist(), seen.of.tolist()
    return list(map(Stroke._make, zip(*columns, strict=True)))


def unshown(sheet: Sheet) -> list[tuple[str, str]]:
    """Id of every visible figure that a vector tube cannot show, with the sentence that says why."""
    reason = _(
        "A vector tube draws strokes and has no memory of areas, so the seed fill is missing here. "
        "Look at it on the raster tube."
    )
    return [(f.id, reason) for f in sheet.figures if f.visible and isinstance(f, SeedFill)]
