"""What a crash has left is offered, and never replaces anything unasked."""

from collections.abc import Callable
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.shell.files.filing import CONTROL, answer, crash, draw_a_line, saved
from workbench.document.storage.files import load
from workbench.session.recovery import recoverable
from workbench.shell.window import MainWindow

pytestmark = [
    # The offscreen platform says so of every dialog and menu.
    pytest.mark.qt_log_ignore("This plugin does not support", extend=True),
    pytest.mark.xdist_group("processes"),
]


@pytest.mark.parametrize("wish", ["Recover", "Discard"])
def test_what_a_crash_left_is_offered(qtbot: QtBot, window: MainWindow, wish: str) -> None:
    crash()
    window.files.offer_recovery()
    assert window.messages.text.startswith("The program ended before nearly lost was saved")
    answer(window, wish)
    assert (window.session.sheet.name == "nearly lost") == (wish == "Recover")
    assert window.session.dirty == (wish == "Recover")
    if wish == "Discard":
        window.files.offer_recovery()
        assert window.messages.text == ""


def test_recovering_asks_about_what_was_drawn_meanwhile(qtbot: QtBot, window: MainWindow) -> None:
    crash()
    window.files.offer_recovery()
    offer = window.messages.text
    draw_a_line(qtbot, window)
    drawn = window.session.document
    answer(window, "Recover")
    assert window.messages.text == "Untitled has unsaved changes."
    answer(window, "Cancel")
    assert window.session.document == drawn
    window.files.offer_recovery()
    assert window.messages.text == offer
    answer(window, "Recover")
    answer(window, "Discard changes")
    assert window.session.sheet.name == "nearly lost"


def test_recovered_work_asks_before_it_replaces_what_was_saved_since(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    window.files.save_as()
    saved(window)
    crash(chosen)
    theirs = chosen.read_bytes() + b"\n"
    chosen.write_bytes(theirs)
    window.files.offer_recovery()
    answer(window, "Recover")
    assert window.messages.text == (
        "my lines.gwb was changed after this work was kept; you will be asked before it is replaced."
    )
    qtbot.keyClick(window, "S", CONTROL)
    assert window.messages.text == "Another program has changed my lines.gwb since it was opened here."
    assert [button.text() for button in window.messages.buttons()] == [
        "Save under another name",
        "Save over it",
        "Cancel",
    ]
    answer(window, "Cancel")
    assert chosen.read_bytes() == theirs
    qtbot.keyClick(window, "S", CONTROL)
    answer(window, "Save over it")
    saved(window)
    assert load(chosen).sheets[0].name == "nearly lost"


def test_recovered_work_is_saved_without_a_question_where_nothing_was_changed(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    window.files.save_as()
    saved(window)
    crash(chosen)
    window.files.offer_recovery()
    answer(window, "Recover")
    assert window.messages.text == ""
    qtbot.keyClick(window, "S", CONTROL)
    saved(window)
    assert load(chosen).sheets[0].name == "nearly lost"


def test_nothing_is_offered_after_a_clean_end(window: MainWindow) -> None:
    window.files.offer_recovery()
    assert window.messages.text == ""


GONE = "Another window has already recovered or discarded nearly lost."


def test_what_another_window_takes_is_offered_no_longer(
    qtbot: QtBot, window: MainWindow, open_window: Callable[[], MainWindow]
) -> None:
    crash()
    other = open_window()
    for each in (window, other):
        each.files.offer_recovery()
    answer(window, "Discard")
    qtbot.waitUntil(lambda: other.messages.text == GONE)
    assert other.messages.buttons() == []
    assert window.messages.text == ""


def test_what_another_window_has_just_taken_is_said_to_be_gone(qtbot: QtBot, window: MainWindow) -> None:
    crash()
    window.files.offer_recovery()
    draw_a_line(qtbot, window)
    drawn = window.session.document
    (lost,) = recoverable()
    lost.discard()
    answer(window, "Recover")  # before anything of it was heard
    assert window.messages.text == GONE  # and nobody is asked to give up the line
    assert window.session.document == drawn


def test_what_is_taken_during_the_question_about_unsaved_changes_is_said_to_be_gone(
    qtbot: QtBot, window: MainWindow
) -> None:
    crash()
    window.files.offer_recovery()
    draw_a_line(qtbot, window)
    answer(window, "Recover")
    (lost,) = recoverable()
    lost.discard()
    answer(window, "Discard changes")
    qtbot.waitUntil(lambda: window.messages.text == GONE)
    assert window.session.dirty
