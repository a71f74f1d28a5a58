"""A run longer than what is recorded at once: its whole length is known, and any stretch can be chosen."""

from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from workbench.algorithms import catalogue
from workbench.document.subjects import Subject
from workbench.engine import compiled, counts
from workbench.engine.observation import Steps
from workbench.engine.recorder import record
from workbench.rendering.mapping import Call
from workbench.session.run import Run
from workbench.widgets.stepping.step_bar import StepBar

BRESENHAM = catalogue.get("bresenham_line")
LINE = (0, 0, 400, 130)
LIMIT = 600
WHOLE = Steps(BRESENHAM, record(BRESENHAM.function, *LINE))


def finish(qtbot: QtBot, run: Run) -> None:
    qtbot.waitUntil(lambda: run.done, timeout=20_000)


@pytest.fixture
def run(qtbot: QtBot) -> Iterator[Run]:
    counts.step_total(BRESENHAM, *LINE)
    run = Run()
    run.limit = LIMIT
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, LINE)], (420, 140))
    finish(qtbot, run)
    if compiled.available():
        qtbot.waitUntil(lambda: run.total_steps is not None, timeout=20_000)
    yield run
    run.clear()


def shows(run: Run, number: int) -> None:
    """The cursor stands at step ``number`` of the whole run, and shows what that step is."""
    assert run.number == number
    assert run.step is not None
    assert run.steps is not None
    assert run.steps[run.position].row == WHOLE[number].row
    assert "".join(part.text for part in run.sentence) == "".join(p.text for p in WHOLE[number].sentence)
    assert run.image().sum() == WHOLE[number].emitted_to


def test_the_whole_length_is_known(run: Run) -> None:
    assert run.in_stretches
    assert run.goes_on
    if compiled.available():
        assert (run.total_steps, run.total_text) == (400, "400")
    assert f"steps 0 to {run.last_position}" in run.message


def test_a_step_that_is_not_recorded_is_gone_to(qtbot: QtBot, run: Run) -> None:
    assert run.last_position < 200
    run.go_to_number(317)
    finish(qtbot, run)
    shows(run, 317)
    assert 0 < run.passed < 316
    run.back()
    shows(run, 316)
    run.go_to_number(5)
    finish(qtbot, run)
    shows(run, 5)
    assert run.passed == 0


def test_stepping_goes_on_behind_the_stretch_and_before_it(qtbot: QtBot, run: Run) -> None:
    last = run.last_position
    run.go(last)
    run.forward()
    finish(qtbot, run)
    shows(run, last + 1)
    run.go(1)
    number = run.number
    run.back()
    finish(qtbot, run)
    shows(run, number - 1)


def test_first_and_last(qtbot: QtBot, run: Run) -> None:
    run.go_to_number(200)
    finish(qtbot, run)
    if compiled.available():
        run.last()
        finish(qtbot, run)
        shows(run, 400)
        assert run.ended
        assert not run.goes_on
    run.first()
    finish(qtbot, run)
    shows(run, 0)


def test_a_step_behind_the_end_is_the_end(qtbot: QtBot, run: Run) -> None:
    run.total_steps = None
    run.go_to_number(5_000)
    qtbot.waitUntil(lambda: run.done and run.step is not None, timeout=20_000)
    assert run.total_steps == 400
    shows(run, 400)


def test_a_place_wanted_while_it_is_recorded_is_reached(qtbot: QtBot) -> None:
    run = Run()
    run.limit = LIMIT
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, LINE)], (420, 140))
    run.go_to_number(250)
    qtbot.waitUntil(lambda: run.done and run.number == 250, timeout=20_000)
    shows(run, 250)
    run.clear()


def test_what_is_told_on_the_way_to_another_stretch_is_the_step_that_was_asked_for(
    qtbot: QtBot, run: Run
) -> None:
    run.go_to_number(20)
    told: list[int | None] = []
    run.moved.connect(lambda: told.append(run.target))
    run.stay_at(317)
    finish(qtbot, run)
    assert told
    assert set(told) == {317}


@pytest.mark.parametrize("number", [2, 40])
def test_a_step_asked_for_by_number_stays_where_another_run_is_longer(qtbot: QtBot, number: int) -> None:
    run = Run()
    for length in (40, 300):
        run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, (0, 0, length, 13))], (420, 140))
        if length == 40:
            finish(qtbot, run)
            run.stay_at(number)
    finish(qtbot, run)
    assert (run.number, run.target, run.total_steps) == (number, number, 300)
    run.clear()


