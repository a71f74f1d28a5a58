"""A sheet as a frame buffer: in one view after the other every figure scan converted, from back to front.

What is not said to be of all views is of the first.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from itertools import groupby, repeat
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.document.model import AnyFigure, Sheet
from workbench.engine.at_hand import at_hand
from workbench.engine.batches import USE, Calls
from workbench.geometry.conventions import round_half_up
from workbench.rendering.clipping import clip_box
from workbench.rendering.emissions import Emitted, emitted
from workbench.rendering.mapping import Call
from workbench.rendering.pipeline import Batch, batches, calls, colour_of, faster, fills, law_holds
from workbench.rendering.rounds import is_area, is_lines

__all__ = [
    "Bounds",
    "Composite",
    "Emitted",
    "arguments",
    "calls_in_views",
    "composite_below",
    "emitted",
    "figure_calls",
    "frame_buffer",
    "painter_of",
    "pixels",
    "seen_bounds",
    "viewport_bounds",
]

Index = NDArray[np.int64]
Bounds = tuple[int, int, int, int]
"""First and last column, first and last row."""


class Composite(NamedTuple):
    """A sheet's picture (h, w), 0xRRGGBB, and the index of the figure that painted each pixel last, or -1."""

    image: NDArray[np.uint32]
    painter: NDArray[np.int32]


def pixels(entry: Entry, rows: Emitted, bounds: Bounds | None = None) -> Index:
    """The pixels (n, 2) as (x, y) in the order in which they were emitted, spans spread out.

    With ``bounds`` spans are cut there first, since those of a large area are long; all else stays whole.
    """
    return _spread(entry, rows, bounds)[0]


def _spread(entry: Entry, rows: Emitted, bounds: Bounds | None) -> tuple[Index, Index]:
    """As ``pixels``, and for each (n,) the number of its row."""
    number = np.arange(len(rows))
    if entry.emits != "spans":
        return rows[:, :2].astype(np.int64), number
    y, left, right = (rows[:, j].astype(np.int64) for j in range(3))
    if bounds is not None:
        x_first, x_last, y_first, y_last = bounds
        seen = (y >= y_first) & (y <= y_last)
        number, y = number[seen], y[seen]
        left, right = np.maximum(left[seen], x_first), np.minimum(right[seen], x_last)
    lengths = np.maximum(right - left + 1, 0)
    starts = np.cumsum(lengths) - lengths
    offsets = np.arange(int(lengths.sum())) - np.repeat(starts, lengths)
    xy = np.column_stack([np.repeat(left, lengths) + offsets, np.repeat(y, lengths)])
    return xy, np.repeat(number, lengths)


def viewport_bounds(sheet: Sheet) -> Bounds:
    """First and last column, first and last row of the pixels whose centres lie in the viewport."""
    view = sheet.first_view.viewport_device
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
    if clip is None or is_lines(figure) or is_area(figure):
        return bounds
    low_x, low_y, high_x, high_y = clip
    return (
        max(bounds[0], math.ceil(low_x)),
        min(bounds[1], math.floor(high_x)),
        max(bounds[2], math.ceil(low_y)),
        min(bounds[3], math.floor(high_y)),
    )


def _blend(image: NDArray[np.uint32], x: Index, y: Index, share: NDArray[Any], colours: Index) -> None:
    mixed = np.zeros(len(share), dtype=np.uint32)
    for shift in (16, 8, 0):
        old, over = ((value >> shift) & 0xFF for value in (image[y, x], colours))
        mixed |= np.floor(old + share * (over - old.astype(float)) + 0.5).astype(np.uint32) << np.uint32(
            shift
        )
    image[y, x] = mixed


class _Stretch(NamedTuple):
    """Calls of a batch, from ``first`` to before ``last``, of figures that nothing else lies between.

    ``entry`` paints them: that of the batch, or a faster one whose law holds for all of these calls.
    """

    batch: Batch
    entry: Entry
    colours: Index
    numbers: Index
    bounds: Bounds
    first: int
    last: int


def _stretches(sheet: Sheet, numbers: Sequence[int]) -> Iterator[_Stretch | int]:
    """What paints figures of these numbers, from back to front; of a figure that fills, its number."""
    figures = [sheet.figures[k] for k in numbers]
    laid_out = batches(sheet, figures)
    # Number of a figure, of its batch, of its first call and one past its last.
    order = [(k, -1, 0, 0) for k, figure in zip(numbers, figures, strict=True) if fills(figure)]
    whole: list[_Stretch] = []
    lawful: list[NDArray[np.bool_]] = []
    for batch in laid_out:
        number_of = np.array(numbers)[batch.of]
        starts = np.flatnonzero(np.diff(number_of, prepend=-1))
        owners = number_of[starts].tolist()
        colours = np.array([colour_of(sheet, sheet.figures[k]) for k in owners], np.int64)
        counts = np.diff(starts, append=len(number_of))
        bounds = seen_bounds(sheet, sheet.figures[owners[0]]) if owners else (0, 0, 0, 0)
        each = np.repeat(colours, counts)
        whole.append(_Stretch(batch, batch.entry, each, number_of, bounds, 0, len(number_of)))
        lawful.append(law_holds(batch))
        ends = (starts + counts).tolist()
        order += zip(owners, repeat(len(whole) - 1), starts.tolist(), ends, strict=False)
    order.sort()
    for number, group in groupby(order, key=itemgetter(1)):
        first, *rest = group
        if number < 0:
            yield from (figure for figure, *_calls in (first, *rest))
        else:
            start, end = first[2], (rest or [first])[-1][3]
            entry = whole[number].entry
            if entry.drawn_by is not None and lawful[number][start:end].all():
                entry = catalogue.get(entry.drawn_by.slug)
            yield whole[number]._replace(entry=entry, first=start, last=end)


