"""What the views of the scan-line fill say in words, pixels and tables."""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.numerals import numeral, with_minus
from workbench.algorithms.polygons.active_edges import Crossing, end_of_level
from workbench.algorithms.polygons.edges import Edge

Fill = Callable[..., Iterator[tuple[int, int, int]]]
Point = tuple[float, float]
Pixels = tuple[tuple[int, int], ...]

COLUMNS = ("y", "x of the crossings", "pixels", "count")

LEVEL = "level"
# Which vertices of vertices_on, under which condition, and how they count
VERTEX_RULE = (
    ("top", "closed and ", "the edges on both sides end there, so both count, as a pair."),
    ("top", "", "the edges on both sides end there, and half-open leaves out upper ends."),
    ("bottom", "", "the edges on both sides begin there, so both count, as a pair."),
    ("through", "", "one edge ends and the next goes on, so only one counts."),
)

_LISTED = 12
_KINDS = ("bottom", "through", "top")


def listed(values: Sequence[float | str]) -> str:
    """Numbers as a sentence has them: six digits, a true minus sign; a long list is cut."""
    texts = [value if isinstance(value, str) else numeral(value) for value in values]
    return ", ".join([*texts[:_LISTED], "…"] if len(texts) > _LISTED else texts)


@lru_cache(maxsize=8)
def _all_rows(
    fill: Fill, vertices: bytes, ring_ends: bytes, closed: bool, nonzero: bool
) -> dict[int, tuple[tuple[int, int], ...]]:
    rows: dict[int, tuple[tuple[int, int], ...]] = {}
    points = np.frombuffer(vertices).reshape(-1, 2)
    for y, left, right in fill(points, np.frombuffer(ring_ends, np.int64), closed, nonzero):
        rows[y] = (*rows.get(y, ()), (left, right))
    return rows


def row_spans(
    fill: Fill, vertices: NDArray[Any], ring_ends: NDArray[Any], closed: bool, nonzero: bool, y: int
) -> tuple[tuple[int, int], ...]:
    """The spans of row y, from a run of the text itself."""
    points, ends = np.ascontiguousarray(vertices, np.float64), np.ascontiguousarray(ring_ends, np.int64)
    return _all_rows(fill, points.tobytes(), ends.tobytes(), closed, nonzero).get(y, ())


def spans_text(spans: Sequence[tuple[int, int]]) -> str:
    """Spans as the course writes them: 4 to 6; a single pixel by itself; those side by side as one."""
    joined: list[tuple[int, int]] = []
    for left, right in spans:
        if joined and joined[-1][1] == left - 1:
            left = joined.pop()[0]
        joined.append((left, right))
    return listed([with_minus(f"{a} to {b}" if a < b else f"{a}") for a, b in joined])


def span_pixels(spans: Sequence[tuple[int, int]], y: int) -> Pixels:
    """The pixels of the spans of row y."""
    return tuple((x, y) for left, right in spans for x in range(left, right + 1))


def reached(active: Sequence[Crossing], edges: Sequence[Edge], vertices: NDArray[Any], y: int) -> Pixels:
    """The pixels of row y from the first crossing to the last, and the one outside at either end."""
    ends = [math.floor(c.x) if c.slope < math.inf else end_of_level(vertices, edges[c.edge]) for c in active]
    left = min([math.ceil(crossing.x) for crossing in active], default=0)
    return span_pixels(((left - 1, max(ends, default=0) + 1),), y)


def crossings(
    active: Sequence[Crossing], edges: Sequence[Edge], vertices: NDArray[Any], ring_ends: NDArray[Any]
) -> list[float]:
    """Where edges cross the row by the vertex rule; those along it do not."""
    return [c.x for c in active if counted_winding(c, edges[c.edge], vertices, ring_ends) != 0]


def counted_winding(crossing: Crossing, edge: Edge, vertices: NDArray[Any], ring_ends: NDArray[Any]) -> int:
    """The winding of a crossing; at an upper end, which the text leaves uncounted, by the vertex rule.

    An edge along the row has none, nor one after whose upper end the ring goes on upwards.
    """
    if crossing.winding != 0 or crossing.slope == math.inf:
        return crossing.winding
    way = winding_of(edge, vertices, ring_ends)
    return 0 if goes_on_upwards(edge.high, way, vertices, ring_ends) else way


