"""The canvas follows the run: stepping, asking first, comparing, pointing."""

import numpy as np
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolButton

from tests.panels.by_hand import LEFT, at, drag, points, recorded, settle
from workbench.algorithms.marks import Word
from workbench.document.edits import add_figure, set_attribute
from workbench.document.model import Circle
from workbench.document.samples.figures import points_at
from workbench.rendering import frame_buffer
from workbench.rendering.comparing import BOTH, ONLY_FIRST, TIE_FIRST
from workbench.widgets.look.tokens import LIGHT
from workbench.widgets.stepping.sentence_view import SentenceView
from workbench.widgets.stepping.step_bar import Steps

CIRCLE = Circle("", points_at((9, 9)), "midpoint_circle", radius_world=5.0)


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
    score = SentenceView(session.run)
    qtbot.addWidget(score)
    session.update_state(ask_first=True)
    settle()
    assert session.run.waiting
    assert len(shown_cells(panel, LIGHT.data[0])) == 1
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 21, 11))
    settle()
    assert (session.run.right, session.run.wrong) == (1, 0)
    assert score.plain.endswith("Click it. First tries: 1 right, 0 wrong.")
    assert panel.canvas.overlay.right == ((21, 11),)
    qtbot.mouseClick(panel.canvas, LEFT, pos=at(panel, 23, 11))
    settle()
    assert (session.run.position, session.run.right, session.run.wrong) == (1, 1, 1)
    assert panel.canvas.overlay.wrong == ((23, 11),)
    assert words(panel) == ["Not this one"]
    assert points(line()) == [(20, 10), (30, 18)]
    assert score.plain.endswith("First tries: 1 right, 1 wrong.")


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
    assert bar.sentence.plain.startswith("No: (21, 10) does not come next.")
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


def test_what_was_cut_before_the_algorithm_began_is_said_at_its_first_step(qtbot, session, panel, line):
    bar = Steps(session.run)
    qtbot.addWidget(bar)
    bar.show()
    recorded(qtbot, session)
    assert bar.sentence.plain.startswith("Start at (20, 10).")
    figure = line()
    start, _end = figure.points_world
    session.apply(set_attribute(f"{session.sheet.id}/{figure.id}/{start.id}/x", 100_000.0), "Move")
    settle()
    recorded(qtbot, session)
    assert bar.sentence.plain.startswith("This line is cut 16,384 pixels beyond the picture: the algorithm")
    assert "Start at (16424, " in bar.sentence.plain
    session.run.go(1)
    settle()
    assert "is cut" not in bar.sentence.plain
    session.apply(add_figure(session.sheet.id, replace(CIRCLE, radius_world=1e5)), "Circle")
    session.update_state(active=session.sheet.figures[-1].id)
    settle()
    assert bar.sentence.plain.startswith("This figure is not drawn: it reaches 100,000 pixels")