def _paint(sheet: Sheet, numbers: Sequence[int], onto: Composite) -> None:
    """Paint the figures of these numbers, from back to front."""
    painters: dict[tuple[int, str], Callable[[int, int], None]] = {}
    for stretch in _stretches(sheet, numbers):
        if isinstance(stretch, int):
            _fill(sheet, stretch, onto)
            continue
        batch, entry, colours, figures, bounds, first, last = stretch
        if at_hand(entry.function, USE):
            painter = id(batch), entry.slug
            if painter not in painters:
                compiled = Calls.of(entry.function, colours, figures, batch.values)
                painters[painter] = compiled.painter(*onto, bounds)
            painters[painter](first, last)
        else:
            rows = [emitted(call._replace(entry=entry)) for call in batch.calls(first, last)]
            _put(entry, rows, colours[first:last], figures[first:last], bounds, onto)


def _fill(sheet: Sheet, number: int, onto: Composite) -> None:
    """Paint a figure that reads what lies below it."""
    figure = sheet.figures[number]
    for call in map(faster, calls(sheet, figure, below=onto.image)):
        colour, bounds = colour_of(sheet, figure), seen_bounds(sheet, figure)
        at_once = call.entry.at_once
        if at_once is None or at_hand(call.entry.function, "collect"):
            _put(call.entry, [emitted(call)], np.array([colour]), np.array([number]), bounds, onto)
            continue
        x_first, x_last, y_first, y_last = bounds
        area = slice(max(y_first, 0), max(y_last + 1, 0)), slice(max(x_first, 0), max(x_last + 1, 0))
        where = at_once(*call.arguments)[area]
        onto.image[area][where] = colour
        onto.painter[area][where] = number


def _put(
    entry: Entry, parts: list[Emitted], colours: Index, numbers: Index, bounds: Bounds, onto: Composite
) -> None:
    """Paint what calls have emitted, one after the other, each in its colour and for the figure it is of."""
    x_first, x_last, y_first, y_last = bounds
    rows: Any = np.concatenate(parts)
    xy, row = _spread(entry, rows, bounds)
    x, y = xy.T
    of = np.repeat(np.arange(len(parts)), [len(part) for part in parts])[row]
    inside = (x >= x_first) & (x <= x_last) & (y >= y_first) & (y <= y_last)
    if not inside.all():
        x, y, row, of = x[inside], y[inside], row[inside], of[inside]
    if entry.emits == "coverage":
        for turn in _turns(x, y, of):
            _blend(onto.image, x[turn], y[turn], rows[row[turn], 2], colours[of[turn]])
    else:
        onto.image[y, x] = colours[of]
    onto.painter[y, x] = numbers[of]


def _turns(x: Index, y: Index, of: Index) -> list[Index]:
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
    """The picture in the first view made of the first ``count`` figures."""
    return _below(sheet.seen[:1], count)


def _below(seen: Sequence[Sheet], count: int) -> Composite:
    """The picture made in all of some views, in the last of them by the first ``count`` figures only."""
    onto = _empty(seen[0])
    for sheet in seen:
        figures = sheet.figures if sheet is not seen[-1] else sheet.figures[:count]
        _paint(sheet, [k for k, figure in enumerate(figures) if figure.visible], onto)
    return onto


@lru_cache(maxsize=4)
def _composite(sheet: Sheet) -> Composite:
    whole = _below(sheet.seen, len(sheet.figures))
    for array in whole:
        array.setflags(write=False)
    return whole


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
    """The calls that draw a figure where it stands on its sheet, in all views one after the other.

    A seed fill gets what lies below it.
    """
    return [call for calls_ in calls_in_views(sheet, figure, algorithm) for call in calls_]


def calls_in_views(sheet: Sheet, figure: AnyFigure, algorithm: str | None = None) -> list[list[Call]]:
    """As ``figure_calls``, for each view by itself."""
    seen = sheet.seen
    if not fills(figure):
        return [calls(each, figure, algorithm) for each in seen]
    place = sheet.figures.index(figure) if figure in sheet.figures else len(sheet.figures)
    return [calls(each, figure, algorithm, _below(seen[: k + 1], place).image) for k, each in enumerate(seen)]
