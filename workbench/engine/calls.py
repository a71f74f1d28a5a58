"""The calls of a recorded run: in which of them an event is, and what its variables were."""

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple, overload

from numpy.typing import NDArray

from workbench.algorithms.entry import CALLS
from workbench.engine.columns import MISSING
from workbench.engine.recording import Recording

_NONE = -1


class Variables(Mapping[str, Any]):
    """The variables of one call at one time; each is read when it is asked for, since a picture is costly.

    Of a text that calls itself the calls under way are among them, as CALLS.
    """

    def __init__(self, recording: Recording, frame: int, stamp: int) -> None:
        self._recording, self._frame, self._stamp = recording, frame, stamp
        self._since = recording.frame_starts[frame]
        self._columns = recording.columns(recording.frame_depths[frame], recording.frame_texts[frame])

    def __getitem__(self, name: str) -> Any:
        if name in self._columns:
            value = self._columns[name].read(self._since, self._stamp)
            if value is not MISSING:
                return value
        elif name == CALLS and _calls_itself(self._recording):
            return _Calls(self._recording, self._frame, self._stamp)
        raise KeyError(name)

    def __iter__(self) -> Iterator[str]:
        return (name for name in (*self._columns, CALLS) if name in self)

    def __len__(self) -> int:
        return sum(1 for _name in self)


class _Calls(Sequence[Variables]):
    """The variables of the calls under way, the first call first; there may be thousands."""

    def __init__(self, recording: Recording, frame: int, stamp: int) -> None:
        self._recording, self._frame, self._stamp = recording, frame, stamp
        self._frames: list[int] = []

    def __len__(self) -> int:
        return int(self._recording.frame_depths[self._frame]) + 1

    @overload
    def __getitem__(self, index: int) -> Variables: ...
    @overload
    def __getitem__(self, index: slice) -> list[Variables]: ...
    def __getitem__(self, index: int | slice) -> Any:
        if not self._frames:
            self._frames = [*_outwards(self._recording, self._frame)][::-1]
        if isinstance(index, slice):
            return [Variables(self._recording, frame, self._stamp) for frame in self._frames[index]]
        return Variables(self._recording, self._frames[index], self._stamp)


class OwnCall(NamedTuple):
    """How far a call of an entry's own text has come: the ``number``-th of the run, from 0.

    ``variables`` are those of the innermost one where it calls itself; ``emitted`` (n, k) is its own.
    """

    number: int
    variables: Variables
    emitted: NDArray[Any]
    ended: bool


def variables_at(recording: Recording, event: int) -> Variables:
    """Those of the entry's own text at an event in it or in what it calls."""
    return Variables(recording, _own(recording, int(recording.frame_column[event])), 2 * event)


def own_call(recording: Recording, first: int, last: int, count: int, over: bool) -> OwnCall:
    """The call that event ``first`` is in, before event ``last``, or at its own end where that comes first.

    Of all that the run emitted ``count`` are there by then; ``over`` says that it has come to its end.
    """
    *_inner, root = _outwards(recording, int(recording.frame_column[first]))
    number = bisect_right(recording.call_frames, root) - 1
    following = number + 1
    event, ended = last, over
    if following < len(recording.call_frames):
        event = _first_event(recording, recording.call_frames[following], first, last + 1) - 1
        if event < last:
            ended, count = True, min(count, recording.call_emissions[following])
    stamp = recording.frame_ends[root] if ended and recording.frame_ends[root] else 2 * event
    own = _own(recording, int(recording.frame_column[event]))
    emitted = recording.emitted.array(recording.call_emissions[number], count)
    return OwnCall(number, Variables(recording, own, stamp), emitted, ended)


def _calls_itself(recording: Recording) -> bool:
    first = recording.texts[0]
    return first.name in first.code.co_names


def _outwards(recording: Recording, frame: int) -> Iterator[int]:
    """A frame, the one it was called from, and so on."""
    while frame != _NONE:
        yield frame
        frame = int(recording.frame_parents[frame])


def _own(recording: Recording, frame: int) -> int:
    """The innermost frame of the entry's own text."""
    return next(each for each in _outwards(recording, frame) if recording.frame_texts[each] == 0)


def _first_event(recording: Recording, frame: int, low: int, high: int) -> int:
    """The first event from ``low`` on in a call that began with this frame or later; ``high`` if none is."""
    return bisect_left(range(high), True, low, key=lambda event: recording.frame_column[event] >= frame)
