"""What emitted numbers go to. Each sink is a named tuple and one body; the same body serves both readings.

``emit(sink, *values)`` runs the body of the sink's type, here as plain Python, compiled as the overload
that ``compiled`` makes of it. Coordinates are integers in device pixels, pictures are (h, w) arrays.
A sink that may see a long run has a ``stop``. Where ``stopped`` says that it was set, a lowered text returns,
function by function: numba lets go of nothing that a function holds when an exception leaves it.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray


class Nothing(NamedTuple):
    """For a text that writes its picture itself."""


class Collect(NamedTuple):
    """Keeps what is emitted, one tuple after another, while there is room; ``emitted`` counts on."""

    values: NDArray[Any]
    emitted: NDArray[np.int64]
    stop: NDArray[np.uint8]


class Paint(NamedTuple):
    """Paints single pixels, those inside the picture."""

    image: NDArray[Any]
    value: Any


class PaintInside(NamedTuple):
    """Paints single pixels that are known to lie inside the picture."""

    image: NDArray[Any]
    value: Any


class Blend(NamedTuple):
    """Paints single pixels with a coverage: 1 gives ``value``, 0 leaves what is there.

    A picture of 32 bits holds 0xRRGGBB and is mixed channel by channel, any other is mixed as one intensity.
    """

    image: NDArray[Any]
    value: Any


class PaintSpans(NamedTuple):
    """Paints runs of pixels (y, x_left, x_right), both ends included, clipped to the picture."""

    image: NDArray[Any]
    value: Any


class Bounds(NamedTuple):
    """First and last column, first and last row of what is seen; it lies inside the picture."""

    x_first: int
    x_last: int
    y_first: int
    y_last: int


class PaintFigure(NamedTuple):
    """Paints single pixels that are seen, and notes the ``number`` of their figure as their painter."""

    image: NDArray[Any]
    painter: NDArray[np.int32]
    value: Any
    number: Any
    bounds: Bounds


class BlendFigure(NamedTuple):
    """As ``PaintFigure``, for pixels with a coverage; the picture holds 0xRRGGBB."""

    image: NDArray[Any]
    painter: NDArray[np.int32]
    value: Any
    number: Any
    bounds: Bounds


class PaintFigureSpans(NamedTuple):
    """As ``PaintFigure``, for runs of pixels (y, x_left, x_right), both ends included."""

    image: NDArray[Any]
    painter: NDArray[np.int32]
    value: Any
    number: Any
    bounds: Bounds


class Hit(NamedTuple):
    """Keeps the numbers of the emissions that touch the pixel (x, y)."""

    x: int
    y: int
    numbers: NDArray[np.int64]
    emitted: NDArray[np.int64]
    found: NDArray[np.int64]
    stop: NDArray[np.uint8]


class HitSpan(NamedTuple):
    """As ``Hit``, for spans (y, x_left, x_right)."""

    x: int
    y: int
    numbers: NDArray[np.int64]
    emitted: NDArray[np.int64]
    found: NDArray[np.int64]
    stop: NDArray[np.uint8]


class Count(NamedTuple):
    """For the counting text: ``runs`` of each slot, ``visits`` of each block, ``blocks`` of the slots."""

    runs: NDArray[np.int64]
    visits: NDArray[np.int64]
    blocks: NDArray[np.int64]
    emitted: NDArray[np.int64]
    stop: NDArray[np.uint8]


class ProbePixel(NamedTuple):
    """For the probing text: keeps what touched or considered the pixel (x, y).

    ``touches`` (n, 3) get 1 or 0 for emitted or considered, the number of the emission (of the next one, if
    only considered) and the number of the step. ``rows`` tells of each block whether its visits are steps.
    """

    x: int
    y: int
    touches: NDArray[np.int64]
    found: NDArray[np.int64]
    rows: NDArray[np.bool_]
    blocks: NDArray[np.int64]
    steps: NDArray[np.int64]
    emitted: NDArray[np.int64]
    stop: NDArray[np.uint8]


class ProbeSpan(NamedTuple):
    """As ``ProbePixel``, for spans (y, x_left, x_right)."""

    x: int
    y: int
    touches: NDArray[np.int64]
    found: NDArray[np.int64]
    rows: NDArray[np.bool_]
    blocks: NDArray[np.int64]
    steps: NDArray[np.int64]
    emitted: NDArray[np.int64]
    stop: NDArray[np.uint8]


def _nothing(sink: Nothing, *values: Any) -> None:
    pass


def room(sink: Collect, arity: int) -> int:
    """Index at which the next tuple goes, -1 when it is full; counts the tuple."""
    start = sink.emitted[0] * arity
    sink.emitted[0] += 1
    return start if start + arity <= len(sink.values) else -1


def _collect_1(sink: Collect, *values: Any) -> None:
    start = room(sink, 1)
    if start >= 0:
        sink.values[start] = values[0]


def _collect_2(sink: Collect, *values: Any) -> None:
    start = room(sink, 2)
    if start >= 0:
        sink.values[start] = values[0]
        sink.values[start + 1] = values[1]


def _collect_3(sink: Collect, *values: Any) -> None:
    start = room(sink, 3)
    if start >= 0:
        sink.values[start] = values[0]
        sink.values[start + 1] = values[1]
        sink.values[start + 2] = values[2]


def _collect_4(sink: Collect, *values: Any) -> None:
    start = room(sink, 4)
    if start >= 0:
        sink.values[start] = values[0]
        sink.values[start + 1] = values[1]
        sink.values[start + 2] = values[2]
        sink.values[start + 3] = values[3]


def _collect_5(sink: Collect, *values: Any) -> None:
    start = room(sink, 5)
    if start >= 0:
        sink.values[start] = values[0]
        sink.values[start + 1] = values[1]
        sink.values[start + 2] = values[2]
        sink.values[start + 3] = values[3]
        sink.values[start + 4] = values[4]


def _paint(sink: Paint, *values: Any) -> None:
    x, y = values[0], values[1]
    if 0 <= x < sink.image.shape[1] and 0 <= y < sink.image.shape[0]:
        sink.image[np.uint64(y), np.uint64(x)] = sink.value


def _paint_inside(sink: PaintInside, *values: Any) -> None:
    sink.image[np.uint64(values[1]), np.uint64(values[0])] = sink.value


def mixed(under: int, over: int, coverage: float) -> int:
    """Two colours, 0xRRGGBB, mixed channel by channel: a coverage of 1 gives ``over``, 0 ``under``."""
    colour = 0
    for shift in (0, 8, 16):
        below = (under >> shift) & 255
        above = (over >> shift) & 255
        colour |= int(below + (above - below) * coverage + 0.5) << shift
    return colour


def _blend(sink: Blend, *values: Any) -> None:
    x, y = values[0], values[1]
    if 0 <= x < sink.image.shape[1] and 0 <= y < sink.image.shape[0]:
        under, over, coverage = int(sink.image[y, x]), int(sink.value), values[2]
        if sink.image.itemsize == 4:
            sink.image[y, x] = mixed(under, over, coverage)
        else:
            sink.image[y, x] = int(np.floor(under + (over - under) * coverage + 0.5))


def _paint_span(sink: PaintSpans, *values: Any) -> None:
    y = values[0]
    if 0 <= y < sink.image.shape[0]:
        left, right = max(values[1], 0), min(values[2], sink.image.shape[1] - 1)
        if left <= right:
            sink.image[y, left : right + 1] = sink.value


def seen(b: Bounds, x: int, y: int) -> bool:
    """Whether the pixel (x, y) lies within the bounds."""
    return b.x_first <= x <= b.x_last and b.y_first <= y <= b.y_last


def _paint_figure(sink: PaintFigure, *values: Any) -> None:
    x, y = values[0], values[1]
    if seen(sink.bounds, x, y):
        sink.image[np.uint64(y), np.uint64(x)] = sink.value
        sink.painter[np.uint64(y), np.uint64(x)] = sink.number


def _blend_figure(sink: BlendFigure, *values: Any) -> None:
    x, y = values[0], values[1]
    if seen(sink.bounds, x, y):
        sink.image[y, x] = mixed(int(sink.image[y, x]), int(sink.value), values[2])
        sink.painter[y, x] = sink.number


def _paint_figure_span(sink: PaintFigureSpans, *values: Any) -> None:
    y, bounds = values[0], sink.bounds
    if bounds.y_first <= y <= bounds.y_last:
        left, right = max(values[1], bounds.x_first), min(values[2], bounds.x_last)
        if left <= right:
            row, painters = sink.image[np.uint64(y)], sink.painter[np.uint64(y)]
            for x in range(np.uint64(left), np.uint64(right + 1)):
                row[x], painters[x] = sink.value, sink.number


def _hit(sink: Hit, *values: Any) -> None:
    if values[0] == sink.x and values[1] == sink.y:
        if sink.found[0] < len(sink.numbers):
            sink.numbers[sink.found[0]] = sink.emitted[0]
        sink.found[0] += 1
    sink.emitted[0] += 1


def _hit_span(sink: HitSpan, *values: Any) -> None:
    if values[0] == sink.y and values[1] <= sink.x <= values[2]:
        if sink.found[0] < len(sink.numbers):
            sink.numbers[sink.found[0]] = sink.emitted[0]
        sink.found[0] += 1
    sink.emitted[0] += 1


def _count(sink: Count, *values: Any) -> None:
    sink.emitted[0] += 1


def note(sink: ProbePixel | ProbeSpan, emitted: int) -> None:
    """Keep one touch while there is room; counts it."""
    found = sink.found[0]
    if found < len(sink.touches):
        sink.touches[found, 0] = emitted
        sink.touches[found, 1] = sink.emitted[0]
        sink.touches[found, 2] = sink.steps[0]
    sink.found[0] += 1


def _probe_pixel(sink: ProbePixel | ProbeSpan, *values: Any) -> None:
    if values[0] == sink.x and values[1] == sink.y:
        note(sink, 1)
    sink.emitted[0] += 1


def _probe_span(sink: ProbePixel | ProbeSpan, *values: Any) -> None:
    if values[0] == sink.y and values[1] <= sink.x <= values[2]:
        note(sink, 1)
    sink.emitted[0] += 1


def _tick_count(sink: Count, slot: int, block: int) -> int:
    sink.runs[slot] += 1
    here: int = sink.blocks[slot]
    if here >= 0 and here != block:
        sink.visits[here] += 1
    return here


def _tick_probe(sink: ProbePixel | ProbeSpan, slot: int, block: int) -> int:
    here: int = sink.blocks[slot]
    if here >= 0 and here != block and sink.rows[here]:
        sink.steps[0] += 1
    return here


TICKS: dict[type, Callable[..., int]] = {Count: _tick_count, ProbePixel: _tick_probe, ProbeSpan: _tick_probe}


STOPPABLE = {Collect, Hit, HitSpan, Count, ProbePixel, ProbeSpan}


def stopped(sink: Any) -> bool:
    """Whether the run that this sink sees was stopped."""
    return type(sink) in STOPPABLE and sink.stop[0] != 0


def tick(sink: Any, slot: int, block: int) -> int:
    """Note that the statements of ``slot`` run, after a visit of ``block``; returns their own block."""
    return TICKS[type(sink)](sink, slot, block)


def probe(sink: Any, pixel: tuple[int, int]) -> None:
    """Note that a block considered ``pixel``."""
    if pixel[0] == sink.x and pixel[1] == sink.y:
        note(sink, 0)


_COLLECT = {1: _collect_1, 2: _collect_2, 3: _collect_3, 4: _collect_4, 5: _collect_5}
_BODIES: dict[type, Callable[..., None]] = {
    Nothing: _nothing,
    Paint: _paint,
    PaintInside: _paint_inside,
    Blend: _blend,
    PaintSpans: _paint_span,
    PaintFigure: _paint_figure,
    BlendFigure: _blend_figure,
    PaintFigureSpans: _paint_figure_span,
    Hit: _hit,
    HitSpan: _hit_span,
    Count: _count,
    ProbePixel: _probe_pixel,
    ProbeSpan: _probe_span,
}

# What the bodies call.
SHARED = (room, note, mixed, seen)


def body(sink: type, arity: int) -> Callable[..., None]:
    """What ``emit`` does for a sink of this type and so many values."""
    return _COLLECT[arity] if sink is Collect else _BODIES[sink]


def emit(sink: Any, *values: Any) -> None:
    """Give ``values`` to the sink."""
    body(type(sink), len(values))(sink, *values)
