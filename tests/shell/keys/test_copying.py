"""Copy and paste act on what has the focus."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from tests.shell.keys.focus import press, settle, work_in
from workbench.document.building import without_ids
from workbench.document.model import Line
from workbench.exchange.figures import MIME
from workbench.panels.stage.clipboard import copy_figures, figures_held
from workbench.shell.window import MainWindow
from workbench.widgets.stepping.source_text import SourceText


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


def test_what_is_cut_is_pasted_and_other_programs_get_it_as_svg(window: MainWindow) -> None:
    work_in(window, "draw")
    panel, session = window.panels("draw")[0], window.session
    before = session.sheet.figures
    session.update_state(selection=(), active="")
    press(panel.canvas, "Ctrl+X")
    assert session.sheet.figures == before
    assert "nothing here to cut" in window.status.hover.text()
    session.update_state(selection=(before[0].id,), active=before[0].id)
    press(panel.canvas, "Ctrl+X")
    settle()
    assert session.sheet.figures == before[1:]
    data = QGuiApplication.clipboard().mimeData()
    assert bytes(data.data("image/svg+xml").data()).startswith(b"<?xml")
    assert panel.paste()
    settle()
    assert without_ids(session.sheet.figures[-1]) == without_ids(before[0])


@pytest.mark.parametrize("place", ["draw", "clip"])
def test_svg_of_another_program_is_pasted_with_its_colours(window: MainWindow, place: str) -> None:
    work_in(window, place)
    session = window.session
    count, palette = len(session.sheet.figures), session.sheet.palette
    text = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><line x2="9" stroke="#123456"/></svg>'
    QGuiApplication.clipboard().setText(text)
    window.panels(place)[0].paste()
    settle()
    assert [type(figure) for figure in session.sheet.figures[count:]] == [Line]
    assert session.sheet.palette == (*palette, 0x123456)
    session.undo_stack.undo()
    assert (len(session.sheet.figures), session.sheet.palette) == (count, palette)


def test_the_menu_acts_on_what_has_the_focus(window: MainWindow) -> None:
    work_in(window, "draw")
    panel, session = window.panels("draw")[0], window.session
    count = len(session.sheet.figures)
    panel.canvas.setFocus()
    actions = window.menus.actions
    actions["select_all"].trigger()
    assert len(session.state.selection) == count
    actions["duplicate"].trigger()
    assert len(session.sheet.figures) == 2 * count
    actions["delete"].trigger()
    assert len(session.sheet.figures) == count
    field = window.findChild(QLineEdit, "step") or window.findChildren(QLineEdit)[0]
    field.setFocus()
    field.setText("123")
    actions["select_all"].trigger()
    assert field.selectedText() == "123"
    actions["delete"].trigger()
    assert field.text() == ""
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
    tube = window.panels("display")[0].page_of("display").raster
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
    copy_figures(window.session.sheet, list(figures[:1]))
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
    copied = QGuiApplication.clipboard().text()
    source.fold(False)
    assert copied == source.toPlainText()


@pytest.mark.parametrize("place", ["draw", "transform", "animate"])
def test_the_menu_edit_changes_what_is_painted_over_what(window: MainWindow, place: str) -> None:
    window.open_example("house")
    window.go(place)
    settle()
    session, actions = window.session, window.menus.actions
    ids = [figure.id for figure in session.sheet.figures]
    window.panels(place)[0].center.setFocus()
    session.update_state(selection=(), active="")
    actions["bring_forwards"].trigger()
    assert "nothing here to bring forwards" in window.status.hover.text()
    session.update_state(selection=(ids[0],), active=ids[0])
    actions["bring_forwards"].trigger()
    swapped = [ids[1], ids[0], *ids[2:]]
    assert [figure.id for figure in session.sheet.figures] == swapped
    actions["send_backwards"].trigger()
    assert [figure.id for figure in session.sheet.figures] == ids
    session.undo_stack.undo()
    assert [figure.id for figure in session.sheet.figures] == swapped
