"""Opening, saving and not losing work, as a person does it."""

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QObject, QPoint, Qt
from PySide6.QtWidgets import QApplication, QFileDialog, QPushButton
from pytestqt.qtbot import QtBot

from tests.shell.dialogs import dialog_of, type_name
from workbench.document import building
from workbench.document.model import Document, Polyline, WorldPoint
from workbench.document.samples.examples import example_document
from workbench.document.state import SessionState
from workbench.document.storage import saving
from workbench.document.storage.files import Stored, load, save, write
from workbench.document.subjects import Position, Subject
from workbench.engine import background
from workbench.session import saver
from workbench.shell.command_palette import offers
from workbench.shell.window import MainWindow
from workbench.widgets.fields.save_dialog import SaveDialog

pytestmark = [
    # The offscreen platform says so of every dialog and menu.
    pytest.mark.qt_log_ignore("This plugin does not support", extend=True),
    pytest.mark.xdist_group("processes"),
]

ROOT = Path(__file__).resolve().parents[2]
CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def chosen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The file that a person names whenever they are asked for one."""
    path = tmp_path / "my lines.gwb"
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_args: (str(path), ""))
    monkeypatch.setattr(SaveDialog, "open", lambda dialog: dialog._then(path, dialog.row))
    return path


def draw_a_line(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    qtbot.mouseClick(window.panels("draw")[0], Qt.MouseButton.LeftButton, pos=QPoint(30, 30))
    window.session.flush()


def saved(window: MainWindow) -> None:
    """Wait for the save in the background."""
    window.session.finish_saving()


def answer(window: MainWindow, text: str) -> None:
    next(button for button in window.messages.buttons() if button.text() == text).click()


def test_draw_undo_redo_save_and_reopen(qtbot: QtBot, window: MainWindow, chosen: Path) -> None:
    before = window.session.document
    draw_a_line(qtbot, window)
    drawn = window.session.document
    assert window.isWindowModified()
    assert window.menus.actions["undo"].text() == "Undo: Draw a line"
    qtbot.keyClick(window, "Z", CONTROL)
    assert window.session.document == before
    assert not window.menus.actions["undo"].isEnabled()
    qtbot.keyClick(window, "Z", CONTROL | SHIFT)
    assert window.session.document == drawn
    qtbot.keyClick(window, "S", CONTROL)
    assert window.session.saving
    qtbot.waitUntil(lambda: not window.session.saving, timeout=10_000)
    assert load(chosen) == drawn
    assert not window.isWindowModified()
    assert window.windowTitle() == "my lines[*] - Graphics Workbench"
    qtbot.keyClick(window, "N", CONTROL)
    assert window.session.sheet.figures == ()
    qtbot.keyClick(window, "O", CONTROL)
    assert window.session.document == drawn


def test_a_name_without_ending_gets_one(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    window.files.save_as()
    type_name(qtbot, window, tmp_path / "plain")
    saved(window)
    assert (tmp_path / "plain.gwb").is_file()


def test_a_damaged_file_is_refused_in_one_sentence(qtbot: QtBot, window: MainWindow, chosen: Path) -> None:
    chosen.write_text('{"version": 1, "sheets"', encoding="utf-8")
    before = window.session.document
    qtbot.keyClick(window, "O", CONTROL)
    assert window.session.document is before
    assert window.messages.text.startswith("my lines.gwb was not opened: ")
    assert "\n" not in window.messages.text


def test_a_picture_that_was_stepped_by_a_newer_program_opens_and_what_is_left_out_is_said(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    session = SessionState(workspace="circus", positions={"circus": Position(Subject("flea_circus"), 3)})
    write(Stored(example_document(), session), chosen)
    window.files.open()
    qtbot.waitUntil(lambda: window.session.path == chosen)
    qtbot.waitUntil(lambda: "“flea_circus” is nothing that this version" in window.messages.text)
    assert "circus" not in window.session.state.positions


def test_a_folder_that_cannot_be_written_is_said(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        SaveDialog, "open", lambda dialog: dialog._then(tmp_path / "no" / "x.gwb", dialog.row)
    )
    window.files.save_as()
    saved(window)
    assert window.messages.text.startswith("x.gwb was not saved: ")
    assert window.status.hover.text() == ""
    assert window.session.path is None


def test_closing_asks_and_cancel_keeps_the_window(qtbot: QtBot, window: MainWindow) -> None:
    draw_a_line(qtbot, window)
    window.close()
    assert window.isVisible()
    assert window.messages.text == "Untitled has changes that are not saved."
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


def test_what_is_changed_while_it_is_saved_stays_unsaved(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    draw_a_line(qtbot, window)
    drawn = window.session.document
    window.files.save_as()
    draw_a_line(qtbot, window)
    qtbot.waitUntil(lambda: not window.session.saving, timeout=10_000)
    assert load(chosen) == drawn
    assert window.session.dirty
    assert window.session.path == chosen


def test_a_file_that_another_program_changed_is_not_saved_over_unasked(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    window.files.save_as()
    saved(window)
    theirs = chosen.read_bytes() + b"\n"
    chosen.write_bytes(theirs)
    draw_a_line(qtbot, window)
    qtbot.keyClick(window, "S", CONTROL)
    assert window.messages.text == "Another program has changed my lines.gwb since it was opened here."
    answer(window, "Cancel")
    assert chosen.read_bytes() == theirs
    qtbot.keyClick(window, "S", CONTROL)
    answer(window, "Save over it")
    saved(window)
    assert load(chosen) == window.session.document
    draw_a_line(qtbot, window)
    qtbot.keyClick(window, "S", CONTROL)
    saved(window)
    assert window.messages.text == ""
    assert not window.session.dirty


def test_a_file_that_is_gone_is_saved_again(qtbot: QtBot, window: MainWindow, chosen: Path) -> None:
    window.files.save_as()
    saved(window)
    chosen.unlink()
    draw_a_line(qtbot, window)
    qtbot.keyClick(window, "S", CONTROL)
    saved(window)
    assert load(chosen) == window.session.document


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
    assert window.messages.text == "Untitled has changes that are not saved."


def test_opening_asks_too_and_a_failed_save_loses_nothing(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    draw_a_line(qtbot, window)
    drawn = window.session.document
    qtbot.keyClick(window, "N", CONTROL)
    answer(window, "Save")
    dialog_of(qtbot, window).reject()
    assert window.session.document is drawn


def test_recent_files_are_on_home_and_in_the_menu(
    qtbot: QtBot, window: MainWindow, chosen: Path, open_window: Callable[[], MainWindow]
) -> None:
    window.files.save_as()
    saved(window)
    window.settings.write()
    again = open_window()
    again.go("home")
    names = [b.text() for b in again.stack.currentWidget().findChildren(QPushButton)]
    assert "my lines" in names
    next(b for b in again.stack.currentWidget().findChildren(QPushButton) if b.text() == "my lines").click()
    assert again.session.path == chosen.resolve()
    assert again.place == "draw"
    chosen.unlink()
    assert again.settings.recent() == []


def test_an_example_opens_beside_unsaved_work(qtbot: QtBot, window: MainWindow) -> None:
    draw_a_line(qtbot, window)
    window.open_example("octants")
    assert window.session.sheet.name == "A star in all octants"
    assert len(window.session.document.sheets) == 2


def test_the_sheets_are_in_the_menu_and_among_the_commands(qtbot: QtBot, window: MainWindow) -> None:
    draw_a_line(qtbot, window)
    mine = window.session.sheet
    window.open_example("octants")
    assert window.messages.text == "A line stays open beside this example: View, Sheets shows it again."
    window.menus._fill_sheets()
    first, second = window.menus._sheets.actions()
    assert [(each.text(), each.isChecked()) for each in (first, second)] == [
        ("A line", False),
        ("A star in all octants", True),
    ]
    window.go("home")
    first.trigger()
    assert window.session.sheet == mine
    assert window.session.state.selection == (mine.figures[-1].id,)
    assert window.place == "draw"
    next(each for each in offers(window) if each.text == "Sheet: A star in all octants").act()
    assert window.session.sheet.name == "A star in all octants"


def long_picture(path: Path) -> Document:
    """A picture that is too long to be read at once."""
    points = tuple(WorldPoint(f"q{k}x", k % 30, k % 20) for k in range(2_000))
    sheet = replace(example_document().sheets[0], figures=(Polyline("long", points, "dda_line"),))
    document = replace(example_document(), sheets=(sheet,))
    save(document, path)
    return document


def test_a_long_picture_is_read_beside_and_says_how_far_it_is(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    document = long_picture(chosen)
    before = window.session.document
    qtbot.keyClick(window, "O", CONTROL)
    assert window.session.document is before
    assert window.messages.text.startswith("Reading my lines.gwb ... ")
    assert [button.text() for button in window.messages.buttons()] == ["Cancel"]
    qtbot.waitUntil(lambda: window.session.path == chosen, timeout=30_000)
    assert window.session.document == document
    assert window.messages.text == ""
    assert not window.session.dirty
    assert not window.session.changed_on_disk
    assert window.settings.recent() == [chosen.resolve()]


@pytest.mark.parametrize("how", ["button", "escape", "new"])
def test_a_reading_can_be_cancelled(qtbot: QtBot, window: MainWindow, chosen: Path, how: str) -> None:
    long_picture(chosen)
    before = window.session.document
    qtbot.keyClick(window, "O", CONTROL)
    assert window.session.incoming.busy
    if how == "button":
        answer(window, "Cancel")
    elif how == "escape":
        qtbot.keyClick(window.messages, Qt.Key.Key_Escape)
    else:
        qtbot.keyClick(window, "N", CONTROL)
        before = window.session.document
    assert not window.session.incoming.busy
    assert window.messages.text == ""
    assert background.end_all()
    QApplication.processEvents()
    assert window.session.document is before
    assert window.session.path is None


def test_what_is_drawn_while_a_picture_is_read_is_asked_about(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    document = long_picture(chosen)
    qtbot.keyClick(window, "O", CONTROL)
    draw_a_line(qtbot, window)
    drawn = window.session.document
    qtbot.waitUntil(lambda: "changes that are not saved" in window.messages.text, timeout=30_000)
    assert window.session.document is drawn
    answer(window, "Discard changes")
    assert window.session.document == document


def test_a_long_picture_that_is_broken_is_refused(qtbot: QtBot, window: MainWindow, chosen: Path) -> None:
    long_picture(chosen)
    chosen.write_bytes(chosen.read_bytes()[:-40])
    before = window.session.document
    qtbot.keyClick(window, "O", CONTROL)
    qtbot.waitUntil(lambda: "was not opened" in window.messages.text, timeout=30_000)
    assert "breaks off at line" in window.messages.text
    assert window.session.document is before


def other_threads(monkeypatch: pytest.MonkeyPatch, module: object, name: str) -> list[bool]:
    """For each call of a function from now on, whether it is on a thread beside the interface."""
    real, beside = getattr(module, name), []

    def watched(*given: object) -> object:
        beside.append(threading.current_thread() is not threading.main_thread())
        return real(*given)

    monkeypatch.setattr(module, name, watched)
    return beside


def test_the_sheets_of_a_long_picture_are_put_in_beside_the_interface(
    qtbot: QtBot, window: MainWindow, chosen: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    document = long_picture(chosen)
    beside = other_threads(monkeypatch, building, "foreseen")
    window.files.bring_in()
    qtbot.waitUntil(lambda: len(window.session.document.sheets) == 2, timeout=30_000)
    assert beside == [True]
    points = [(point.x, point.y) for point in window.session.sheet.figures[0].points_world]
    assert points == [(point.x, point.y) for point in document.sheets[0].figures[0].points_world]


def test_many_figures_are_pasted_beside_the_interface(
    qtbot: QtBot, window: MainWindow, chosen: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from workbench.panels.stage import clipboard

    session, said = window.session, []
    (figure,) = long_picture(chosen).sheets[0].figures
    beside = other_threads(monkeypatch, clipboard, "foreseen")
    clipboard.copy_figures([figure])
    for _time in range(2):
        before = session.document
        clipboard.paste_figures(session, said.append)
        assert session.document is before
        qtbot.waitUntil(lambda: not session.incoming.busy, timeout=30_000)
    assert beside == [True, True]
    assert said == ["1 figure pasted.", "1 figure pasted."]
    first, second = session.sheet.figures[-2:]
    assert session.state.selection == (second.id,)
    shifts = {(b.x - a.x, b.y - a.y) for a, b in zip(first.points_world, second.points_world, strict=True)}
    assert shifts == {(1, -1)}
    clipboard.paste_figures(session, said.append)
    session.open_example("line")
    qtbot.waitUntil(lambda: not session.incoming.busy, timeout=30_000)
    assert said[2:] == ["Another sheet was opened before the figures were pasted; paste them again here."]
    QApplication.clipboard().clear()


def test_long_work_is_recovered_beside_the_interface(
    qtbot: QtBot, window: MainWindow, chosen: Path, tmp_path: Path
) -> None:
    document = long_picture(chosen)
    crash(chosen)
    before = window.session.document
    window.session.start_autosave()
    window.files.offer_recovery()
    answer(window, "Recover")
    assert window.session.document is before
    qtbot.waitUntil(lambda: window.session.document is not before, timeout=30_000)
    assert window.session.sheet.figures == document.sheets[0].figures
    assert window.session.dirty
    assert window.session._recovery.flush()
    window.files.offer_recovery()
    assert window.messages.text == ""


CRASH = """
import os, sys
from PySide6.QtCore import QCoreApplication
from workbench.document import building
from workbench.document.edits import rename_sheet
from workbench.document.samples.examples import example_document
from workbench.session.session import Session
application = QCoreApplication([])
session = Session(None, example_document())
if sys.argv[1:]:
    session.open(sys.argv[1])
