"""What ray casting through boxes shows of its blocks."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.entry import View
from workbench.algorithms.marks import MOST_SPOTS, Ink, Mark, Stroke, Weight, closed
from workbench.algorithms.recorded import is_recorded
from workbench.algorithms.visibility.box_cuts import Cut
from workbench.algorithms.visibility.boxes import NONE, X_HIGH, X_LOW, Y_HIGH, Y_LOW, Boxes
from workbench.algorithms.visibility.ray_views import offered
from workbench.algorithms.visibility.surface_marks import marks
from workbench.algorithms.visibility.surface_words import listed

COLUMNS = ("box or ray", "surfaces", "tried", "nearest z", "so")
_AXES = "xyz"


def box_mark(boxes: Boxes, box: int, ink: Ink = "accent", weight: Weight = "medium") -> tuple[Mark, ...]:
    """The outline of a box as the eye sees it; of an empty one there is none."""
    if not is_recorded(*boxes) or boxes.first[box] == boxes.end[box]:
        return ()
    left, right, low, high = boxes.extents[box, [X_LOW, X_HIGH, Y_LOW, Y_HIGH]]
    return (Stroke(closed(np.array([[left, low], [right, low], [right, high], [left, high]])), ink, weight),)


def box_marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """Outlines of the triangles, and all boxes so far that hold a surface."""
    yield from marks(arguments, now, emitted, ended)
    if "total" in now:
        for box in range(min(now["total"], MOST_SPOTS)):
            yield from box_mark(now["boxes"], box, "data4", "hair")


def surfaces_in(boxes: Boxes, order: NDArray[np.int64], box: int) -> str:
    """The numbers of the surfaces in a box."""
    if not is_recorded(order, *boxes):
        return "–"
    return listed(order[boxes.first[box] : boxes.end[box]].tolist())


def box_rows(boxes: Boxes, order: NDArray[np.int64], total: int) -> list[tuple[int, str, str]]:
    """Each box, its surfaces, and the boxes in it."""
    return [
        (box, surfaces_in(boxes, order, box), inner_of(boxes, box)) for box in range(min(total, MOST_SPOTS))
    ]


def inner_of(boxes: Boxes, box: int) -> str:
    """The two boxes in a box."""
    if not is_recorded(boxes.inner):
        return "–"
    inner = int(boxes.inner[box])
    return "–" if inner == NONE else f"{inner}, {inner + 1}"


def across(cut: Cut) -> str:
    """The axis that a cut is across, by its name."""
    return _AXES[cut.axis]


def waiting_boxes(waiting: NDArray[np.int64], count: int) -> list[tuple[int]]:
    """The boxes that wait, the nearest last."""
    return [(box,) for box in waiting[:count].tolist()] if is_recorded(waiting) else []


def surfaces_offered(order: NDArray[np.int64]) -> tuple[Any, ...]:
    """The answers to which surface is seen."""
    return offered(sorted(order.tolist())) if is_recorded(order) else ()


VIEW_FUNCTIONS = (
    listed,
    is_recorded,
    box_mark,
    surfaces_in,
    box_rows,
    inner_of,
    across,
    waiting_boxes,
    surfaces_offered,
)

_TAKE = "Take a box: few surfaces stay as they are"
_CUT = "Find the cut that leaves rays the least to try"
_TRY = "Try the ray on the nearest box that waits"
_MEET = "Find where the ray meets a surface in it"
_GIVE = "Give the pixel the colour of the nearest"
_BOXES = {"Boxes": ("box_rows(boxes, order, total)", ("box", "surfaces", "in it"))}
_WAITING = {"Boxes that wait, the nearest last": ("waiting_boxes(waiting, count)", ("box",))}
_HERE = "box_mark(boxes, here)"
_BOX = "box_mark(boxes, box)"

VIEWS = (
    View(
        block="Put one box around all surfaces",
        sentence="One box is put around {order.shape[0]} surfaces.",
    ),
    View(
        block=_TAKE,
        when="end - first <= 4",
        row="('box ' + str(here), surfaces_in(boxes, order, here), '–', '–', 'stays')",
        tables=_BOXES,
        marks=_HERE,
        sentence="Box {here} holds {end - first} surfaces, so few that it is not divided.",
    ),
    View(
        block=_TAKE,
        row="('box ' + str(here), surfaces_in(boxes, order, here), '–', '–', 'may be divided')",
        tables=_BOXES,
        marks=_HERE,
        sentence="Box {here} holds {end - first} surfaces: it may be divided.",
    ),
    View(
        block=_CUT,
        when="cut.axis == -1",
        marks=_HERE,
        sentence="All surfaces of box {here} have their middles in one place: no cut parts them.",
    ),
    View(
        block=_CUT,
        marks=_HERE,
        sentence="The cheapest cut of box {here} is across {across(cut)} at {cut.at}.",
    ),
    View(
        block="Put a box around each of the two parts",
        row="('box ' + str(here), surfaces_in(boxes, order, here), '–', '–', "
        "'in boxes ' + inner_of(boxes, here))",
        tables=_BOXES,
        marks="(*box_mark(boxes, total - 2), *box_mark(boxes, total - 1, 'data2'))",
        sentence="{middle - first} surfaces of box {here} go into box {total - 2}, {end - middle} into box "
        "{total - 1}.",
    ),
    View(
        block=_TRY,
        when="not is_recorded(*boxes)",
        tables=_WAITING,
        sentence="The ray through {(x, y)} is tried on box {box}.",
    ),
    View(
        block=_TRY,
        when="missed(boxes, box, x, y, nearest)",
        tables=_WAITING,
        marks=_BOX,
        sentence="The ray passes box {box} by, or has met something nearer: nothing in it is tried.",
    ),
    View(
        block=_TRY,
        tables=_WAITING,
        marks=_BOX,
        sentence="The ray through {(x, y)} meets box {box}.",
    ),
    View(
        block="Open it: the nearer one in it comes first",
        tables=_WAITING,
        marks="(*box_mark(boxes, near), *box_mark(boxes, far, 'data2'))",
        sentence="Boxes {near} and {far} are in box {box}; box {near} begins no farther, so it comes first.",
    ),
    View(
        block=_MEET,
        when="hit",
        sentence="The ray meets surface {number} at z = {z}.",
    ),
    View(
        block=_MEET,
        sentence="The ray misses surface {number}.",
    ),
    View(
        block=_GIVE,
        when="seen == -1",
        candidates="((x, y),)",
        rejected="((x, y),)",
        row="((x, y), order.shape[0], tried, '–', 'none')",
        considers="(x, y)",
        options="surfaces_offered(order)",
        answer="'none'",
        sentence="The ray through {(x, y)} is tried on {tried} of {order.shape[0]} surfaces and meets none.",
    ),
    View(
        block=_GIVE,
        candidates="((x, y),)",
        chosen="((x, y),)",
        row="((x, y), order.shape[0], tried, nearest, seen)",
        considers="(x, y)",
        options="surfaces_offered(order)",
        answer="seen",
        sentence="The ray through {(x, y)} is tried on {tried} of {order.shape[0]} surfaces; surface {seen} "
        "is the nearest, at z = {nearest}.",
    ),
)
