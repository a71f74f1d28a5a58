"""The Draw panel as a person uses it: draw, drag, type, nudge, step, compare, undo."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QToolButton

from workbench.document.model import Circle, Ellipse, Line, Polyline
from workbench.document.samples.examples import blank_sheet, example_document
from workbench.document.subjects import Subject
from workbench.panels.draw.panel import DrawPanel
from workbench.rendering import frame_buffer
from workbench.rendering.comparing import BOTH, ONLY_FIRST, TIE_FIRST
from workbench.session.session import Session
from workbench.widgets.canvas.drawing import Word
from workbench.widgets.look.tokens import LIGHT
from workbench.widgets.stepping.step_bar import Steps

LEFT = Qt.MouseButton.LeftButton
SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def session(qtbot):
    return Session(document=blank_sheet(64, 48))


@pytest.fixture
def panel(qtbot, session):
    made = DrawPanel(session)
    qtbot.addWidget(made)
    made.resize(850, 600)
    made.show()
    made.canvas.setFocus()
    settle()
    return made


def settle():
    for _turn in range(4):
        QApplication.processEvents()


def at(panel, x, y):
    return panel.canvas.widget_position(x, y).toPoint()


def drag(qtbot, panel, *places, modifiers=Qt.KeyboardModifier.NoModifier):
    canvas = panel.canvas
    qtbot.mousePress(canvas, LEFT, modifiers, at(panel, *places[0]))
    for place in places[1:]:
        qtbot.mouseMove(canvas, at(panel, *place))
        settle()
    qtbot.mouseRelease(canvas, LEFT, modifiers, at(panel, *places[-1]))
    settle()


def points(figure):
    return [(p.x, p.y) for p in figure.points_world]


def recorded(qtbot, session):
    qtbot.waitUntil(lambda: session.run.entry is not None and session.run.done, timeout=5000)
    settle()


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


@pytest.fixture
def line(qtbot, session, panel):
    session.new(example_document())
    settle()
    panel.choose_tool("select")
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 25, 14))
    settle()
    assert session.state.selection == ("f1",)
    return lambda: session.sheet.figures[0]


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
    qtbot.mouseRelease(panel.canvas, LEFT, pos=at(panel, 23, 14))


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


def shown_cells(panel, colour):
    value = int(colour.removeprefix("#"), 16)
    rows, columns = np.nonzero(panel.canvas.picture.pixels == value)
    return set(zip(columns.tolist(), rows.tolist(), strict=True))


def test_the_canvas_shows_the_frame_buffer_and_while_stepping_what_is_reached(qtbot, session, panel, line):
    recorded(qtbot, session)
    rows, columns = np.nonzero(frame_buffer(session.sheet) != 0)
    all_cells = set(zip(columns.tolist(), rows.tolist(), strict=True))
    assert shown_cells(panel, LIGHT.data[0]) == all_cells
    assert len(all_cells) == 11
    session.run.go(3)
    settle()
    assert shown_cells(panel, LIGHT.data[0]) == {(20, 10), (21, 11), (22, 12), (23, 12)}
    assert panel.canvas.overlay.current == session.run.step.chosen
    assert panel.canvas.overlay.rejected == session.run.step.rejected
    assert set(panel.canvas.overlay.candidates) == {(24, 12), (24, 13)}
    session.run.last()
    settle()
    assert shown_cells(panel, LIGHT.data[0]) == all_cells


def test_arrows_step_when_nothing_is_selected(qtbot, session, panel, line):
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Escape)
    recorded(qtbot, session)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Right)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Right)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Left)
    assert session.run.position == 1
    qtbot.keyClick(panel.canvas, Qt.Key.Key_End)
    assert session.run.position == 10
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Home)
    assert session.run.position == 0
    assert points(line()) == [(20, 10), (30, 18)]


def test_ask_first_hides_what_comes_and_a_click_answers(qtbot, session, panel, line):
    recorded(qtbot, session)
    session.update_state(ask_first=True)
    settle()
    assert session.run.waiting
    assert len(shown_cells(panel, LIGHT.data[0])) == 1
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 21, 11))
    settle()
    assert (session.run.right, session.run.wrong) == (1, 0)
    assert panel.canvas.overlay.right == ((21, 11),)
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 23, 11))
    settle()
    assert (session.run.position, session.run.right, session.run.wrong) == (1, 1, 1)
    assert panel.canvas.overlay.wrong == ((23, 11),)
    assert words(panel) == ["Not this one"]
    assert points(line()) == [(20, 10), (30, 18)]


def test_a_wrong_click_is_tried_again_or_shown_by_the_step_bar(qtbot, session, panel, line):
    bar = Steps(session.run)
    qtbot.addWidget(bar)
    bar.show()
    recorded(qtbot, session)
    again, show = bar.bar.after_wrong
    assert not again.isVisible()
    qtbot.mouseClick(ask_button(bar), LEFT)
    settle()
    assert again.isVisible()
    assert show.isVisible()
    assert not again.isEnabled()
    assert not show.isEnabled()
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 21, 10))
    settle()
    assert panel.canvas.overlay.wrong == ((21, 10),)
    assert bar.sentence.plain.startswith("Not so: (21, 10) does not come next.")
    qtbot.mouseClick(again, LEFT)
    settle()
    assert panel.canvas.overlay.wrong == ()
    assert words(panel) == []
    assert bar.sentence.plain.startswith("Which pixel comes next?")
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 21, 10))
    settle()
    qtbot.mouseClick(show, LEFT)
    settle()
    assert panel.canvas.overlay.wrong == ()
    assert not again.isEnabled()
    assert (session.run.position, session.run.right, session.run.wrong) == (1, 0, 1)
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 30, 2))
    settle()
    assert bar.sentence.plain.startswith("(30, 2) is far from the pixels in question")
    assert panel.canvas.overlay.wrong == ()
    assert (session.run.position, session.run.right, session.run.wrong) == (1, 0, 1)
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 22, 11))
    settle()
    assert panel.canvas.overlay.wrong == ((22, 11),)
    qtbot.mouseClick(ask_button(bar), LEFT)
    settle()
    assert panel.canvas.overlay.wrong == ()
    assert not again.isVisible()
    assert not session.state.ask_first


def test_a_pixel_under_a_handle_can_be_answered(qtbot, session, panel, line):
    recorded(qtbot, session)
    session.update_state(ask_first=True)
    settle()
    while session.run.position < 9:
        session.run.answer(*session.run.steps[session.run.position + 1].chosen[0])
    settle()
    assert any((handle.x, handle.y) == (30, 18) for handle in panel.canvas.overlay.handles)
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 30, 18))
    settle()
    assert (session.run.position, session.run.right) == (10, 10)
    assert points(line()) == [(20, 10), (30, 18)]


def words(panel):
    return [drawn.text for drawn in panel.canvas.overlay.drawn if isinstance(drawn, Word)]


def ask_button(steps):
    return next(b for b in steps.bar.findChildren(QToolButton) if b.text() == "Ask first")


def test_two_algorithms_are_compared_and_ties_are_counted_apart(qtbot, session, panel):
    panel.choose_tool("line")
    drag(qtbot, panel, (14, 6), (10, 4))
    figure = session.sheet.figures[0]
    session.update_state(compare="dda_line")
    settle()
    comparison = panel.view.comparison
    assert comparison.ties == 2
    assert len(comparison.only_first) == len(comparison.only_second) == 0
    classes = panel.canvas.overlay.classes
    assert classes[6, 14] == BOTH
    assert (classes == TIE_FIRST).sum() == 2
    assert (classes == ONLY_FIRST).sum() == 0
    assert "2 ties" in panel.card.summary.text()
    panel.card.side_by_side.setChecked(True)
    settle()
    assert panel.second.isVisible()
    assert panel.second.picture_size == panel.canvas.picture_size
    assert panel.second.view.cell == panel.canvas.view.cell
    assert set(np.unique(panel.second.overlay.classes)) <= {0, 3, 5}
    assert figure.algorithm == "bresenham_line"


def test_hover_names_the_pixel_and_what_painted_it(qtbot, session, panel, line):
    said = []
    panel.hover_text.connect(said.append)
    qtbot.mouseMove(panel.canvas, at(panel, 21, 11))
    assert said[-1] == "(21, 11) Line, Bresenham's line"
    qtbot.mouseMove(panel.canvas, at(panel, 2, 2))
    assert said[-1] == "(2, 2)"


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
