"""Figures of a group are selected, moved, copied and removed together, unless one is picked alone."""

import pytest
from PySide6.QtCore import Qt

from tests.panels.by_hand import LEFT, SHIFT, at, drag, points, settle
from workbench.document.edits import add_drawing
from workbench.exchange.svg_paths import read_svg

ALT, CTRL = Qt.KeyboardModifier.AltModifier, Qt.KeyboardModifier.ControlModifier
SQUARE = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="-0.5 -0.5 64 48" width="64" height="48">'
    '<path d="M 10 10 H 30 V 30 H 10 Z" fill="red" stroke="blue"/>'
    '<path d="M 40 10 H 50" stroke="blue"/></svg>'
)


@pytest.fixture
def square(session, panel):
    """A filled square with its outline, brought in from an SVG, and a line beside it."""
    drawing = read_svg(SQUARE, session.sheet)
    session.apply(add_drawing(session.sheet.id, drawing.figures, drawing.palette), "Import")
    panel.choose_tool("select")
    session.update_state(selection=())
    settle()
    return [figure.id for figure in session.sheet.figures]


def click(qtbot, panel, x, y, modifiers=Qt.KeyboardModifier.NoModifier):
    qtbot.mouseClick(panel.canvas, LEFT, modifiers, at(panel, x, y))
    settle()


def places(session):
    return {figure.id: points(figure) for figure in session.sheet.figures}


def moved(there, by):
    return [(x + by[0], y + by[1]) for x, y in there]


def test_fill_and_stroke_of_a_shape_move_together(qtbot, session, panel, square):
    fill, stroke, line = square
    before = places(session)
    drag(qtbot, panel, (20, 30), (22, 27))
    after = places(session)
    assert after[fill] == moved(before[fill], (2, -3))
    assert after[stroke] == moved(before[stroke], (2, -3))
    assert after[line] == before[line]
    assert set(session.state.selection) == {fill, stroke}


def test_one_is_picked_alone_with_alt_or_by_a_double_click(qtbot, session, panel, square):
    fill, stroke, _line = square
    click(qtbot, panel, 20, 25, ALT)
    assert session.state.selection == (fill,)
    before = places(session)
    drag(qtbot, panel, (20, 25), (21, 25))
    assert places(session)[fill] == moved(before[fill], (1, 0))
    assert places(session)[stroke] == before[stroke]
    click(qtbot, panel, 60, 40)
    click(qtbot, panel, 20, 25)
    assert set(session.state.selection) == {fill, stroke}
    qtbot.mouseDClick(panel.canvas, LEFT, pos=at(panel, 20, 25))
    assert session.state.selection == (fill,)


def test_shift_adds_and_takes_away_a_group(qtbot, session, panel, square):
    fill, stroke, line = square
    click(qtbot, panel, 45, 37)
    assert session.state.selection == (line,)
    click(qtbot, panel, 20, 25, SHIFT)
    assert set(session.state.selection) == {fill, stroke, line}
    click(qtbot, panel, 20, 25, SHIFT)
    assert session.state.selection == (line,)


def test_a_band_takes_a_group_that_is_whole_in_it(qtbot, session, panel, square):
    fill, stroke, line = square
    drag(qtbot, panel, (6, 12), (34, 42))
    assert set(session.state.selection) == {fill, stroke}
    panel.canvas.setFocus()
    qtbot.keyClick(panel.canvas, Qt.Key.Key_A, CTRL)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_G, CTRL)
    settle()
    drag(qtbot, panel, (6, 12), (34, 42))
    assert session.state.selection == ()
    drag(qtbot, panel, (6, 12), (56, 42))
    assert set(session.state.selection) == {fill, stroke, line}


def test_group_and_ungroup_by_key_are_steps_of_undo(qtbot, session, panel, square):
    fill, stroke, _line = square
    click(qtbot, panel, 20, 25)
    qtbot.keyClick(panel.canvas, Qt.Key.Key_G, CTRL | SHIFT)
    settle()
    assert [figure.group for figure in session.sheet.figures] == [0, 0, 0]
    assert not panel._actions["ungroup"].isEnabled()
    click(qtbot, panel, 60, 40)
    click(qtbot, panel, 20, 25)
    assert session.state.selection == (fill,)
    assert not panel._actions["group"].isEnabled()
    session.undo_stack.undo()
    click(qtbot, panel, 60, 40)
    click(qtbot, panel, 20, 25)
    assert set(session.state.selection) == {fill, stroke}


def test_grouping_is_said_and_the_card_tells_a_group_from_figures(qtbot, session, panel, square):
    said = []
    panel.hover_text.connect(said.append)
    click(qtbot, panel, 20, 25)
    assert panel.card.title.text() == "Group of 2 figures"
    panel.canvas.setFocus()
    qtbot.keyClick(panel.canvas, Qt.Key.Key_A, CTRL)
    settle()
    assert panel.card.title.text() == "3 figures"
    qtbot.keyClick(panel.canvas, Qt.Key.Key_G, CTRL)
    assert said[-1] == "3 figures are one group; hold Alt and click to select one of them."
    settle()
    assert panel.card.title.text() == "Group of 3 figures"
    session.update_state(selection=tuple(square[:2]))
    settle()
    assert panel.card.title.text() == "2 figures"
    qtbot.keyClick(panel.canvas, Qt.Key.Key_G, CTRL | SHIFT)
    assert said[-1] == "Each of the 3 figures is on its own again."
    settle()
    assert panel.card.title.text() == "2 figures"


def test_a_group_is_copied_pasted_ordered_and_removed_as_one(qtbot, session, panel, square):
    fill, stroke, line = square
    click(qtbot, panel, 20, 25)
    panel._actions["forwards"].trigger()
    assert [figure.id for figure in session.sheet.figures] == [line, fill, stroke]
    panel.copy()
    panel.paste()
    qtbot.waitUntil(lambda: len(session.sheet.figures) == 5)
    assert [figure.group for figure in session.sheet.figures] == [0, 1, 1, 2, 2]
    panel._actions["duplicate"].trigger()
    settle()
    assert [figure.group for figure in session.sheet.figures] == [0, 1, 1, 2, 2, 3, 3]
    qtbot.keyClick(panel.canvas, Qt.Key.Key_Delete)
    settle()
    assert [figure.group for figure in session.sheet.figures] == [0, 1, 1, 2, 2]


def test_what_cannot_be_done_to_the_selection_is_left_to_the_window_to_say(session, panel, square):
    before, line = session.document, square[2]
    grouping = panel.group_selected, panel.ungroup_selected
    others = panel.duplicate_selected, panel.bring_forwards, panel.send_backwards
    for chosen, undoable in (((), (*grouping, *others)), ((line,), grouping)):
        session.update_state(selection=chosen)
        assert [act() for act in undoable] == [False] * len(undoable)
    assert session.document is before