def test_the_end_of_a_longer_run_is_gone_to_once_when_all_of_it_is_recorded(qtbot: QtBot) -> None:
    run = Run()
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, (0, 0, 40, 13))], (4200, 140))
    finish(qtbot, run)
    run.last()
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, (0, 0, 4000, 13))], (4200, 140))
    places: list[int] = []
    run.moved.connect(lambda: places.append(run.number))
    finish(qtbot, run)
    assert places[-1] == run.total_steps == 4000
    assert all(place <= 40 for place in places[:-1])
    run.clear()


def test_the_end_asked_for_before_it_is_recorded_is_gone_to_once(qtbot: QtBot) -> None:
    run = Run()
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, (0, 0, 4000, 13))], (4200, 140))
    assert not run.done
    places: list[int] = []
    run.moved.connect(lambda: places.append(run.number))
    run.last()
    finish(qtbot, run)
    assert places[-1] == run.total_steps == 4000
    assert len(places) <= 2
    run.last()
    run.stay_at(7)
    assert run.number == 7
    run.clear()


def test_the_end_of_a_run_in_stretches_is_that_of_the_whole_run(qtbot: QtBot) -> None:
    run = Run()
    run.limit = LIMIT
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, LINE)], (420, 140))
    run.last()
    finish(qtbot, run)
    if compiled.available():
        qtbot.waitUntil(lambda: run.done and run.number == 400, timeout=20_000)
        shows(run, 400)
    else:
        shows(run, run.last_position)
    run.clear()


def test_another_input_keeps_the_step(qtbot: QtBot, run: Run) -> None:
    run.go_to_number(300)
    finish(qtbot, run)
    run.follow(Subject(ids=("figure",)), [Call(BRESENHAM, (0, 0, 400, 131))], (420, 140))
    qtbot.waitUntil(lambda: run.done and run.number == 300, timeout=20_000)
    assert run.steps is not None
    row = record(BRESENHAM.function, 0, 0, 400, 131)
    assert run.steps[run.position].row == Steps(BRESENHAM, row)[300].row


def test_in_detail_lines_of_the_stretch_are_counted(qtbot: QtBot, run: Run) -> None:
    run.go_to_number(300)
    finish(qtbot, run)
    run.set_detail(True)
    assert run.recording is not None
    assert 0 < run.position < len(run.recording)
    assert run.moment is not None
    assert np.isclose(run.moment.variables["k"], WHOLE.recording[WHOLE.span(300)[1]].variables["k"])


def test_the_step_bar_offers_stretches(qtbot: QtBot, run: Run) -> None:
    bar = StepBar(run)
    qtbot.addWidget(bar)
    bar.show()
    assert bar.stretch.isVisible()
    assert not bar.stretch_start.isEnabled()
    last = run.last_position
    bar.stretch_next.trigger()
    finish(qtbot, run)
    shows(run, last + 1)
    assert bar.stretch_start.isEnabled()
    bar.jump.setFocus()
    bar.jump.selectAll()
    qtbot.keyClicks(bar.jump, "310")
    qtbot.keyClick(bar.jump, Qt.Key.Key_Return)
    finish(qtbot, run)
    shows(run, 310)
    bar.stretch_start.trigger()
    finish(qtbot, run)
    shows(run, 0)


def test_the_slider_records_where_it_is_let_go(qtbot: QtBot, run: Run) -> None:
    bar = StepBar(run)
    qtbot.addWidget(bar)
    bar.resize(900, 44)
    bar.show()
    slider = bar.slider
    if not compiled.available():
        pytest.skip("without the compiler the length of the run is not known")
    assert slider.maximum() == 400
    slider.setSliderDown(True)
    slider.setValue(350)
    assert run.passed == 0
    slider.setSliderDown(False)
    finish(qtbot, run)
    assert run.passed > 0
    shows(run, 350)


def test_the_step_bar_has_room_for_stretches_and_for_what_is_asked(qtbot: QtBot, run: Run) -> None:
    bar = StepBar(run)
    qtbot.addWidget(bar)
    bar.resize(960, bar.height())
    bar.show()
    run.set_ask_first(True)
    assert not bar.stretch.isHidden()
    assert all(not button.isHidden() for button in bar.after_wrong)
    assert bar.minimumSizeHint().width() <= 960
