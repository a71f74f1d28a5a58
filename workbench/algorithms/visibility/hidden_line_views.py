"""What the removal of hidden lines shows of its blocks."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import View
from workbench.algorithms.marks import MOST_SPOTS, Mark, Stroke
from workbench.algorithms.visibility.device_plane import Corner
from workbench.algorithms.visibility.edge_parts import Part, place_at
from workbench.algorithms.visibility.surface_marks import surface_mark

COLUMNS = ("edge", "surface", "is", "from t", "to t", "parts seen")


def part_mark(start: Corner, end: Corner, part: Part) -> Mark:
    """A part of an edge."""
    a, b = place_at(start, end, part.begin), place_at(start, end, part.end)
    return Stroke(np.array([a[:2], b[:2]], np.float64), "data2", "bold")


VIEW_FUNCTIONS = (part_mark, surface_mark)


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """All edges thin, and what is drawn of them."""
    vertices, _faces, edges = arguments
    for edge in edges[:MOST_SPOTS]:
        yield Stroke(np.array(vertices[edge, :2], np.float64), "muted", "hair")
    for x0, y0, x1, y1, *_edge in emitted[:MOST_SPOTS]:
        yield Stroke(np.array([[x0, y0], [x1, y1]], np.float64), "accent", "medium")


_PARTS = {"What is seen of the edge": ("seen", ("from t", "to t"))}

VIEWS = (
    View(
        block="Take an edge, all of it seen so far",
        tables=_PARTS,
        marks="(part_mark(start, end, seen[0]),)",
        sentence="Edge {edge} runs from {start[:2]} to {end[:2]}; all of it is seen so far.",
    ),
    View(
        block="Find the part that is behind the plane of the surface",
        when="behind.begin >= behind.end",
        marks="(surface_mark(surfaces[number]),)",
        sentence="No part of edge {edge} is behind the plane of surface {number}: it hides nothing.",
    ),
    View(
        block="Find the part that is behind the plane of the surface",
        marks="(surface_mark(surfaces[number]), part_mark(start, end, behind))",
        sentence="Edge {edge} is behind the plane of surface {number} from t = {behind.begin} to "
        "{behind.end}.",
    ),
    View(
        block="Clip it to the sides of the surface: that is hidden",
        when="hidden.begin >= hidden.end",
        marks="(surface_mark(surfaces[number]), part_mark(start, end, behind))",
        sentence="That part passes surface {number} by: it hides nothing.",
    ),
    View(
        block="Clip it to the sides of the surface: that is hidden",
        marks="(surface_mark(surfaces[number]), part_mark(start, end, hidden))",
        sentence="Its sides enclose it from t = {hidden.begin} to {hidden.end}: there surface {number} hides "
        "edge {edge}.",
    ),
    View(
        block="Take the hidden part out of what is seen",
        row="(edge, number, 'hidden', hidden.begin, hidden.end, len(seen))",
        tables=_PARTS,
        marks="(surface_mark(surfaces[number]), *(part_mark(start, end, part) for part in seen))",
        sentence="Surface {number} hides edge {edge} from t = {hidden.begin} to {hidden.end}; parts that are "
        "still seen: {len(seen)}.",
    ),
    View(
        block="Draw a part that is seen",
        row="(edge, '–', 'drawn', part.begin, part.end, len(seen))",
        tables=_PARTS,
        marks="(part_mark(start, end, part),)",
        sentence="Edge {edge} is drawn from t = {part.begin} to {part.end}.",
    ),
)
