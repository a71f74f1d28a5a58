"""The window as it is drawn of a clipping text: the edge that is looked at, and what runs along it."""

from collections.abc import Iterator, Sequence

from workbench.algorithms.clipping.degenerate_edges import degenerate_edges
from workbench.algorithms.clipping.edges import BOTTOM, LEFT, RIGHT, TOP
from workbench.algorithms.marks import Mark, Points, Spot, Stroke, along

_FIRST_CORNER = {BOTTOM: 0, RIGHT: 1, TOP: 2, LEFT: 3}


def corners(window: Sequence[float]) -> Points:
    """The window (xmin, ymin, xmax, ymax) as a closed polyline (5, 2), counter-clockwise."""
    xmin, ymin, xmax, ymax = map(float, window)
    return along((xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax), (xmin, ymin))


def edge_mark(window: Sequence[float], edge: int) -> Stroke:
    """One edge of the window, by its bit in a region code."""
    first = _FIRST_CORNER[edge]
    return Stroke(corners(window)[first : first + 2], "accent", "heavy")


def degenerate_marks(polygon: Sequence[Sequence[float]], window: Sequence[float]) -> Iterator[Mark]:
    """What Sutherland-Hodgman leaves of a concave polygon along the window: edges that enclose nothing."""
    for start, end in degenerate_edges(polygon, window):
        yield Stroke(along(start, end), "error", "bold", "dot")
        for x, y in (start, end):
            yield Spot(x, y, "error", "square", "small")
