"""Steps found in a recording: by hand on small texts, and the same whether it is whole or still growing."""

import gc
import weakref
from collections.abc import Iterator
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry, View
from workbench.engine.observation import Step, Steps
from workbench.engine.recorder import Recorder, record
from workbench.engine.recording import Recording
from workbench.engine.sentences import Part, fill_in, number_text
from workbench.engine.visits import ViewError


def tree(depth: int, place: int) -> Iterator[tuple[int, int]]:
    """A text that calls itself, with rows before and after the calls."""
    # Arrive
    here = 2 * place
    yield depth, here

    if depth > 0:
        # Go down on the left
        yield from tree(depth - 1, here)

        # Go down on the right
        yield from tree(depth - 1, here + 1)

    # Leave
    here += 1
    yield depth, here


TREE = Entry(
    function=tree,
    topic="trees",
    title="A tree",
    summary="Walks a tree.",
    parameters=(),
    emits="pixels",
    source="",
    columns=("what", "depth", "here"),
    views=(
        View(block="Arrive", row="('arrive', depth, here)", sentence="At {here}."),
        View(block="Go down on the right", row="('right', depth, here)", sentence="Right of {here}."),
        View(block="Leave", row="('leave', before.depth, here)", sentence="From {before.here} to {here}."),
    ),
)


def walked(depth: int, place: int) -> list[tuple[Any, ...]]:
    """The rows of TREE in the order in which their blocks are entered, without any of the machinery."""
    here = 2 * place
    rows: list[tuple[Any, ...]] = [("arrive", depth, here)]
    if depth > 0:
        rows += walked(depth - 1, here)
        rows.append(("right", depth, here))
        rows += walked(depth - 1, here + 1)
    return [*rows, ("leave", depth, here + 1)]


def so_far(whole: Recording, count: int) -> Recording:
    """The recording as it was after ``count`` line events."""
    part = Recording(whole.texts)
    calls = max(whole.frame_column[:count], default=-1) + 1
    part.line_column = whole.line_column[:count]
    part.frame_column = whole.frame_column[:count]
    part.frame_texts = whole.frame_texts[:calls]
    part.frame_depths = whole.frame_depths[:calls]
    part.frame_parents = whole.frame_parents[:calls]
    part.frame_starts = whole.frame_starts[:calls]
    part.frame_ends = whole.frame_ends[:calls]
    for call in range(calls):
        if part.frame_ends[call] > 2 * count:
            part.frame_ends[call] = 0
    part._columns = whole._columns
    part.emitted = whole.emitted
    part.call_emissions, part.call_frames = whole.call_emissions, whole.call_frames
    part.complete = whole.complete and count == whole.count
    part.count = count
    return part


@pytest.mark.parametrize("depth", range(4))
def test_rows_of_calls_within_calls_come_in_the_order_of_entering(depth: int) -> None:
    steps = Steps(TREE, record(tree, depth, 1))
    assert [step.row for step in list(steps)[1:]] == walked(depth, 1)


@given(data=st.data())
def test_a_growing_recording_shows_the_same_steps(data: st.DataObject) -> None:
    entry, run = data.draw(
        st.sampled_from(
            [
                (TREE, (3, 1)),
                (catalogue.get("bresenham_line"), (3, 9, -4, 2)),
                (catalogue.get("midpoint_circle"), (0, 0, 6)),
                (catalogue.get("boundary_fill_4"), (np.zeros((3, 3), np.int64), 1, 1, 2, 1)),
            ]
        )
    )
    whole = record(entry.function, *run)
    expected = Steps(entry, whole)
    cuts = data.draw(st.lists(st.integers(0, len(whole)), max_size=6).map(sorted))
    steps = Steps(entry, so_far(whole, 0))
    for cut in [*cuts, len(whole)]:
        now = so_far(whole, cut)
        steps.recording = steps._visits.recording = now
        steps.update()
        for number in range(len(steps)):
            assert steps[number] == expected[number]
        if len(steps) and number_is_shown(steps, cut):
            assert steps[len(steps)].row == expected[len(steps)].row
    assert [*steps] == [*expected]
    assert steps.decisions == expected.decisions


def test_a_row_counts_as_soon_as_its_call_is_over() -> None:
    whole = record(tree, 1, 1)
    back = next(
        event for event in range(len(whole)) if event and whole.depths[event] < whole.depths[event - 1]
    )
    steps = Steps(TREE, so_far(whole, back + 1))
    assert [step.row for step in list(steps)[1:]] == walked(1, 1)[:3]


def number_is_shown(steps: Steps, cut: int) -> bool:
    return steps.span(len(steps))[1] < cut


