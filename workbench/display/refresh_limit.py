"""From which time of a picture on it is seen to flicker, and how many lines a random-scan display has until
then.
"""

import math
from functools import lru_cache
from typing import NamedTuple

from workbench.display.flicker import fusion_hz
from workbench.display.list_time import ListTime
from workbench.display.phosphor import Phosphor
from workbench.display.vector_timing import VectorTiming

EYE_CD_M2 = 100.0
"""The brightness of the picture that an eye is assumed to look at."""


@lru_cache(maxsize=16)
def longest_steady_s(guns: tuple[Phosphor, ...]) -> float:
    """The longest time of a picture (s) that does not flicker; infinite where none does."""
    fastest = max(fusion_hz(gun, EYE_CD_M2) for gun in guns)
    return 1.0 / fastest if fastest > 0.0 else math.inf


class LineTime(NamedTuple):
    """What one of many lines of the same length takes: drawn, jumped to and settled, in picoseconds."""

    stroke_ps: int
    jump_ps: int
    settle_ps: int

    @staticmethod
    def of(timing: VectorTiming, units: float) -> "LineTime":
        """For lines ``units`` long, each as far from the end of the one before."""
        jump = timing.jump_ps(units, 0.0)
        return LineTime(timing.stroke_ps(units, 0.0), jump, timing.settle_ps if units > 0.0 else 0)

    @staticmethod
    def mean(time: ListTime, lines: int) -> "LineTime":
        """The mean over the lines of a list; some time even where there is none."""
        count = max(lines, 1)
        return LineTime(max(time.strokes_ps // count, 1), time.jumps_ps // count, time.settles_ps // count)

    @property
    def total_ps(self) -> int:
        """All of it."""
        return self.stroke_ps + self.jump_ps + self.settle_ps

    def frame_ps(self, lines: int, shortest_ps: int) -> int:
        """The time of a picture of so many lines."""
        return max(lines * self.total_ps, shortest_ps, 1)

    def most_lines(self, longest_s: float, shortest_ps: int) -> int | None:
        """How many lines take no longer than ``longest_s``: floor(T / t); None: any number.

        0 where not even an empty list is refreshed as often.
        """
        if math.isinf(longest_s):
            return None
        longest_ps = math.floor(longest_s * 1e12)
        return longest_ps // self.total_ps if shortest_ps <= longest_ps else 0
