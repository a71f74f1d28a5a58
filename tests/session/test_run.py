"""The cursor of a run: recorded behind the interface, stepped, played, jumped with, asked first."""

import gc
import weakref
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pytestqt.qtbot import QtBot

from workbench.algorithms import catalogue
from workbench.algorithms.entry import Entry, View
from workbench.document.samples.examples import example_document
from workbench.document.subjects import Subject
from workbench.engine.observation import Steps
from workbench.engine.recorder import record
from workbench.rendering.mapping import Call
from workbench.session.run import Run
from workbench.session.session import Session

BRESENHAM = catalogue.get("bresenham_line")
LINE = (20, 10, 30, 18)
SIZE = (40, 28)


def finish(qtbot: QtBot, run: Run) -> None:
    qtbot.waitUntil(lambda: run.done, timeout=20_000)


@pytest.fixture
def make(qtbot: QtBot) -> Iterator[Callable[..., Run]]:
    runs = []

    def made(entry: Entry = BRESENHAM, arguments: tuple[Any, ...] = LINE, **options: Any) -> Run:
        run = Run()
        runs.append(run)
        for name, value in options.items():
            setattr(run, name, value)
        run.follow(Subject(ids=("figure",)), [Call(entry, arguments)], SIZE)
        finish(qtbot, run)
        return run

    yield made
    for run in runs:
        run.clear()


def words(run: Run) -> str:
    return "".join(part.text for part in run.sentence)


def test_steps_are_the_rows_of_the_hand_table(make: Callable[..., Run]) -> None:
    run = make()
    assert run.total_steps == run.last_position == 10
    assert run.total_text == "10"
    assert run.position == 0
    assert run.image().sum() == 1
    rows = []
    while run.position < run.last_position:
        before = run.position
        run.forward()
        assert run.position == before + 1
        assert run.step is not None
        rows.append(run.step.row)
        assert run.image().sum() == before + 2
    assert [row[1] for row in rows] == [6, 2, -2, 14, 10, 6, 2, -2, 14, 10]
    run.forward()
    assert run.position == 10
    assert run.ended
    run.back()
    assert run.position == 9
    run.first()
    assert run.position == 0
    run.last()
    assert run.position == 10


def test_what_changed_in_a_step(make: Callable[..., Run]) -> None:
    run = make()
    run.go(1)
    assert run.changed_names == {"x", "y", "p"}
    run.go(3)
    assert run.changed_names == {"x", "p"}
    assert list(run.variables)[:4] == ["x", "y", "p", "k"]
    names = {line for _, line in run.lines_run}
    first = BRESENHAM.function.__code__.co_firstlineno
    assert all(first < line < first + 60 for line in names)


def test_detail_shows_every_line_and_stays_in_its_step(make: Callable[..., Run]) -> None:
    run = make()
    straight = record(BRESENHAM.function, *LINE)
    run.go(4)
    run.set_detail(True)
    assert run.step is not None
    assert run.step.number == 4
    for position in range(len(straight)):
        run.go(position)
        assert run.moment is not None
        assert run.moment.line == straight[position].line
        assert run.moment.variables == straight[position].variables
        assert run.image().sum() == straight.emitted_count(position)
    run.forward()
    assert run.ended
    assert run.total_text == str(len(straight))
    assert run.image().sum() == 11
    run.set_detail(False)
    assert run.position == 10


@given(step=st.integers(0, 10))
@settings(max_examples=11, deadline=None)
def test_switching_to_detail_and_back_keeps_the_step(step: int, fixed_run: Run) -> None:
    fixed_run.go(step)
    fixed_run.set_detail(True)
    assert fixed_run.step_number == step
    fixed_run.set_detail(False)
    assert fixed_run.position == step


@pytest.fixture(scope="module")
def fixed_run(qapp: Any) -> Iterator[Run]:
    run = Run()
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, LINE)], SIZE)
    while not run.done:
        qapp.processEvents()
    yield run
    run.clear()


