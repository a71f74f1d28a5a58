"""Detail and asking first, switched while runs go on, go over to another figure or are compared."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from workbench.document.edits import add_figure, add_sheet, move_figures, set_algorithm
from workbench.document.model import Line, WorldPoint
from workbench.document.samples.examples import blank_sheet, example
from workbench.document.state import SessionState
from workbench.document.storage.files import Stored
from workbench.document.subjects import Position
from workbench.session.asking import Answer
from workbench.session.session import Session


def recorded(session: Session, qtbot: QtBot) -> None:
    """Wait until what is active now, and what it is compared with, is recorded."""
    session.flush()
    qtbot.waitUntil(lambda: session.run.done and session.followers[0].done, timeout=20_000)


@pytest.fixture
def session(qtbot: QtBot) -> Iterator[Session]:
    """The textbook line by Bresenham, compared with the DDA."""
    session = Session(document=example("line").document)
    session.update_state(compare="dda_line")
    recorded(session, qtbot)
    yield session
    session.close()
    session.deleteLater()


def test_a_follower_leaves_detail_and_shows_the_step_of_the_run(session: Session, qtbot: QtBot) -> None:
    session.run.go(3)
    session.followers[0].set_detail(True)
    assert session.followers[0].position > 3
    session.run.forward()
    assert not session.followers[0].detail
    assert session.followers[0].position == session.run.position == 4


def test_a_run_in_detail_is_followed_by_whole_steps(session: Session, qtbot: QtBot) -> None:
    session.run.go(3)
    session.run.set_detail(True)
    assert session.state.detail
    steps = set()
    for _line in range(12):
        session.run.forward()
        assert session.run.step is not None
        assert not session.followers[0].detail
        assert session.followers[0].position == session.run.step.number
        steps.add(session.followers[0].position)
    assert len(steps) > 1
    session.run.set_detail(False)
    assert not session.state.detail
    assert session.followers[0].position == session.run.position


def test_asking_begins_where_the_cursor_is_and_counts_from_nought(session: Session, qtbot: QtBot) -> None:
    run = session.run
    run.go(7)
    run.go(2)
    run.set_ask_first(True)
    assert run.waiting
    assert run.seen == 2
    run.last()
    assert run.position == 2
    run.answer(23, 11)
    run.show_answer()
    run.answer(24, 13)
    assert (run.right, run.wrong) == (1, 1)
    assert run.seen == 4
    run.set_ask_first(False)
    assert (run.right, run.wrong) == (0, 0)
    assert not run.waiting
    run.last()
    run.first()
    run.set_ask_first(True)
    assert (run.right, run.wrong, run.seen) == (0, 0, 0)
    assert run.waiting


def test_asking_switched_on_twice_keeps_the_score(session: Session, qtbot: QtBot) -> None:
    run = session.run
    run.set_ask_first(True)
    run.answer(21, 11)
    run.set_ask_first(True)
    assert (run.right, run.wrong, run.seen) == (1, 0, 1)


def test_asking_in_detail_begins_after_the_step_that_the_line_is_in(session: Session, qtbot: QtBot) -> None:
    run = session.run
    run.go(4)
    run.set_detail(True)
    run.set_ask_first(True)
    assert not run.waiting
    assert run.seen == 4
    run.set_detail(False)
    assert run.position == 4
    assert run.waiting


def test_another_figure_is_asked_for_from_its_start_with_a_new_score(session: Session, qtbot: QtBot) -> None:
    session.new(example("slopes").document)
    session.update_state(active="f1", compare="", ask_first=True)
    recorded(session, qtbot)
    for _step in range(2):
        (x, y), *_others = session.run.steps[session.run.seen + 1].chosen
        session.run.answer(x, y + 1)
        session.run.show_answer()
    assert (session.run.wrong, session.run.seen) == (2, 2)
    (x, y), *_others = session.run.steps[3].chosen
    session.run.answer(x, y + 1)
    assert session.run.refused
    session.update_state(active="f2")
    recorded(session, qtbot)
    assert session.run.ask_first
    assert session.run.answered is None
    assert (session.run.right, session.run.wrong, session.run.seen) == (0, 0, 0)
    assert session.run.waiting


def test_the_switch_is_the_sessions_and_comes_back_with_it(session: Session, qtbot: QtBot) -> None:
    session.run.set_ask_first(True)
    assert session.state.ask_first
    session.flush()
    session.update_state(ask_first=False)
    session.flush()
    assert not session.run.ask_first
    session.update_state(ask_first=True)
    session.flush()
    assert session.run.waiting


@pytest.mark.parametrize("on", [True, False])
def test_what_is_switched_last_in_a_turn_holds_for_state_and_run(
    session: Session, qtbot: QtBot, on: bool
) -> None:
    session.run.set_ask_first(not on)
    session.run.set_detail(not on)
    session.flush()
    session.run.set_ask_first(on)
    session.run.set_detail(on)
    session.update_state(ask_first=not on, detail=not on)
    session.flush()
    assert session.run.ask_first == session.state.ask_first == (not on)
    assert session.run.detail == session.state.detail == (not on)
    session.update_state(ask_first=on, detail=on)
    session.run.set_ask_first(not on)
    session.run.set_detail(not on)
    session.flush()
    assert session.run.ask_first == session.state.ask_first == (not on)
    assert session.run.detail == session.state.detail == (not on)


def test_a_step_given_back_in_the_same_turn_is_gone_to(session: Session, qtbot: QtBot) -> None:
    session.flush()
    session.run.go(5)
    session.update_state(step=0)
    session.flush()
    assert session.run.position == session.state.step == 0


def test_another_algorithm_begins_at_its_start_and_the_state_says_so(session: Session, qtbot: QtBot) -> None:
    session.run.go(5)
    session.flush()
    session.apply(set_algorithm("f1", "midpoint_line"), "Change algorithm")
    recorded(session, qtbot)
    assert session.run.entry is not None
    assert session.run.entry.slug == "midpoint_line"
    assert session.run.position == session.state.step == 0


def test_another_document_opens_at_its_own_step(session: Session, qtbot: QtBot) -> None:
    session.run.go(5)
    session.flush()
    kept = Stored(example("slopes").document, SessionState(active="f1", positions={"": Position(step=5)}))
    session.take(kept, Path("slopes.gwb"), None)
    recorded(session, qtbot)
    assert session.run.position == session.state.step == 5


def test_a_wrong_answer_stands_until_it_is_tried_again_or_shown(session: Session, qtbot: QtBot) -> None:
    run = session.run
    run.set_ask_first(True)
    assert not run.refused
    run.try_again()
    run.show_answer()
    assert (run.position, run.seen) == (0, 0)
    assert not run.answer(21, 10)
    assert run.refused
    assert run.answered == Answer((21, 10), "wrong", 0)
    assert (run.position, run.right, run.wrong) == (0, 0, 1)
    run.try_again()
    assert run.answered is None
    assert not run.answer(22, 11)
    assert not run.answer(22, 11)
    assert (run.right, run.wrong) == (0, 1)
    assert run.answer(21, 11)
    assert (run.position, run.right, run.wrong) == (1, 0, 1)
    assert not run.answer(22, 11)
    run.show_answer()
    assert (run.position, run.seen, run.right, run.wrong) == (2, 2, 0, 2)
    assert run.waiting
    assert run.answer(23, 12)
    assert (run.right, run.wrong) == (1, 2)


@pytest.mark.parametrize("far", [(0, 0), (29, 17), (23, 6), (21, 15), (26, 11)])
def test_a_click_far_from_all_in_question_counts_nothing(
    session: Session, qtbot: QtBot, far: tuple[int, int]
) -> None:
    run = session.run
    run.set_ask_first(True)
    assert not run.answer(*far)
    assert run.answered == Answer(far, "far", 0)
    assert not run.refused
    assert (run.position, run.right, run.wrong) == (0, 0, 0)
    assert run.answer(21, 11)
    assert (run.right, run.wrong) == (1, 0)


def leave(session: Session, how: str) -> None:
    """Do what an answer does not outlast."""
    match how:
        case "asking is switched off":
            session.update_state(ask_first=False)
        case "the step is shown":
            session.run.show_answer()
        case "the cursor moves":
            session.run.back()
        case "detail":
            session.run.set_detail(True)
        case "the figure is changed":
            session.apply(move_figures(["f1"], 3, 0), "Move")
        case "another figure":
            line = Line("", (WorldPoint("", 2, 2), WorldPoint("", 9, 4)), "bresenham_line", 1)
            session.apply(add_figure(session.sheet.id, line), "Draw a line")
            session.update_state(active=session.sheet.figures[-1].id)
        case "another sheet":
            session.apply(add_sheet(blank_sheet(20, 20).sheets[0]), "Add")
            session.show_sheet(session.document.sheets[-1].id)


@pytest.mark.parametrize(
    "how",
    [
        "asking is switched off",
        "the step is shown",
        "the cursor moves",
        "detail",
        "the figure is changed",
        "another figure",
        "another sheet",
    ],
)
def test_a_wrong_answer_goes_when_its_question_does(session: Session, qtbot: QtBot, how: str) -> None:
    session.run.set_ask_first(True)
    session.run.answer(21, 11)
    session.run.answer(22, 11)
    assert session.run.refused
    leave(session, how)
    session.flush()
    assert session.run.answered is None


def test_what_was_seen_in_detail_is_not_asked_for(session: Session, qtbot: QtBot) -> None:
    run = session.run
    run.set_ask_first(True)
    run.set_detail(True)
    while run.step_number < 4:
        run.forward()
    run.set_detail(False)
    assert (run.position, run.seen) == (4, 4)
    assert run.waiting


def test_detail_switched_by_the_state_takes_the_place_of_the_run_along(
    session: Session, qtbot: QtBot
) -> None:
    run = session.run
    run.go(4)
    session.flush()
    session.update_state(detail=True)
    assert session.state.step == run.number > 4
    session.flush()
    assert session.state.step == run.number
    session.update_state(detail=False)
    assert session.state.step == run.number == 4
    session.update_state(detail=True, step=3)
    session.flush()
    assert session.state.step == run.number == 3
