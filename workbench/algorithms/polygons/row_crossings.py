"""What the fill by crossings stands on: rows, neighbours round a ring, and sorting."""

import math
from typing import Any, NamedTuple, Protocol, TypeVar

from numpy.typing import NDArray

FAR_LEFT = -(1 << 40)


class HasX(Protocol):
    """What is on a row at x."""

    @property
    def x(self) -> float: ...


Placed = TypeVar("Placed", bound=HasX)


class Crossing(NamedTuple):
    """What an edge has on a row: ``x`` to ``x_end``, one point where it crosses.

    ``winding`` is 1 for an edge that goes up, -1 down, 0 where it lies along the row.
    """

    x: float
    x_end: float
    winding: int


def corner(vertices: NDArray[Any], k: int) -> tuple[float, float]:
    """x and y of a vertex."""
    return float(vertices[k, 0]), float(vertices[k, 1])


def rows_of(vertices: NDArray[Any]) -> tuple[int, int]:
    """The lowest and the highest row of pixels of a polygon; the second is lower where it has none."""
    if len(vertices) == 0:
        return 0, -1
    lowest = highest = float(vertices[0, 1])
    for k in range(1, len(vertices)):
        y = float(vertices[k, 1])
        lowest = min(lowest, y)
        highest = max(highest, y)
    return math.ceil(lowest), math.floor(highest)


def next_vertices(vertices: NDArray[Any], ring_ends: NDArray[Any]) -> list[int]:
    """For each vertex of the rings the number of the one after it: after a ring's last comes its first."""
    after: list[int] = []
    start = 0
    for ring_end in ring_ends:
        end = min(int(ring_end), len(vertices))
        for k in range(start, end):
            after.append(k + 1 if k + 1 < end else start)
        start = max(start, end)
    return after


def sort_by_x(crossings: list[Placed]) -> None:
    """Put crossings in order from left to right: each moves left past those that are further right."""
    for k in range(1, len(crossings)):
        crossing = crossings[k]
        place = k
        while place > 0 and crossings[place - 1].x > crossing.x:
            crossings[place] = crossings[place - 1]
            place -= 1
        crossings[place] = crossing


def last_pixel(crossing: Crossing, closed: bool) -> int:
    """The last pixel up to a crossing, which closed takes in; of an edge along the row the last one on it."""
    return math.floor(crossing.x_end) if closed else math.ceil(crossing.x) - 1
