"""Figures that are there are selected, dragged, nudged and deleted."""

from PySide6.QtCore import Qt

from tests.panels.by_hand import LEFT, SHIFT, at, drag, points, settle


def test_a_handle_drags_an_end_and_one_drag_is_one_step_of_undo(qtbot, session, panel, line):
    drag(qtbot, panel, (30, 18), (33, 20), (35, 5))
    assert points(line()) == [(20, 10), (35, 5)]
    assert session.undo_stack.count() == 1
    session.undo_stack.undo()
    assert points(line()) == [(20, 10), (30, 18)]


def test_while_dragging_length_and_slope_stand_beside_the_pointer(qtbot, session, panel, line):
    qtbot.mousePress(panel.canvas, LEFT, pos=at(panel, 30, 18))
    qtbot.mouseMove(panel.canvas, at(panel, 23, 14))
    assert "length 5.0" in panel.canvas._tag
    assert "slope 1.33" in panel.canvas._tag
    assert session.run._held
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Escape)
    settle()
    assert points(line()) == [(20, 10), (30, 18)]
    assert session.undo_stack.count() == 0
    assert not session.run._held
    qtbot.mouseMove(panel.canvas, at(panel, 25, 15))
    qtbot.mouseRelease(panel.canvas, LEFT, pos=at(panel, 25, 15))
    settle()
    assert points(line()) == [(20, 10), (30, 18)]


def test_a_selected_figure_is_moved_nudged_duplicated_and_deleted(qtbot, session, panel, line):
    drag(qtbot, panel, (25, 14), (27, 16))
    assert points(line()) == [(22, 12), (32, 20)]
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Left)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Down, SHIFT)
    assert points(line()) == [(21, 2), (31, 10)]
    panel._actions["duplicate"].trigger()
    assert len(session.sheet.figures) == 2
    assert session.state.selection == (session.sheet.figures[1].id,)
    panel._actions["backwards"].trigger()
    assert session.state.selection == (session.sheet.figures[0].id,)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Delete)
    settle()
    assert len(session.sheet.figures) == 1


def test_nudges_of_one_gesture_are_one_step_of_undo(qtbot, session, panel, line):
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 25, 14))
    settle()
    start, before = points(line()), session.undo_stack.count()
    for _times in range(5):
        qtbot.keyClick(panel.canvas, Qt.Key.Key_Left)
    assert session.undo_stack.count() == before + 1
    panel._nudging.timeout.emit()
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Up)
    assert session.undo_stack.count() == before + 2
    session.undo_stack.undo()
    assert points(line()) == [(x - 5, y) for x, y in start]
    session.undo_stack.undo()
    assert points(line()) == start
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Left)
    drag(qtbot, panel, (24, 14), (25, 15), (26, 16))
    assert session.undo_stack.count() == before + 2


def test_shift_adds_to_the_selection_and_a_band_selects_what_it_holds(qtbot, session, panel, line):
    panel.choose_tool("circle")
    drag(qtbot, panel, (8, 8), (12, 8))
    panel.choose_tool("select")
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 25, 14))
    settle()
    qtbot.mouseClick(panel.canvas, LEFT, SHIFT, at(panel, 12, 8))
    settle()
    assert len(session.state.selection) == 2
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 38, 2))
    settle()
    assert session.state.selection == ()
    drag(qtbot, panel, (1, 1), (10, 10), (15, 15))
    assert session.state.selection == (session.sheet.figures[1].id,)
