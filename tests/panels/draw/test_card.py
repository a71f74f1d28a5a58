"""The card of the Draw panel: numbers, the sheet, the algorithm."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import LEFT, drag, points, settle


def test_numbers_are_typed_on_the_card(qtbot, session, panel, line):
    field = panel.card._fields["s1/f1/p2/x"]
    field.field.setFocus()
    field.field.selectAll()
    qtbot.keyClicks(field.field, "70/2")
    qtbot.keyClick(field.field, Qt.Key.Key_Return)
    settle()
    assert points(line()) == [(20, 10), (35, 18)]
    field.field.selectAll()
    qtbot.keyClicks(field.field, "1e300")
    qtbot.keyClick(field.field, Qt.Key.Key_Return)
    settle()
    assert points(line()) == [(20, 10), (35, 18)]
    assert field.complaint.isVisible()


def test_scrubbing_a_label_is_one_step_of_undo(qtbot, session, panel, line):
    label = panel.card._fields["s1/f1/p2/y"].label
    qtbot.mousePress(label, LEFT, pos=QPoint(4, 4))
    for step in range(1, 6):
        qtbot.mouseMove(label, QPoint(4 + 4 * step, 4))
        settle()
    qtbot.mouseRelease(label, LEFT, pos=QPoint(24, 4))
    assert points(line())[1] == (30, 23)
    assert session.undo_stack.count() == 1


def test_the_sheet_is_resized_on_the_card(qtbot, session, panel):
    width = panel.card._size[0]
    width.field.setFocus()
    width.field.selectAll()
    qtbot.keyClicks(width.field, "100")
    qtbot.keyClick(width.field, Qt.Key.Key_Return)
    settle()
    assert session.sheet.width_px == 100
    assert panel.canvas.picture_size == (100, 48)


def test_the_algorithm_is_chosen_before_and_after_drawing(qtbot, session, panel):
    panel.choose_tool("line")
    box = panel.card.algorithm
    box.setCurrentIndex(box.findData("dda_line"))
    box.activated.emit(box.currentIndex())
    drag(qtbot, panel, (5, 5), (20, 9))
    assert session.sheet.figures[0].algorithm == "dda_line"
    box.setCurrentIndex(box.findData("midpoint_line"))
    box.activated.emit(box.currentIndex())
    settle()
    assert session.sheet.figures[0].algorithm == "midpoint_line"


def test_escape_in_a_field_gives_the_focus_to_the_canvas(qtbot, session, panel, line):
    field = next(iter(panel.card._fields.values())).field
    field.setFocus()
    settle()
    qtbot.keyClick(field, Qt.Key.Key_Escape)
    settle()
    assert session.state.selection == ()
    assert QApplication.focusWidget() is panel.canvas
