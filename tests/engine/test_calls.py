"""Which call of a run an event is in, what its variables were, and what it had emitted by then."""

from itertools import pairwise

import numpy as np
import pytest

from workbench.algorithms import catalogue
from workbench.algorithms.entry import CALLS
from workbench.engine.calls import Variables, own_call, variables_at
from workbench.engine.observation import Steps
from workbench.engine.recorder import Recorder
from workbench.engine.visits import skip

LINES = [(10.0, 30.0, 40.0, 0.0), (2.0, 2.0, 5.0, 5.0), (-9.0, -9.0, -9.0, 40.0), (5.0, 10.0, 50.0, 12.0)]
CALLED = [(*line, 0.0, 0.0, 30.0, 20.0) for line in LINES]


def recorded(slug, calls, passed=0):
    entry = catalogue.get(slug)
    recorder = Recorder(entry.function, *calls[0], then=calls[1:], skip=skip(entry, passed))
    recorder.start()
    assert recorder.join(30)
    return entry, recorder.recording, Steps(entry, recorder.recording)


def state_of(recording, step):
    last = max(step.last, 0)
    over = recording.complete and last == len(recording) - 1
    return own_call(recording, max(step.first, 0), last, step.emitted_to, over)


def test_a_step_belongs_to_the_call_that_it_begins_in() -> None:
    entry, recording, steps = recorded("cohen_sutherland", CALLED)
    states = [state_of(recording, step) for step in steps]
    assert {state.number for state in states} == {0, 1, 2, 3}
    assert [state.number for state in states] == sorted(state.number for state in states)
    for number, call in enumerate(CALLED):
        ended = [state for state in states if state.number == number and state.ended]
        kept = [list(row) for row in entry.function(*call)]
        assert [state.emitted.tolist() for state in ended] == [kept]
        assert all(state.variables["ax"] == call[0] for state in states if state.number == number)
    assert not any(state.ended for state, after in pairwise(states) if state.number == after.number)


@pytest.mark.parametrize("passed", [1, 3, 5])
def test_a_call_is_told_in_a_stretch_from_the_middle_too(passed: int) -> None:
    _entry, recording, steps = recorded("cohen_sutherland", CALLED)
    _entry, part, its_steps = recorded("cohen_sutherland", CALLED, passed)
    assert part.steps_before == passed
    for number in range(1, len(its_steps) + 1):
        here, there = state_of(part, its_steps[number]), state_of(recording, steps[passed + number])
        assert here.number == there.number
        assert here.ended == there.ended
        assert here.emitted.tolist() == there.emitted.tolist()
        assert dict(here.variables) == dict(there.variables)


def test_within_a_function_that_it_calls_the_texts_own_variables_are_there() -> None:
    _entry, recording, _steps = recorded("sutherland_hodgman", [catalogue.get("sutherland_hodgman").example])
    inner = np.flatnonzero(recording.depths == 1)
    assert len(inner) > 10
    for event in inner.tolist()[::7]:
        assert "polygon" not in recording[event].variables
        assert len(variables_at(recording, event)["polygon"]) >= 8


def test_variables_are_a_mapping_of_those_that_are_bound() -> None:
    _entry, recording, _steps = recorded("liang_barsky", [CALLED[0]])
    first, last = variables_at(recording, 0), Variables(recording, 0, 2 * len(recording))
    assert set(first) == {"x0", "y0", "x1", "y1", "xmin", "ymin", "xmax", "ymax"}
    assert len(first) == 8
    assert "u1" not in first
    assert first.get("u1", 0.5) == 0.5
    assert {"u1", "u2", "k", "p", "q"} <= set(last)
    assert CALLS not in last
    assert dict(recording[9].variables) == dict(variables_at(recording, 9))


def test_of_a_text_that_calls_itself_the_innermost_call_counts() -> None:
    picture = np.zeros((2, 6), np.int64)
    _entry, recording, _steps = recorded("boundary_fill_recursive", [(picture, 0, 0, 2, 1)])
    for event in range(0, len(recording), 11):
        now = variables_at(recording, event)
        calls = now[CALLS]
        asking = recording.codes[event] != 0  # what only reads a pixel is no call of the fill's own
        assert len(calls) == recording.depths[event] + 1 - asking == len(list(calls))
        assert calls[-1]["x"] == now["x"] == recording[event].variables["x"]
        assert (calls[0]["x"], calls[0]["y"]) == (0, 0)
        under_way = recording.stack(event)[::-1][: len(calls)]
        assert [(c["x"], c["y"]) for c in calls] == [(v["x"], v["y"]) for _line, _name, v in under_way]
        assert [c["x"] for c in calls[-2:]] == [c["x"] for c in list(calls)[-2:]]


def test_what_the_next_call_emits_before_its_first_step_is_not_its_own() -> None:
    curves = [(np.array([(0.0, 0.0), (9.0, y), (20.0, 0.0)]), 1.0) for y in (6.0, -3.0)]
    entry, recording, steps = recorded("flatten_bezier", curves)
    for step in list(steps)[1:]:
        state = state_of(recording, step)
        whole = np.array(list(entry.function(*curves[state.number])))
        assert len(state.emitted) <= len(whole)
        assert (state.emitted == whole[: len(state.emitted)]).all()
        assert state.ended == (len(state.emitted) == len(whole))
