"""What a pixel canvas shows over its picture. Everything is in device coordinates, as values."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from workbench.widgets.canvas.drawing import Drawn

Cell = tuple[int, int]
GripShape = Literal["round", "square", "diamond"]

ONLY_FIRST, ONLY_SECOND, BOTH, TIE_FIRST, TIE_SECOND = 1, 2, 3, 4, 5


@dataclass(frozen=True, slots=True)
class Handle:
    """A point that can be grabbed. ``id`` comes back with the signals, ``name`` is written beside it.

    It may lie outside the picture. ``shape`` tells kinds of grips apart, such as those of a frame from those
    of a figure, or an inner control point from a point of the curve; ``ink`` names a colour of the theme.
    """

    id: str
    name: str
    x: float
    y: float
    selected: bool = False
    shape: GripShape = "round"
    ink: str = "accent"


@dataclass(frozen=True, slots=True, eq=False)
class Still:
    """What stays while something else is dragged over it: painted once, kept as long as it is the same."""

    drawn: tuple[Drawn, ...] = ()
    handles: tuple[Handle, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Overlay:
    """Marks over the picture.

    ``candidates`` are outlined, ``chosen`` filled, ``rejected`` crossed out, ``current`` ringed twice;
    ``right`` and ``wrong`` are answers, ticked and struck out. ``classes`` is a (h, w) uint8 array that
    compares two algorithms: 0 neither, ONLY_FIRST, ONLY_SECOND, BOTH, and TIE_FIRST, TIE_SECOND where the
    ideal curve passes exactly half way. ``ideal`` are open polylines, each (n, 2), thin in muted;
    ``outlined`` the same in accent for what is selected. ``snap`` is the cell the pointer has snapped to.
    ``drawn`` lies under these and over the picture: the marks of a step, and what a panel draws of figures;
    ``still`` lies under it.
    """

    candidates: tuple[Cell, ...] = ()
    chosen: tuple[Cell, ...] = ()
    rejected: tuple[Cell, ...] = ()
    current: tuple[Cell, ...] = ()
    right: tuple[Cell, ...] = ()
    wrong: tuple[Cell, ...] = ()
    ideal: tuple[NDArray[np.float64], ...] = ()
    outlined: tuple[NDArray[np.float64], ...] = ()
    handles: tuple[Handle, ...] = ()
    classes: NDArray[np.uint8] | None = None
    snap: Cell | None = None
    drawn: tuple[Drawn, ...] = ()
    still: Still | None = None


def compare_classes(
    size: tuple[int, int],
    first: NDArray[np.integer],
    second: NDArray[np.integer],
    ties: NDArray[np.integer] | None = None,
) -> NDArray[np.uint8]:
    """The (h, w) classes of two lists of cells, each (n, 2), on a picture of ``size`` (width, height).

    Cells outside the picture drop out; ``ties`` counts only where the two differ.
    """
    classes = np.zeros((size[1], size[0]), np.uint8)
    for cells, value in ((first, ONLY_FIRST), (second, ONLY_SECOND)):
        x, y = _inside(size, cells)
        classes[y, x] |= value
    if ties is not None:
        tied = np.zeros(classes.shape, bool)
        x, y = _inside(size, ties)
        tied[y, x] = True
        classes[tied & ((classes == ONLY_FIRST) | (classes == ONLY_SECOND))] += TIE_FIRST - ONLY_FIRST
    return classes


def _inside(
    size: tuple[int, int], cells: NDArray[np.integer]
) -> tuple[NDArray[np.integer], NDArray[np.integer]]:
    x, y = cells.reshape(-1, 2).T
    kept = (x >= 0) & (x < size[0]) & (y >= 0) & (y < size[1])
    return x[kept], y[kept]
