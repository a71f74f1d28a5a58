"""Lines, circles and polylines are drawn by hand, by clicks and with the keyboard."""

import pytest
from PySide6.QtCore import Qt

from tests.panels.by_hand import LEFT, SHIFT, at, drag, points, recorded, settle
from workbench.document.model import Circle, Ellipse, Line, Polyline
from workbench.document.subjects import Subject


def test_a_line_is_drawn_by_dragging_and_is_one_step_of_undo(qtbot, session, panel):
    assert panel.empty.isVisible()
    drag(qtbot, panel, (20, 10), (25, 30), (30, 18))
    (line,) = session.sheet.figures
    assert isinstance(line, Line)
    assert points(line) == [(20, 10), (30, 18)]
    assert session.state.selection == (line.id,)
    assert session.undo_stack.count() == 1
    assert not panel.empty.isVisible()
    session.undo_stack.undo()
    settle()
    assert session.sheet.figures == ()
    session.undo_stack.redo()
    assert points(session.sheet.figures[0]) == [(20, 10), (30, 18)]


def test_two_clicks_draw_a_line_too_and_escape_takes_it_back(qtbot, session, panel):
    panel.choose_tool("line")
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 20, 10))
    qtbot.mouseMove(panel.canvas, at(panel, 40, 40))
    settle()
    assert len(session.sheet.figures) == 1
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Escape)
    settle()
    assert session.sheet.figures == ()
    assert session.undo_stack.count() == 0
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 20, 10))
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 30, 18))
    settle()
    assert points(session.sheet.figures[0]) == [(20, 10), (30, 18)]


def test_circle_ellipse_and_polyline(qtbot, session, panel):
    panel.choose_tool("circle")
    drag(qtbot, panel, (20, 20), (23, 24))
    panel.choose_tool("ellipse")
    drag(qtbot, panel, (40, 20), (48, 23))
    panel.choose_tool("polyline")
    for place in ((5, 40), (15, 45), (25, 40), (25, 40)):
        qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, *place))
    settle()
    circle, ellipse, polyline = session.sheet.figures
    assert isinstance(circle, Circle)
    assert circle.radius_world == 5
    assert isinstance(ellipse, Ellipse)
    assert (ellipse.radius_x_world, ellipse.radius_y_world) == (8, 3)
    assert isinstance(polyline, Polyline)
    assert points(polyline) == [(5, 40), (15, 45), (25, 40)]
    assert not polyline.closed
    assert session.undo_stack.count() == 3


def test_a_polyline_closes_on_its_first_point(qtbot, session, panel):
    panel.choose_tool("polyline")
    for place in ((5, 5), (30, 5), (30, 20), (5, 5)):
        qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, *place))
    settle()
    (polyline,) = session.sheet.figures
    assert polyline.closed
    assert len(polyline.points_world) == 3


@pytest.mark.parametrize("end", ["Enter", "another tool"])
def test_the_run_follows_a_polyline_however_it_is_ended(qtbot, session, panel, end):
    panel.choose_tool("polyline")
    for place in ((5, 30), (15, 40), (25, 30)):
        qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, *place))
    if end == "Enter":
        qtbot.keyClick(panel.canvas, Qt.Key.Key_Return)
    else:
        panel.choose_tool("select")
    settle()
    assert not session.run._held
    if end == "Enter":
        recorded(qtbot, session)
        assert session.run.subject == Subject(ids=(session.sheet.figures[0].id,))


def test_the_empty_sheet_offers_an_example(qtbot, session, panel):
    qtbot.mouseClick(panel.empty.button, LEFT)
    settle()
    panel.choose_tool("select")
    assert len(session.sheet.figures) == 1
    assert not panel.empty.isVisible()
    assert not session.dirty


def test_a_line_is_drawn_with_the_keyboard_alone(qtbot, session, panel):
    panel.choose_tool("line")
    canvas = panel.canvas
    canvas.setFocus()
    qtbot.keyClick(canvas, Qt.Key.Key_C)
    start = canvas.cursor_cell
    qtbot.keyClick(canvas, Qt.Key.Key_Return)
    qtbot.keyClick(canvas, Qt.Key.Key_Right, SHIFT)
    qtbot.keyClick(canvas, Qt.Key.Key_Up)
    qtbot.keyClick(canvas, Qt.Key.Key_Return)
    settle()
    (line,) = session.sheet.figures
    assert points(line) == [start, (start[0] + 10, start[1] + 1)]


def test_every_tool_has_a_pointer_of_its_own(qtbot, session, panel):
    pictures = []
    for tool in panel.tools[1:]:
        panel.choose_tool(tool.name)
        pictures.append(panel.canvas.cursor().pixmap().toImage())
    assert all(one != other for k, one in enumerate(pictures) for other in pictures[:k])
    panel.choose_tool("select")
    assert panel.canvas.cursor().shape() == Qt.CursorShape.ArrowCursor