session.start_autosave()
session.apply(rename_sheet(session.sheet.id, "nearly lost"), "Rename")
session._recovery.flush()
os._exit(1)
"""


def crash(*opened: Path) -> None:
    """Let another start of the program change a picture, the one ``opened`` if any, and die."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    subprocess.run([sys.executable, "-c", CRASH, *map(str, opened)], env=environment, timeout=60)


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
    assert window.messages.text == "Untitled has changes that are not saved."
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
        "my lines.gwb was changed after this work was kept; saving it asks before that is replaced."
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


@pytest.mark.parametrize("name", ["\u00e4" + "x" * 250, f"{'x' * 300}/a", "\u00e4" * 200], ids=range(3))
def test_a_name_that_no_file_can_have_is_asked_for_again(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, name: str
) -> None:
    window.files.save_as()
    (sentence,) = type_name(qtbot, window, tmp_path / name)
    assert "is too long; choose a shorter one." in sentence
    assert len(sentence) < 150
    assert sentence.isprintable()
    dialog = dialog_of(qtbot, window)
    assert dialog.isVisible()
    dialog.reject()
    assert window.session.path is None


def test_saving_twice_at_once_is_not_taken_for_another_program(
    qtbot: QtBot, window: MainWindow, chosen: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window.files.save()
    saved(window)
    draw_a_line(qtbot, window)
    replaced, go_on = threading.Event(), threading.Event()
    sync = saving._sync_folder

    def slowly(folder: Path) -> None:
        replaced.set()
        assert go_on.wait(10)
        sync(folder)

    monkeypatch.setattr(saving, "_sync_folder", slowly)
    window.files.save()
    assert replaced.wait(10)
    draw_a_line(qtbot, window)
    window.files.save()
    assert window.messages.text == ""
    go_on.set()
    qtbot.waitUntil(lambda: not window.session.dirty)
    assert window.messages.text == ""
    assert load(chosen) == window.session.document


def test_a_window_stays_where_a_save_that_it_waited_for_failed(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    window.files._save(tmp_path / "nowhere" / "copy.gwb", None)
    window.close()
    assert window.isVisible()
    assert window.messages.text.startswith("copy.gwb was not saved: ")
    window.close()
    assert not window.isVisible()


def test_the_name_of_a_file_is_shown_as_it_is_and_on_one_line(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    folder = tmp_path / "a"
    folder.mkdir()
    path = folder / f"<h1>big&<br>\n{'x' * 100}[*].gwb"
    window.files._save(path, None)
    saved(window)
    draw_a_line(qtbot, window)
    window.files.new()
    asked = window.messages.text
    assert asked.startswith("<h1>big&<br>\N{REPLACEMENT CHARACTER}xxx")
    assert asked.isprintable()
    assert len(asked) < 120
    assert window.messages._text.textFormat() == Qt.TextFormat.PlainText
    assert "\n" not in window.windowTitle()
    window.menus._fill_recent()
    entry = window.menus._recent.actions()[0]
    assert entry.text().startswith("<h1>big&&<br>\N{REPLACEMENT CHARACTER}xxx")
    assert "&lt;h1&gt;" in entry.toolTip()
    window.go("home")
    home = window._pages["home"]
    button = home._recent.itemAtPosition(0, 0).widget()
    assert "&lt;h1&gt;" in button.toolTip()
    assert button.text().isprintable()
