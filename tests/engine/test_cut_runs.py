"""A run is told wherever it is cut: while it grows, at a limit, stopped, ended by an error, or too deep."""

import copy

import numpy as np
import pytest

from tests.engine.test_observation import so_far
from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.engine import recorder
from workbench.engine.calls import own_call
from workbench.engine.observation import Steps
from workbench.engine.recorder import Recorder, record
from workbench.engine.recording import Failure, Recording

ENTRIES = [pytest.param(entry, id=entry.slug) for entry in catalogue.entries()]
_SHORT = 80
_CUTS = 16
_ENDS = 3


def run_of(entry: Entry, limit: int = recorder.LIMIT, depth_limit: int | None = None) -> Recording:
    return record(entry.function, *copy.deepcopy(entry.example), limit=limit, depth_limit=depth_limit)


def spread(length: int, most: int) -> list[int]:
    """Lengths spread over a run of this one, with the whole and, next to one another, those at its ends."""
    return sorted({1, 2, 3, length - 1, length, *np.linspace(0, length, most).astype(int).tolist()})


def ended_with_its_line(part: Recording, error: Failure | None) -> Recording:
    """The same as when an error in its last line ended all calls; it is told once they have ended."""
    part.frame_ends = part.frame_ends[:]
    for call, end in enumerate(part.frame_ends):
        part.frame_ends[call] = end or max(2 * part.count - 1, 0)
    part.error = error
    return part


def tell(entry: Entry, recording: Recording) -> None:
    """All that the program asks about its last event and its last step."""
    steps = Steps(entry, recording)
    last = len(steps)
    assert bool(steps[last].row) <= bool(last)
    steps.candidates_next(last)
    steps.options_next(last)
    for event in (len(recording) - 1, len(recording)):
        steps.told(event)
        steps.marks_told(event)
    if len(recording):
        event = len(recording) - 1
        call = own_call(recording, event, event, recording.emitted_count(event), False)
        list(entry.marks(entry.example, call.variables, call.emitted, call.ended))


@pytest.mark.parametrize("entry", ENTRIES)
def test_a_run_is_told_at_any_length_also_where_an_error_ends_it(entry: Entry) -> None:
    whole = run_of(entry)
    length = len(whole)
    for cut in range(length + 1) if length <= _SHORT else spread(length, _CUTS):
        tell(entry, so_far(whole, cut))
        if 0 < cut < length:
            failure = Failure(ZeroDivisionError(), 0, entry.slug, 0, overflow=False)
            tell(entry, ended_with_its_line(so_far(whole, cut), None))
            tell(entry, ended_with_its_line(so_far(whole, cut), failure))


@pytest.mark.parametrize("entry", ENTRIES)
def test_a_run_that_a_limit_or_a_stop_ends_is_told_up_to_there(
    entry: Entry, monkeypatch: pytest.MonkeyPatch
) -> None:
    length = len(run_of(entry))
    for cut in spread(length, _ENDS)[1:-1]:
        limited = run_of(entry, limit=cut)
        assert limited.truncated
        tell(entry, limited)
        monkeypatch.setattr(recorder, "_SLICE", cut)
        stopped = Recorder(entry.function, *copy.deepcopy(entry.example))
        stopped.stop()
        stopped.start()
        assert stopped.join(30.0)
        assert stopped.recording.count == cut
        assert not stopped.recording.complete
        tell(entry, stopped.recording)


@pytest.mark.parametrize("entry", ENTRIES)
def test_a_run_that_goes_too_deep_is_told_up_to_there(entry: Entry) -> None:
    for depth_limit in range(int(max(run_of(entry).depths))):
        tell(entry, run_of(entry, depth_limit=depth_limit))
