"""The beam of a random-scan tube: a display list in time, and what it leaves on the face.

A picture lasts as long as its strokes, jumps and settles take together, and never less than the shortest
frame allowed. The beam's place is found by bisection in the cumulative times. Strokes are cut into short
pieces, so that each touches a small box of the face; a piece that lies in the past as a whole is kept as a
patch, and runs of pieces as whole maps, already decayed to the end of the run.
"""

import itertools
import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.display.beam import BeamState
from workbench.display.spot import narrowed, stroke_energy, stroke_remainder
from workbench.display.tube import Tube
from workbench.display.vector_timing import VectorTiming

Floats = NDArray[np.floating[Any]]
Point = tuple[float, float]

_PIECE_PX = 24.0
_RUNS = 8
_NOTHING_LEFT = 1e-30


class MmStroke(NamedTuple):
    """One stroke on the face, in millimetres, with the current of each gun, 0 to 1."""

    start: Point
    end: Point
    currents: tuple[float, ...]


class Segment(NamedTuple):
    """A stretch of the frame: what the beam does, from when, how long (ps), from where to where (mm)."""

    kind: Literal["jump", "settle", "stroke", "wait"]
    start_ps: int
    duration_ps: int
    begin: Point
    end: Point
    currents: tuple[float, ...]
    stroke: int


@dataclass(frozen=True, slots=True)
class _Marks:
    """Energy 1 of a piece on a box of the face, and what of it each term would have kept at its end."""

    region: tuple[slice, slice]
    energy: Floats
    remainders: tuple[Floats, ...]


@lru_cache(maxsize=1024)  # of many terms and wide spots, some 20 kB each
def _marks(
    size_px: tuple[int, int],
    size_mm: tuple[float, float],
    begin: Point,
    end: Point,
    spot_mm: float,
    reach: float,
    durations: tuple[float, ...],
    kind: str,
) -> _Marks:
    patch = stroke_energy(size_px, size_mm, begin, end, spot_mm, 1.0, reach)
    left = tuple(narrowed(stroke_remainder(patch, duration), kind) for duration in durations)
    return _Marks((patch.rows, patch.columns), narrowed(patch.values, kind), left)


def schedule(
    strokes: Sequence[MmStroke],
    timing: VectorTiming,
    units_per_mm: float,
    home: Point,
    min_frame_ps: int = 0,
) -> list[Segment]:
    """The whole frame in order, without gaps; the last stretch waits until the frame may end.

    The beam starts where the last stroke ended. Its total is the sum of its parts, in picoseconds.
    """
    segments: list[Segment] = []
    clock = 0
    at = strokes[-1].end if strokes else home
    dark = tuple(0.0 for _ in strokes[0].currents) if strokes else (0.0,)

    def add(kind: Literal["jump", "settle", "stroke", "wait"], duration: int, to: Point, *rest: Any) -> None:
        nonlocal clock, at
        if duration > 0:
            segments.append(Segment(kind, clock, duration, at, to, *(rest or (dark, -1))))
            clock += duration
        at = to

    for number, stroke in enumerate(strokes):
        jump = timing.jump_ps(
            (stroke.start[0] - at[0]) * units_per_mm, (stroke.start[1] - at[1]) * units_per_mm
        )
        moved = at != stroke.start
        add("jump", jump, stroke.start)
        if moved:
            add("settle", timing.settle_ps, stroke.start)
        dx, dy = stroke.end[0] - stroke.start[0], stroke.end[1] - stroke.start[1]
        lit = timing.stroke_ps(dx * units_per_mm, dy * units_per_mm)
        add("stroke", lit, stroke.end, stroke.currents, number)
    add("wait", max(timing.min_frame_ps, min_frame_ps, 1) - clock, at)
    return segments


