"""Every view of every entry, evaluated at every step of generated runs."""

import copy

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.algorithms.runs import arguments
from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry
from workbench.engine.observation import Step, Steps
from workbench.engine.recorder import record

ENTRIES = [entry for entry in catalogue.entries() if entry.views]
each = pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.slug)


def steps_of(entry: Entry, run: tuple[object, ...]) -> Steps:
    recording = record(entry.function, *copy.deepcopy(run))
    assert recording.complete
    return Steps(entry, recording)


@each
@settings(max_examples=12)
@given(data=st.data())
def test_every_step_of_a_run_can_be_shown(entry: Entry, data: st.DataObject) -> None:
    steps = steps_of(entry, data.draw(arguments(entry)))
    emitted = len(steps.recording.emitted)
    before: Step | None = None
    for step in steps:
        assert step.number == (before.number + 1 if before else 0)
        assert step.first == (before.last + 1 if before else 0)
        assert step.emitted_from == (before.emitted_to if before else 0)
        assert 0 <= step.emitted_from <= step.emitted_to <= emitted
        if step.number:
            assert step.view is not None
            assert step.title == step.view.block
            assert len(step.row) == len(entry.columns)
            assert "".join(part.text for part in step.sentence).endswith((".", "…"))
        for headings, rows in step.tables.values():
            assert all(len(row) == len(headings) for row in rows)
        if before is not None:
            assert steps.candidates_next(before.number) == step.candidates
            assert steps.options_next(before.number) == step.options
        if step.options:
            assert step.options.count(step.answer) == 1
        if step.candidates:
            assert set(step.chosen) | set(step.rejected) == set(step.candidates)
            assert not set(step.chosen) & set(step.rejected)
        before = step
    assert before is not None
    assert before.last == len(steps.recording) - 1
    assert before.emitted_to == emitted


@pytest.mark.parametrize(
    "slug", ["dda_line", "dda_line_fixed", "bresenham_line", "midpoint_line", "boundary_fill_4"]
)
@settings(max_examples=25)
@given(data=st.data())
def test_what_is_chosen_is_what_is_drawn(slug: str, data: st.DataObject) -> None:
    entry = catalogue.get(slug)
    steps = steps_of(entry, data.draw(arguments(entry)))
    emitted = steps.recording.emitted
    for step in list(steps)[1:]:
        assert list(step.chosen) == [emitted[n][:2] for n in range(step.emitted_from, step.emitted_to)]


@pytest.mark.parametrize("slug", [e.slug for e in ENTRIES if any(view.considers for view in e.views)])
@settings(max_examples=8)
@given(data=st.data())
def test_what_a_block_considers_is_a_pixel(slug: str, data: st.DataObject) -> None:
    entry = catalogue.get(slug)
    steps = steps_of(entry, data.draw(arguments(entry)))
    for step in steps:
        if step.view is not None and step.view.considers and step.number:
            after = steps.recording.after(steps.span(step.number)[0])
            x, y = eval(step.view.considers, {**entry.function.__globals__, **after})
            assert (int(x), int(y)) in step.candidates


def test_the_hand_table_of_the_course() -> None:
    entry = catalogue.get("bresenham_line")
    rows = [step.row for step in list(steps_of(entry, (20, 10, 30, 18)))[1:]]
    assert [row[0] for row in rows] == list(range(10))
    assert [row[1] for row in rows] == [6, 2, -2, 14, 10, 6, 2, -2, 14, 10]
    assert [row[2] for row in rows] == [
        (20 + k + 1, y) for k, y in enumerate([11, 12, 12, 13, 14, 15, 16, 16, 17, 18])
    ]


def test_the_hand_table_of_a_circle() -> None:
    rows = [step.row for step in list(steps_of(catalogue.get("midpoint_circle"), (0, 0, 10)))[1:]]
    assert [row[1] for row in rows] == [-9, -6, -1, 6, -3, 8, 5]
    assert [row[2] for row in rows] == [(1, 10), (2, 10), (3, 10), (4, 9), (5, 9), (6, 8), (7, 7)]
    assert [row[5] for row in rows] == [8, 8, 8, 8, 8, 8, 4]


def test_the_hand_table_of_an_ellipse_has_the_change_of_region() -> None:
    rows = [step.row for step in list(steps_of(catalogue.get("midpoint_ellipse"), (0, 0, 8, 6)))[1:]]
    assert [(row[0], row[2]) for row in rows] == [
        *((1, p) for p in (-332, -224, -44, 208, -108, 288, 244)),
        ("1 → 2", -23),
        *((2, p) for p in (-23, 361, 297)),
    ]


def test_the_drift_of_a_fixed_point_line_is_beside_those_of_32_and_64_bits() -> None:
    steps = steps_of(catalogue.get("dda_line_fixed"), (0, 0, 100, 33, 8))
    *_, drift, single, double = steps[70].row
    assert drift == pytest.approx(70 * 84 / 256 - 70 * 33 / 100, abs=1e-12)
    assert 0 < abs(double) < abs(single) < 1e-4 < abs(drift)


def test_a_tie_is_told_as_one() -> None:
    steps = steps_of(catalogue.get("bresenham_line"), (0, 0, 2, 1))
    assert "exactly halfway" in "".join(part.text for part in steps[1].sentence)
    assert steps[1].chosen == ((1, 1),)
    assert steps[1].rejected == ((1, 0),)


def test_duplicates_are_told_where_they_are_dropped() -> None:
    steps = steps_of(catalogue.get("midpoint_circle"), (5, 5, 10))
    told = ["".join(part.text for part in steps.told(event)) for event in range(len(steps.recording))]
    assert any("only 4 are new" in sentence for sentence in told)
    assert "only 4 are new" in "".join(part.text for part in steps[0].sentence)


def test_the_stack_is_a_table() -> None:
    steps = steps_of(catalogue.get("boundary_fill_4"), catalogue.get("boundary_fill_4").example)
    assert steps[2].tables == {"Stack": (("x", "y"), ((6, 5), (4, 5)))}
