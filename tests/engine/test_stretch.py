"""A stretch of a run, recorded from a chosen step on, is that stretch of the whole recording."""

from functools import lru_cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.engine.test_recorder import equal
from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.engine.observation import Steps
from workbench.engine.recorder import Recorder, record
from workbench.engine.recording import Recording
from workbench.engine.visits import skip

ENTRIES = [entry for entry in catalogue.entries() if any(view.row for view in entry.views)]


def example(entry: Entry) -> tuple[Any, ...]:
    """The arguments of the entry's example, sharing nothing with another call."""
    values = entry.example
    return tuple(value.copy() if isinstance(value, np.ndarray) else value for value in values)


@lru_cache(maxsize=1)
def whole_run(slug: str) -> Recording:
    """The recording of an entry's example, once for all stretches of it."""
    entry = catalogue.get(slug)
    return record(entry.function, *example(entry))


def both(entry: Entry, passed: int, limit: int = 1_000_000) -> tuple[Recording, Recording]:
    return whole_run(entry.slug), record(
        entry.function, *example(entry), skip=skip(entry, passed), limit=limit
    )


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.slug)
@settings(max_examples=8)
@given(data=st.data())
def test_a_stretch_is_the_whole_from_there(entry: Entry, data: st.DataObject) -> None:
    whole = whole_run(entry.slug)
    steps = Steps(entry, whole)
    passed = data.draw(st.integers(1, max(len(steps) - 1, 1)))
    stretch = record(entry.function, *example(entry), skip=skip(entry, passed))
    shown = Steps(entry, stretch)
    assert (stretch.complete, stretch.error, len(shown)) == (True, None, max(len(steps) - passed, 0))
    assert stretch.emitted == whole.emitted
    if passed == len(steps):
        assert stretch.steps_before == passed
        return
    first = steps.span(passed + 1)[0]
    assert len(stretch) == len(whole) - first
    for event in {0, len(stretch) - 1, *data.draw(st.lists(st.integers(0, len(stretch) - 1), max_size=12))}:
        a, b = whole[first + event], stretch[event]
        assert (a.line, a.function, a.depth) == (b.line, b.function, b.depth)
        assert equal(a.variables, b.variables)
        assert len(a.emitted) == len(b.emitted)
        assert [frame[:2] for frame in whole.stack(first + event)] == [
            frame[:2] for frame in stretch.stack(event)
        ]
    for number in {1, len(shown), data.draw(st.integers(1, len(shown)))}:
        a, b = steps[passed + number], shown[number]
        assert (a.row, a.title, a.candidates, a.chosen, a.rejected) == (
            b.row,
            b.title,
            b.candidates,
            b.chosen,
            b.rejected,
        )
        assert (a.tables, a.sentence, a.emitted_from, a.emitted_to) == (
            b.tables,
            b.sentence,
            b.emitted_from,
            b.emitted_to,
        )
        assert (a.first - first, a.last - first) == (b.first, b.last)


def test_the_limit_counts_what_is_recorded() -> None:
    whole, stretch = both(catalogue.get("bresenham_line"), 3, limit=10)
    assert (len(stretch), stretch.truncated, stretch.steps_before) == (10, True, 3)
    assert stretch[9].variables.items() <= whole[len(whole) - 1].variables.items() | set(
        stretch[9].variables.items()
    )


def test_more_steps_passed_than_there_are() -> None:
    _whole, stretch = both(catalogue.get("bresenham_line"), 500)
    assert (len(stretch), stretch.complete, stretch.steps_before) == (0, True, 10)


def test_calls_too_deep_end_the_run_before_the_stretch_too() -> None:
    entry = catalogue.get("boundary_fill_recursive")
    failed = record(entry.function, *example(entry), skip=skip(entry, 10_000), depth_limit=3)
    assert failed.error is not None
    assert failed.error.overflow
    assert str(failed.error) == str(record(entry.function, *example(entry), depth_limit=3).error)


def test_a_recorder_is_stopped_while_it_passes_over() -> None:
    entry = catalogue.get("flood_fill_4")
    image = np.zeros((300, 300), np.int64)
    recorder = Recorder(entry.function, image, 150, 150, 1, skip=skip(entry, 89_000))
    recorder.start()
    recorder.stop()
    assert recorder.join(30)
    assert (len(recorder.recording), recorder.recording.complete) == (0, False)
