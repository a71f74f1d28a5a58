"""Sheets are added, named, copied and removed by commands that a person finds in the menus and by Ctrl+K."""

from collections.abc import Callable

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QInputDialog, QLineEdit, QMenu
from pytestqt.qtbot import QtBot

from workbench.document.check import MAX_NAME
from workbench.document.samples.examples import blank_sheet
from workbench.shell.command_palette import CommandPalette
from workbench.shell.window import MainWindow


def names(window: MainWindow) -> list[str]:
    return [sheet.name for sheet in window.session.document.sheets]


@pytest.fixture
def find(qtbot: QtBot, window: MainWindow) -> Callable[[str], list[str]]:
    """What Ctrl+K offers for some letters."""

    def find(letters: str) -> list[str]:
        window.show_palette()
        palette = window.findChildren(CommandPalette)[-1]
        qtbot.keyClicks(palette.field, letters)
        found = [palette.list.item(row).text() for row in range(palette.list.count())]
        palette.leave()
        return found

    return find


def do(window: MainWindow, name: str) -> None:
    window.menus.actions[name].trigger()


def rename(qtbot: QtBot, window: MainWindow, text: str) -> None:
    do(window, "rename_sheet")
    dialog = window.findChild(QInputDialog)
    assert dialog is not None
    field = dialog.findChild(QLineEdit)
    assert field is not None
    field.selectAll()
    qtbot.keyClicks(field, text) if text else field.clear()
    qtbot.keyClick(field, Qt.Key.Key_Return)
    QApplication.processEvents()


@pytest.mark.parametrize(
    ("letters", "command"),
    [
        ("sheet", "New sheet"),
        ("new", "New sheet"),
        ("rename", "Rename sheet..."),
        ("duplicate", "Duplicate sheet"),
        ("remove", "Remove sheet"),
        ("close", "Remove sheet"),
    ],
)
def test_the_commands_are_found_by_their_words(
    find: Callable[[str], list[str]], letters: str, command: str
) -> None:
    assert command in find(letters)


def test_the_menu_that_lists_the_sheets_has_the_commands(window: MainWindow) -> None:
    view = next(each for each in window.menu_bar.findChildren(QMenu) if each.title() == "&View")
    menu = next(action.menu() for action in view.actions() if action.text() == "Sheets")
    for _time in range(2):
        menu.aboutToShow.emit()
        texts = [action.text() for action in menu.actions() if not action.isSeparator()]
        assert texts == ["New sheet", "Rename sheet...", "Duplicate sheet", "Remove sheet", "A line"]
    assert [action.text() for action in view.actions()].count("Sheets") == 1


def test_a_new_sheet_is_empty_shown_and_undone(window: MainWindow) -> None:
    window.go("draw")
    size = window.session.sheet.width_px, window.session.sheet.height_px
    do(window, "new_sheet")
    shown = window.session.sheet
    assert (names(window), shown.name, shown.figures) == (["A line", "Sheet 2"], "Sheet 2", ())
    assert (shown.width_px, shown.height_px) == size
    do(window, "undo")
    assert (names(window), window.session.sheet.name) == (["A line"], "A line")
    do(window, "redo")
    assert window.session.sheet.name == "Sheet 2"


def test_a_copy_stands_beside_its_sheet_under_another_name(window: MainWindow) -> None:
    do(window, "new_sheet")
    window.files.show_sheet(window.session.document.sheets[0].id)
    do(window, "duplicate_sheet")
    assert names(window) == ["A line", "A line copy", "Sheet 2"]
    copy = window.session.sheet
    assert copy.name == "A line copy"
    assert len(copy.figures) == 1
    assert copy.figures[0].id != window.session.document.sheets[0].figures[0].id


def test_a_copy_of_a_copy_counts_up_and_so_does_one_of_a_long_name(qtbot: QtBot, window: MainWindow) -> None:
    do(window, "duplicate_sheet")
    do(window, "duplicate_sheet")
    assert names(window) == ["A line", "A line copy", "A line copy 2"]
    rename(qtbot, window, "x" * MAX_NAME)
    for _time in range(2):
        do(window, "duplicate_sheet")
    assert names(window)[3:] == ["x" * 195 + " copy", "x" * 193 + " copy 2"]
    assert window.messages.text == ""


def test_why_there_is_no_other_sheet_is_said_without_the_path_of_a_field(window: MainWindow) -> None:
    blank = blank_sheet(8, 8).sheets[0]
    sheets = [replace(blank, id=f"s{n}", views=(replace(blank.views[0], id=f"v{n}"),)) for n in range(1000)]
    window.session.apply(lambda document: replace(document, sheets=tuple(sheets), last_id=1000), "Many")
    do(window, "new_sheet")
    assert window.messages.text.startswith("The list of sheets has 1,001 ")


def test_a_sheet_is_renamed_and_never_without_a_name(qtbot: QtBot, window: MainWindow) -> None:
    rename(qtbot, window, "Homework 3")
    assert names(window) == ["Homework 3"]
    rename(qtbot, window, "")
    assert names(window) == ["Homework 3"]
    assert "needs a name" in window.messages.text
    do(window, "undo")
    assert names(window) == ["A line"]


def test_removing_shows_the_neighbour_and_undo_the_sheet(window: MainWindow) -> None:
    for _time in range(2):
        do(window, "new_sheet")
    window.files.show_sheet(window.session.document.sheets[1].id)
    do(window, "remove_sheet")
    assert (names(window), window.session.sheet.name) == (["A line", "Sheet 3"], "Sheet 3")
    do(window, "remove_sheet")
    assert window.session.sheet.name == "A line"
    do(window, "undo")
    assert (names(window), window.session.sheet.name) == (["A line", "Sheet 3"], "Sheet 3")


def test_the_only_sheet_stays_and_that_is_said(window: MainWindow) -> None:
    do(window, "remove_sheet")
    assert names(window) == ["A line"]
    assert "only sheet" in window.messages.text


def test_an_example_that_is_open_already_gets_a_name_of_its_own(window: MainWindow) -> None:
    do(window, "new_sheet")
    for _time in range(2):
        window.session.open_example("line")
    assert names(window) == ["A line", "Sheet 2", "A line 2", "A line 3"]
