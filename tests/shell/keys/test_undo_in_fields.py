"""A field takes its own typing back, and leaves undo to the picture otherwise."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLineEdit
from pytestqt.qtbot import QtBot

from tests.shell.keys.focus import press, settle, work_in
from workbench.document.edits import set_sheet_size
from workbench.shell.window import MainWindow

CONTROL = Qt.KeyboardModifier.ControlModifier


def entry_of(window: MainWindow) -> QLineEdit:
    window.go("draw")
    session = window.session
    session.update_state(selection=(session.sheet.figures[0].id,))
    settle()
    panel = window.panels("draw")[0]
    return next(field.field for field in panel.card._fields.values())


def test_a_field_that_was_just_entered_leaves_undo_to_the_picture(window: MainWindow, qtbot: QtBot) -> None:
    work_in(window, "draw")
    session = window.session
    entry = entry_of(window)
    moved = session.document
    qtbot.mouseClick(entry, Qt.MouseButton.LeftButton)
    assert entry.hasFocus()
    press(entry, "Ctrl+Z")
    settle()
    assert session.document != moved
    press(entry, "Ctrl+Shift+Z")
    settle()
    assert session.document == moved


def test_a_field_that_is_typed_into_takes_its_typing_back_first(window: MainWindow, qtbot: QtBot) -> None:
    work_in(window, "draw")
    session = window.session
    entry = entry_of(window)
    moved, text = session.document, entry.text()
    qtbot.mouseClick(entry, Qt.MouseButton.LeftButton)
    qtbot.keyClick(entry, Qt.Key.Key_A, CONTROL)
    qtbot.keyClicks(entry, "77")
    while entry.isUndoAvailable():
        press(entry, "Ctrl+Z")
        assert session.document == moved
    assert entry.text() == text
    press(entry, "Ctrl+Z")
    settle()
    assert session.document != moved
    # What was entered is an edit of the picture, and taken back as one.
    qtbot.keyClick(entry, Qt.Key.Key_A, CONTROL)
    qtbot.keyClicks(entry, "9")
    before = session.document
    qtbot.keyClick(entry, Qt.Key.Key_Return)
    settle()
    assert session.document != before
    press(entry, "Ctrl+Z")
    settle()
    assert session.document == before


def test_the_step_field_leaves_undo_to_the_picture(window: MainWindow, qtbot: QtBot) -> None:
    work_in(window, "draw")
    session = window.session
    moved = session.document
    jump = window.panels("draw")[1].step_bar.bar.jump
    qtbot.mouseClick(jump, Qt.MouseButton.LeftButton)
    press(jump, "Ctrl+Z")
    settle()
    assert session.document != moved
    session.apply(set_sheet_size(session.sheet.id, 50, 40), "Change sheet size")
    now = session.document
    qtbot.keyClicks(jump, "1")
    press(jump, "Ctrl+Z")
    settle()
    assert session.document == now
