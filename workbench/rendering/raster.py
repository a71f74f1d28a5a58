"""A sheet as a frame buffer: every figure scan converted, from back to front."""

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry
from workbench.document.model import AnyFigure, Circle, Curve, Line, Polyline, Sheet
from workbench.geometry.conventions import round_half_up
from workbench.rendering.clipping import clip_box, clipper_of
from workbench.rendering.emissions import Emitted, emitted, emitted_by_all
from workbench.rendering.mapping import Call
from workbench.rendering.pipeline import calls, colour_of, fills, line_calls_table
from workbench.rendering.segments import few

__all__ = [
    "Bounds",
    "Composite",
    "Emitted",
    "arguments",
    "composite_below",
    "emitted",
    "figure_calls",
    "frame_buffer",
    "painter_of",
    "pixels",
    "seen_bounds",
    "viewport_bounds",
]

Bounds = tuple[int, int, int, int]
"""First and last column, first and last row."""


class Composite(NamedTuple):
    """A sheet's picture (h, w), 0xRRGGBB, and the index of the figure that painted each pixel last, or -1."""

    image: NDArray[np.uint32]
    painter: NDArray[np.int32]


def pixels(entry: Entry, rows: Emitted, bounds: Bounds | None = None) -> NDArray[np.int64]:
    """The pixels (n, 2) as (x, y) in the order in which they were emitted, spans spread out.

    With ``bounds`` spans are cut there first, since those of a large area are long; all else stays whole.
    """
    if entry.emits != "spans":
        return rows[:, :2].astype(np.int64)
    y, left, right = (rows[:, j].astype(np.int64) for j in range(3))
    if bounds is not None:
        x_first, x_last, y_first, y_last = bounds
        seen = (y >= y_first) & (y <= y_last)
        y, left, right = y[seen], np.maximum(left[seen], x_first), np.minimum(right[seen], x_last)
    lengths = np.maximum(right - left + 1, 0)
    starts = np.cumsum(lengths) - lengths
    offsets = np.arange(int(lengths.sum())) - np.repeat(starts, lengths)
    return np.column_stack([np.repeat(left, lengths) + offsets, np.repeat(y, lengths)])


def viewport_bounds(sheet: Sheet) -> Bounds:
    """First and last column, first and last row of the pixels whose centres lie in the viewport."""
    view = sheet.viewport_device
    x_first, y_first = round_half_up(view.xmin), round_half_up(view.ymin)
    x_last, y_last = round_half_up(view.xmax) - 1, round_half_up(view.ymax) - 1
    return (
        max(x_first, 0),
        min(x_last, sheet.width_px - 1),
        max(y_first, 0),
        min(y_last, sheet.height_px - 1),
    )


def seen_bounds(sheet: Sheet, figure: AnyFigure) -> Bounds:
    """As ``viewport_bounds``; and for a figure whose calls are not clipped, within the clip window."""
    bounds, clip = viewport_bounds(sheet), clip_box(sheet)
    if clip is None or (clipper_of(sheet, figure) and not isinstance(figure, Circle)):
        return bounds
    low_x, low_y, high_x, high_y = clip
    return (
        max(bounds[0], math.ceil(low_x)),
        min(bounds[1], math.floor(high_x)),
        max(bounds[2], math.ceil(low_y)),
        min(bounds[3], math.floor(high_y)),
    )


def _blend(image: NDArray[np.uint32], x: Any, y: Any, coverage: NDArray[Any], colour: int) -> None:
    share = coverage.astype(np.float64)
    mixed = np.zeros(len(share), dtype=np.uint32)
    for shift in (16, 8, 0):
        old = (image[y, x] >> shift) & 0xFF
        mixed |= (np.floor(old + share * (((colour >> shift) & 0xFF) - old.astype(float)) + 0.5)).astype(
            np.uint32
        ) << np.uint32(shift)
    image[y, x] = mixed


def _paint(sheet: Sheet, index: int, figure: AnyFigure, onto: Composite) -> None:
    below = onto.image if fills(figure) else None
    colour = colour_of(sheet, figure)
    bounds = seen_bounds(sheet, figure)
    if isinstance(figure, Line | Polyline | Curve) and not few(figure):
        entry, table = line_calls_table(sheet, figure)
        rows, ends = emitted_by_all(entry, table)
        of = np.repeat(np.arange(len(table)), np.diff(ends, prepend=0))
        _put(entry, rows, of, colour, index, bounds, onto)
        return
    for call in calls(sheet, figure, below=below):
        _put(call.entry, emitted(call), None, colour, index, bounds, onto)


