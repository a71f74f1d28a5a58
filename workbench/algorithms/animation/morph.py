"""A polygon halfway into another one, which may have another number of vertices.

most, fewest    the numbers of edges, the larger and the smaller: L_max and L_min
extra           so many edges of the simpler outline get one piece more: N_e = L_max mod L_min
pieces          pieces of each of the others: N_s = L_max div L_min
start, end      both outlines with the same number of vertices
i               number of a vertex
"""

from collections.abc import Iterator, Mapping
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.animation.refusals import refuse_outlines
from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.marks import MOST_SPOTS, Ink, Mark, Points, Region, Spot, Stroke, along
from workbench.algorithms.marks import closed as closed_ring


def morph(
    first: NDArray[Any], second: NDArray[Any], closed: bool, shift: int, t: float
) -> Iterator[tuple[float, float]]:
    """Emit the vertices of the outline that is the part t of the way from the first to the second.

    Args: (n, 2) and (m, 2) vertices, whether the last is joined to the first, the number of the vertex of a
    closed second outline to which the first vertex of the first one goes, and t, 0 to 1.
    Emits: (x, y) of each vertex, as many as the outline with more has. Raises: ValueError below two vertices.
    Source: Hearn and Baker, Computer Graphics, C Version, section 16-5.
    """
    # Count the edges of both outlines
    refuse_outlines(first, second)
    first_edges = len(first) if closed else len(first) - 1
    second_edges = len(second) if closed else len(second) - 1
    most = max(first_edges, second_edges)
    fewest = min(first_edges, second_edges)

    # Share the edges of the longer list among those of the shorter
    extra = most % fewest
    pieces = most // fewest
    start = divided(first, 0, first_edges, most)
    end = divided(second, shift if closed else 0, second_edges, most)

    for i in range(len(start)):
        # Move a vertex that fraction of its way
        x0, y0 = start[i]
        x1, y1 = end[i]
        x = (1.0 - t) * x0 + t * x1
        y = (1.0 - t) * y0 + t * y1
        yield x, y


def divided(vertices: NDArray[Any], shift: int, edges: int, most: int) -> list[tuple[float, float]]:
    """The vertices from number ``shift`` on, with new ones on the edges, so that there are ``most`` edges.

    The first ``most mod edges`` edges are cut into one piece more than the others.
    """
    count = len(vertices)
    extra = most % edges
    outline = [(float(vertices[shift % count, 0]), float(vertices[shift % count, 1]))]
    for edge in range(edges):
        pieces = most // edges + 1 if edge < extra else most // edges
        x0 = float(vertices[(shift + edge) % count, 0])
        y0 = float(vertices[(shift + edge) % count, 1])
        x1 = float(vertices[(shift + edge + 1) % count, 0])
        y1 = float(vertices[(shift + edge + 1) % count, 1])
        for piece in range(1, pieces + 1):
            u = piece / pieces
            outline.append(((1.0 - u) * x0 + u * x1, (1.0 - u) * y0 + u * y1))
    if edges == count:
        outline.pop()
    return outline


def marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """Both outlines, the ways of their vertices once they are shared out, and the outline between so far."""
    first, second, closed, *_numbers = arguments
    inks: tuple[Ink, ...] = ("data2", "data3")
    for outline, ink in zip((first, second), inks, strict=True):
        corners = np.asarray(outline, np.float64)
        yield Stroke(closed_ring(corners) if closed else corners, ink, "hair", "dash")
    start, end = now.get("start", ()), now.get("end", ())
    if len(start) == len(end) <= MOST_SPOTS:
        for number, ((x0, y0), (x1, y1)) in enumerate(zip(start, end, strict=True)):
            yield Stroke(along((x0, y0), (x1, y1)), "muted", "hair", "dot")
            if number == now.get("i") and not ended:
                yield Spot(x0, y0, "data2", "dot", "small")
                yield Spot(x1, y1, "data3", "square", "small")
    between: Points = np.asarray(emitted, np.float64).reshape(-1, 2)
    if len(between) > 2 and closed:
        yield Region(between, "data1")
    if len(between) > 1:
        yield Stroke(closed_ring(between) if ended and closed else between, "data1", "medium")
    if len(between) and not ended:
        x, y = between[-1].tolist()
        yield Spot(x, y, "accent", "ring", "large")


