"""Unsaved work is asked about before it is left, and lost only when a person says so."""

import time
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QObject, Qt
from pytestqt.qtbot import QtBot

from tests.shell.dialogs import dialog_of
from tests.shell.files.filing import CONTROL, answer, draw_a_line
from workbench.document.storage.files import load
from workbench.document.storage.saving import SavingError
from workbench.session import saver
from workbench.shell.window import MainWindow

pytestmark = [
    # The offscreen platform says so of every dialog and menu.
    pytest.mark.qt_log_ignore("This plugin does not support", extend=True),
    pytest.mark.xdist_group("processes"),
]


def test_closing_asks_and_cancel_keeps_the_window(qtbot: QtBot, window: MainWindow) -> None:
    draw_a_line(qtbot, window)
    window.close()
    assert window.isVisible()
    assert window.messages.text == "Untitled has unsaved changes."
    answer(window, "Cancel")
    assert window.isVisible()
    assert window.messages.text == ""
    window.close()
    qtbot.keyClick(window.messages, Qt.Key.Key_Escape)
    assert window.isVisible()


def test_closing_can_save_first(qtbot: QtBot, window: MainWindow, chosen: Path) -> None:
    draw_a_line(qtbot, window)
    drawn = window.session.document
    window.close()
    answer(window, "Save")
    qtbot.waitUntil(lambda: not window.isVisible(), timeout=10_000)
    assert load(chosen) == drawn


def test_quitting_waits_for_a_save_that_is_under_way(
    qtbot: QtBot, window: MainWindow, chosen: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    draw_a_line(qtbot, window)
    drawn = window.session.document
    slow = saver.write
    monkeypatch.setattr(saver, "write", lambda *given: (time.sleep(0.3), slow(*given)))
    qtbot.keyClick(window, "S", CONTROL)
    assert window.session.saving
    assert window.isWindowModified()
    window.close()
    assert not window.isVisible()
    assert load(chosen) == drawn


def test_closing_can_discard(qtbot: QtBot, window: MainWindow) -> None:
    draw_a_line(qtbot, window)
    window.close()
    answer(window, "Discard changes")
    assert not window.isVisible()


def test_what_is_drawn_after_a_close_that_came_to_nothing_is_asked_about(
    qtbot: QtBot, window: MainWindow
) -> None:
    class Stays(QObject):
        def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
            if event.type() == QEvent.Type.Close:
                event.ignore()
            return event.type() == QEvent.Type.Close

    draw_a_line(qtbot, window)
    window.close()
    stays = Stays()
    window.installEventFilter(stays)
    answer(window, "Discard changes")
    window.removeEventFilter(stays)
    draw_a_line(qtbot, window)
    window.close()
    assert window.isVisible()
    assert window.messages.text == "Untitled has unsaved changes."


def test_opening_asks_too_and_a_failed_save_loses_nothing(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    draw_a_line(qtbot, window)
    drawn = window.session.document
    qtbot.keyClick(window, "N", CONTROL)
    answer(window, "Save")
    dialog_of(qtbot, window).reject()
    assert window.session.document is drawn


def test_an_example_opens_beside_unsaved_work(qtbot: QtBot, window: MainWindow) -> None:
    draw_a_line(qtbot, window)
    window.open_example("octants")
    assert window.session.sheet.name == "A star in all octants"
    assert len(window.session.document.sheets) == 2


def test_a_window_stays_where_a_save_that_it_waited_for_failed(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    window.files._save(tmp_path / "nowhere" / "copy.gwb", None)
    window.close()
    assert window.isVisible()
    assert window.messages.text.startswith("copy.gwb was not saved: ")
    window.close()
    assert not window.isVisible()


def test_a_file_that_could_not_be_written_leaves_the_picture_unsaved(
    qtbot: QtBot, window: MainWindow, chosen: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What that file holds now nobody knows, so closing asks, and the work is kept for a recovery."""
    draw_a_line(qtbot, window)
    window.files.save()
    qtbot.waitUntil(lambda: not window.session.saving, timeout=10_000)
    assert not window.session.dirty
    with monkeypatch.context() as patch:
        patch.setattr(saver, "write", _refuse)
        window.files.save()
        qtbot.waitUntil(lambda: not window.session.saving, timeout=10_000)
    failure = "my lines.gwb was not saved: the disk is full"
    assert window.messages.text == failure
    assert window.isWindowModified()
    window.close()
    assert window.isVisible()
    assert window.messages.text == "my lines has unsaved changes."
    window.files.save()
    qtbot.waitUntil(lambda: not window.session.saving, timeout=10_000)
    assert window.messages.text == ""  # neither is true any longer
    assert not window.isWindowModified()


def test_what_has_to_wait_for_an_answer_is_said_in_the_status_bar_meanwhile(
    qtbot: QtBot, window: MainWindow
) -> None:
    window.messages.ask("Replace it?", [("No", lambda: None)])
    window.messages.say("a.gwb was not saved: the disk is full", "error")
    assert window.messages.text == "Replace it?"
    assert window.status.hover.text() == "a.gwb was not saved: the disk is full"
    answer(window, "No")
    assert window.messages.text == "a.gwb was not saved: the disk is full"


def _refuse(*_what: object) -> None:
    raise SavingError("the disk is full")
