"""What is drawn of a step, as plain values: what an algorithm's ``marks`` function gives.

Everything is in the frame of the text's arguments (``Entry.frame``). A mark names its ink and how much it
counts, never a colour or a width: those belong to the theme and to the widget that paints it. A pattern or a
shape stands beside every ink. What is of weight or size "pixel" fits on one pixel of the picture without
hiding it.
"""

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import NDArray

Ink = Literal[
    "text", "muted", "accent", "warn", "error", "data1", "data2", "data3", "data4", "data5", "data6"
]
Weight = Literal["hair", "thin", "medium", "bold", "heavy", "pixel"]
Size = Literal["small", "medium", "large", "pixel"]
Pattern = Literal["solid", "dash", "dot"]
Shape = Literal["dot", "ring", "square", "cross"]
Frame = Literal["device", "world", "view"]
Points: TypeAlias = NDArray[np.float64]

INKS: tuple[Ink, ...] = get_args(Ink)

MOST_SPOTS = 600
MOST_WORDS = 24
"""Of more spots or words one cannot be told from the next."""


class Stroke(NamedTuple):
    """A polyline (n, 2)."""

    points: Points
    ink: Ink = "text"
    weight: Weight = "thin"
    pattern: Pattern = "solid"


class Ray(NamedTuple):
    """From a place in a direction to the edge of the picture, at least ``least`` far; or ``both_ways``."""

    x: float
    y: float
    dx: float
    dy: float
    ink: Ink = "text"
    weight: Weight = "thin"
    pattern: Pattern = "solid"
    least: float = 0.0
    both_ways: bool = False


class Region(NamedTuple):
    """The inside of a polygon (n, 2), tinted."""

    points: Points
    ink: Ink = "accent"


class Spot(NamedTuple):
    """One place, marked by a shape."""

    x: float
    y: float
    ink: Ink = "text"
    shape: Shape = "dot"
    size: Size = "medium"


class Word(NamedTuple):
    """A text beside a place (``right``, ``up``: 1, -1, or 0 for the middle), on a card when ``carded``."""

    text: str
    x: float
    y: float
    ink: Ink = "text"
    right: int = 0
    up: int = 0
    carded: bool = False
    strong: bool = False


class Matrix(NamedTuple):
    """A matrix, shown beside the picture and not in it; a cell that is not known yet has no text.

    Of two with one name the later one is shown: a block's own takes the place of the entry's. ``inked`` are
    the cells that are looked at, each as (row, column, ink), counted from 0.
    """

    name: str
    cells: tuple[tuple[str, ...], ...]
    inked: tuple[tuple[int, int, Ink], ...] = ()


Mark: TypeAlias = Stroke | Ray | Region | Spot | Word | Matrix
MarksFunction: TypeAlias = Callable[[tuple[Any, ...], Mapping[str, Any], NDArray[Any], bool], Iterable[Mark]]


def no_marks(
    _arguments: tuple[Any, ...], _now: Mapping[str, Any], _emitted: NDArray[Any], _ended: bool
) -> Iterable[Mark]:
    """Of most texts the pixels say all."""
    return ()


def along(*points: tuple[float, float]) -> Points:
    """These points as those of a stroke."""
    return np.array(points, np.float64)


def closed(ring: Points) -> Points:
    """A ring (n, 2) with its first corner at the end again."""
    return np.concatenate([ring, ring[:1]]) if len(ring) else ring.reshape(0, 2)