class VectorBeam:
    """Draws strokes over and over on a tube. ``power`` is the energy per second of a full current.

    ``min_frame_ps`` holds short lists back, so that a phosphor is not burnt. An empty list waits.
    """

    def __init__(
        self,
        tube: Tube,
        strokes: Sequence[MmStroke],
        timing: VectorTiming,
        power: float = 1.0,
        min_frame_ps: int = 0,
    ) -> None:
        self.power = power
        self._geometry = tube.size_px, tube.size_mm, tube.spot_mm, tube.reach
        self._kind = tube.stored[0].dtype
        self._taus = tuple(tuple(term.tau_s for term in gun.terms) for gun in tube.guns)
        width, height = tube.size_mm
        units_per_mm = timing.grid / width
        self.segments = schedule(strokes, timing, units_per_mm, (width / 2, height / 2), min_frame_ps)
        self.frame_ps = sum(segment.duration_ps for segment in self.segments)
        self.list_ps = sum(s.duration_ps for s in self.segments if s.kind != "wait")
        self.pieces = self._cut(min(width / tube.size_px[0], height / tube.size_px[1]) * _PIECE_PX)
        self._starts = np.array([piece.start_ps for piece in self.pieces], dtype=np.int64)
        self._ends = self._starts + np.array([piece.duration_ps for piece in self.pieces], dtype=np.int64)
        self._segment_starts = [segment.start_ps for segment in self.segments]
        per_run = -(-len(self.pieces) // _RUNS) or 1
        self._runs = [(i, min(i + per_run, len(self.pieces))) for i in range(0, len(self.pieces), per_run)]
        self._frames: dict[int, Floats] = {}
        self._maps: dict[tuple[int, int, float], Floats] = {}

    @property
    def frame_s(self) -> Fraction:
        """Seconds from one picture to the next."""
        return Fraction(self.frame_ps, 10**12)

    def _cut(self, longest_mm: float) -> list[Segment]:
        pieces = []
        for segment in self.segments:
            if segment.kind != "stroke" or not any(segment.currents):
                continue
            (x0, y0), (x1, y1) = segment.begin, segment.end
            count = max(1, math.ceil(math.hypot(x1 - x0, y1 - y0) / longest_mm))
            times = [segment.duration_ps * i // count for i in range(count + 1)]
            for first, last in itertools.pairwise(times):
                a, b = self._along(segment, first), self._along(segment, last)
                pieces.append(
                    Segment(
                        "stroke",
                        segment.start_ps + first,
                        last - first,
                        a,
                        b,
                        segment.currents,
                        segment.stroke,
                    )
                )
        return [piece for piece in pieces if piece.duration_ps > 0]

    @staticmethod
    def _along(segment: Segment, elapsed_ps: Fraction | int) -> Point:
        share = float(Fraction(elapsed_ps) / segment.duration_ps)
        (x0, y0), (x1, y1) = segment.begin, segment.end
        return x0 + share * (x1 - x0), y0 + share * (y1 - y0)

    def _marks_of(
        self, begin: Point, end: Point, duration_s: float, taus: tuple[float, ...], keep: bool = True
    ) -> _Marks:
        size_px, size_mm, spot, reach = self._geometry
        durations = tuple(duration_s / tau for tau in taus)
        found = _marks if keep else _marks.__wrapped__
        return found(size_px, size_mm, begin, end, spot, reach, durations, str(self._kind))

    def _energy_of(self, piece: Segment, gun: int) -> float:
        return self.power * piece.currents[gun] * piece.duration_ps * 1e-12

    def _map_of_run(self, run: int, gun: int, tau_s: float) -> Floats:
        """All pieces of a run, decayed to its end with one time constant (infinite: the energy itself)."""
        key = run, gun, tau_s
        if key not in self._maps:
            columns, rows = self._geometry[0]
            total = np.zeros((rows, columns), dtype=self._kind)
            first, last = self._runs[run]
            end = int(self._ends[last - 1])
            for number in range(first, last):
                piece = self.pieces[number]
                taus = () if math.isinf(tau_s) else self._taus[gun]
                marks = self._marks_of(piece.begin, piece.end, piece.duration_ps * 1e-12, taus)
                values = marks.remainders[taus.index(tau_s)] if taus else marks.energy
                age = (end - int(self._ends[number])) * 1e-12
                total[marks.region] += values * (self._energy_of(piece, gun) * math.exp(-age / tau_s))
            self._maps[key] = total
        return self._maps[key]

    def energy_per_frame(self, gun: int = 0) -> Floats:
        """What one whole frame deposits, (face rows, face columns); read-only."""
        if gun in self._frames:
            return self._frames[gun]
        columns, rows = self._geometry[0]
        total = np.zeros((rows, columns), dtype=self._kind)
        for piece in self.pieces:
            if piece.currents[gun]:
                marks = self._marks_of(piece.begin, piece.end, 0.0, ())
                total[marks.region] += marks.energy * self._energy_of(piece, gun)
        total.setflags(write=False)
        self._frames[gun] = total
        return total

    def _passes(self, start: int, end: int, t0: Fraction, t1: Fraction) -> tuple[int, Fraction]:
        """How often [start, end) of the frame lies wholly in (t0, t1], and the age of the last (ps)."""
        first = math.ceil((t0 - start) / self.frame_ps)
        last = math.floor((t1 - end) / self.frame_ps)
        return max(last - first + 1, 0), t1 - (end + last * self.frame_ps)

    def _kept(self, count: int, age_ps: Fraction, tau_s: float) -> float:
        youngest = math.exp(-float(age_ps) * 1e-12 / tau_s)
        frame = self.frame_ps * 1e-12 / tau_s
        return youngest * math.expm1(-count * frame) / math.expm1(-frame)

    def play(self, tube: Tube, ticks: int | Fraction) -> None:
        """Let time pass on the tube while the beam draws."""
        t0 = tube.seconds * 10**12
        tube.advance(ticks)
        t1 = tube.seconds * 10**12
        whole: list[tuple[int, int, Fraction]] = []
        for run, (first, last) in enumerate(self._runs):
            start, end = int(self._starts[first]), int(self._ends[last - 1])
            count, age = self._passes(start, end, t0, t1)
            if count:
                whole.append((run, count, age))
                middle_end = t1 - age
                middle_start = middle_end - (end - start) - (count - 1) * self.frame_ps
                self._play_pieces(tube, first, last, t0, middle_start, t1)
                self._play_pieces(tube, first, last, middle_end, t1, t1)
            else:
                self._play_pieces(tube, first, last, t0, t1, t1)
        self._play_runs(tube, whole)

    def _play_runs(self, tube: Tube, whole: list[tuple[int, int, Fraction]]) -> None:
        """Deposit runs that passed as a whole, given as (run, how often, age of the last)."""
        if not whole:
            return
        for gun, taus in enumerate(self._taus):
            sums = []
            for tau in (math.inf, *taus):
                total = np.zeros(self._geometry[0][::-1], dtype=self._kind)
                for run, count, age in whole:
                    factor = count if math.isinf(tau) else self._kept(count, age, tau)
                    if factor > _NOTHING_LEFT:
                        total += self._map_of_run(run, gun, tau) * self._kind.type(factor)
                sums.append(total)
            tube.deposit_aged(sums[0], sums[1:], gun)

    def _play_pieces(
        self, tube: Tube, first: int, last: int, t0: Fraction, t1: Fraction, now: Fraction
    ) -> None:
        """Deposit what pieces ``first`` to ``last`` leave from t0 to t1, seen at ``now`` (ps)."""
        for frame in range(math.floor(t0 / self.frame_ps), math.floor(t1 / self.frame_ps) + 1):
            base = frame * self.frame_ps
            low = first + int(np.searchsorted(self._ends[first:last], float(t0 - base), side="right"))
            for piece in self.pieces[max(low - 1, first) : last]:
                begin = max(Fraction(piece.start_ps + base), t0)
                end = min(Fraction(piece.start_ps + piece.duration_ps + base), t1)
                if piece.start_ps + base >= t1:
                    break
                if begin < end:
                    self._play_piece(tube, piece, begin - base - piece.start_ps, end - begin, now - end)

    def _play_piece(
        self, tube: Tube, piece: Segment, elapsed: Fraction, duration: Fraction, age: Fraction
    ) -> None:
        a = self._along(piece, elapsed)
        b = self._along(piece, elapsed + duration)
        energy = self.power * float(duration) * 1e-12
        for gun, taus in enumerate(self._taus):
            if piece.currents[gun] == 0.0:
                continue
            marks = self._marks_of(a, b, float(duration) * 1e-12, taus, duration == piece.duration_ps)
            given = energy * piece.currents[gun]
            left = [
                values * (given * math.exp(-float(age) * 1e-12 / tau))
                for values, tau in zip(marks.remainders, taus, strict=True)
            ]
            tube.deposit_aged(marks.energy * given, left, gun, marks.region)

    def settle(self, tube: Tube) -> None:
        """Bring the tube to the state it would have, had this list always been drawn until now."""
        now = tube.seconds * 10**12
        fresh = Tube(
            tube.size_px,
            tube.size_mm,
            tube.guns,
            spot_mm=tube.spot_mm,
            reach=tube.reach,
            precision=tube.stored[0].dtype.type,
        )
        for run, (first, last) in enumerate(self._runs):
            start, end = int(self._starts[first]), int(self._ends[last - 1])
            passed = math.floor((now - end) / self.frame_ps)
            age = now - (end + passed * self.frame_ps)
            for gun, taus in enumerate(self._taus):
                left = [
                    self._map_of_run(run, gun, tau)
                    * (self._kept(1, age, tau) / -math.expm1(-float(self.frame_s) / tau))
                    for tau in taus
                ]
                fresh.deposit_aged(self._map_of_run(run, gun, math.inf), left, gun)
            begun = Fraction(start + (passed + 1) * self.frame_ps)
            if begun < now:
                self._play_pieces(fresh, first, last, begun, now, now)
        for gun in range(len(tube.guns)):
            tube.settle(list(fresh.stored[gun]), gun)

    def state(self, seconds: Fraction) -> BeamState:
        """Where the beam is and what it does at a time."""
        frame, within = divmod(seconds * 10**12, self.frame_ps)
        number = bisect_right(self._segment_starts, math.floor(within)) - 1
        segment = self.segments[number]
        x, y = self._along(segment, within - segment.start_ps)
        place = int((within - segment.start_ps) // 1000)
        lit = segment.kind == "stroke"
        return BeamState(x, y, segment.currents, lit, segment.stroke, place, int(frame))

    @cached_property
    def times_ps(self) -> dict[str, int]:
        """How the frame is spent: picoseconds per kind of stretch."""
        spent = {"stroke": 0, "jump": 0, "settle": 0, "wait": 0}
        for segment in self.segments:
            spent[segment.kind] += segment.duration_ps
        return spent
