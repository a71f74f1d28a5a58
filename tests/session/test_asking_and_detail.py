"""Detail and asking first, switched while runs go on, go over to another figure or are compared."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from workbench.document.samples.examples import example
from workbench.session.session import Session


def recorded(session: Session, qtbot: QtBot) -> None:
    """Wait until what is active now, and what it is compared with, is recorded."""
    session.flush()
    qtbot.waitUntil(lambda: session.run.done and session.follower.done, timeout=20_000)


@pytest.fixture
def session(qtbot: QtBot) -> Iterator[Session]:
    """The textbook line by Bresenham, compared with the DDA."""
    session = Session(document=example("line").document)
    session.update_state(compare="dda_line")
    recorded(session, qtbot)
    yield session
    session.close()


def test_a_follower_leaves_detail_and_shows_the_step_of_the_run(session: Session, qtbot: QtBot) -> None:
    session.run.go(3)
    session.follower.set_detail(True)
    assert session.follower.position > 3
    session.run.forward()
    assert not session.follower.detail
    assert session.follower.position == session.run.position == 4


def test_a_run_in_detail_is_followed_by_whole_steps(session: Session, qtbot: QtBot) -> None:
    session.run.go(3)
    session.run.set_detail(True)
    assert session.state.detail
    steps = set()
    for _line in range(12):
        session.run.forward()
        assert session.run.step is not None
        assert not session.follower.detail
        assert session.follower.position == session.run.step.number
        steps.add(session.follower.position)
    assert len(steps) > 1
    session.run.set_detail(False)
    assert not session.state.detail
    assert session.follower.position == session.run.position


def test_asking_begins_where_the_cursor_is_and_counts_from_nought(session: Session, qtbot: QtBot) -> None:
    run = session.run
    run.go(7)
    run.go(2)
    run.set_ask_first(True)
    assert run.waiting
    assert run.seen == 2
    run.last()
    assert run.position == 2
    run.answer(0, 0)
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
    session.run.answer(0, 0)
    session.run.answer(0, 0)
    assert (session.run.wrong, session.run.seen) == (2, 2)
    session.update_state(active="f2")
    recorded(session, qtbot)
    assert session.run.ask_first
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
