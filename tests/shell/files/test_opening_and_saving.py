"""Opening and saving a picture, as a person does it."""

import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QApplication, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from tests.shell.dialogs import dialog_of, type_name
from tests.shell.files.filing import CONTROL, answer, draw_a_line, saved
from workbench.document.samples.examples import blank_sheet, example_document
from workbench.document.state import SessionState
from workbench.document.storage import saving
from workbench.document.storage.files import Stored, load, save, write
from workbench.document.subjects import Position, Subject
from workbench.shell.command_palette import offers
from workbench.shell.window import MainWindow
from workbench.widgets.fields.save_dialog import SaveDialog

pytestmark = [
    # The offscreen platform says so of every dialog and menu.
    pytest.mark.qt_log_ignore("This plugin does not support", extend=True),
    pytest.mark.xdist_group("processes"),
]

SHIFT = Qt.KeyboardModifier.ShiftModifier


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


def test_what_serves_for_an_algorithm_of_tomorrow_is_said(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    save(example_document(), chosen)
    chosen.write_text(chosen.read_text().replace('"bresenham_line"', '"line_of_tomorrow"'))
    window.files.open_path(chosen)
    said = "1 figure asks for line_of_tomorrow, which this version lacks; Bresenham's line draws it, and the "
    qtbot.waitUntil(lambda: window.messages.text.startswith(said))
    window.files.save()
    saved(window)
    assert [figure.algorithm for figure in load(chosen).sheets[0].figures] == ["line_of_tomorrow"]


def test_enter_presses_the_button_that_has_the_focus_and_where_it_was_saved_is_said(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    draw_a_line(qtbot, window)
    window.files.new()
    save_button = next(button for button in window.messages.buttons() if button.text() == "Save")
    save_button.setFocus()
    qtbot.waitUntil(save_button.hasFocus)
    qtbot.keyClick(save_button, Qt.Key.Key_Return)
    saved(window)
    assert chosen.is_file()
    assert window.session.sheet.figures == ()
    draw_a_line(qtbot, window)
    window.files.save_as()
    saved(window)
    assert f"Saved my lines.gwb in {chosen.parent}." in window.status.hover.text()


class Paints(QObject):
    """Counts how often a widget is painted."""

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self.count = 0
        widget.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        self.count += event.type() == QEvent.Type.Paint
        return False


def test_the_mark_of_a_message_is_painted_anew_for_another_kind(qtbot: QtBot, window: MainWindow) -> None:
    window.show()
    window.messages.say("One sentence.")
    qtbot.waitExposed(window)
    paints = Paints(window.messages._mark)
    QApplication.processEvents()
    before = paints.count
    window.messages.say("One sentence.", "error")
    qtbot.waitUntil(lambda: paints.count > before)


def test_a_name_that_is_a_folder_is_refused_in_a_sentence(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    (tmp_path / "taken.gwb").mkdir()
    window.files.save_as()
    assert type_name(qtbot, window, tmp_path / "taken") == ["taken.gwb is a folder; choose another name."]
    dialog_of(qtbot, window).reject()
    assert list((tmp_path / "taken.gwb").iterdir()) == []


def test_a_large_picture_is_warned_about_when_it_is_opened(
    qtbot: QtBot, window: MainWindow, chosen: Path
) -> None:
    save(blank_sheet(4096, 4096, "large"), chosen)
    window.files.open_path(chosen)
    qtbot.waitUntil(lambda: "4096 \u00d7 4096" in window.messages.text)
    assert window.messages.text.endswith("choose a size such as 2048 \u00d7 1536.")


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
    qtbot.waitUntil(lambda: "cannot step “flea_circus”" in window.messages.text)
    assert "circus" not in window.session.state.positions


def test_a_folder_that_cannot_be_written_is_said(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        SaveDialog, "open", lambda dialog: dialog._then(tmp_path / "no" / "x.gwb", dialog.file_format)
    )
    window.files.save_as()
    saved(window)
    assert window.messages.text.startswith("x.gwb was not saved: ")
    assert window.status.hover.text() == ""
    assert window.session.path is None


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


def test_the_sheets_are_in_the_menu_and_among_the_commands(qtbot: QtBot, window: MainWindow) -> None:
    draw_a_line(qtbot, window)
    mine = window.session.sheet
    window.open_example("octants")
    assert window.messages.text == "A line stays open beside this example: View > Sheets shows it again."
    window.menus._fill_sheets()
    first, second = window.menus._sheets.actions()[-2:]
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