def test_run_to_a_line_and_to_a_pixel(make: Callable[..., Run]) -> None:
    run = make()
    straight = next(line for line in run_lines(run) if "p += two_dy\n" in line[1])[0]
    assert run.run_to_line(straight)
    assert run.position == 3
    assert run.run_to_line(straight)
    assert run.position == 8
    assert not run.run_to_line(straight)
    assert run.position == 8
    assert run.run_to_pixel(23, 12)
    assert run.position == 3
    assert run.run_to_pixel(30, 18)
    assert run.position == 10
    assert not run.run_to_pixel(0, 0)
    run.first()
    run.set_detail(True)
    assert run.run_to_line(straight, "bresenham_line")
    assert not run.run_to_line(straight, "de_casteljau")  # of a run before this one
    assert run.moment is not None
    assert run.moment.line == straight


def run_lines(run: Run) -> list[tuple[int, str]]:
    import inspect

    lines, first = inspect.getsourcelines(run.entry.function)  # type: ignore[union-attr]
    return list(enumerate(lines, first))


def test_ask_first_hides_the_next_step_until_a_pixel_is_named(make: Callable[..., Run], qtbot: QtBot) -> None:
    run = make()
    run.set_ask_first(True)
    assert run.waiting
    run.forward()
    run.last()
    run.run_to_pixel(30, 18)
    assert run.position == 0
    assert run.answer(21, 11)
    assert run.position == 1
    assert not run.answer(23, 11)
    assert run.position == 1
    run.show_answer()
    assert run.position == 2
    assert (run.right, run.wrong) == (1, 1)
    run.back()
    assert not run.waiting
    assert not run.answer(22, 12)
    assert (run.right, run.wrong) == (1, 1)
    run.last()
    assert run.position == 2
    run.set_ask_first(False)
    run.last()
    assert run.position == 10


def test_ask_first_by_a_choice(make: Callable[..., Run]) -> None:
    run = make(catalogue.get("cohen_sutherland"), (10.0, 30.0, 40.0, 0.0, 0.0, 0.0, 30.0, 20.0))
    assert run.options == ()
    run.set_ask_first(True)
    assert run.waiting
    assert len(run.options) == 6
    assert not run.answer(20, 20)
    assert not run.choose("clip at dawn")
    assert (run.position, run.right, run.wrong) == (0, 0, 0)
    assert run.choose("clip top")
    assert not run.choose("accept")
    assert not run.choose("reject")
    assert (run.position, run.right, run.wrong) == (1, 1, 1)
    run.show_answer()
    assert (run.position, run.right, run.wrong) == (2, 1, 1)
    assert run.choose("accept")
    assert (run.position, run.right, run.wrong) == (3, 2, 1)
    assert run.options == ()
    assert not run.choose("accept")


def test_points_and_segments_are_no_pixels(make: Callable[..., Run]) -> None:
    run = make(catalogue.get("cohen_sutherland"), (10.0, 30.0, 40.0, 0.0, 0.0, 0.0, 30.0, 20.0))
    run.last()
    assert not run.image().any()
    assert not run.run_to_pixel(20, 20)


def test_playing_goes_to_the_end_and_stops(make: Callable[..., Run], qtbot: QtBot) -> None:
    run = make()
    run.set_speed(64)
    with qtbot.waitSignals([run.played, run.played], timeout=20_000):
        run.play()
        assert run.playing
    assert run.position == 10
    assert not run.playing
    run.play()
    assert run.position == 0
    run.toggle_play()
    assert not run.playing


def test_a_moved_figure_keeps_the_cursor_and_its_end(make: Callable[..., Run], qtbot: QtBot) -> None:
    run = make()
    run.go(4)
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, (20, 10, 35, 18))], SIZE)
    finish(qtbot, run)
    assert run.position == 4
    assert run.total_steps == 15
    run.last()
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, (20, 10, 24, 11))], SIZE)
    finish(qtbot, run)
    assert run.position == 4 == run.total_steps
    run.follow(Subject(ids=("another",)), [Call(BRESENHAM, (20, 10, 24, 11))], SIZE)
    finish(qtbot, run)
    assert run.position == 0
    run.clear()
    assert run.step is None
    assert run.moment is None
    assert run.total_text == "0"


def test_the_same_run_is_not_recorded_again(make: Callable[..., Run]) -> None:
    run = make()
    recording = run.recording
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, LINE)], SIZE)
    assert run.recording is recording


def test_several_calls_are_one_run(qtbot: QtBot) -> None:
    run = Run()
    ends = (0, 0, 4, 2), (4, 2, 4, 9), (4, 9, 0, 0)
    run.follow(Subject(ids=("polyline",)), [Call(BRESENHAM, each) for each in ends], SIZE)
    finish(qtbot, run)
    assert run.total_steps == 4 + 7 + 9
    run.last()
    one = {pixel for call in run.calls for pixel in BRESENHAM.function(*call)}
    y, x = np.nonzero(run.image())
    assert set(zip(x.tolist(), y.tolist(), strict=True)) == one


