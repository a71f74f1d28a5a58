"""What is drawn of the scan-line fill: the row, where edges cross it, and what is filled of it."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from numpy.typing import NDArray

from workbench.algorithms.marks import MOST_SPOTS, MOST_WORDS, Mark, Ray, Spot, Stroke, Word, along
from workbench.algorithms.numerals import numeral
from workbench.algorithms.polygons.edges import Edge
from workbench.algorithms.polygons.scan_line_words import goes_on_upwards, winding_of

_CLOSE = 1.5


def row_crossings(
    edges: Sequence[Edge], row: int, vertices: NDArray[Any], ring_ends: NDArray[Any]
) -> list[float]:
    """Where the edges on a row cross it by the vertex rule, from left to right; those along it do not."""
    on_row = (edge for edge in edges if edge.y_start <= row <= edge.y_end and edge.slope < math.inf)
    counted = (edge for edge in on_row if _counts(edge, row, vertices, ring_ends))
    return sorted(edge.x + (row - edge.y_start) * edge.slope for edge in counted)


def _counts(edge: Edge, row: int, vertices: NDArray[Any], ring_ends: NDArray[Any]) -> bool:
    if edge.winding != 0 and edge.y_top > row:
        return True
    return not goes_on_upwards(edge.high, winding_of(edge, vertices, ring_ends), vertices, ring_ends)


def marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """The scan line, its spans so far, its crossings with their x."""
    if "row" in now:
        yield from row_marks(now["row"], row_crossings(now["edges"], now["row"], *arguments[:2]), emitted)


def row_marks(
    row: int, crossings: Sequence[float], emitted: NDArray[Any], words: Sequence[str] = ()
) -> Iterator[Mark]:
    """A scan line, its spans so far, its crossings from left to right with their x, or these words."""
    yield Ray(0.0, float(row), 1.0, 0.0, "accent", "thin", "dash", both_ways=True)
    for y, left, right in emitted[emitted[:, 0] == row].tolist() if len(emitted) else ():
        yield Stroke(along((left, y), (right, y)), "accent", "bold")
    for number, x in enumerate(crossings[:MOST_SPOTS]):
        yield Spot(x, float(row), "data2", "ring")
        if len(crossings) <= MOST_WORDS:
            close = any(0.0 < x - other < _CLOSE for other in crossings[:number])
            text = words[number] if words else numeral(x)
            yield Word(text, x, float(row), "text", 0, -1 if close else 1, carded=True)
