"""Every key of the table, in every workspace and with every focus: one command each, or the field's."""

from collections import Counter
from collections.abc import Iterator
from functools import partial

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit, QPlainTextEdit, QTableView, QToolButton, QWidget
from pytestqt.qtbot import QtBot

from tests.shell.conftest import leave
from workbench.document.edits import move_figures, set_sheet_size
from workbench.exchange.figures import MIME
from workbench.panels.stage.clipboard import copy_figures, figures_held
from workbench.session.session import Session
from workbench.shell.actions import commands
from workbench.shell.settings import Settings
from workbench.shell.start import make_window
from workbench.shell.window import MainWindow
from workbench.widgets.canvas.pixel_canvas import PixelCanvas
from workbench.widgets.stepping.source_view import SourceText
from workbench.widgets.tube.view import TubeView

EXAMPLES = {"draw": "line", "fill": "triangle", "clip": "clip", "curves": "curve-interpolation"}
CONTROL = Qt.KeyboardModifier.ControlModifier
# What a line that is typed into keeps for itself.
TYPED = {",", ".", "D", "A", "Shift+A", "Shift+I", "T", "?", "Ctrl+C", "Ctrl+V"}


@pytest.fixture
def window(qtbot: QtBot) -> Iterator[MainWindow]:
    """The program's own window with a picture that has something to undo and something to redo."""
    window = make_window(Settings())
    window.resize(1280, 900)
    window.show()
    window.attach(Session(window))
    qtbot.waitExposed(window)
    yield window
    leave(window)


def settle() -> None:
    for _turn in range(5):
        QApplication.processEvents()


def work_in(window: MainWindow, place: str) -> None:
    """Open the example of a workspace and edit it twice, so that undo and redo are able."""
    session = window.session
    session.undo_stack.setClean()
    window.open_example(EXAMPLES.get(place, "line"))
    window.go(place)
    session.update_state(selection=())
    settle()
    figure = session.sheet.figures[0].id
    session.apply(move_figures([figure], 1, 0), "Move")
    session.apply(move_figures([figure], 1, 0), "Move")
    session.undo_stack.undo()
    settle()
    session.run.last()
    settle()
    for command in commands():
        if command.needs == "answer":  # as after a wrong answer, which not every place asks for
            window.menus.actions[command.id].setEnabled(True)


def places_of_focus(window: MainWindow, place: str) -> dict[str, QWidget]:
    """One part of each kind that can have the focus there, by what it is."""
    if place in ("home", "settings"):
        return {place: window._pages[place]}
    for dock in window.arrangements.docks(place):
        dock.show()
        dock.raise_()
        settle()
    parts: dict[str, QWidget] = {}
    for widget in window.findChildren(QWidget):
        if not widget.isVisible() or not widget.isEnabled() or widget.focusPolicy() == Qt.FocusPolicy.NoFocus:
            continue
        kinds = (PixelCanvas, TubeView, QTableView, QPlainTextEdit, QLineEdit, QToolButton)
        kind = next((each.__name__ for each in kinds if isinstance(widget, each)), "")
        if kind:
            name = widget.accessibleName() if kind in ("QTableView", "QLineEdit") else ""
            parts.setdefault(f"{kind} {name}".strip(), widget)
    return parts


def press(widget: QWidget, key: str) -> None:
    combination = QKeySequence(key)[0]
    QTest.keyClick(widget, combination.key(), combination.keyboardModifiers())