def test_an_image_is_recorded_on_a_copy(qtbot: QtBot) -> None:
    entry = catalogue.get("boundary_fill_4")
    image = np.zeros((9, 9), np.int64)
    image[[0, -1], :] = image[:, [0, -1]] = 2
    before = image.copy()
    run = Run()
    run.follow(Subject(ids=("fill",)), [Call(entry, (image, 4, 4, 1, 2))], (9, 9))
    finish(qtbot, run)
    assert np.array_equal(image, before)
    run.last()
    assert run.image().sum() == 49


def endless(n: int) -> Iterator[tuple[int, int]]:
    x = 0
    while True:
        # Go on
        x += 1
        yield x % n, 0


def failing(n: int) -> Iterator[tuple[int, int]]:
    for x in range(n, -1, -1):
        # Divide
        share = n // x
        yield x, share


def own(function: Callable[..., Any], block: str) -> Entry:
    view = View(block=block, row="(x,)", chosen="((x, 0),)", sentence="x = {x}")
    return Entry(function, "lines", "Own", "", (), "pixels", "", ("x",), views=(view,))


def test_an_endless_text_ends_at_the_limit_and_says_so(make: Callable[..., Run]) -> None:
    run = make(own(endless, "Go on"), (5,), limit=3000)
    run.last()
    assert 990 < run.position <= 1000
    assert run.total_text.endswith("+")
    assert "3,000" in run.message
    assert not run.ended


def test_a_text_that_raises_shows_its_steps_and_says_where(make: Callable[..., Run]) -> None:
    run = make(own(failing, "Divide"), (3,))
    run.last()
    assert "ZeroDivisionError" in run.message
    assert run.moment is not None
    assert run.moment.variables["x"] == 0


def test_a_held_run_waits(qtbot: QtBot) -> None:
    run = Run()
    run.hold()
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, LINE)], SIZE)
    qtbot.wait(30)
    assert run.step is None
    run.go_on()
    finish(qtbot, run)
    assert run.total_steps == 10


def test_a_position_not_yet_recorded_is_reached_later(qtbot: QtBot) -> None:
    run = Run()
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, (0, 0, 3000, 1000))], SIZE)
    run.go(2900)
    assert run.position < 2900
    finish(qtbot, run)
    assert run.position == 2900


def test_a_session_makes_its_runs_follow_the_active_figure(qtbot: QtBot) -> None:
    session = Session(document=example_document())
    qtbot.waitUntil(lambda: session.run.entry is not None and session.run.done, timeout=20_000)
    assert session.run.arguments == LINE
    session.run.go(3)
    assert session.state.step == 3
    session.update_state(compare="dda_line")
    session.flush()
    qtbot.waitUntil(
        lambda: session.followers[0].entry is not None and session.followers[0].done, timeout=20_000
    )
    assert session.followers[0].position == 3
    session.run.forward()
    assert session.followers[0].position == 4
    session.run.last()
    assert session.followers[0].ended
    session.update_state(step=2)
    session.flush()
    assert session.run.position == session.followers[0].position == 2
    session.run.set_ask_first(True)
    assert session.state.ask_first
    session.update_state(compare="")
    session.flush()
    assert session.followers[0].entry is None
    session.close()


def test_the_steps_are_those_of_a_straight_recording(make: Callable[..., Run]) -> None:
    entry = catalogue.get("midpoint_circle")
    run = make(entry, (15, 14, 9))
    steps = Steps(entry, record(entry.function, 15, 14, 9))
    assert run.total_steps == len(steps)
    for number in range(len(steps) + 1):
        run.go(number)
        assert run.step == steps[number]
        assert words(run) == "".join(part.text for part in steps[number].sentence)


def test_a_run_that_nobody_holds_records_no_further(qtbot: QtBot) -> None:
    run = Run()
    run.limit = 10**9
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, (0, 0, 10**9, 10**8))], SIZE)
    recorder = run._recorder
    assert recorder is not None
    gone = weakref.ref(run)
    del run
    gc.collect()
    assert gone() is None
    assert recorder.join(30)
