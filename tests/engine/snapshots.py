"""A second, naive way to know every state of a run: copy all variables at every line. And texts to try."""

import pickle
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from types import CodeType, FrameType
from typing import Any, NamedTuple

import numpy as np


@dataclass
class Seen:
    """One line event as the naive tracer saw it."""

    line: int
    function: str
    depth: int
    variables: dict[str, Any]
    emitted: int


def watch(
    function: Callable[..., Any], *args: Any, callees: tuple[Any, ...] = ()
) -> tuple[list[Seen], list[Any]]:
    """Every line event of ``function`` and ``callees``, and what was emitted, by copying everything."""
    codes: set[CodeType] = {each.__code__ for each in (function, *callees)}
    seen: list[Seen] = []
    emitted: list[Any] = []

    def trace(frame: FrameType, event: str, arg: Any) -> Any:
        if frame.f_code not in codes:
            return None
        if event == "line":
            depth, above = -1, frame
            while above is not None:
                depth += above.f_code in codes
                above = above.f_back
            names = frame.f_code.co_varnames + frame.f_code.co_cellvars
            variables = {
                name: pickle.loads(pickle.dumps(v)) for name, v in frame.f_locals.items() if name in names
            }
            seen.append(Seen(frame.f_lineno, frame.f_code.co_name, depth, variables, len(emitted)))
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        for item in function(*args):
            emitted.append(item)
    finally:
        sys.settrace(before)
    return seen, emitted


class Edge(NamedTuple):
    y_end: int
    x: float
    slope: float


class Node(NamedTuple):
    polygon: list[tuple[float, float]]
    front: int


def inside(image: np.ndarray, x: int, y: int) -> bool:
    height, width = image.shape
    return 0 <= x < width and 0 <= y < height


def recursive_fill(image: np.ndarray, x: int, y: int, fill: int) -> Iterator[tuple[int, int]]:
    if inside(image, x, y) and image[y, x] == 0:
        image[y, x] = fill
        yield x, y
        for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            yield from recursive_fill(image, x + dx, y + dy, fill)


def stack_fill(image: np.ndarray, x: int, y: int, fill: int) -> Iterator[tuple[int, int]]:
    stack = [(x, y)]
    while stack:
        x, y = stack.pop()
        if not inside(image, x, y) or image[y, x] != 0:
            continue
        row = image[y]
        row[x] = fill
        yield x, y
        for step in (-1, 1):
            stack.append((x + step, y))
            stack.append((x, y + step))


def halves(low: int, high: int) -> Iterator[tuple[int, int]]:
    if high - low > 1:
        middle = (low + high) // 2
        yield from halves(low, middle)
        last = middle
        yield low, last
        yield from halves(middle, high)
    else:
        found = low
        yield found, high


def add_to(bucket: list[int], value: int) -> None:
    bucket.append(value)
    bucket.sort()


def tables(values: list[int]) -> Iterator[tuple[int, int]]:
    buckets: list[list[int]] = [[] for _ in range(3)]
    alias = buckets[0]
    nodes: list[Node] = []
    for value in values:
        buckets[value % 3].append(value)
        add_to(alias, -value)
        nodes.append(Node([(float(value), 0.0)], len(nodes)))
        if len(nodes) > 2:
            nodes[0].polygon.append((0.0, float(value)))
        which = alias if value % 2 else buckets[1]
        yield value, len(which)
    seen = {value: [value] for value in values}
    for value in values:
        seen[value].append(0)
        yield value, len(seen)


def active_edges(rows: list[tuple[int, int, int]]) -> Iterator[tuple[int, float]]:
    active = [Edge(rows[0][1], float(rows[0][0]), 0.5)]
    polygon = active
    for y in range(12):
        for start, end, slope in rows:
            if start == y:
                active.insert(0, Edge(end, float(start), slope / 2))
        kept = 0
        for edge in active:
            if edge.y_end > y:
                active[kept] = Edge(edge.y_end, edge.x + edge.slope, edge.slope)
                kept += 1
        while len(active) > kept:
            active.pop()
        for edge in active:
            yield y, edge.x
        if y == 5:
            polygon = active[:2]
            active = polygon
    total: float | int | None = None
    total = 2**70
    total = 0.5
    yield len(active), total


def arithmetic(numbers: np.ndarray, weights: np.ndarray) -> Iterator[tuple[int, float]]:
    copied = numbers * 1.0
    window = copied[1:3]
    for i in range(len(numbers)):
        copied[i] += weights[i % len(weights)]
        window[:] = window[::-1]
        match i % 3:
            case 0:
                first, *rest = copied.tolist()
            case other:
                first = float(other)
        scaled = [value * first for value in rest]
        yield i, scaled[0] if scaled else (first)
