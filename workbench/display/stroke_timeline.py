"""The frame of a random-scan tube in time: what the beam does, from when, and how long, in picoseconds."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.display.vector_timing import VectorTiming

Floats = NDArray[np.floating[Any]]
Point = tuple[float, float]


class MmStroke(NamedTuple):
    """One stroke on the face, in millimetres, with the current of each gun, 0 to 1."""

    start: Point
    end: Point
    currents: tuple[float, ...]


class StrokeTable(NamedTuple):
    """Strokes as arrays: ends (n, 2, 2) on the face in millimetres, and the current of each gun (n, guns)."""

    ends: Floats
    currents: Floats

    @staticmethod
    def of(strokes: Sequence[MmStroke]) -> "StrokeTable":
        """The same strokes."""
        ends = np.array([(*stroke.start, *stroke.end) for stroke in strokes], np.float64)
        guns = len(strokes[0].currents) if strokes else 1
        currents = np.array([stroke.currents for stroke in strokes], np.float64).reshape(-1, guns)
        return StrokeTable(ends.reshape(-1, 2, 2), currents)


class Segment(NamedTuple):
    """A stretch of the frame: what the beam does, from when, how long (ps), from where to where (mm)."""

    kind: Literal["jump", "settle", "stroke", "wait"]
    start_ps: int
    duration_ps: int
    begin: Point
    end: Point
    currents: tuple[float, ...]
    stroke: int


KINDS: tuple[Literal["jump", "settle", "stroke", "wait"], ...] = ("jump", "settle", "stroke", "wait")
JUMP, SETTLE, STROKE, WAIT = range(4)


@dataclass(frozen=True, slots=True, eq=False)
class Timeline:
    """The stretches of a frame in order: kind (a number of ``KINDS``), times in picoseconds, places (k, 2) in
    millimetres, and the stroke of each, -1 for none.
    """

    kind: NDArray[np.int64]
    start_ps: NDArray[np.int64]
    duration_ps: NDArray[np.int64]
    begin: Floats
    end: Floats
    stroke: NDArray[np.int64]


def timeline(
    strokes: StrokeTable, timing: VectorTiming, units_per_mm: float, home: Point, min_frame_ps: int = 0
) -> Timeline:
    """The whole frame in order, without gaps; the last stretch waits until the frame may end.

    The beam starts where the last stroke ended. Its total is the sum of its parts, in picoseconds.
    """
    count = len(strokes.ends)
    starts, stops = strokes.ends[:, 0], strokes.ends[:, 1]
    before = np.roll(stops, 1, axis=0)
    distances = _longer_ways(before, starts)
    jumps = timing.jumps_ps(distances * units_per_mm)
    moved = distances > 0.0
    lit = timing.strokes_ps(_longer_ways(starts, stops) * units_per_mm)
    durations = np.zeros(3 * count + 1, np.int64)
    durations[0:-1:3], durations[1:-1:3], durations[2:-1:3] = jumps, moved * timing.settle_ps, lit
    durations[-1] = max(max(timing.min_frame_ps, min_frame_ps, 1) - int(durations.sum()), 0)
    rest = stops[-1] if count else np.array(home)
    begin, end = np.empty((3 * count + 1, 2)), np.empty((3 * count + 1, 2))
    begin[0:-1:3], begin[1:-1:3], begin[2:-1:3], begin[-1] = before, starts, starts, rest
    end[0:-1:3], end[1:-1:3], end[2:-1:3], end[-1] = starts, starts, stops, rest
    kinds, numbers = np.full(3 * count + 1, WAIT), np.full(3 * count + 1, -1)
    kinds[:-1] = np.tile([JUMP, SETTLE, STROKE], count)
    numbers[2:-1:3] = np.arange(count)
    # By number, as rows of two are picked by a mask ten times as slowly
    there = np.flatnonzero(durations > 0)
    kinds, durations, numbers = kinds[there], durations[there], numbers[there]
    clock = np.cumsum(durations) - durations
    return Timeline(kinds, clock, durations, begin.take(there, axis=0), end.take(there, axis=0), numbers)


def _longer_ways(begins: Floats, ends: Floats) -> Floats:
    """The longer of the two components of each way, (n,)."""
    x, y = np.abs(ends - begins).T
    longer: Floats = np.maximum(x, y)
    return longer


def with_dark(currents: Floats, guns: int, blanked: float) -> Floats:
    """Currents of strokes (n, guns), and after them, as number -1, what the beam has between strokes."""
    return np.concatenate([currents.reshape(-1, guns), np.full((1, guns), blanked)])


def segments_of(frame: Timeline, currents: Floats) -> list[Segment]:
    """The stretches of a frame, one value each; ``currents`` as ``with_dark`` gives them."""
    listed = list(map(tuple, currents.tolist()))
    columns = frame.kind, frame.start_ps, frame.duration_ps, frame.begin, frame.end, frame.stroke
    return [
        Segment(KINDS[kind], start, took, tuple(a), tuple(b), listed[stroke], stroke)
        for kind, start, took, a, b, stroke in zip(*(each.tolist() for each in columns), strict=True)
    ]
