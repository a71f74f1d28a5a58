"""Which vertex of an outline meets which one of the next: shared out, drawn side by side, turned by hand."""

from collections.abc import Iterator
from itertools import accumulate
from typing import NamedTuple

import numpy as np

from workbench.algorithms.animation.morph import divided
from workbench.algorithms.marks import MOST_SPOTS, Mark, Points, Region, Spot, Stroke, Word, along
from workbench.algorithms.marks import closed as closed_ring
from workbench.widgets.canvas.overlay import Handle

_GAP = 0.35
_MOST_GRIPS = 60


class Correspondence(NamedTuple):
    """Two outlines (n, 2) and (m, 2), the second one drawn ``aside`` (2,) from its place.

    ``start`` and ``end`` (k, 2) are both with as many vertices: each of the first meets that of its number.
    """

    first: Points
    second: Points
    closed: bool
    shift: int
    aside: Points
    start: Points
    end: Points

    @property
    def edges(self) -> tuple[int, int]:
        """The numbers of edges of both."""
        return _edges(self.first, self.closed), _edges(self.second, self.closed)

    @property
    def own_places(self) -> list[int]:
        """Where the second outline's own vertices, from the one that vertex 0 meets on, stand in ``end``."""
        return _own_places(self.edges[1], max(self.edges), len(self.second))


def corresponding(first: Points, second: Points, closed: bool, shift: int) -> Correspondence:
    """That of the course's rule, with vertex 0 of the first going to the vertex ``shift`` of the second."""
    edges = _edges(first, closed), _edges(second, closed)
    most = max(edges)
    shift = shift % len(second) if closed else 0
    apart = max(float(np.ptp(first[:, 0])), float(np.ptp(second[:, 0])), 1.0) * (1.0 + _GAP)
    apart += float(first[:, 0].min() - second[:, 0].min())
    start, end = divided(first, 0, edges[0], most), divided(second, shift, edges[1], most)
    return Correspondence(
        first, second, closed, shift, np.array([apart, 0.0]), np.array(start), np.array(end)
    )


def _edges(outline: Points, closed: bool) -> int:
    return len(outline) if closed else len(outline) - 1


def _own_places(edges: int, most: int, count: int) -> list[int]:
    pieces = [most // edges + (edge < most % edges) for edge in range(edges)]
    return list(accumulate(pieces, initial=0))[:count]


def drawn(pair: Correspondence, part: float | None) -> Iterator[Mark]:
    """Both outlines, a line between each two vertices that meet, and the outline that is ``part`` of the way.

    A vertex that was put on an edge is a ring. Each vertex between two moves along its line.
    """
    inks = (("data1", pair.first, pair.start, pair.edges[0]), ("data2", pair.second, pair.end, pair.edges[1]))
    if len(pair.start) <= MOST_SPOTS:
        for here, there in zip(pair.start, pair.end + pair.aside, strict=True):
            yield Stroke(np.array([here, there]), "muted", "hair", "dot")
    for ink, outline, shared, edges in inks:
        moved = 0.0 if ink == "data1" else pair.aside
        yield Stroke((closed_ring(outline) if pair.closed else outline) + moved, ink, "thin")  # type: ignore[arg-type]
        if len(shared) <= MOST_SPOTS:
            own = set(_own_places(edges, max(pair.edges), len(outline)))
            for number, (x, y) in enumerate((shared + moved).tolist()):
                shape = "dot" if number in own else "ring"
                yield Spot(x, y, ink, shape, "small")  # type: ignore[arg-type]
    yield Stroke(along(tuple(pair.start[0]), tuple(pair.end[0] + pair.aside)), "accent", "thin")
    x, y = pair.start[0].tolist()
    yield Word("0", x, y, "text", -1, 0, carded=True)
    if part is not None:
        between = (1.0 - part) * pair.start + part * (pair.end + pair.aside)
        if pair.closed:
            yield Region(between, "accent")
        yield Stroke(closed_ring(between) if pair.closed else between, "accent", "thin")


def grips(pair: Correspondence) -> list[Handle]:
    """The ends that can be dragged round a closed second outline: at its own vertices, named by the vertices
    of the first that meet them."""
    places = pair.own_places if pair.closed else []
    if len(places) > _MOST_GRIPS:
        return []
    ends = [(place, *(pair.end[place] + pair.aside).tolist()) for place in places]
    return [Handle(str(place), "", x, y, selected=place == 0, ink="data2") for place, x, y in ends]


def dragged(pair: Correspondence, grip: str, x: float, y: float) -> int:
    """The shift with which the held end lies at the vertex of the second outline nearest to a hand."""
    nearest = int(np.hypot(*(pair.second + pair.aside - np.array([x, y])).T).argmin())
    return (nearest - pair.own_places.index(int(grip))) % len(pair.second)