def test_a_recorder_at_work_can_be_followed() -> None:
    entry = catalogue.get("bresenham_line")
    recorder = Recorder(entry.function, 0, 0, 3000, 1234)
    steps = Steps(entry, recorder.recording)
    recorder.start()
    while not recorder.done:
        steps.update()
        if len(steps):
            assert steps[len(steps)].row[0] == len(steps) - 1
    steps.update()
    assert len(steps) == 3000
    assert steps[3000].row[2] == (3000, 1234)


def test_a_step_is_found_from_each_of_its_events() -> None:
    steps = Steps(TREE, record(tree, 2, 1))
    for step in steps:
        assert {steps.step_of(event) for event in range(step.first, step.last + 1)} <= {step.number}


def test_step_numbers_are_checked() -> None:
    steps = Steps(TREE, record(tree, 0, 1))
    assert len(steps) == 2
    for number in (-1, 3):
        with pytest.raises(IndexError, match="no step"):
            steps[number]


def test_a_row_alone_is_that_of_its_step() -> None:
    for slug in ("bresenham_line", "midpoint_ellipse", "boundary_fill_4", "cohen_sutherland"):
        entry = catalogue.get(slug)
        recording = record(entry.function, *entry.example)
        alone, steps = Steps(entry, recording), Steps(entry, recording)
        assert alone.row(0) == ()
        assert [alone.row(number) for number in range(len(alone) + 1)] == [step.row for step in steps]
        with pytest.raises(IndexError):
            alone.row(len(alone) + 1)


def test_steps_that_nobody_looks_at_any_more_are_gone_at_once() -> None:
    gc.disable()
    try:
        entry = catalogue.get("bresenham_line")
        steps = Steps(entry, record(entry.function, 20, 10, 30, 18))
        assert all(step.sentence for step in steps)
        gone = weakref.ref(steps.recording)
        del steps
        assert gone() is None
    finally:
        gc.enable()


def test_decisions_are_where_another_view_holds() -> None:
    entry = catalogue.get("bresenham_line")
    steps = Steps(entry, record(entry.function, 20, 10, 30, 18))
    assert steps.decisions == (3, 4, 8, 9)
    again = Steps(entry, record(entry.function, 20, 10, 30, 18))
    assert again.find_decisions(3) == (3,)
    assert again.find_decisions(100) == (3, 4, 8, 9)


def test_nothing_emitted_and_no_row_is_still_a_run() -> None:
    entry = catalogue.get("depth_buffer")
    image, depth, *_ = entry.example
    none = np.zeros((0, 3))
    steps = Steps(entry, record(entry.function, image, depth, none, none.astype(int), np.zeros(0, int)))
    assert len(steps) == 0
    assert steps[0].row == ()
    assert steps[0].emitted_to == 0
    assert steps.candidates_next(0) == ()


def test_titles_of_events() -> None:
    recording = record(tree, 0, 1)
    steps = Steps(TREE, recording)
    assert [steps.title_of(event) for event in range(len(recording))] == [
        "Arrive",
        "Arrive",
        "Arrive",  # the line that asks whether to go down
        "Leave",
        "Leave",
    ]


def with_view(view: View) -> Entry:
    return replace(TREE, views=(view,))


def test_a_view_of_a_block_that_is_not_there_is_refused() -> None:
    with pytest.raises(ViewError, match="“Sit down”"):
        Steps(with_view(View(block="Sit down")), record(tree, 0, 1))


def test_views_of_one_block_that_disagree_on_rows_are_refused() -> None:
    entry = replace(TREE, views=(View(block="Leave", when="here > 3", row="(1, 2, 3)"), View(block="Leave")))
    with pytest.raises(ViewError, match="“Leave”"):
        Steps(entry, record(tree, 0, 1))


def test_an_expression_that_fails_names_itself() -> None:
    steps = Steps(with_view(View(block="Leave", row="(nowhere,)")), record(tree, 0, 1))
    with pytest.raises(ViewError, match=r"A tree.*Leave.*nowhere"):
        steps[1]


def test_a_sentence_links_variables_and_pixels() -> None:
    names = {"p": -2, "two_dy": 16, "pixel": (3, -4), "before": SimpleNamespace(p=6)}
    parts = fill_in("p = {before.p} + {two_dy} = {p} at {pixel}, {p / 4}.", lambda text: eval(text, names))
    assert parts == (
        Part("p = ", None),
        Part("6", ("variable", "p")),
        Part(" + ", None),
        Part("16", ("variable", "two_dy")),
        Part(" = ", None),
        Part("−2", ("variable", "p")),
        Part(" at ", None),
        Part("(3, −4)", ("pixel", (3, -4))),
        Part(", ", None),
        Part("−0.5", None),
        Part(".", None),
    )