@pytest.mark.parametrize("place", ["home", "settings", "draw", "fill", "clip", "curves", "display"])
def test_every_key_of_the_window_does_its_command_once(
    window: MainWindow, place: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    work_in(window, place)
    done: list[str] = []
    monkeypatch.setattr(window, "do", lambda command: done.append(command.id))
    for name, widget in places_of_focus(window, place).items():
        for command in commands():
            for key in command.keys:
                dock = widget.parentWidget()
                if not widget.isVisible() and dock is not None:
                    window.arrangements.bring_forward(_dock_of(window, place, widget))
                widget.setFocus()
                assert widget.hasFocus() or widget.focusProxy() is not None, (place, name)
                done.clear()
                press(widget, key)
                expected = [] if isinstance(widget, QLineEdit) and key in TYPED else [command.id]
                assert done == expected, (place, name, key)
                if isinstance(widget, QLineEdit):
                    widget.undo()
                    widget.setModified(False)


def _dock_of(window: MainWindow, place: str, widget: QWidget) -> str:
    docks = window.arrangements.docks(place)
    return next(dock.objectName() for dock in docks if dock.isAncestorOf(widget))


@pytest.mark.parametrize("place", ["draw", "fill", "clip", "curves"])
def test_every_key_of_a_canvas_does_its_command_once(window: MainWindow, place: str) -> None:
    work_in(window, place)
    panel = window.panels(place)[0]
    panel.select_all()
    settle()
    done: Counter[str] = Counter()

    def note(name: str, *_checked: bool) -> None:
        done[name] += 1

    actions = [action for action in panel.actions() if not action.shortcut().isEmpty()]
    for action in actions:
        action.triggered.disconnect()
        action.triggered.connect(partial(note, action.objectName()))
    for action in actions:
        action.setEnabled(True)
        panel.canvas.setFocus()
        done.clear()
        press(panel.canvas, action.shortcut().toString())
        assert done == {action.objectName(): 1}, (place, action.shortcut().toString())
    entry = window.panels(place)[1].step_bar.bar.jump
    for action in actions:
        entry.setFocus()
        done.clear()
        press(entry, action.shortcut().toString())
        assert sum(done.values()) <= 1
        if len(action.shortcut().toString()) == 1:
            assert not done, action.shortcut().toString()


# Copy and paste


def copied_by(widget: QWidget, key: str = "Ctrl+C") -> str:
    QGuiApplication.clipboard().setText("before")
    widget.setFocus()
    press(widget, key)
    settle()
    return QGuiApplication.clipboard().text()


@pytest.mark.parametrize("place", ["draw", "fill", "clip", "curves"])
def test_the_canvas_copies_its_figures_or_else_the_picture(window: MainWindow, place: str) -> None:
    work_in(window, place)
    panel, session = window.panels(place)[0], window.session
    panel.choose_tool("select")
    session.update_state(selection=())
    settle()
    copied_by(panel.canvas)
    data = QGuiApplication.clipboard().mimeData()
    assert data.hasImage()
    assert not data.hasFormat(MIME)

    figure = session.sheet.figures[0]
    session.update_state(selection=(figure.id,), active=figure.id)
    settle()
    copied_by(panel.canvas)
    assert QGuiApplication.clipboard().mimeData().hasFormat(MIME)

    count = len(session.sheet.figures)
    press(panel.canvas, "Ctrl+V")
    settle()
    pasted = session.sheet.figures[count:]
    assert len(pasted) == 1
    assert type(pasted[0]) is type(figure)
    assert session.state.selection == (pasted[0].id,)
    ways = {
        (round(new.x - old.x, 9), round(new.y - old.y, 9))
        for old, new in zip(figure.points_world, pasted[0].points_world, strict=True)
    }
    assert ways == {(1, -1)}
    press(panel.canvas, "Ctrl+Z")
    settle()
    assert len(session.sheet.figures) == count


def test_figures_come_to_another_picture_where_they_were(window: MainWindow) -> None:
    work_in(window, "draw")
    panel, session = window.panels("draw")[0], window.session
    panel.select_all()
    settle()
    before = [(p.x, p.y) for figure in session.sheet.figures for p in figure.points_world]
    copied_by(panel.canvas)
    session.new()
    settle()
    press(panel.canvas, "Ctrl+V")
    settle()
    assert [(p.x, p.y) for figure in session.sheet.figures for p in figure.points_world] == before


@pytest.mark.parametrize("text", ["[", '[{"kind": "line"}]', '[{"kind": "house"}]', "{}", "[]"])
def test_figures_that_cannot_be_read_are_refused_in_words(window: MainWindow, text: str) -> None:
    from PySide6.QtCore import QMimeData

    work_in(window, "draw")
    panel, session = window.panels("draw")[0], window.session
    said: list[str] = []
    panel.hover_text.connect(said.append)
    data = QMimeData()
    data.setData(MIME, text.encode())
    QGuiApplication.clipboard().setMimeData(data)
    before = session.document
    panel.canvas.setFocus()
    press(panel.canvas, "Ctrl+V")
    assert session.document == before
    assert any("figures" in sentence for sentence in said)


def test_tables_copy_their_selected_rows_or_else_all(window: MainWindow, qtbot: QtBot) -> None:
    work_in(window, "draw")
    hand = window.panels("draw")[1].hand
    window.arrangements.bring_forward("hand_table")
    settle()
    rows = hand.model.rowCount()
    assert rows > 3
    assert len(copied_by(hand.view).splitlines()) == rows + 1

    def at(row: int) -> object:
        return hand.view.visualRect(hand.model.index(row, 0)).center()

    window.session.run.first()
    settle()
    hand.view.scrollToTop()
    # Shift chooses several rows and goes nowhere; a click alone goes to its step and chooses none.
    qtbot.mouseClick(hand.view.viewport(), Qt.MouseButton.LeftButton, pos=at(0))
    assert window.session.run.step_number == 1
    assert len(copied_by(hand.view).splitlines()) == rows + 1
    qtbot.mousePress(hand.view.viewport(), Qt.MouseButton.LeftButton, pos=at(0))
    qtbot.mouseRelease(hand.view.viewport(), Qt.MouseButton.LeftButton, pos=at(0))
    shift = Qt.KeyboardModifier.ShiftModifier
    qtbot.mouseClick(hand.view.viewport(), Qt.MouseButton.LeftButton, shift, at(1))
    assert window.session.run.step_number == 1
    lines = copied_by(hand.view).splitlines()
    assert len(lines) == 3
    steps = window.session.run.steps
    assert lines[1].split("\t")[0] == str(steps.row(1)[0])
    # All of them by the key that selects all, which is the table's here.
    hand.view.setFocus()
    press(hand.view, "Ctrl+A")
    assert window.session.state.selection == ()
    assert len(copied_by(hand.view).splitlines()) == rows + 1


def test_variables_are_copied_as_they_are_read(window: MainWindow) -> None:
    work_in(window, "draw")
    table = window.panels("draw")[1].variables
    window.arrangements.bring_forward("variables")
    settle()
    table.view.clearSelection()
    lines = copied_by(table.view).splitlines()
    assert lines[0].split("\t") == ["Variable", "Value"]
    assert len(lines) == 1 + table.model.rowCount()
    table.view.selectRow(1)
    one = copied_by(table.view).splitlines()
    assert [line.split("\t")[0].lstrip("● ") for line in one] == ["Variable", table.model.names[1]]


# Undo


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


def test_selected_words_of_a_message_are_copied(window: MainWindow, qtbot: QtBot) -> None:
    window.go("draw")
    window.messages.say("Nothing is lost.")
    settle()
    label = window.messages._text
    qtbot.mouseClick(label, Qt.MouseButton.LeftButton)
    label.setSelection(0, 7)
    assert copied_by(label) == "Nothing"


def test_a_tube_is_copied_as_it_glows(window: MainWindow) -> None:
    work_in(window, "display")
    tube = window.panels("display")[0].raster
    copied_by(tube)
    assert QGuiApplication.clipboard().image().size() == tube.grab().size()


def test_where_nothing_can_be_copied_that_is_said(window: MainWindow) -> None:
    window.go("home")
    QGuiApplication.clipboard().setText("before")
    press(window._pages["home"], "Ctrl+C")
    assert QGuiApplication.clipboard().text() == "before"
    assert window.status.hover.text() == "There is nothing here to copy."


def test_text_that_is_only_read_leaves_copy_and_paste_to_the_picture(window: MainWindow) -> None:
    work_in(window, "draw")
    source = window.findChild(SourceText)
    assert source.isReadOnly()
    figures = window.session.sheet.figures
    copy_figures(list(figures[:1]))
    source.setFocus()
    press(source, "Ctrl+V")
    settle()
    assert len(window.session.sheet.figures) == len(figures) + 1
    assert window.status.hover.text() == "1 figure pasted."
    QGuiApplication.clipboard().clear()
    press(source, "Ctrl+C")
    assert figures_held()  # the one that was pasted is selected
    source.selectAll()
    press(source, "Ctrl+C")
    assert QGuiApplication.clipboard().text() == source.toPlainText()


def test_a_panel_that_is_not_seen_answers_no_keys(window: MainWindow) -> None:
    work_in(window, "draw")
    work_in(window, "fill")
    session, (hidden, seen) = window.session, (window.panels(place)[0] for place in ("draw", "fill"))
    seen.choose_tool("select")
    session.update_state(selection=(session.sheet.figures[0].id,))
    settle()
    hidden.refresh()
    count = len(session.sheet.figures)
    seen.canvas.setFocus()
    press(seen.canvas, "Ctrl+D")
    settle()
    assert len(session.sheet.figures) == count + 1