def _arguments(chance: Random) -> tuple[Any, ...]:
    return (
        _outline(chance),
        _outline(chance),
        bool(chance.randint(0, 1)),
        chance.randint(0, 9),
        chance.choice((0.0, 1.0, 0.5, 1e-9, chance.random())),
    )


def _outline(chance: Random) -> NDArray[np.float64]:
    count = chance.randint(2, 9)
    cells = [(float(chance.randint(-6, 6)), chance.uniform(-6.0, 6.0)) for _vertex in range(count)]
    if chance.randint(0, 1):
        cells[chance.randrange(count)] = cells[0]
    return np.array(cells, np.float64)


_ROW = "(i, (x0, y0), (x1, y1), (x, y))"

# A house of five edges and the letter H, of thirteen
_HOUSE = np.array([[2.0, 1], [8, 1], [8, 6], [5, 9], [2, 6]])
_LETTER = np.array(
    [
        *([16.0, 1], [18, 1], [18, 4], [21, 4], [21, 1], [23, 1], [23, 9]),
        *([21, 9], [21, 6], [18, 6], [18, 9], [16, 9], [16, 5]),
    ]
)

ENTRY = Entry(
    function=morph,
    topic="animation",
    title="Morphing",
    summary="Cuts edges of the simpler outline until both have equally many, and moves each vertex straight.",
    parameters=(
        Parameter("first", "P_i", "points", _HOUSE, meaning="the vertices of the first key"),
        Parameter("second", "Q_i", "points", _LETTER, meaning="the vertices of the second key"),
        Parameter("closed", "closed", "bool", True, meaning="whether the last vertex is joined to the first"),
        Parameter("shift", "shift", "int", 0, low=0, meaning="the second's vertex that vertex 0 moves to"),
        Parameter("t", "t", "float", 0.5, low=0, high=1, meaning="how far along the way, from 0 to 1"),
    ),
    arguments=_arguments,
    emits="points",
    source="Hearn and Baker, Computer Graphics, C Version, section 16-5",
    columns=("i", "from", "to", "vertex"),
    views=(
        View(
            block="Count the edges of both outlines",
            sentence="The first outline has {first_edges} edges, the second {second_edges}: "
            "the larger number is {most}, the smaller {fewest}.",
        ),
        View(
            block="Share the edges of the longer list among those of the shorter",
            when="most == fewest",
            sentence="Both have {most} edges: each vertex has one to move to.",
        ),
        View(
            block="Share the edges of the longer list among those of the shorter",
            when="extra > 0",
            sentence="N_e = {most} mod {fewest} = {extra} edges are cut into {pieces + 1} pieces, "
            "the other {fewest - extra} into N_s = {most} div {fewest} = {pieces}.",
        ),
        View(
            block="Share the edges of the longer list among those of the shorter",
            sentence="{most} mod {fewest} is 0: each of the {fewest} edges is cut into "
            "N_s = {most} div {fewest} = {pieces}.",
        ),
        View(
            block="Move a vertex that fraction of its way",
            row=_ROW,
            sentence="Vertex {i}: (1 − {t}) {(x0, y0)} + {t} {(x1, y1)} = {(x, y)}.",
        ),
    ),
    laws=(
        Law(
            "At t = 0 and t = 1 it is the first and the second outline, with new vertices on straight edges.",
            "animation/test_morph.py::test_at_its_ends_a_morph_is_the_keys",
        ),
        Law(
            "L_max mod L_min edges get one piece more than L_max div L_min, and the others that many.",
            "animation/test_morph.py::test_edges_are_shared_by_the_rule_of_the_course",
        ),
        Law(
            "It has as many vertices as the larger outline, and each moves straight at a constant speed.",
            "animation/test_morph.py::test_every_vertex_moves_evenly_on_a_line",
        ),
    ),
    not_laws=("What lies between two outlines that do not cross themselves does not cross itself either.",),
    questions=(9,),
    labs=("Animation: key frames and in-betweens",),
    marks=marks,
    frame="world",
)
