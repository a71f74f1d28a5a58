"""The beam of a random-scan tube: a display list in time, and what it leaves on the face.

A picture lasts as long as its strokes, jumps and settles take together, and never less than the shortest
frame allowed. The beam's place is found by bisection in the cumulative times. Strokes are cut into short
pieces, so that each touches a small box of the face; a piece that lies in the past as a whole is kept as a
patch, and runs of pieces as whole maps, already decayed to the end of the run.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.display.beam import BeamState
from workbench.display.blurred_strokes import blur_strokes
from workbench.display.many_strokes import draw_strokes, strokes_ready
from workbench.display.spot import narrowed, stroke_energy, stroke_remainder
from workbench.display.stroke_timeline import (
    WAIT,
    MmStroke,
    Point,
    Segment,
    StrokeTable,
    segments_of,
    timeline,
    with_dark,
)
from workbench.display.tube import Tube
from workbench.display.vector_timing import VectorTiming

Floats = NDArray[np.floating[Any]]

_PIECE_PX = 24.0
_FEW, _MANY = 64, 500
_RUNS = 8
_NOTHING_LEFT = 1e-30


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


class VectorBeam:
    """Draws strokes over and over on a tube. ``power`` is the energy per second of a full current.

    ``min_frame_ps`` holds short lists back, so that a phosphor is not burnt. An empty list waits. Each of
    many pieces is taken to fade evenly over its length, and until ``beam_strokes`` is compiled those of a
    long list are blurred. ``blanked`` is the current between strokes, 0 to 1: a rest of it, where brightness
    is turned up. ``blurred`` tells whether anything was, so that a beam made anew may be sharper.
    """

    def __init__(
        self,
        tube: Tube,
        strokes: Sequence[MmStroke] | StrokeTable,
        timing: VectorTiming,
        power: float = 1.0,
        min_frame_ps: int = 0,
        blanked: float = 0.0,
    ) -> None:
        self.power = power
        self._geometry = tube.size_px, tube.size_mm, tube.spot_mm, tube.reach
        self._kind = tube.stored[0].dtype
        self._taus = tuple(tuple(term.tau_s for term in gun.terms) for gun in tube.guns)
        width, height = tube.size_mm
        table = strokes if isinstance(strokes, StrokeTable) else StrokeTable.of(strokes)
        self._currents = with_dark(table.currents, len(tube.guns), blanked)
        self.timeline = timeline(table, timing, timing.grid / width, (width / 2, height / 2), min_frame_ps)
        self.frame_ps = int(self.timeline.duration_ps.sum())
        waits = bool(self.timeline.kind[-1] == WAIT)
        self.list_ps = self.frame_ps - waits * int(self.timeline.duration_ps[-1])
        self._cut(min(width / tube.size_px[0], height / tube.size_px[1]) * _PIECE_PX)
        count = len(self._starts)
        per_run = -(-count // _RUNS) or 1
        self._runs = [(i, min(i + per_run, count)) for i in range(0, count, per_run)]
        self.blurred = False
        self._frames: dict[int, Floats] = {}
        self._maps: dict[tuple[int, int, float], Floats] = {}

    @cached_property
    def segments(self) -> list[Segment]:
        """The stretches of the frame, one value each."""
        return segments_of(self.timeline, self._currents)

    @cached_property
    def pieces(self) -> list[Segment]:
        """The pieces into which the strokes are cut, one value each."""
        return [self._piece(number) for number in range(len(self._starts))]

    def _piece(self, number: int) -> Segment:
        stroke, start = int(self._of[number]), int(self._starts[number])
        (x0, y0), (x1, y1) = self._begins[number].tolist(), self._stops[number].tolist()
        return Segment(
            "stroke" if stroke >= 0 else "jump",
            start,
            int(self._ends[number]) - start,
            (x0, y0),
            (x1, y1),
            tuple(self._currents[stroke].tolist()),
            stroke,
        )

    @property
    def frame_s(self) -> Fraction:
        """Seconds from one picture to the next."""
        return Fraction(self.frame_ps, 10**12)

    def _cut(self, longest_mm: float) -> None:
        """Cut every lit stretch into pieces of the same length, none longer than ``longest_mm``."""
        frame = self.timeline
        shining = np.asarray((self._currents > 0.0).any(axis=1))
        lit = np.flatnonzero(shining[frame.stroke])
        begins = frame.begin.take(lit, axis=0)
        ways = frame.end.take(lit, axis=0) - begins
        counts = np.maximum(np.ceil(np.hypot(*ways.T) / longest_mm), 1).astype(np.int64)
        of = np.repeat(np.arange(len(lit)), counts)
        number = np.arange(len(of)) - (np.cumsum(counts) - counts)[of]
        durations = frame.duration_ps[lit][of]
        first, last = durations * number // counts[of], durations * (number + 1) // counts[of]
        there = last > first
        of, first, last, durations = of[there], first[there], last[there], durations[there]
        self._starts, self._ends = frame.start_ps[lit][of] + first, frame.start_ps[lit][of] + last
        begins, ways = begins.take(of, axis=0), ways.take(of, axis=0)
        self._begins = begins + ways * (first / durations)[:, None]
        self._stops = begins + ways * (last / durations)[:, None]
        self._of = frame.stroke[lit][of]

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

    def _left_by(self, pieces: slice | NDArray[np.int64], gun: int, weights: Floats | float = 1.0) -> Floats:
        """What pieces leave, all at once, each times its weight."""
        (columns, rows), (width, height), spot, _reach = self._geometry
        pitch = np.array([width / columns, height / rows])
        table = np.empty((len(self._starts[pieces]), 5))
        table[:, 0:2] = self._begins[pieces] / pitch - 0.5
        table[:, 2:4] = self._stops[pieces] / pitch - 0.5
        seconds = (self._ends[pieces] - self._starts[pieces]) * 1e-12
        table[:, 4] = self.power * self._currents[self._of[pieces], gun] * seconds * weights
        face = np.zeros((rows, columns))
        spot_px = spot / math.sqrt(float(pitch.prod()))
        if strokes_ready():
            draw_strokes(face, table, spot_px)
        else:
            self.blurred = True
            blur_strokes(face, table, spot_px, len(table) / len(self._starts))
        return face.astype(self._kind, copy=False)

    @property
    def _at_once(self) -> bool:
        """Whether the pieces are so many that they are drawn together: by the compiled text if it is there
        already, else, were it long to add them up one by one, blurred."""
        return len(self._starts) > (_FEW if strokes_ready() else _MANY)

    def _map_of_run(self, run: int, gun: int, tau_s: float) -> Floats:
        """All pieces of a run, decayed to its end with one time constant (infinite: the energy itself)."""
        key = run, gun, tau_s
        if key not in self._maps and self._at_once:
            part = slice(*self._runs[run])
            kept = self._shares(part, int(self._ends[part.stop - 1]), tau_s)
            self._maps[key] = self._left_by(part, gun, kept)
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

    def _shares(self, pieces: slice | NDArray[np.int64], now: Fraction | int, tau_s: float) -> Floats | float:
        """What of the energy of each piece is still stored at a time of the frame (ps), all in one term."""
        if math.isinf(tau_s):
            return 1.0
        seconds = (self._ends[pieces] - self._starts[pieces]) * 1e-12
        ages = (float(now) - self._ends[pieces]) * 1e-12
        shares: Floats = np.exp(-ages / tau_s) * -np.expm1(-seconds / tau_s) / (seconds / tau_s)
        return shares

    def energy_per_frame(self, gun: int = 0) -> Floats:
        """What one whole frame deposits, (face rows, face columns); read-only."""
        if gun in self._frames:
            return self._frames[gun]
        columns, rows = self._geometry[0]
        if self._at_once:
            total = self._left_by(slice(None), gun)
        else:
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
            whole = range(0)
            if self._at_once:
                # Those that lie wholly in this time, all together; then the two at its ends
                ends = self._starts[first:last], self._ends[first:last]
                begun = first + int(np.searchsorted(ends[0], math.ceil(t0 - base)))
                over = first + int(np.searchsorted(ends[1], math.floor(t1 - base), side="right"))
                whole = range(begun, max(begun, over))
                self._deposit_whole(tube, slice(whole.start, whole.stop), now - base)
            low = first + int(np.searchsorted(self._ends[first:last], float(t0 - base), side="right"))
            for number in range(max(low - 1, first), last):
                if number in whole:
                    continue
                start, stop = int(self._starts[number]) + base, int(self._ends[number]) + base
                if start >= t1:
                    break
                begin, end = max(Fraction(start), t0), min(Fraction(stop), t1)
                if begin < end:
                    self._play_piece(tube, number, begin - start, end - begin, now - end)

    def _deposit_whole(self, tube: Tube, pieces: slice, now: Fraction) -> None:
        """Deposit pieces that are over at a time of the frame."""
        if pieces.stop <= pieces.start:
            return
        for gun, taus in enumerate(self._taus):
            left = [self._left_by(pieces, gun, self._shares(pieces, now, tau)) for tau in taus]
            tube.deposit_aged(self._left_by(pieces, gun), left, gun)

    def _play_piece(
        self, tube: Tube, number: int, elapsed: Fraction, duration: Fraction, age: Fraction
    ) -> None:
        piece = self._piece(number)
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
        number = int(np.searchsorted(self.timeline.start_ps, math.floor(within), side="right")) - 1
        start, took = (int(each[number]) for each in (self.timeline.start_ps, self.timeline.duration_ps))
        share = float((within - start) / took)
        begin, end = self.timeline.begin[number], self.timeline.end[number]
        x, y = (begin + share * (end - begin)).tolist()
        stroke = int(self.timeline.stroke[number])
        currents = tuple(self._currents[stroke].tolist())
        place = int((within - start) // 1000)
        return BeamState(x, y, currents, stroke >= 0, stroke, place, int(frame))