@pytest.mark.parametrize("operator", [" + ", " − ", " · ", "/"])
def test_a_negative_number_after_an_operator_stands_in_brackets(operator: str) -> None:
    parts = fill_in(
        f"{{y}}{operator}{{y}} = {{x}}{operator}{{point}}", {"x": 2, "y": -5, "point": (-1, 2)}.get
    )
    assert "".join(part.text for part in parts) == f"−5{operator}(−5) = 2{operator}(−1, 2)"
    assert parts[2].link == ("variable", "y")


def test_numbers_are_shown_as_people_write_them() -> None:
    shown = [number_text(value) for value in (12, -3, 10.800000000000001, -0.0, 1 / 3, np.float32(10.8))]
    assert shown == ["12", "−3", "10.8", "0", "0.3333", "10.8"]


def test_a_step_is_a_value() -> None:
    steps = Steps(TREE, record(tree, 1, 1))
    first: Step = steps[1]
    assert first == Steps(TREE, record(tree, 1, 1))[1]
    assert first is steps[1]


@pytest.mark.parametrize(
    ("structure", "rows"),
    [
        ([(1, 2), (3, 4)], ((1, 2), (3, 4))),
        ([1, 2], ((1,), (2,))),
        ([(np.int64(1), 2.5), (3, 4.5)], ((1, 2.5), (3, 4.5))),
        (np.array([[1, 2], [3, 4]]), ((1, 2), (3, 4))),
        ([], ()),
    ],
)
def test_a_local_structure_becomes_a_table(structure: Any, rows: tuple[tuple[Any, ...], ...]) -> None:
    entry = with_view(View(block="Leave", row="(0, 0, 0)", tables={"Kept": ("kept", ("a", "b"))}))
    steps = Steps(replace(entry, view_functions=()), record(tree, 0, 1))
    steps._functions["kept"] = structure
    shown = steps[1].tables["Kept"][1]
    assert shown == rows
    assert not any(isinstance(cell, np.generic) for row in shown for cell in row)


def long_lists() -> Iterator[tuple[str, tuple[Any, ...]]]:
    """Texts whose views name a list, with lists longer than what is recorded of one that may change."""
    points = np.column_stack([np.arange(3000) * 7919 % 61, np.arange(3000) * 104729 % 43]).astype(float)
    ends = np.array([len(points)])
    yield "de_boor", (points, np.arange(3004.0), 3, 5.5)
    yield "de_boor_rational", (points, np.ones(3000), np.arange(3004.0), 3, 5.5)
    yield "de_casteljau", (points[:40], 0.5)
    yield "sutherland_hodgman", (points, 5.0, 5.0, 40.0, 40.0)
    yield "scan_line_exact", (points, ends, False, False)
    yield "inside_outside", (points, ends, 20.0, 20.0, False)


@pytest.mark.parametrize(("slug", "arguments"), [pytest.param(*each, id=each[0]) for each in long_lists()])
@pytest.mark.parametrize("limit", [300, 4000, 30_000])
def test_a_run_over_long_lists_is_told_also_where_it_is_cut_short(
    slug: str, arguments: tuple[Any, ...], limit: int
) -> None:
    entry = catalogue.get(slug)
    steps = Steps(entry, record(entry.function, *arguments, limit=limit))
    for number in {*range(min(len(steps), 20) + 1), len(steps)}:
        step = steps[number]
        assert len(step.row) == (len(entry.columns) if number else 0)
        steps.candidates_next(number)
        steps.options_next(number)


@pytest.mark.parametrize(
    ("slug", "arguments"),
    [
        ("de_casteljau", (np.zeros((1, 2)), 0.5)),
        ("de_boor", (np.zeros((5, 2)), np.arange(3.0), 3, 3.5)),
        ("scan_line_exact", (np.full((3, 2), np.nan), np.array([3]), False, False)),
        ("cohen_sutherland", (0.0, 0.0, 1.0, 1.0, "a", 0.0, 1.0, 1.0)),
    ],
)
def test_a_run_that_an_error_ends_is_told_up_to_there(slug: str, arguments: tuple[Any, ...]) -> None:
    entry = catalogue.get(slug)
    recording = record(entry.function, *arguments)
    assert recording.error is not None
    assert all(step.first <= step.last for step in Steps(entry, recording))


def test_while_an_error_ends_all_calls_nothing_is_told_of_what_it_broke_off() -> None:
    entry = catalogue.get("boundary_fill_recursive")
    recording = record(entry.function, np.zeros((9, 9), int), 0, 0, 1, 2, depth_limit=20)
    failure, recording.error = recording.error, None  # as while the calls end, one after the other
    assert failure is not None
    steps = Steps(entry, recording)
    told = [steps.row(number) for number in range(1, len(steps) + 1)]
    recording.error = failure
    whole = Steps(entry, recording)
    assert told == [whole.row(number) for number in range(1, len(steps) + 1)]
    assert len(whole) - len(steps) <= 1
