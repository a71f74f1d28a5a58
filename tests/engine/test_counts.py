"""Counts against the tracer: runs of each line, steps, and operations reckoned by hand."""

from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.engine import written_texts as texts
from workbench.algorithms import catalogue
from workbench.engine.counts import counts, step_total
from workbench.engine.observation import Steps
from workbench.engine.recorder import record
from workbench.engine.touches import touches

ENTRIES = [pytest.param(entry, id=entry.slug) for entry in catalogue.entries()]
# Among them texts with helpers, with lists, with a picture of their own and with records
COMPILED = ("bresenham_line", "scan_line_crossings", "boundary_fill_4", "depth_buffer")
LINE = catalogue.get("bresenham_line").function


@pytest.mark.parametrize("entry", ENTRIES)
def test_lines_and_steps_are_those_that_the_tracer_sees(entry: catalogue.Entry) -> None:
    recording = record(entry.function, *entry.example)
    names = [text.name for text in recording.texts]
    traced = Counter((names[code], line) for code, line in zip(recording.codes, recording.lines, strict=True))
    work = counts(entry.function, *entry.example, compiling=False)
    for place, runs in work.line_runs.items():
        assert runs == traced[place], place
    steps = Steps(entry, recording)
    steps.update()
    assert step_total(entry, *entry.example, compiling=False) == len(steps)
    assert work.emitted == len(recording.emitted)


@pytest.mark.parametrize("entry", [each for each in ENTRIES if each.id in COMPILED])
def test_compiled_it_counts_the_same(entry: catalogue.Entry) -> None:
    call = (entry.function, *entry.example)
    assert counts(*call) == counts(*call, compiling=False)
    assert step_total(entry, *entry.example) == step_total(entry, *entry.example, compiling=False)
    x, y = (int(value) for value in record(*call).emitted[0][:2])
    assert list(touches(entry.function, x, y, *entry.example)) == list(
        touches(entry.function, x, y, *entry.example, compiling=False)
    )


@given(width=st.integers(-2, 5), height=st.integers(-1, 6))
@settings(max_examples=30)
def test_loops_with_else_and_continue_tick_as_they_run(width: int, height: int) -> None:
    recording = record(texts.box, width, height)
    traced = Counter(recording[k].line for k in range(len(recording)))
    for (_function, line), runs in counts(texts.box, width, height, compiling=False).line_runs.items():
        assert runs == traced[line], line


def test_operations_of_a_line_by_hand() -> None:
    # 10 steps, of which 8 go up: dx = 10, dy = 8
    found = counts(LINE, 20, 10, 30, 18)
    assert found.writes == found.emitted == 11
    # steep?, two directions, and the sign of p at each step
    assert found.tests == 3 + 10
    # 8 differences before the loop; p and x at each step; y when it goes up
    assert found.additions == 4 + 2 + 1 + 1 - 2 + 10 + 10 + 8
    assert found.multiplications == 2
    assert found.divisions == 0


def test_a_seed_that_is_refused_is_a_touch_that_only_considered() -> None:
    fill = catalogue.get("boundary_fill_4")
    image, _x, _y, colour, boundary = fill.example
    wall = next(
        (x, y) for y in range(image.shape[0]) for x in range(image.shape[1]) if image[y, x] == boundary
    )
    found = touches(fill.function, *wall, image, *wall, colour, boundary)
    assert [(one.emitted, one.step) for one in found] == [(False, 0)]


@pytest.mark.parametrize("entry", [e for e in ENTRIES if e.values[0].emits in ("pixels", "coverage")])
def test_a_touch_names_the_step_whose_span_emits_it(entry: catalogue.Entry) -> None:
    recording = record(entry.function, *entry.example)
    steps = Steps(entry, recording)
    steps.update()
    emissions = list(recording.emitted)
    for number in (0, len(emissions) // 2, len(emissions) - 1):
        x, y = (int(value) for value in emissions[number][:2])
        touched = touches(entry.function, x, y, *entry.example, compiling=False)
        found = {one.emission: one.step for one in touched if one.emitted}
        assert number in found
        for emission, step in found.items():
            reached = [
                s.number
                for s in (steps[i] for i in range(len(steps)))
                if s.emitted_from <= emission < s.emitted_to
            ]
            assert reached in ([step], []), (emission, step)
