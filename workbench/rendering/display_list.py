"""A sheet as a display list: what a random-scan tube draws, one stroke after the other.

Strokes are in device coordinates (pixels, float, not rounded: a vector tube has no pixels), in one view after
the other, clipped to its viewport and its clip window. Of a filled polygon, circle or ellipse the outline is
drawn.
"""

import itertools
import math
from typing import NamedTuple

import numpy as np

from workbench.document.model import (
    AnyFigure,
    Circle,
    Ellipse,
    Sheet,
)
from workbench.language import _
from workbench.rendering.clipping import clip_box, ring_strokes, visible_rings, visible_segments
from workbench.rendering.limits import reach
from workbench.rendering.mapping import Box, box, device_radii, figure_map
from workbench.rendering.pipeline import colour_of, fills
from workbench.rendering.rounds import Lines, is_area, is_lines
from workbench.rendering.segments import Segment, Segments, cut

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


def _ellipse_chords(
    xc: float, yc: float, rx: float, ry: float, flatness: float, bounds: Box
) -> list[Segment]:
    """Those chords of an ellipse that may reach into ``bounds``, as few as a large one has there."""
    largest = max(rx, ry)
    # The sagitta of a chord over the angle a is r (1 - cos(a / 2)) = 2 r sin(a / 4)^2.
    half_angle = 2.0 * math.asin(math.sqrt(flatness / (2.0 * largest))) if largest > flatness else math.pi / 8
    count = max(8, 4 * math.ceil(math.pi / (4.0 * half_angle)))

    def point(number: int) -> tuple[float, float]:
        angle = 2 * math.pi * (number % count) / count
        return xc + rx * math.cos(angle), yc + ry * math.sin(angle)

    per_angle = count / (2 * math.pi)
    seen = {
        number % count
        for begin, end in _arcs(xc, yc, rx, ry, bounds)
        for number in range(math.floor(begin * per_angle) - 1, math.ceil(end * per_angle) + 1)
    }
    return [(*point(number), *point(number + 1)) for number in sorted(seen)]


def _arcs(xc: float, yc: float, rx: float, ry: float, bounds: Box) -> list[tuple[float, float]]:
    """The stretches of angle, radians from 0 to 2 pi, in which an ellipse lies in ``bounds``."""
    xmin, ymin, xmax, ymax = bounds
    full = 2 * math.pi
    cuts = {0.0, full}
    for edge in (xmin, xmax):
        if abs(edge - xc) < rx:
            angle = math.acos((edge - xc) / rx)
            cuts |= {angle, full - angle}
    for edge in (ymin, ymax):
        if abs(edge - yc) < ry:
            angle = math.asin((edge - yc) / ry)
            cuts |= {angle % full, math.pi - angle}
    arcs = []
    for begin, end in itertools.pairwise(sorted(cuts)):
        x, y = xc + rx * math.cos((begin + end) / 2), yc + ry * math.sin((begin + end) / 2)
        if xmin <= x <= xmax and ymin <= y <= ymax:
            arcs.append((begin, end))
    return arcs


def _outline(sheet: Sheet, figure: AnyFigure, flatness: float, bounds: Box) -> list[Segment]:
    if is_area(figure):
        return [stroke for ring in visible_rings(sheet, [figure])[0] for stroke in ring_strokes(ring)]
    scale = figure_map(sheet, figure)
    if isinstance(figure, Circle | Ellipse) and figure.points_world:
        centre = scale.point(figure.points_world[0].x, figure.points_world[0].y)
        return _ellipse_chords(*centre, *device_radii(sheet, figure), flatness, bounds)
    return []


def _segments(sheet: Sheet, flatness: float, bounds: Box) -> Segments:
    """What the visible figures of a sheet are made of, and the index of the figure each segment is of."""
    lines: list[tuple[int, Lines]] = []
    rows: list[Segment] = []
    of: list[int] = []
    for index, figure in enumerate(sheet.figures):
        if figure.visible and is_lines(figure):
            lines.append((index, figure))
        elif figure.visible:
            rows += _outline(sheet, figure, flatness, bounds)
            of += [index] * (len(rows) - len(of))
    straight = visible_segments(sheet, [figure for _index, figure in lines])
    indexes = np.array([index for index, _figure in lines], np.int64)
    table = np.concatenate([straight.table, np.array(rows, np.float64).reshape(-1, 4)])
    whose = np.concatenate([indexes[straight.of], np.array(of, np.int64)])
    order = np.argsort(whose, kind="stable")
    return Segments(table[order], whose[order])


def _bounds(sheet: Sheet) -> Box:
    """What of the viewport, within reach of the picture, the clip window leaves."""
    view, near = box(sheet.first_view.viewport_device), reach(sheet.width_px, sheet.height_px)
    boxes = [view, near, clip_box(sheet) or view]
    xmin, ymin = (max(each[side] for each in boxes) for side in (0, 1))
    xmax, ymax = (min(each[side] for each in boxes) for side in (2, 3))
    return xmin, ymin, xmax, ymax


def display_list(sheet: Sheet, flatness_px: float = FLATNESS_PX) -> list[Stroke]:
    """The strokes of every visible figure from back to front; a seed fill has none (see ``unshown``)."""
    return [stroke for seen in sheet.seen for stroke in _in_one_view(seen, flatness_px)]


def seen_segments(sheet: Sheet, flatness_px: float = FLATNESS_PX) -> Segments:
    """The strokes as segments, those of one view after those of another, and of which figures they are."""
    views = [_seen_in_one_view(seen, flatness_px) for seen in sheet.seen]
    return Segments(*(np.concatenate(columns) for columns in zip(*views, strict=True)))


def _seen_in_one_view(sheet: Sheet, flatness: float) -> Segments:
    bounds = _bounds(sheet)
    return cut(_segments(sheet, flatness, bounds), bounds)


def _in_one_view(sheet: Sheet, flatness: float) -> list[Stroke]:
    seen = _seen_in_one_view(sheet, flatness)
    colours = np.array([colour_of(sheet, figure) for figure in sheet.figures], np.int64)[seen.of]
    columns = *seen.table.T.tolist(), colours.tolist(), seen.of.tolist()
    return list(map(Stroke._make, zip(*columns, strict=True)))


def unshown(sheet: Sheet) -> list[tuple[str, str]]:
    """Id of every visible figure that a vector tube cannot show, with the sentence that says why."""
    reason = _(
        "A vector tube draws strokes and has no memory of areas, so the seed fill is missing here. "
        "Look at it on the raster tube."
    )
    return [(f.id, reason) for f in sheet.figures if f.visible and fills(f)]
