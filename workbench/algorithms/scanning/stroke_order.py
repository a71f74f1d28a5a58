"""Nearest end first: the strokes of a display list in an order that makes the dark jumps short.

ends            first and last point of each stroke, two rows for a stroke
x, y            where the beam is
nearest         the stroke, not drawn yet, with an end nearest to the beam
backwards       whether that is its last point, from which it is then drawn
least           how far that end is away: the longer of the two ways, across or up
"""

from collections.abc import Iterable, Iterator, Mapping
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import Entry, Law, Parameter, View
from workbench.algorithms.marks import Mark, Spot, Stroke


def nearest_end_first(ends: NDArray[Any]) -> Iterator[tuple[int, int]]:
    """Emit the number of each stroke, and 1 where it is drawn backwards.

    Args: end points (2 n, 2), two for a stroke. The first stroke stays first.
    Emits: (stroke, backwards). Source: nearest neighbour, a greedy tour.
    """
    # Nothing is drawn yet
    strokes = len(ends) // 2
    drawn = [False for _k in range(strokes)]
    x = 0.0
    y = 0.0
    if strokes > 0:
        x = float(ends[0, 0])
        y = float(ends[0, 1])

    for _turn in range(strokes):
        # Look for the end that is nearest to the beam
        nearest = -1
        backwards = 0
        least = 0.0
        for k in range(strokes):
            if not drawn[k]:
                to_first = max(abs(ends[2 * k, 0] - x), abs(ends[2 * k, 1] - y))
                to_last = max(abs(ends[2 * k + 1, 0] - x), abs(ends[2 * k + 1, 1] - y))
                if nearest < 0 or to_first < least:
                    nearest = k
                    backwards = 0
                    least = float(to_first)
                if to_last < least:
                    nearest = k
                    backwards = 1
                    least = float(to_last)

        # Draw that stroke, and be at its other end
        drawn[nearest] = True
        x = float(ends[2 * nearest + 1 - backwards, 0])
        y = float(ends[2 * nearest + 1 - backwards, 1])
        yield nearest, backwards


_ENDS = np.array([[10, 10], [40, 10], [50, 5], [50, 35], [25, 34], [40, 10], [10, 12], [25, 34]], np.float64)


def _ends(chance: Random) -> tuple[Any, ...]:
    """Up to six strokes; some share ends, some have no length."""
    places = [(float(chance.randint(0, 9)), chance.choice((3.0, chance.uniform(0, 9)))) for _k in range(4)]
    rows = [chance.choice(places) for _end in range(2 * chance.randint(0, 6))]
    return (np.array(rows, np.float64).reshape(-1, 2),)


def _marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterable[Mark]:
    """The strokes in their order, the jumps between them, and the beam."""
    strokes = np.asarray(arguments[0], np.float64)[: len(arguments[0]) // 2 * 2].reshape(-1, 2, 2)
    order = np.asarray(emitted, np.int64).reshape(-1, 2)
    for k in sorted(set(range(len(strokes))) - set(order[:, 0].tolist())):
        yield Stroke(strokes[k], "muted", "hair", "dot")
    at = None
    for k, backwards in order.tolist():
        ends = strokes[k][::-1] if backwards else strokes[k]
        if at is not None and not np.array_equal(at, ends[0]):
            yield Stroke(np.stack([at, ends[0]]), "data2", "thin", "dash")
        yield Stroke(ends, "data1", "medium")
        at = ends[1]
    if not ended and "y" in now:
        yield Spot(now["x"], now["y"], "accent", "dot", "large")


ENTRY = Entry(
    function=nearest_end_first,
    topic="scanning",
    title="Nearest end first",
    summary="A display list is put in order by going on with the stroke that has an end nearest to the beam.",
    parameters=(Parameter("ends", "ends", "points", _ENDS, meaning="end points, two for a stroke"),),
    arguments=_ends,
    emits="cells",
    source="Nearest neighbour: a greedy tour, which need not be the shortest",
    emitted_columns=("stroke", "backwards"),
    columns=("stroke", "backwards", "jump", "beam"),
    views=(
        View(
            block="Look for the end that is nearest to the beam",
            sentence="Of what is not drawn yet, stroke {nearest} has the end nearest to the beam: "
            "{least} away.",
        ),
        View(
            block="Draw that stroke, and be at its other end",
            when="backwards == 0",
            row="(nearest, backwards, least, (x, y))",
            sentence="Stroke {nearest} is drawn as it is; the beam is at ({x}, {y}).",
        ),
        View(
            block="Draw that stroke, and be at its other end",
            row="(nearest, backwards, least, (x, y))",
            sentence="Stroke {nearest} is drawn backwards, from its last point; the beam is at ({x}, {y}).",
        ),
    ),
    marks=_marks,
    laws=(
        Law(
            "Every stroke is emitted once.",
            "scanning/test_stroke_order.py::test_every_stroke_is_drawn_once_and_each_jump_is_the_shortest",
        ),
        Law(
            "No end of a stroke that is not drawn yet is nearer than the one that is gone to.",
            "scanning/test_stroke_order.py::test_every_stroke_is_drawn_once_and_each_jump_is_the_shortest",
        ),
    ),
    not_laws=("The order it finds is the best one: a greedy tour may end far from what it left behind.",),
    questions=(10,),
    labs=("Random scan and display list",),
    next_rung="beam_spot",
)