def winding_of(edge: Edge, vertices: NDArray[Any], ring_ends: NDArray[Any]) -> int:
    """1 for an edge that goes up round its ring, -1 for one that goes down."""
    return 1 if edge.high == _next(edge.low, 1, ring_ends) else -1


def goes_on_upwards(vertex: int, way: int, vertices: NDArray[Any], ring_ends: NDArray[Any]) -> bool:
    """Whether the ring, followed from a vertex that way round, leaves the vertex's row upwards."""
    further = _next(vertex, way, ring_ends)
    while vertices[further, 1] == vertices[vertex, 1]:
        further = _next(further, way, ring_ends)
    return bool(vertices[further, 1] > vertices[vertex, 1])


def _next(vertex: int, way: int, ring_ends: NDArray[Any]) -> int:
    ring = int(np.searchsorted(ring_ends, vertex, side="right"))
    start = int(ring_ends[ring - 1]) if ring else 0
    return start + (vertex + way - start) % (int(ring_ends[ring]) - start)


def row_of_box(vertices: NDArray[Any], y: int) -> Pixels:
    """The pixels of row y from the polygon's first column to its last, and the one outside at either end."""
    left, right = float(vertices[:, 0].min()), float(vertices[:, 0].max())
    return span_pixels(((math.ceil(left) - 1, math.floor(right) + 1),), y)


def not_among(pixels: Pixels, others: Pixels) -> Pixels:
    """Those of the first that are not among the second."""
    found = set(others)
    return tuple(pixel for pixel in pixels if pixel not in found)


def active_rows(
    active: Sequence[Crossing], edges: Sequence[Edge], vertices: NDArray[Any], ring_ends: NDArray[Any]
) -> list[tuple[Any, ...]]:
    """The active edge table: both ends of each edge, its last row, x, 1/m and the way it goes."""
    return [
        (
            *_ends(edges[c.edge], vertices),
            edges[c.edge].y_end,
            c.x,
            _gain(c.slope),
            counted_winding(c, edges[c.edge], vertices, ring_ends),
        )
        for c in active
    ]


def edge_rows(edges: Sequence[Edge], vertices: NDArray[Any]) -> list[tuple[Any, ...]]:
    """The edge table: first and last row, x on the first one, 1/m and both ends of each edge."""
    return [(e.y_start, e.y_end, e.x, _gain(e.slope), *_ends(e, vertices)) for e in edges]


def _gain(slope: float) -> float | str:
    return LEVEL if slope == math.inf else slope


def _ends(edge: Edge, vertices: NDArray[Any]) -> tuple[Point, Point]:
    (x0, y0), (x1, y1) = vertices[edge.low, :2].tolist(), vertices[edge.high, :2].tolist()
    return (x0, y0), (x1, y1)


def moves(active: Sequence[Crossing]) -> str:
    """How each crossing goes to the next row: 3.5 + 0.5 = 4."""
    crossed = [c for c in active if c.winding != 0]
    return listed(
        [
            f"{listed([c.x])} {'−' if c.slope < 0 else '+'} {listed([abs(c.slope)])} = "
            f"{listed([c.x + c.slope])}"
            for c in crossed
        ]
    )


def vertices_on(vertices: NDArray[Any], ring_ends: NDArray[Any], y: int, kind: str) -> str:
    """Where on row y the polygon turns back (``top``, ``bottom``) or goes on (``through``), in words.

    Vertices side by side on the row are one such place: the level edge between them.
    """
    corners: list[str] = []
    levels: list[str] = []
    start = 0
    for end in ring_ends.tolist():
        ring = vertices[start:end, :2].tolist()
        start = end
        outside = next((k for k, (_x, level) in enumerate(ring) if level != y), None)
        if outside is None:
            continue
        turned = [*ring[outside:], *ring[: outside + 1]]
        before = first = turned[0]
        for point, after in pairwise(turned):
            if point[1] != y:
                before, first = point, after
            elif after[1] != y and kind == _KINDS[(before[1] < y) + (after[1] < y)]:
                (left, _y), (right, _y) = sorted((first, point))
                if left == right:
                    corners.append(f"({listed(point)})")
                else:
                    levels.append(f"the level edge from ({listed([left, y])}) to ({listed([right, y])})")
    if corners:
        levels.insert(0, f"the {'vertex' if len(corners) == 1 else 'vertices'} {listed(corners)}")
    return " and ".join(levels[:_LISTED])