def _put(
    entry: Entry,
    rows: Emitted,
    of: NDArray[np.int64] | None,
    colour: int,
    index: int,
    bounds: Bounds,
    onto: Composite,
) -> None:
    """Paint what was emitted; ``of`` tells for each row which call it is of, None that all are of one."""
    x_first, x_last, y_first, y_last = bounds
    xy = pixels(entry, rows, bounds)
    x, y = xy[:, 0], xy[:, 1]
    inside = (x >= x_first) & (x <= x_last) & (y >= y_first) & (y <= y_last)
    if not inside.all():
        x, y, rows = x[inside], y[inside], rows if entry.emits == "spans" else rows[inside]
        of = None if of is None else of[inside]
    if entry.emits != "coverage":
        onto.image[y, x] = colour
    elif of is None:
        _blend(onto.image, x, y, rows[:, 2], colour)
    else:
        for turn in _turns(x, y, of):
            _blend(onto.image, x[turn], y[turn], rows[turn, 2], colour)
    onto.painter[y, x] = index


def _turns(x: NDArray[np.int64], y: NDArray[np.int64], of: NDArray[np.int64]) -> list[NDArray[np.int64]]:
    """The rows in groups that can be blended at once, one after the other: no pixel twice in one of them.

    A call that comes to a pixel twice blends it once, by the last row, as it does alone.
    """
    if not len(x):
        return []
    order = np.lexsort((np.arange(len(x)), of, x, y))
    xs, ys, calls_ = x[order], y[order], of[order]
    same_pixel = (xs[1:] == xs[:-1]) & (ys[1:] == ys[:-1])
    last = np.append(~(same_pixel & (calls_[1:] == calls_[:-1])), True)
    order, starts = order[last], np.append(True, ~same_pixel)
    group = np.cumsum(starts)[last]
    first = np.searchsorted(group, group)
    rank = np.arange(len(group)) - first
    return [np.sort(order[rank == turn]) for turn in range(int(rank.max()) + 1)]


def _empty(sheet: Sheet) -> Composite:
    shape = sheet.height_px, sheet.width_px
    background = sheet.palette[sheet.background % len(sheet.palette)]
    return Composite(np.full(shape, background, dtype=np.uint32), np.full(shape, -1, dtype=np.int32))


def composite_below(sheet: Sheet, count: int) -> Composite:
    """The picture made of the first ``count`` figures."""
    made = _empty(sheet)
    for index, figure in enumerate(sheet.figures[:count]):
        if figure.visible:
            _paint(sheet, index, figure, made)
    return made


@lru_cache(maxsize=4)
def _composite(sheet: Sheet) -> Composite:
    made = composite_below(sheet, len(sheet.figures))
    for array in made:
        array.setflags(write=False)
    return made


def frame_buffer(sheet: Sheet) -> NDArray[np.uint32]:
    """The sheet's picture, (height_px, width_px), 0xRRGGBB, row 0 at the bottom; the caller's own copy."""
    return _composite(sheet).image.copy()


def painter_of(sheet: Sheet) -> NDArray[np.int32]:
    """For each pixel (h, w) the index of the figure that painted it last, -1 where none did."""
    return _composite(sheet).painter.copy()


def arguments(sheet: Sheet, figure: AnyFigure, algorithm: str | None = None) -> list[tuple[Any, ...]]:
    """The device arguments of each call of the figure's algorithm (a polyline makes several).

    A seed fill gets its own copy of what lies below it on the sheet. Raises LookupError when the catalogue
    has no such algorithm.
    """
    return [call.arguments for call in figure_calls(sheet, figure, algorithm)]


def figure_calls(sheet: Sheet, figure: AnyFigure, algorithm: str | None = None) -> list[Call]:
    """The calls that draw a figure where it stands on its sheet, a seed fill with what lies below it."""
    below = None
    if fills(figure):
        place = sheet.figures.index(figure) if figure in sheet.figures else len(sheet.figures)
        below = composite_below(sheet, place).image
    return calls(sheet, figure, algorithm, below)
