"""How long each instruction of a display list takes, whole lists at a time; the text ``random_scan`` and this
give the same.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.scanning.operations import DRAW, MOVE
from workbench.display.vector_timing import VectorTiming


@dataclass(frozen=True, slots=True, eq=False)
class ListTime:
    """``each_ps``: the time of every instruction (m,); then the sums of strokes, jumps and settles, and the
    time of a whole picture, all in picoseconds.
    """

    each_ps: NDArray[np.int64]
    strokes_ps: int
    jumps_ps: int
    settles_ps: int
    frame_ps: int

    @property
    def list_ps(self) -> int:
        """The time of the list, without waiting."""
        return self.strokes_ps + self.jumps_ps + self.settles_ps

    @property
    def refresh_hz(self) -> float:
        """Pictures a second."""
        return 1e12 / self.frame_ps


def list_time(rows: NDArray[Any], units: float, timing: VectorTiming, shortest_ps: int) -> ListTime:
    """The times of instructions (m, 4), ``units`` of the deflection per unit of their places."""
    if not len(rows):
        return ListTime(np.empty(0, np.int64), 0, 0, 0, max(shortest_ps, 1))
    places = rows[:, 1:3]
    distances = np.abs(places - np.roll(places, 1, axis=0)).max(axis=1) * units
    draws, moves = rows[:, 0] == DRAW, rows[:, 0] == MOVE
    strokes = np.where(draws, timing.strokes_ps(distances), 0)
    jumps = np.where(moves, timing.jumps_ps(distances), 0)
    settles = np.where(moves & (distances > 0.0), timing.settle_ps, 0)
    each = strokes + jumps + settles
    together = int(each.sum())
    frame = max(together, shortest_ps, 1)
    if not (draws | moves)[-1]:
        each[-1] = frame - together
    return ListTime(each, int(strokes.sum()), int(jumps.sum()), int(settles.sum()), frame)
