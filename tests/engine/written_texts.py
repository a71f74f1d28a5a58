"""Functions as a student may write them, without an entry, for the tests of lowering and compiling."""

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.conventions import round_half_up as rounded

LIMIT = 3
CORNERS = ((0, 0), (4, 1), (2, 5))
WEIGHTS = np.array([0.5, 0.25])
FAR = math.inf


class Edge(NamedTuple):
    x: float
    slope: float


def stepped(edge: Edge) -> Edge:
    return Edge(edge.x + edge.slope, edge.slope)


def row_of(y: int, left: int, right: int = 2) -> Iterator[tuple[int, int]]:
    for x in range(left, right):
        yield x, y


def box(width: int, height: int) -> Iterator[tuple[int, int]]:
    """Rows, by another generator; an early return and both kinds of loop."""
    if width < 1:
        return
    y = 0
    while y < height:
        y += 1
        if y == LIMIT:
            continue
        yield from row_of(y, 0, right=width)
    else:
        yield -1, y
    yield from row_of(0, 0)


def edges(count: int) -> Iterator[tuple[int, float]]:
    edge = Edge(0.0, WEIGHTS[1])
    for _k in range(count):
        if edge.x < FAR:
            edge = stepped(edge)
        yield rounded(edge.x), edge.x * WEIGHTS[0]


def corners() -> Iterator[tuple[int, int]]:
    for x, y in CORNERS:
        total: int = x + y
        yield x, total


def spans(count: int) -> Iterator[tuple[int, int, int]]:
    for y in range(count):
        yield y, -y, y


def endless() -> Iterator[tuple[int, int]]:
    x = 0
    while True:
        x = (x + 1) % 7
        yield x, 0


def doubled(image: NDArray[Any], step: int) -> Iterator[tuple[int, int]]:
    _height, width = image.shape
    for x in range(0, width, step):
        image[0, x] = 2 * np.int64(image[0, x]) + 1
        yield x, 0


def downwards(depth: int) -> Iterator[tuple[int, int]]:
    yield depth, 0
    if depth > 0:
        yield from downwards(depth - 1)


def mixed(k: int) -> Iterator[tuple[int, ...]]:
    yield k, k
    yield k, k, k


def taking(k: int) -> Iterator[tuple[int, int]]:
    for x, y in row_of(k, 0):
        yield y, x


class Span(NamedTuple):
    edge: Edge
    columns: tuple[int, int]
    free: bool


def gathered(count: int) -> Iterator[tuple[int, int, float, int]]:
    """Lists that are filled elsewhere, or never."""
    stack: list[tuple[int, int]] = []
    rows: list[list[float]] = []
    spans: list[Span] = []
    none: list[int] = []
    for k in range(count):
        widen(spans, k)
        if k % 2 == 0:
            stack.append((k, -k))
        row: list[float] = []
        for _k in range(k):
            row.append(0.5)
        rows.append(row)
    for span in spans:
        yield len(stack), len(rows[span.columns[0]]), span.edge.x, len(none) + int(span.free)


def widen(spans: list[Span], k: int) -> None:
    spans.append(Span(Edge(k + 0.5, 1.0), (k, k + 1), k > 1))


def of_anything(count: int) -> Iterator[tuple[int, int]]:
    things: list[Any] = []
    yield count, len(things)


def of_no_list(count: int) -> Iterator[tuple[int, int]]:
    things: tuple[int, int] = []  # type: ignore[assignment]
    yield count, len(things)


def item(image: NDArray[Any], x: int, y: int, outside: int) -> int:
    """One item, or what is outside."""
    if 0 <= x < image.shape[1] and 0 <= y < image.shape[0]:
        return np.int64(image[y, x])  # type: ignore[return-value]
    return outside


def item_below(image: NDArray[Any], x: int, y: int) -> int:
    return np.int64(image[y - LIMIT, x])  # type: ignore[return-value]


def items(image: NDArray[Any], count: int) -> Iterator[tuple[int, int]]:
    """Items by name, by a sum and with a name that means something else here."""
    left, y = -1, LIMIT
    for x in range(count):
        yield item(image, x, y, left), item(image, x + 1, y, -2)
        yield item_below(image, x, y), 0


def items_hidden(image: NDArray[Any], count: int) -> Iterator[tuple[int, int]]:
    LIMIT = 1
    for x in range(count):
        y = LIMIT + 2
        yield item_below(image, x, y), y


def silent(k: int) -> int:
    return k


def unknown(k: int) -> Iterator[tuple[int, int]]:
    yield k, nowhere  # noqa: F821


def part(x: int) -> int:
    return x + 1


def _run(x: int) -> int:
    return x + 1


class Bounds(NamedTuple):
    low: int
    high: int


def calling_part(k: int) -> Iterator[tuple[int, int]]:
    yield k, part(k)


def calling_run(k: int) -> Iterator[tuple[int, int]]:
    yield k, _run(k)


def naming_bounds(k: int) -> Iterator[tuple[int, int]]:
    bounds = Bounds(k, k + 1)
    yield bounds.low, bounds.high


def taking_count(_count: int) -> Iterator[tuple[int, int]]:
    yield _count, 0


def taking_hit(Hit: int) -> Iterator[tuple[int, int]]:
    yield Hit, 0


def taking_decorators(
    reading: int, part: int, enter: int, leave: int, call: int = 5
) -> Iterator[tuple[int, int]]:
    """Names that mean nothing where they are a text's own."""
    yield reading + part, enter + leave
    if call > 3:
        yield from taking_decorators(reading, part, enter=enter, leave=leave, call=call - 2)
        yield from taking_keywords(reading, of=enter)


def taking_keywords(k: int, step: int = 2, *, of: int, past: int = 7) -> Iterator[tuple[int, int]]:
    yield k * step, of + past
