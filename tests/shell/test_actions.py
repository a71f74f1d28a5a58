"""One table of commands: its keys are unambiguous, and menus, palette and key table come from it."""

import itertools

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QAction, QKeySequence, QShortcut
from PySide6.QtWidgets import QApplication, QLabel, QLineEdit, QWidget
from pytestqt.qtbot import QtBot
from shiboken6 import delete

from workbench.document.edits import add_sheet, rename_sheet
from workbench.document.samples.examples import blank_sheet
from workbench.shell.actions import commands, keys_elsewhere, menu_titles, submenu_titles
from workbench.shell.command_palette import CommandPalette, match
from workbench.shell.window import MainWindow
from workbench.widgets.look.icons import icon


def test_ids_menus_and_words() -> None:
    table = commands()
    assert len({command.id for command in table}) == len(table)
    menus = {name for name, _title in menu_titles()} | {name for name, *_rest in submenu_titles()}
    for command in table:
        assert command.menu in menus
        assert command.tooltip
        assert command.needs in ("", "document", "run", "answer")


def test_keys_of_the_window_are_unambiguous() -> None:
    keys = [QKeySequence(key) for command in commands() for key in command.keys]
    for key in keys:
        assert not key.isEmpty()
    for one, other in itertools.combinations(keys, 2):
        assert one.matches(other) == QKeySequence.SequenceMatch.NoMatch, (one.toString(), other.toString())


def test_keys_elsewhere_clash_with_no_window_key() -> None:
    window_keys = {QKeySequence(key).toString() for command in commands() for key in command.keys}
    seen = set()
    for part, keys, _text in keys_elsewhere():
        for key in keys.split(", "):
            assert QKeySequence(key).toString() not in window_keys
            assert (part, key) not in seen
            seen.add((part, key))


def test_no_shortcut_of_the_open_window_is_ambiguous(window: MainWindow) -> None:
    everywhere = Qt.ShortcutContext.WindowShortcut, Qt.ShortcutContext.ApplicationShortcut
    actions = {
        id(action): action
        for action in window.findChildren(QAction)
        if action.shortcutContext() in everywhere
    }
    taken = [key.toString() for action in actions.values() for key in action.shortcuts() if not key.isEmpty()]
    taken += [
        each.key().toString() for each in window.findChildren(QShortcut) if each.context() in everywhere
    ]
    assert len(taken) == len(set(taken))


def test_every_icon_of_the_table_exists(window: MainWindow) -> None:
    for command in commands():
        if command.icon:
            assert not icon(command.icon).isNull()


def test_the_key_table_lists_every_key(qtbot: QtBot, window: MainWindow) -> None:
    qtbot.keyClick(window, "?")
    assert window.place == "keys"
    words = " ".join(label.text() for label in window.stack.currentWidget().findChildren(QLabel))
    for command in commands():
        for key in command.keys:
            assert QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText) in words


@pytest.mark.parametrize(
    ("letters", "better", "worse"),
    [
        ("sa", "Save as...", "Last step"),
        ("rw", "Reset workspace", "Show the hints again, forward"),
        ("un", "Undo", "Run"),
    ],
)
def test_the_nearer_name_wins(letters: str, better: str, worse: str) -> None:
    near, far = match(letters, better), match(letters, worse)
    assert near is not None
    assert far is None or near < far


def test_letters_in_another_order_do_not_match() -> None:
    assert match("odnu", "Undo") is None
    assert match("", "Undo") is not None


def test_a_command_is_found_and_run_by_a_few_letters(qtbot: QtBot, window: MainWindow) -> None:
    qtbot.keyClick(window, "K", Qt.KeyboardModifier.ControlModifier)
    palette = window.findChild(CommandPalette)
    assert palette is not None
    assert palette.isVisible()
    qtbot.keyClicks(palette.field, "sttngs")
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert window.place == "settings"
    assert not palette.isVisible()


