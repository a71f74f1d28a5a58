"""What the fills with edge tables say of their edges: rows of both tables, crossings, how x grows."""

from collections.abc import Sequence
from operator import itemgetter
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.numerals import numeral
from workbench.algorithms.polygons.edge_table import Edge
from workbench.algorithms.polygons.integer_edges import WholeEdge
from workbench.algorithms.polygons.scan_line_words import LEVEL, Point, listed

AnyEdge = Edge | WholeEdge


def table_rows(edges: Sequence[AnyEdge], vertices: NDArray[Any]) -> list[tuple[Any, ...]]:
    """The edge table: first and last row, x on the first one, what it gains per row, both ends."""
    return [(e.y_start, e.y_end, _x(e), _gain(e), *_ends(e, vertices)) for e in edges]


def active_rows(active: Sequence[AnyEdge], vertices: NDArray[Any]) -> list[tuple[Any, ...]]:
    """The active edge table: both ends of each edge, its last row, x, what it gains per row, its winding."""
    return [(*_ends(e, vertices), e.y_end, _x(e), _gain(e), e.winding) for e in active]


def crossings(active: Sequence[AnyEdge]) -> list[str]:
    """Where edges cross the row; level ones lie along it."""
    return [_text(_x(edge)) for edge in active if edge.winding != 0]


def crossings_on(edges: Sequence[AnyEdge], y: int) -> tuple[list[float], list[str]]:
    """Where the edges of the whole edge table cross row y, from left to right, and how that is written."""
    on_row = [e for e in edges if e.winding != 0 and e.y_start <= y <= e.y_end]
    placed = sorted([_crossing(edge, y - edge.y_start) for edge in on_row], key=itemgetter(0))
    return [x for x, _words in placed], [words for _x, words in placed]


def pairs(active: Sequence[AnyEdge]) -> str:
    """The crossings two by two: (3.5, 6.5), (8, 9)."""
    xs = crossings(active)
    return listed([f"({a}, {b})" for a, b in zip(xs[::2], xs[1::2], strict=False)])


def moves(active: Sequence[AnyEdge], y: int) -> str:
    """How x of each edge that goes on to row y grows: 3.5 + 0.5 = 4."""
    return listed([_move(edge) for edge in active if edge.winding != 0 and edge.y_end >= y])


def _crossing(edge: AnyEdge, rows: int) -> tuple[float, str]:
    if isinstance(edge, WholeEdge):
        carry, counter = divmod(rows * edge.rest, edge.delta_y)
        x = edge.x + rows * edge.step + carry
        return x + counter / edge.delta_y, _text(_mixed(x, counter, edge.delta_y))
    x_here = edge.x + rows * edge.slope
    return x_here, numeral(x_here)


def _move(edge: AnyEdge) -> str:
    if isinstance(edge, WholeEdge):
        carry, counter = divmod(edge.counter + edge.rest, edge.delta_y)
        x = edge.x + edge.step + carry
        # A counter of 0 is written too, where it is to grow: 2 + 0/6 + 3/6 = 2 + 3/6
        here = f"{numeral(edge.x)} + {edge.counter}/{edge.delta_y}" if edge.rest else numeral(edge.x)
        return f"{here} {_signed(_gain(edge))} = {_text(_mixed(x, counter, edge.delta_y))}"
    return f"{numeral(edge.x)} {_signed(edge.slope)} = {numeral(edge.x + edge.slope)}"


def _signed(value: float | str) -> str:
    text = _text(value)
    return f"− {text[1:]}" if text.startswith("−") else f"+ {text}"


def _x(edge: AnyEdge) -> float | str:
    """Where an edge crosses its row; in whole numbers as a whole part and a counter over delta y."""
    return _mixed(edge.x, edge.counter, edge.delta_y) if isinstance(edge, WholeEdge) else edge.x


def _gain(edge: AnyEdge) -> float | str:
    """1/m, in the same way."""
    if edge.winding == 0:
        return LEVEL
    return _mixed(edge.step, edge.rest, edge.delta_y) if isinstance(edge, WholeEdge) else edge.slope


def _mixed(whole: int, part: int, of: int) -> float | str:
    if not part:
        return whole
    return f"{numeral(whole)} + {part}/{of}" if whole else f"{part}/{of}"


def _text(value: float | str) -> str:
    return value if isinstance(value, str) else numeral(value)


def _ends(edge: AnyEdge, vertices: NDArray[Any]) -> tuple[Point, Point]:
    (x0, y0), (x1, y1) = vertices[edge.low, :2].tolist(), vertices[edge.high, :2].tolist()
    return (x0, y0), (x1, y1)
