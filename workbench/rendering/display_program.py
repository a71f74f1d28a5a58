"""The program of a display processor: a display list as MOVE, DRAW and JUMP, in the order of drawing.

Places are device coordinates in pixels, not rounded; the deflection turns them into its own units.
"""

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.scanning.operations import DRAW, JUMP, MOVE
from workbench.display.setup import DeviceStroke
from workbench.document.model import Sheet
from workbench.rendering.display_list import display_list
from workbench.rendering.scene.line_drawing import scene_strokes

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MOST_ORDERED = 2500
"""Of more strokes the order is left as it is: to look for it takes the square of their number."""


@dataclass(frozen=True, slots=True, eq=False)
class Strokes:
    """Ends (n, 2, 2) in pixels, colours 0xRRGGBB (n,), and the place of the figure that each is of (n,), -1
    for none.
    """

    ends: Floats
    colours: Ints
    figures: Ints

    def __len__(self) -> int:
        return len(self.ends)

    def cut(self, count: int) -> "Strokes":
        """The first ``count`` of them."""
        return Strokes(self.ends[:count], self.colours[:count], self.figures[:count])

    def for_tube(self) -> Floats:
        """As a tube takes them, (n, 5): x0, y0, x1, y1 and the colour."""
        return np.column_stack([self.ends.reshape(-1, 4), self.colours])


@dataclass(frozen=True, slots=True, eq=False)
class DisplayProgram:
    """Instructions (m, 4): operation, x, y, intensity 0 to 1, and the stroke that each draws or goes to (m,).

    The last is a JUMP to the first, -1 as its stroke; it tells where the beam rests. Without strokes there
    are no instructions.
    """

    strokes: Strokes
    rows: Floats
    stroke_of: Ints

    def __len__(self) -> int:
        return len(self.rows)

    @property
    def moves(self) -> int:
        """How many dark jumps there are."""
        return int((self.rows[:, 0] == MOVE).sum())

    def drawn_by(self, address: int) -> int:
        """How many strokes are drawn once this instruction was run."""
        return int((self.rows[: address + 1, 0] == DRAW).sum())

    def address_of(self, stroke: int) -> int:
        """The address of the instruction that draws a stroke."""
        return int(np.flatnonzero((self.stroke_of == stroke) & (self.rows[:, 0] == DRAW))[0])


def tube_strokes(sheet: Sheet) -> list[DeviceStroke]:
    """What a vector tube draws of a sheet, its scene included."""
    strokes: list[DeviceStroke] = [(s.x0, s.y0, s.x1, s.y1, s.colour) for s in display_list(sheet)]
    return [*strokes, *scene_strokes(sheet)]


def strokes_of(sheet: Sheet) -> Strokes:
    """What a sheet draws, its scene included, in the order of its figures."""
    rows: list[tuple[Any, ...]] = [tuple(stroke) for stroke in display_list(sheet)]
    rows += [(*stroke, -1) for stroke in scene_strokes(sheet)]
    table = np.array(rows, np.float64).reshape(-1, 6)
    return Strokes(table[:, :4].reshape(-1, 2, 2), table[:, 4].astype(np.int64), table[:, 5].astype(np.int64))


def equal_lines(count: int, length: float, picture_px: tuple[int, int]) -> Strokes:
    """``count`` white lines ``length`` pixels long, each that far from the end of the one before it.

    The last is as far from the first, so that all take the same time, jump included.
    """
    width, height = picture_px
    span = min(height - 1.0, length)
    y = (height - 1 - span) / 2 + span * (np.arange(count) / max(count - 1, 1))
    left = (width - 1 - length) / 2
    ends = np.empty((count, 2, 2))
    ends[:, 0, 0], ends[:, 1, 0] = left, left + length
    ends[:, :, 1] = y[::-1, None]
    return Strokes(ends, np.full(count, 0xFFFFFF, np.int64), np.full(count, -1, np.int64))


def nearest_first(strokes: Strokes) -> Strokes:
    """The strokes as ``nearest_end_first`` orders them, some of them backwards."""
    if len(strokes) > MOST_ORDERED:
        return strokes
    order, backwards = _order(np.ascontiguousarray(strokes.ends).tobytes())
    ends = strokes.ends[order]
    ends[backwards] = ends[backwards, ::-1]
    return replace(strokes, ends=ends, colours=strokes.colours[order], figures=strokes.figures[order])


@lru_cache(maxsize=8)
def _order(ends: bytes) -> tuple[Ints, NDArray[np.bool_]]:
    """The text's tour, whole arrays at a time: of equal distances the first one in the list is taken."""
    table = np.frombuffer(ends).reshape(-1, 2).copy()
    places = table.copy()
    count = len(table) // 2
    order, backwards = np.empty(count, np.int64), np.zeros(count, np.bool_)
    at = table[0] if count else np.zeros(2)
    for turn in range(count):
        nearest = int(np.abs(places - at).max(axis=1).argmin())
        stroke, backwards[turn] = nearest // 2, nearest % 2
        order[turn] = stroke
        at = table[nearest ^ 1]
        places[2 * stroke : 2 * stroke + 2] = np.inf
    return order, backwards


def program_of(strokes: Strokes) -> DisplayProgram:
    """The instructions that draw the strokes: a MOVE only where the beam is not there already."""
    count = len(strokes)
    if not count:
        return DisplayProgram(strokes, np.empty((0, 4)), np.empty(0, np.int64))
    starts, stops = strokes.ends[:, 0], strokes.ends[:, 1]
    moves = (starts != np.roll(stops, 1, axis=0)).any(axis=1)
    moves[0] = True
    draws = np.arange(count) + np.cumsum(moves)
    rows, stroke_of = np.zeros((count + int(moves.sum()) + 1, 4)), np.full(len(moves) + moves.sum() + 1, -1)
    rows[draws, 0], rows[draws, 1:3], rows[draws, 3] = DRAW, stops, intensities(strokes.colours)
    stroke_of[draws] = np.arange(count)
    before = draws[moves] - 1
    rows[before, 0], rows[before, 1:3] = MOVE, starts[moves]
    stroke_of[before] = np.flatnonzero(moves)
    rows[-1, 0], rows[-1, 1:3] = JUMP, stops[-1]
    return DisplayProgram(strokes, rows, stroke_of)


def intensities(colours: Ints) -> Floats:
    """How far colours 0xRRGGBB (n,) open the gun, 0 to 1: as far as the strongest of their channels."""
    channels = [(colours >> shift) & 0xFF for shift in (16, 8, 0)]
    strongest: Floats = np.maximum.reduce(channels) / 255.0
    return strongest