def test_the_palette_says_when_nothing_is_called_so(qtbot: QtBot, window: MainWindow) -> None:
    window.show_palette()
    palette = window.findChild(CommandPalette)
    assert palette is not None
    qtbot.keyClicks(palette.field, "qqq")
    assert not palette.list.isVisible()
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert palette.isVisible()
    qtbot.keyClick(palette.field, Qt.Key.Key_Escape)
    assert not palette.isVisible()


def test_a_click_elsewhere_closes_the_palette(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    window.show_palette()
    palette = window.findChild(CommandPalette)
    assert palette is not None
    qtbot.mouseClick(palette.field, Qt.MouseButton.LeftButton)
    assert palette.isVisible()
    qtbot.mouseClick(window.status.ready, Qt.MouseButton.LeftButton)
    assert not palette.isVisible()


def test_the_palette_opens_examples_and_workspaces(qtbot: QtBot, window: MainWindow) -> None:
    window.show_palette()
    palette = window.findChild(CommandPalette)
    assert palette is not None
    qtbot.keyClicks(palette.field, "example circle and ellipse")
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert window.place == "draw"
    assert window.session.sheet.name == "Circle and ellipse"


def test_a_command_that_went_while_the_palette_was_open_is_said(qtbot: QtBot, window: MainWindow) -> None:
    session = window.session
    session.apply(add_sheet(blank_sheet().sheets[0]), "Add a sheet")
    name = session.document.sheets[-1].name
    session.apply(rename_sheet(session.document.sheets[-1].id, "Second thoughts"), "Rename")
    window.go("draw")
    window.show_palette()
    palette = window.findChild(CommandPalette)
    assert palette is not None
    qtbot.keyClicks(palette.field, "second thoughts")
    session.undo_stack.undo()
    session.undo_stack.undo()
    assert name not in [sheet.name for sheet in session.document.sheets][1:]
    qtbot.keyClick(palette.field, Qt.Key.Key_Return)
    assert "Second thoughts" in window.status.hover.text()


def test_the_palette_gives_the_focus_back_unless_its_part_went(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    gone = QLineEdit(window)
    gone.show()
    gone.setFocus()
    window.show_palette()
    palette = window.findChild(CommandPalette)
    assert palette is not None
    delete(gone)
    qtbot.keyClick(palette.field, Qt.Key.Key_Escape)
    assert not palette.isVisible()


def test_the_palette_opened_twice_is_one(qtbot: QtBot, window: MainWindow) -> None:
    window.go("draw")
    for _again in range(2):
        window.show_palette()
    visible = [each for each in window.findChildren(CommandPalette) if each.isVisible()]
    assert len(visible) == 1
    qtbot.keyClick(visible[0].field, Qt.Key.Key_Escape)
    assert window.arrangements.area("draw").host.focusProxy().hasFocus()


def test_the_palette_has_no_more_parts_for_more_commands(qtbot: QtBot, window: MainWindow) -> None:
    parts = []
    for place in ("home", "draw"):
        window.go(place)
        window.show_palette()
        palette = window.findChild(CommandPalette)
        assert palette is not None
        assert palette.list.count() > len(commands())
        parts.append(len(palette.findChildren(QWidget)))
        palette.leave()
        palette.deleteLater()
        QApplication.sendPostedEvents(palette, QEvent.Type.DeferredDelete.value)
    assert parts[0] == parts[1]
    assert parts[0] < 20


def test_a_wrong_answer_is_tried_again_and_shown_by_keys(qtbot: QtBot, window: MainWindow) -> None:
    session = window.session
    assert session is not None
    window.enter("draw")
    window.show()
    session.open_example("line")
    session.update_state(ask_first=True)
    session.flush()
    qtbot.waitUntil(lambda: session.run.done and session.run.waiting, timeout=20_000)
    again, show = (window.menus.actions[name] for name in ("try_again", "show_answer"))
    assert not again.isEnabled()
    session.run.answer(21, 10)
    assert again.isEnabled()
    assert show.isEnabled()
    again.trigger()
    assert session.run.answered is None
    assert not show.isEnabled()
    session.run.answer(21, 10)
    show.trigger()
    assert (session.run.position, session.run.right, session.run.wrong) == (1, 0, 1)
    assert not show.isEnabled()
