"""What a pixel canvas shows over its picture. Everything is in device coordinates, as values."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from workbench.widgets.canvas.drawing import Drawn

HANDLE, GRAB = 9, 24
"""How wide a grip is, and where it can be grabbed, in logical pixels."""

Cell = tuple[int, int]
GripShape = Literal["round", "square", "diamond", "mark"]


@dataclass(frozen=True, slots=True)
class Handle:
    """A point that can be grabbed. ``id`` comes back with the signals, ``name`` is written beside it.

    It may lie outside the picture. ``shape`` tells kinds of grips apart, such as those of a frame from those
    of a figure, or an inner control point from a point of the curve; a "mark" is drawn by something
    else, and can be grabbed. ``ink`` names a colour of the theme.
    """

    id: str
    name: str
    x: float
    y: float
    selected: bool = False
    shape: GripShape = "round"
    ink: str = "accent"


def handle_places(handles: Sequence[Handle]) -> NDArray[np.float64]:
    """(n, 2) device points of handles."""
    count = len(handles)
    x = np.fromiter((handle.x for handle in handles), float, count)
    y = np.fromiter((handle.y for handle in handles), float, count)
    return np.stack([x, y], axis=1)


@dataclass(frozen=True, slots=True, eq=False)
class Still:
    """What stays while something else is dragged over it: painted once, kept as long as it is the same."""

    drawn: tuple[Drawn, ...] = ()
    handles: tuple[Handle, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Overlay:
    """Marks over the picture.

    ``candidates`` are outlined, ``chosen`` filled, ``rejected`` crossed out, ``current`` ringed twice;
    ``right`` and ``wrong`` are answers, ticked and struck out. ``classes`` (h, w), uint8, compares two as
    ``rendering.comparing`` has it. ``ideal`` are open polylines, each (n, 2), thin in muted; ``outlined`` the
    same in accent for what is selected. ``snap`` is the cell the pointer has snapped to. ``drawn`` lies under
    these and over the picture: the marks of a step, and what a panel draws of figures; ``still`` lies under
    it. A ``plane`` has no cells to see: no grid and no numbers of them, no edge, and ground all around.
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
    plane: bool = False
