"""The timeline as it is used: zoom, several keys at once, what is in the way, gestures taken back."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QContextMenuEvent, QWheelEvent
from PySide6.QtWidgets import QApplication, QMenu

from tests.panels.animate.test_animate import frame_place, frames_on, key_place, pull, target_of
from tests.panels.by_hand import LEFT, drag, settle
from workbench.document.model import Ellipse
from workbench.document.motion.edits import remove_keys, set_motion
from workbench.document.motion.tracks import motion_of, track_on
from workbench.panels.animate.panel import AnimatePanel
from workbench.widgets.timeline.scale import LABEL_PX, ROW_PX, RULER_PX

CTRL = Qt.KeyboardModifier.ControlModifier
ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
PLAIN = Qt.KeyboardModifier.NoModifier
MENUS = pytest.mark.qt_log_ignore("does not support raise", "does not support grabbing", extend=True)


@pytest.fixture
def said(panel: AnimatePanel) -> list[str]:
    sentences: list[str] = []
    panel.hover_text.connect(sentences.append)
    return sentences


def turn(panel: AnimatePanel, x: float, turned: int, modifiers: Qt.KeyboardModifier) -> None:
    place = QPointF(x, RULER_PX + 10)
    event = QWheelEvent(
        place,
        panel.timeline.mapToGlobal(place),
        QPoint(),
        QPoint(0, turned),
        Qt.MouseButton.NoButton,
        modifiers,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(panel.timeline, event)


def test_ctrl_and_the_wheel_zoom_where_the_pointer_is_and_shift_goes_along(panel: AnimatePanel) -> None:
    timeline = panel.timeline
    x = timeline.scale.x(40)
    for _turn in range(5):
        turn(panel, x, 120, CTRL)
    assert timeline.scale.x(40) == pytest.approx(x, abs=timeline.scale.pixels)
    first = timeline.scale.first
    assert first > 0
    turn(panel, x, 120, SHIFT)
    assert timeline.scale.first < first
    pixels = timeline.scale.pixels
    for _turn in range(9):
        turn(panel, x, -120, CTRL)
    assert timeline.scale.pixels < pixels
    assert timeline.scale.first == 0
    assert LABEL_PX < timeline.scale.x(58) <= timeline.width()


def test_a_zoomed_timeline_follows_the_frame(qtbot, panel: AnimatePanel) -> None:
    timeline = panel.timeline
    for _press in range(6):
        qtbot.keyClick(timeline, Qt.Key.Key_Plus)
    for frame in (58, 0, 31):
        panel.session.frames.show(frame)
        settle()
        assert LABEL_PX < timeline.scale.x(frame) <= timeline.width()
    qtbot.keyClick(timeline, Qt.Key.Key_F)
    assert timeline.scale.first == 0


def test_keys_beyond_the_end_stay_in_sight(panel: AnimatePanel) -> None:
    session = panel.session
    session.apply(set_motion(session.sheet.id, frames=30), "shorter")
    settle()
    assert frames_on(panel, 0)[-1] == 58
    assert panel.timeline.scale.x(58) <= panel.timeline.width()
    panel.timeline.setFocus()
    session.frames.show(99)
    assert session.frames.number == 29


def test_keys_of_several_tracks_are_moved_scaled_and_eased_at_once(qtbot, panel: AnimatePanel) -> None:
    start = QPoint(round(panel.timeline.scale.x(12)), RULER_PX + 2)
    pull(qtbot, panel, start, QPoint(round(panel.timeline.scale.x(20)), RULER_PX + 3 * ROW_PX - 2))
    assert len(panel.timeline.selected) == 4  # frame 16 of y, 14, 16 and 18 of the radius
    pull(qtbot, panel, key_place(panel, 0, 1), frame_place(panel, 0, 18))
    assert (frames_on(panel, 0)[1], frames_on(panel, 2)[1:4]) == (18, [16, 18, 20])
    menu = panel.timeline.key_menu()
    next(action for action in menu.actions() if action.text() == "Held").trigger()
    settle()
    chosen = panel.timeline.selected
    easings = {
        key.easing for t in motion_of(panel.session.sheet).tracks for key in t.keys if key.id in chosen
    }
    assert easings == {"constant"}
    rows = panel.timeline.shown.tracks
    shown = {key.leaving for track in rows for key in track.keys if key.id in chosen}
    assert shown == {"held"}
    ticked = [action.text() for action in panel.timeline.key_menu().actions() if action.isChecked()]
    assert ticked == ["Held"]
    grip, end = key_place(panel, 2, 3), frame_place(panel, 2, 24)
    qtbot.mousePress(panel.timeline, LEFT, CTRL, grip)
    qtbot.mouseMove(panel.timeline, end)
    qtbot.mouseRelease(panel.timeline, LEFT, CTRL, end)
    settle()
    assert (frames_on(panel, 0)[1], frames_on(panel, 2)[1:4]) == (20, [16, 20, 24])


def test_a_key_in_the_way_is_replaced_and_that_is_said(qtbot, panel: AnimatePanel, said: list[str]) -> None:
    keys = track_on(panel.session.sheet, target_of(panel, 0)).keys  # type: ignore[union-attr]
    pull(qtbot, panel, key_place(panel, 0, 1), frame_place(panel, 0, 28))
    assert frames_on(panel, 0) == [0, 28, 40, 49, 58]
    assert any("1 key was in the way" in sentence for sentence in said)
    panel.session.undo_stack.undo()
    settle()
    assert track_on(panel.session.sheet, target_of(panel, 0)).keys == keys  # type: ignore[union-attr]
    said.clear()
    pull(qtbot, panel, key_place(panel, 0, 1), frame_place(panel, 0, 30))  # past it: nothing is lost
    assert frames_on(panel, 0) == [0, 28, 30, 40, 49, 58]
    assert not any("in the way" in sentence for sentence in said)


def test_a_pasted_key_that_takes_a_place_is_said(qtbot, panel: AnimatePanel, said: list[str]) -> None:
    panel.pages.axis.choose([panel.timeline.shown.tracks[0].keys[0].id])
    panel.timeline.setFocus()
    assert panel.timeline.cut()
    settle()
    assert frames_on(panel, 0) == [16, 28, 40, 49, 58]
    panel.session.frames.show(28)
    panel.timeline.paste()
    settle()
    assert frames_on(panel, 0) == [16, 28, 40, 49, 58]
    assert any("1 key was in the way" in sentence for sentence in said)


def test_escape_takes_a_drag_back_and_an_undo_meanwhile_ends_it(qtbot, panel: AnimatePanel) -> None:
    session, timeline = panel.session, panel.timeline
    before, steps = session.document, session.undo_stack.index()
    start, end = key_place(panel, 0, 2), frame_place(panel, 0, 33)
    qtbot.mousePress(timeline, LEFT, pos=start)
    qtbot.mouseMove(timeline, end)
    assert session.document != before
    qtbot.keyClick(timeline, Qt.Key.Key_Escape)
    assert session.document == before
    qtbot.mouseMove(timeline, frame_place(panel, 0, 35))
    qtbot.mouseRelease(timeline, LEFT, pos=end)
    settle()
    assert session.document == before
    assert session.undo_stack.index() == steps
    qtbot.mousePress(timeline, LEFT, pos=start)
    qtbot.mouseMove(timeline, end)
    session.undo_stack.undo()
    qtbot.mouseMove(timeline, frame_place(panel, 0, 35))
    qtbot.mouseRelease(timeline, LEFT, pos=end)
    settle()
    assert session.document == before


def test_any_mark_of_the_path_is_dragged_and_gets_a_key_there(qtbot, panel: AnimatePanel) -> None:
    session = panel.session
    panel.choose_tool("select")
    session.frames.show(2)
    settle()
    handles = {handle.id: handle for handle in panel.canvas.overlay.handles}
    marks = [name for name, handle in handles.items() if handle.shape == "mark"]
    assert len(marks) == 58 - len([0, 16, 28, 40, 49, 58])  # all frames but those with a key, and this one
    grip = handles["path/22"]
    drag(qtbot, panel, (grip.x, grip.y), (grip.x + 3, grip.y + 6), (grip.x + 4, grip.y + 9))
    assert session.frames.number == 22
    assert frames_on(panel, 0) == [0, 16, 22, 28, 40, 49, 58]
    ball = session.shown.figures[-1]
    assert isinstance(ball, Ellipse)
    place = ball.points_world[0]
    assert (place.x, place.y) == pytest.approx((grip.x + 4, grip.y + 9), abs=0.51)
    session.undo_stack.undo()
    settle()
    assert frames_on(panel, 0) == [0, 16, 28, 40, 49, 58]


def test_edit_acts_on_keys_while_the_timeline_has_the_focus(panel: AnimatePanel) -> None:
    figures = panel.session.sheet.figures
    timeline = panel.timeline
    timeline.select_all()
    assert len(timeline.selected) == sum(len(track.keys) for track in timeline.shown.tracks)
    timeline.delete_selected()
    settle()
    assert motion_of(panel.session.sheet).tracks == ()
    assert panel.session.sheet.figures == figures
    panel.session.undo_stack.undo()
    settle()
    assert frames_on(panel, 0) == [0, 16, 28, 40, 49, 58]


@MENUS
def test_the_menu_of_keys_comes_by_keyboard(qtbot, panel: AnimatePanel) -> None:
    panel.session.frames.show(28)
    settle()
    timeline = panel.timeline
    asked = QContextMenuEvent(QContextMenuEvent.Reason.Keyboard, QPoint(5, 5), QPoint(5, 5))
    QApplication.sendEvent(timeline, asked)
    (menu,) = timeline.findChildren(QMenu)
    assert timeline.selected == {timeline.shown.tracks[0].keys[2].id}
    assert [action.text() for action in menu.actions() if action.isChecked()] == ["Ease in"]
    menu.close()


def test_a_key_that_is_gone_meanwhile_is_said(panel: AnimatePanel, said: list[str]) -> None:
    key = panel.timeline.shown.tracks[0].keys[2].id
    panel.pages.axis.choose([key])
    panel.session.apply(remove_keys(panel.session.sheet.id, [key]), "elsewhere")
    panel.keys.drag(3)  # before the timeline has been told
    panel.keys.drop()
    assert any(f"no key '{key}'" in sentence for sentence in said)
    assert frames_on(panel, 0) == [0, 16, 40, 49, 58]


def test_keyboard_reaches_ghosts_zoom_scaling_and_keys(qtbot, panel: AnimatePanel) -> None:
    timeline, frames = panel.timeline, panel.session.frames
    timeline.setFocus()
    reach = panel.view.reach
    qtbot.keyClick(timeline, Qt.Key.Key_BracketRight)
    assert panel.view.reach == reach + 1
    settle()
    qtbot.keyClick(timeline, Qt.Key.Key_BracketLeft)
    settle()
    qtbot.keyClick(timeline, Qt.Key.Key_BracketLeft)
    assert panel.view.reach == reach - 1
    qtbot.keyClick(timeline, Qt.Key.Key_Right, SHIFT)
    assert frames.number == 10
    settle()
    qtbot.keyClick(timeline, Qt.Key.Key_Right, CTRL)
    assert frames.number == 16
    settle()
    qtbot.keyClick(timeline, Qt.Key.Key_Left, CTRL)
    assert frames.number == 0
    keys = timeline.shown.tracks[0].keys
    panel.pages.axis.choose([key.id for key in keys[:3]])
    qtbot.keyClick(timeline, Qt.Key.Key_Left, ALT | SHIFT)
    settle()
    assert frames_on(panel, 0)[:3] == [0, 15, 27]
    qtbot.keyClick(timeline, Qt.Key.Key_A, CTRL)
    assert len(timeline.selected) == sum(len(track.keys) for track in timeline.shown.tracks)


@MENUS
def test_a_whole_exercise_without_a_mouse(qtbot, panel: AnimatePanel) -> None:
    session = panel.session
    session.open_example("circles")
    panel.show()
    settle()
    timeline, frames = panel.timeline, session.frames
    circle = session.sheet.figures[0]
    session.update_state(selection=(circle.id,), active=circle.id)
    settle()

    def key(name: Qt.Key, modifiers: Qt.KeyboardModifier = PLAIN, on=timeline) -> None:
        on.setFocus()
        qtbot.keyClick(on, name, modifiers)
        settle()

    panel._actions["set_key"].trigger()  # K on the canvas
    settle()
    (track,) = motion_of(session.sheet).tracks
    assert [key.frame for key in track.keys] == [0]
    key(Qt.Key.Key_Right, SHIFT)
    key(Qt.Key.Key_Right, SHIFT)
    assert frames.number == 20
    key(Qt.Key.Key_Right, SHIFT, panel.canvas)  # x by ten pixels
    key(Qt.Key.Key_Right, PLAIN, panel.canvas)
    first, second = track_on(session.sheet, track.target).keys  # type: ignore[union-attr]
    assert (second.frame, second.value[0]) == (20, first.value[0] + 11)
    key(Qt.Key.Key_Home)
    key(Qt.Key.Key_Space)
    assert frames.playing
    key(Qt.Key.Key_Space)
    assert not frames.playing
    key(Qt.Key.Key_Home)
    key(Qt.Key.Key_Return)
    assert timeline.selected == {first.id}
    QApplication.sendEvent(
        timeline, QContextMenuEvent(QContextMenuEvent.Reason.Keyboard, QPoint(5, 5), QPoint(5, 5))
    )
    (menu,) = timeline.findChildren(QMenu)
    while menu.activeAction() is None or menu.activeAction().text() != "Ease out":
        qtbot.keyClick(menu, Qt.Key.Key_Down)
    qtbot.keyClick(menu, Qt.Key.Key_Return)
    settle()
    keys = track_on(session.sheet, track.target).keys  # type: ignore[union-attr]
    assert [each.easing for each in keys] == ["ease_out", "linear"]
    assert "Ease out" in timeline.accessibleDescription()
    assert timeline.copy()
    key(Qt.Key.Key_End)
    timeline.paste()
    settle()
    keys = track_on(session.sheet, track.target).keys  # type: ignore[union-attr]
    assert [each.frame for each in keys] == [0, 20, 48]
    assert keys[2].value == first.value
    key(Qt.Key.Key_Escape)
    key(Qt.Key.Key_Return)
    key(Qt.Key.Key_Delete)
    keys = track_on(session.sheet, track.target).keys  # type: ignore[union-attr]
    assert [each.frame for each in keys] == [0, 20]
    assert session.sheet.place_of(circle.id) >= 0
