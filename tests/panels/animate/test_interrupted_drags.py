"""What a hand holds in the curve editor can go away before it lets go: then it holds nothing more."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import LEFT, settle
from workbench.document.motion.edits import remove_keys, set_easing
from workbench.document.motion.tracks import motion_of, track_on
from workbench.panels.animate.panel import AnimatePanel


def another_picture(panel: AnimatePanel) -> None:
    panel.session.open_example("animate-letter")


def another_track(panel: AnimatePanel) -> None:
    panel.curves.track_chosen.emit(panel.curves.shown.tracks[1].target)


def another_number(panel: AnimatePanel) -> None:
    panel.curves.choose_number(1)


def no_keys(panel: AnimatePanel) -> None:
    sheet = panel.session.sheet
    keys = [key.id for track in motion_of(sheet).tracks for key in track.keys]
    panel.session.apply(remove_keys(sheet.id, keys), "")


def no_key_after_it(panel: AnimatePanel) -> None:
    track = track_on(panel.session.sheet, panel.curves.shown.chosen)
    assert track is not None
    panel.session.apply(remove_keys(panel.session.sheet.id, [key.id for key in track.keys[1:]]), "")


def undone(panel: AnimatePanel) -> None:
    panel.session.undo_stack.undo()


def move(panel: AnimatePanel, where: QPoint) -> None:
    at_global = QPointF(panel.curves.mapToGlobal(where))
    plain = Qt.KeyboardModifier.NoModifier
    moved = QMouseEvent(QEvent.Type.MouseMove, QPointF(where), at_global, LEFT, LEFT, plain)
    QApplication.sendEvent(panel.curves, moved)
    settle()


INTERRUPTIONS = (another_picture, another_track, another_number, no_keys, no_key_after_it, undone)


@pytest.mark.parametrize("interrupt", INTERRUPTIONS)
def test_a_handle_that_goes_away_while_it_is_dragged_is_let_go(
    qtbot, panel: AnimatePanel, interrupt: Callable[[AnimatePanel], None]
) -> None:
    panel.transport.curves.trigger()
    settle()
    session, page = panel.session, panel.curves
    track = track_on(session.sheet, page.shown.chosen)
    assert track is not None
    session.apply(set_easing(session.sheet.id, [key.id for key in track.keys], "bezier"), "")
    settle()
    start = page.handles_seen()[track.keys[0].id, 1][1].toPoint()
    qtbot.mousePress(page, LEFT, pos=start)
    untouched = session.document
    move(panel, start + QPoint(-10, -10))
    assert session.document is not untouched
    interrupt(panel)
    settle()
    left = session.document
    for away in (20, 9000, -9000):
        move(panel, start + QPoint(away, -away))
    qtbot.mouseRelease(page, LEFT, pos=start)
    settle()
    assert session.document is left
    while session.undo_stack.canUndo():
        session.undo_stack.undo()
        settle()


def test_escape_takes_a_drag_beside_the_curve_back_until_the_hand_lets_go(qtbot, panel: AnimatePanel) -> None:
    curve, session = panel.between.curve, panel.session
    curve.resize(200, 180)
    assert curve.handles is not None
    before, start = session.document, curve.place(*curve.handles[:2]).toPoint()
    qtbot.mousePress(curve, LEFT, pos=start)
    qtbot.mouseMove(curve, start + QPoint(12, -12))
    settle()
    assert session.document != before
    qtbot.keyClick(curve, Qt.Key.Key_Escape)
    qtbot.mouseMove(curve, start + QPoint(20, -20))
    qtbot.mouseRelease(curve, LEFT, pos=start + QPoint(20, -20))
    settle()
    assert session.document == before
    qtbot.mousePress(curve, LEFT, pos=curve.place(*curve.handles[:2]).toPoint())
    qtbot.mouseMove(curve, start + QPoint(12, -12))
    qtbot.mouseRelease(curve, LEFT, pos=start + QPoint(12, -12))
    settle()
    assert session.document != before  # the next drag is one of its own
