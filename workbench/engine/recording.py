"""What a recorder wrote down, readable at any event, also while it grows on another thread."""

from array import array
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.engine.columns import MISSING, Column, Emissions, EmittedSoFar
from workbench.engine.effects import Text


@dataclass(frozen=True, slots=True)
class Moment:
    """The instant before a line runs: its number in the source file, its function, what was emitted."""

    line: int
    function: str
    depth: int
    variables: dict[str, Any]
    emitted: Sequence[tuple[Any, ...]]


@dataclass(frozen=True, slots=True)
class Failure:
    """How a run ended early: the exception, and where; ``overflow`` when the recursion went too deep."""

    exception: BaseException
    line: int
    function: str
    depth: int
    overflow: bool

    def __str__(self) -> str:
        return f"{type(self.exception).__name__} in line {self.line}: {self.exception}"


class Recording:
    """Line events as columns; see the module of the recorder for how they come about.

    ``complete`` is set when the run came to its own end, ``truncated`` when the limit on line events stopped
    it, ``error`` when it raised. ``result`` is what a plain function returned. ``steps_before`` steps ran
    before the first event that is recorded, and ``begun_in`` and ``begun_at`` tell in which viewed block and
    line each of the calls was that were then under way. ``call_emissions`` and ``call_frames`` are how many
    emissions and frames there were when each call of the run itself began.
    """

    def __init__(self, texts: tuple[Text, ...]) -> None:
        self.texts = texts
        self.count = 0
        self.emitted = Emissions()
        self.complete = False
        self.truncated = False
        self.error: Failure | None = None
        self.result: Any = None
        self.steps_before = 0
        self.call_emissions = array("I")
        self.call_frames = array("I")
        self.begun_in = array("h")
        self.begun_at = array("I")
        self.line_column = array("I")
        self.frame_column = array("I")
        self.frame_texts = array("H")
        self.frame_depths = array("I")
        self.frame_parents = array("i")
        self.frame_starts = array("I")
        self.frame_ends = array("I")
        self._columns: dict[tuple[int, int], dict[str, Column]] = {}
        self._arrays: tuple[int, NDArray[np.uint32], NDArray[np.uint32]] | None = None

    def begin_call(self) -> None:
        """The run calls the entry (once more) with arguments of its own."""
        self.call_emissions.append(len(self.emitted))
        self.call_frames.append(len(self.frame_starts))

    @property
    def functions(self) -> Mapping[str, Callable[..., Any]]:
        """Every function whose lines are recorded, the entry first."""
        return {text.name: text.function for text in self.texts}

    def columns(self, depth: int, text: int) -> dict[str, Column]:
        """The columns of the variables of one text at one depth."""
        found = self._columns.get((depth, text))
        if found is None:
            found = self._columns[depth, text] = {name: Column() for name in self.texts[text].names}
        return found

    def __len__(self) -> int:
        return self.count

    def __getitem__(self, event: int) -> Moment:
        event = self._index(event)
        frame = self.frame_column[event]
        return Moment(
            self.line_column[event],
            self.texts[self.frame_texts[frame]].name,
            self.frame_depths[frame],
            self._read(frame, 2 * event),
            EmittedSoFar(self.emitted, self.emitted.count_at(event)),
        )

    def _index(self, event: int) -> int:
        if not -self.count <= event < self.count:
            raise IndexError(f"There is no line event {event}; {self.count} are recorded.")
        return event % self.count

    def _read(self, frame: int, stamp: int) -> dict[str, Any]:
        since = self.frame_starts[frame]
        columns = self.columns(self.frame_depths[frame], self.frame_texts[frame])
        values = ((name, column.read(since, stamp)) for name, column in columns.items())
        return {name: value for name, value in values if value is not MISSING}

    def after(self, event: int) -> dict[str, Any]:
        """Variables of the frame of ``event`` once its line has run, as far as that is recorded."""
        event = self._index(event)
        return self._read(self.frame_column[event], self._stamp_after(event))

    def values_after(self, event: int, names: Iterable[str]) -> dict[str, Any]:
        """As ``after``, but of the variables ``names`` alone, those of them that there are."""
        event = self._index(event)
        frame, stamp = self.frame_column[event], self._stamp_after(event)
        since = self.frame_starts[frame]
        columns = self.columns(self.frame_depths[frame], self.frame_texts[frame])
        values = ((name, columns[name].read(since, stamp)) for name in names if name in columns)
        return {name: value for name, value in values if value is not MISSING}

    def _stamp_after(self, event: int) -> int:
        """When the line of ``event`` has run."""
        following = self.next_in_frame(event)
        return (
            2 * following if following is not None else self.frame_ends[self.frame_column[event]] or 2 * event
        )

    def next_in_frame(self, event: int) -> int | None:
        """The next line event of the same call, or None when it is left (or recorded no further)."""
        event = self._index(event)
        frame = self.frame_column[event]
        last = self.count
        if self.frame_ends[frame]:
            last = min(last, (self.frame_ends[frame] + 1) // 2)
        step = 64
        while event + 1 < last:
            upto = min(event + 1 + step, last)
            try:
                return self.frame_column[event + 1 : upto].index(frame) + event + 1
            except ValueError:
                event = upto - 1
                step *= 4
        return None

    def stack(self, event: int) -> list[tuple[int, str, dict[str, Any]]]:
        """(line, function, variables) of every call under way at ``event``, the innermost first."""
        event = self._index(event)
        frame, at, found = int(self.frame_column[event]), event, []
        while frame >= 0:
            while at >= 0 and self.frame_column[at] != frame:
                at -= 1
            line = self.line_column[at] if at >= 0 else self.begun_at[frame]
            found.append((line, self.texts[self.frame_texts[frame]].name, self._read(frame, 2 * event)))
            frame = self.frame_parents[frame]
        return found

    def changed(self, event: int) -> frozenset[str]:
        """Names of the running frame whose value became another with the line before."""
        event = self._index(event)
        frame = self.frame_column[event]
        columns = self.columns(self.frame_depths[frame], self.frame_texts[frame])
        return frozenset(name for name, column in columns.items() if column.changed_at(2 * event))

    def emitted_count(self, event: int) -> int:
        """How many were emitted before the line of ``event`` ran."""
        return self.emitted.count_at(self._index(event))

    def _events(self) -> tuple[int, NDArray[np.uint32], NDArray[np.uint32]]:
        count = self.count
        if self._arrays is None or self._arrays[0] != count:
            lines = np.frombuffer(self.line_column[:count], np.uint32)
            frames = np.frombuffer(self.frame_column[:count], np.uint32)
            self._arrays = count, lines, frames
        return self._arrays

    @property
    def lines(self) -> NDArray[np.uint32]:
        """(n,) line number in the source file of each event."""
        return self._events()[1]

    @property
    def frames(self) -> NDArray[np.uint32]:
        """(n,) number of the call each event belongs to, in order of the calls' beginning."""
        return self._events()[2]

    @property
    def depths(self) -> NDArray[np.uint32]:
        """(n,) depth of each event; 0 is the entry's own call."""
        frames = self.frames
        return np.frombuffer(self.frame_depths[:], np.uint32)[frames]

    @property
    def codes(self) -> NDArray[np.uint16]:
        """(n,) index into ``texts`` of the function each event is in."""
        frames = self.frames
        return np.frombuffer(self.frame_texts[:], np.uint16)[frames]

    def ran_between(self, first: int, last: int) -> frozenset[tuple[str, int]]:
        """(function, line) of the events ``first`` to ``last`` (left out)."""
        last = min(last, self.count)
        lines = np.frombuffer(self.line_column[first:last], np.uint32)
        frames = np.frombuffer(self.frame_column[first:last], np.uint32)
        texts = np.frombuffer(self.frame_texts[:], np.uint16)[frames]
        found = np.unique(texts.astype(np.uint64) << np.uint64(32) | lines).tolist()
        return frozenset((self.texts[each >> 32].name, each & 0xFFFFFFFF) for each in found)

    def event_at(self, emission: int) -> int:
        """The line event that emitted number ``emission``."""
        return int(self.emitted.events(emission, emission + 1)[0]) - 1

    def size_bytes(self) -> int:
        """Bytes held by the event columns alone."""
        return sum(len(column) * column.itemsize for column in (self.line_column, self.frame_column))
