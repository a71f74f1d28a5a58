"""A sheet as a frame buffer: every figure scan converted, from back to front.

What a call emits is kept by value (algorithm and arguments), so that moving one figure of a hundred runs one
algorithm. The plain reading serves for short runs and until a kernel is ready; nothing here compiles.
"""

import math
import sys
from collections.abc import Callable, Iterator
from functools import lru_cache
from hashlib import blake2b
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry
from workbench.document.model import AnyFigure, Circle, Sheet
from workbench.engine.limited import collect_limited
from workbench.geometry.conventions import round_half_up
from workbench.rendering.clipping import clip_box, clipper_of
from workbench.rendering.mapping import Call
from workbench.rendering.pipeline import calls, colour_of, fills

Emitted = NDArray[np.float64] | NDArray[np.int64]
Function = Callable[..., Iterator[tuple[Any, ...]]]

Bounds = tuple[int, int, int, int]
"""First and last column, first and last row."""

_LONG_RUN = 4096
"""Emitted pixels from which a compiled kernel is worth its call and the look whether it is ready."""

_MOST_COLUMNS = 3
"""Of a row, as of a span; where nothing is emitted there is no row to tell."""


class Composite(NamedTuple):
    """A sheet's picture (h, w), 0xRRGGBB, and the index of the figure that painted each pixel last, or -1."""

    image: NDArray[np.uint32]
    painter: NDArray[np.int32]


def _expected_length(arguments: tuple[Any, ...]) -> int:
    sizes = [abs(a) for a in arguments if isinstance(a, int)]
    arrays = [a for a in arguments if isinstance(a, np.ndarray)]
    images = [a.size for a in arrays]
    rows = [int(np.ptp(a[:, 1])) for a in arrays if a.dtype == np.float64 and a.ndim == 2 and len(a)]
    return max([4 * size for size in sizes + rows] + images, default=0)


def _run(function: Function, compilable: bool, arguments: tuple[Any, ...], limit: int) -> Emitted:
    given = tuple(a.copy() if isinstance(a, np.ndarray) else a for a in arguments)
    rows: Emitted
    if limit:
        return _as_rows(collect_limited(function, limit, *given).rows)
    if compilable and _expected_length(given) > _LONG_RUN and "numba" in sys.modules:
        from workbench.engine.compiled import collect, ready

        if ready(function, "collect"):
            rows = collect(function, *given, compiling=False)
            return rows
    return _as_rows(list(function(*given)))


def _as_rows(listed: list[tuple[Any, ...]]) -> Emitted:
    return np.array(listed) if listed else np.empty((0, _MOST_COLUMNS), dtype=np.int64)


@lru_cache(maxsize=4096)
def _remembered(function: Function, compilable: bool, arguments: tuple[Any, ...]) -> Emitted:
    rows = _run(function, compilable, arguments, 0)
    rows.setflags(write=False)
    return rows


class _ByContent:
    """An array as a key: equal when its content is."""

    __slots__ = ("array", "digest")

    def __init__(self, array: NDArray[Any]) -> None:
        self.array = array
        self.digest = blake2b(np.ascontiguousarray(array).data, digest_size=16).digest()

    def __hash__(self) -> int:
        return hash(self.digest)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _ByContent) and self.digest == other.digest


@lru_cache(maxsize=64)
def _remembered_on_image(
    function: Function, compilable: bool, arguments: tuple[Any, ...], limit: int
) -> Emitted:
    plain = tuple(a.array if isinstance(a, _ByContent) else a for a in arguments)
    rows = _run(function, compilable, plain, limit)
    rows.setflags(write=False)
    return rows


def emitted(call: Call) -> Emitted:
    """Everything a call emits, one row each; read-only and remembered."""
    function, compilable = call.entry.function, not call.entry.compiles
    if any(isinstance(a, np.ndarray) for a in call.arguments):
        keys = tuple(_ByContent(a.copy()) if isinstance(a, np.ndarray) else a for a in call.arguments)
        return _remembered_on_image(function, compilable, keys, call.recursion_limit)
    return _remembered(function, compilable, call.arguments)


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
    bounds = x_first, x_last, y_first, y_last = seen_bounds(sheet, figure)
    for call in calls(sheet, figure, below=below):
        rows = emitted(call)
        xy = pixels(call.entry, rows, bounds)
        x, y = xy[:, 0], xy[:, 1]
        inside = (x >= x_first) & (x <= x_last) & (y >= y_first) & (y <= y_last)
        if not inside.all():
            x, y, rows = x[inside], y[inside], rows if call.entry.emits == "spans" else rows[inside]
        if call.entry.emits == "coverage":
            _blend(onto.image, x, y, rows[:, 2], colour)
        else:
            onto.image[y, x] = colour
        onto.painter[y, x] = index


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
