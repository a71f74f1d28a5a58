"""Once something else is done in the middle of a drag, the hand changes nothing more."""

import pytest
from PySide6.QtCore import QPoint

from tests.panels.by_hand import settle
from tests.panels.viewing.hand import LEFT, NO_KEYS, window

INTERRUPTIONS = {
    "undo": lambda session: session.undo_stack.undo(),
    "another picture": lambda session: session.open_example("view-numbers"),
    "no picture": lambda session: session.new(),
}


@pytest.mark.parametrize("name", INTERRUPTIONS)
def test_a_drag_of_the_window_ends_where_something_else_is_done(qtbot, session, panel, name):
    plane, before = panel.left.plane, session.document
    x0, y0, x1, y1 = window(panel)
    start = plane.position((x0 + x1) / 2, (y0 + y1) / 2).toPoint()
    qtbot.mousePress(plane, LEFT, NO_KEYS, start)
    for step in (10, 20):
        qtbot.mouseMove(plane, start + QPoint(step, step))
        settle()
    assert session.document != before
    INTERRUPTIONS[name](session)
    settle()
    after = session.document
    for away in (40, 400):
        qtbot.mouseMove(plane, start + QPoint(away, -away))
        settle()
    qtbot.mouseRelease(plane, LEFT, NO_KEYS, start + QPoint(60, 0))
    settle()
    assert session.document is after
    assert not panel.gesture.busy
