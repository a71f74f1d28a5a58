"""The Animate panel by hand and by keyboard: keys dragged, set, eased, deleted, played, stepped; auto-key."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import LEFT, drag, settle
from workbench.document.model import Circle
from workbench.document.motion.tracks import track_on
from workbench.panels.animate.panel import AnimatePanel
from workbench.panels.shared.inspector import InspectorPanel
from workbench.shell.workspaces import join
from workbench.widgets.timeline.scale import LABEL_PX, ROW_PX, RULER_PX

CTRL = Qt.KeyboardModifier.ControlModifier
ALT = Qt.KeyboardModifier.AltModifier


def target_of(panel: AnimatePanel, row: int) -> str:
    return panel.timeline.shown.tracks[row].target


def frames_on(panel: AnimatePanel, row: int) -> list[int]:
    track = track_on(panel.session.sheet, target_of(panel, row))
    return [key.frame for key in track.keys] if track is not None else []


def key_place(panel: AnimatePanel, row: int, number: int) -> QPoint:
    return panel.timeline.place_of(panel.timeline.shown.tracks[row].keys[number].id).toPoint()


def pull(qtbot, panel: AnimatePanel, start: QPoint, end: QPoint) -> None:
    timeline = panel.timeline
    qtbot.mousePress(timeline, LEFT, pos=start)
    qtbot.mouseMove(timeline, (start + end) / 2)
    qtbot.mouseMove(timeline, end)
    qtbot.mouseRelease(timeline, LEFT, pos=end)
    settle()


def frame_place(panel: AnimatePanel, row: int, frame: int) -> QPoint:
    return QPointF(panel.timeline.scale.x(frame), RULER_PX + (row + 0.5) * ROW_PX).toPoint()


def test_the_ruler_is_dragged_to_a_frame_and_everything_shows_it(qtbot, panel: AnimatePanel) -> None:
    ruler = QPoint(round(panel.timeline.scale.x(34)), RULER_PX // 2)
    pull(qtbot, panel, QPoint(round(panel.timeline.scale.x(3)), RULER_PX // 2), ruler)
    assert panel.session.frames.number == 34
    assert panel.transport.frame.text() == "34"
    ball = panel.session.shown.figures[-1]
    assert (ball.points_world[0].x, ball.points_world[0].y) == pytest.approx((152.0, 35.456), abs=1e-3)
    assert panel.timeline.shown.values[target_of(panel, 0)] == "35.4558"
    qtbot.mouseClick(panel.timeline, LEFT, pos=frame_place(panel, 0, 30))
    settle()
    assert "46 + 0.2929 · (10 − 46) = 35.4558" in panel.between.sums.text()
    assert "frame 34 of 58" in panel.timeline.accessibleDescription()
    assert not panel.session.dirty


def test_a_key_is_dragged_in_time_as_one_step_of_undo(qtbot, panel: AnimatePanel) -> None:
    assert frames_on(panel, 0) == [0, 16, 28, 40, 49, 58]
    pull(qtbot, panel, key_place(panel, 0, 2), frame_place(panel, 0, 31))
    assert frames_on(panel, 0) == [0, 16, 31, 40, 49, 58]
    panel.session.undo_stack.undo()
    settle()
    assert frames_on(panel, 0) == [0, 16, 28, 40, 49, 58]


def test_a_box_chooses_keys_that_move_and_go_together(qtbot, panel: AnimatePanel) -> None:
    start = QPoint(round(panel.timeline.scale.x(12)), RULER_PX + 2 * ROW_PX + 2)
    pull(qtbot, panel, start, QPoint(round(panel.timeline.scale.x(20)), RULER_PX + 3 * ROW_PX - 2))
    assert len(panel.timeline.selected) == 3
    panel.timeline.setFocus()
    qtbot.keyClick(panel.timeline, Qt.Key.Key_Right, ALT)
    settle()
    assert frames_on(panel, 2)[:4] == [0, 15, 17, 19]
    qtbot.keyClick(panel.timeline, Qt.Key.Key_Delete)
    settle()
    assert frames_on(panel, 2)[:2] == [0, 38]


def test_a_double_click_and_the_letter_k_set_keys(qtbot, panel: AnimatePanel) -> None:
    qtbot.mouseDClick(panel.timeline, LEFT, pos=frame_place(panel, 1, 20))
    settle()
    assert frames_on(panel, 1) == [0, 20, 58]
    panel.session.frames.show(33)
    panel.timeline.setFocus()
    settle()
    qtbot.keyClick(panel.timeline, Qt.Key.Key_K)
    settle()
    assert frames_on(panel, 1) == [0, 20, 33, 58]


def test_a_key_with_ctrl_goes_to_no_frame(qtbot, panel: AnimatePanel) -> None:
    frames = panel.session.frames
    for held, number in ((Qt.KeyboardModifier.ControlModifier, 0), (Qt.KeyboardModifier.NoModifier, 58)):
        qtbot.keyClick(panel, Qt.Key.Key_End, held)
        settle()
        assert frames.number == number


def test_the_keyboard_goes_from_frame_to_frame_and_from_track_to_track(qtbot, panel: AnimatePanel) -> None:
    timeline, frames = panel.timeline, panel.session.frames
    timeline.setFocus()
    for key, frame in (
        (Qt.Key.Key_Right, 1),
        (Qt.Key.Key_End, 58),
        (Qt.Key.Key_Left, 57),
        (Qt.Key.Key_Home, 0),
    ):
        qtbot.keyClick(timeline, key)
        settle()
        assert frames.number == frame
    settle()
    qtbot.keyClick(timeline, Qt.Key.Key_Down)
    settle()
    assert timeline.shown.chosen == target_of(panel, 1)
    qtbot.keyClick(timeline, Qt.Key.Key_Return)
    assert len(timeline.selected) == 1
    assert "1 key chosen" in timeline.accessibleDescription()
    qtbot.keyClick(timeline, Qt.Key.Key_Space)
    assert frames.playing
    qtbot.keyClick(timeline, Qt.Key.Key_Space)
    assert not frames.playing


def test_an_easing_is_chosen_in_the_menu_of_a_key_and_beside_its_curve(qtbot, panel: AnimatePanel) -> None:
    qtbot.mouseClick(panel.timeline, LEFT, pos=key_place(panel, 1, 0))
    settle()
    menu = panel.timeline.key_menu()
    next(action for action in menu.actions() if action.text() == "Cubic ease in").trigger()
    settle()
    track = track_on(panel.session.sheet, target_of(panel, 1))
    assert track is not None
    assert track.keys[0].easing == "ease_in_cubic"
    assert panel.between.easing.currentText() == "Cubic ease in"
    panel.between.easing.setCurrentIndex(1)
    panel.between.easing.activated.emit(1)
    settle()
    assert track_on(panel.session.sheet, target_of(panel, 1)).keys[0].easing == "linear"  # type: ignore[union-attr]


def test_a_dragged_handle_makes_the_easing_bezier_and_that_is_said(qtbot, panel: AnimatePanel) -> None:
    said: list[str] = []
    panel.hover_text.connect(said.append)
    qtbot.mouseClick(panel.timeline, LEFT, pos=frame_place(panel, 0, 5))
    settle()
    curve = panel.between.curve
    curve.resize(200, 180)
    assert curve.handles is not None
    start = curve.place(*curve.handles[:2]).toPoint()
    end = curve.place(0.6, 0.2).toPoint()
    qtbot.mousePress(curve, LEFT, pos=start)
    qtbot.mouseMove(curve, end)
    qtbot.mouseRelease(curve, LEFT, pos=end)
    settle()
    key = track_on(panel.session.sheet, target_of(panel, 0)).keys[0]  # type: ignore[union-attr]
    assert key.easing == "bezier"
    assert (key.x1, key.y1) == pytest.approx((0.6, 0.2), abs=0.02)
    assert any("Bézier" in sentence for sentence in said)


def test_moved_in_a_frame_with_auto_key_on_it_gets_keys(qtbot, panel: AnimatePanel) -> None:
    session = panel.session
    session.open_example("circles")
    panel.show()
    panel.choose_tool("select")
    panel.transport.auto_key.trigger()
    session.frames.show(24)
    settle()
    drag(qtbot, panel, (30, 20), (36, 20))
    motion = session.sheet.motion
    assert motion is not None
    (track,) = motion.tracks
    assert [(key.frame, key.value) for key in track.keys] == [(0, (18.0, 20.0)), (24, (24.0, 20.0))]
    circle = session.sheet.figures[0]
    assert isinstance(circle, Circle)
    assert circle.points_world[0].x == 18.0


def test_a_figure_that_moves_changes_its_place_in_any_frame(panel: AnimatePanel) -> None:
    session = panel.session
    session.frames.show(24)
    ball = session.sheet.figures[-1]
    session.update_state(selection=(ball.id,), active=ball.id)
    settle()
    assert panel.selected() != [ball]  # it is elsewhere in this frame
    panel.shift_order(-1)
    assert session.sheet.place_of(ball.id) == len(session.sheet.figures) - 2
    panel.shift_order(1)
    panel.shift_order(1)
    assert session.sheet.place_of(ball.id) == len(session.sheet.figures) - 1


def test_a_figure_whose_colour_changes_is_copied_and_cut_in_any_frame(panel: AnimatePanel) -> None:
    session = panel.session
    session.frames.show(24)
    ball = session.sheet.figures[-1]
    session.update_state(selection=(ball.id,), active=ball.id)
    settle()
    (seen,) = panel.selected()
    assert seen.colour >= len(session.sheet.palette)  # a colour of this frame alone
    assert panel.copy()
    assert panel.cut()
    assert session.sheet.place_of(ball.id) == -1
    assert panel.paste()
    settle()
    assert session.sheet.figures[-1].colour == ball.colour


def test_what_is_typed_wrong_is_said(qtbot, panel: AnimatePanel) -> None:
    said: list[str] = []
    panel.hover_text.connect(said.append)
    for field, text in (
        (panel.transport.rate, "0"),
        (panel.transport.length, "2.5"),
        (panel.transport.rate, "x"),
    ):
        field.clear()
        qtbot.keyClicks(field, text)
        qtbot.keyClick(field, Qt.Key.Key_Return)
        settle()
    assert (
        len([sentence for sentence in said if "rate" in sentence or "frame" in sentence or "“x”" in sentence])
        >= 3
    )
    assert panel.transport.rate.text() == "24"
    panel.transport.frame.clear()
    qtbot.keyClicks(panel.transport.frame, "12")
    qtbot.keyClick(panel.transport.frame, Qt.Key.Key_Return)
    assert panel.session.frames.number == 12


def test_stepping_the_in_betweens_shows_their_frames(qtbot, panel: AnimatePanel) -> None:
    qtbot.mouseClick(panel.timeline, LEFT, pos=frame_place(panel, 0, 30))
    panel.session.frames.show(30)
    settle()
    panel.between.step.click()
    run = panel.session.run
    qtbot.waitUntil(lambda: run.entry is not None and run.done and run.number > 0, timeout=5000)
    for _step in range(7):
        run.forward()
        settle()
    assert run.entry is not None
    assert run.entry.slug == "tween"
    assert panel.session.frames.number == 28 + run.number - 1


def test_keys_are_copied_and_pasted_at_the_frame_that_is_shown(qtbot, panel: AnimatePanel) -> None:
    qtbot.mouseClick(panel.timeline, LEFT, pos=key_place(panel, 1, 0))
    panel.timeline.setFocus()
    settle()
    assert panel.timeline.copy()
    panel.session.frames.show(30)
    panel.timeline.paste()
    settle()
    assert frames_on(panel, 1) == [0, 30, 58]


def test_the_ends_of_the_ghosts_are_dragged(qtbot, panel: AnimatePanel) -> None:
    panel.session.frames.show(30)
    settle()
    scale = panel.timeline.scale
    y = RULER_PX // 2
    pull(qtbot, panel, QPoint(round(scale.x(39)), y), QPoint(round(scale.x(34)), y))
    assert panel.view.reach == 4
    assert panel.session.frames.number == 30
    panel.transport.ghosts.trigger()
    assert panel.view.reach == 0


def test_a_zoomed_timeline_keeps_its_frame_and_fits_again(panel: AnimatePanel) -> None:
    panel.session.frames.show(40)
    settle()
    before = panel.timeline.scale.x(40)
    panel.pages.axis.zoom(2.0, 40)
    assert panel.timeline.scale.x(40) == pytest.approx(before, abs=panel.timeline.scale.pixels)
    assert panel.timeline.scale.x(41) - panel.timeline.scale.x(40) > 20
    panel.pages.fit()
    assert panel.timeline.scale.first == 0
    assert panel.timeline.scale.x(58) <= panel.timeline.width()
    assert panel.timeline.scale.x(0) > LABEL_PX


def test_an_empty_sheet_says_what_to_do(panel: AnimatePanel) -> None:
    panel.session.new()
    settle()
    QApplication.processEvents()
    assert panel.between.title.text() == "Nothing moves yet"
    assert panel.timeline.shown.tracks == ()
    assert panel.empty.isVisible()


def test_the_sentence_tells_of_the_frame_that_is_shown_also_after_undo(qtbot, panel: AnimatePanel) -> None:
    session = panel.session
    session.frames.show(34)
    settle()
    qtbot.waitUntil(lambda: session.run.number == 7, timeout=5000)
    said = "".join(part.text for part in session.run.sentence)
    assert said.startswith("Frame 34 is in-between 6 of 11")
    pull(qtbot, panel, key_place(panel, 0, 2), frame_place(panel, 0, 31))
    qtbot.waitUntil(lambda: session.run.number == 4, timeout=5000)
    session.undo_stack.undo()
    settle()
    qtbot.waitUntil(lambda: session.run.number == 7, timeout=5000)
    assert session.frames.number == 34
    session.frames.show(3)
    qtbot.waitUntil(lambda: session.run.number == 4, timeout=5000)
    assert session.frames.number == 3


def test_there_is_one_transport_at_a_time(qtbot, panel: AnimatePanel) -> None:
    inspector = InspectorPanel(panel.session)
    qtbot.addWidget(inspector.step_bar)
    join([panel, inspector])
    inspector.step_bar.show()
    bar, transport = inspector.step_bar.bar, panel.transport
    panel.hide()
    panel.show()
    assert not bar.isVisible()
    assert transport.frame.isVisible()
    panel.between.step.click()
    assert bar.isVisible()
    assert not transport.frame.isVisible()
    transport.leave.trigger()
    assert not bar.isVisible()
    panel.session.run.set_ask_first(True)
    assert bar.isVisible()
    transport.leave.trigger()
    assert not panel.session.run.ask_first
    panel.hide()
    assert bar.isVisible()


def test_chosen_keys_are_scaled_in_time_with_ctrl(qtbot, panel: AnimatePanel) -> None:
    panel.pages.axis.choose([key.id for key in panel.timeline.shown.tracks[0].keys[:3]])
    grip, end = key_place(panel, 0, 2), frame_place(panel, 0, 14)
    qtbot.mousePress(panel.timeline, LEFT, CTRL, grip)
    qtbot.mouseMove(panel.timeline, (grip + end) / 2)
    qtbot.mouseMove(panel.timeline, end)
    qtbot.mouseRelease(panel.timeline, LEFT, CTRL, end)
    settle()
    assert frames_on(panel, 0) == [0, 8, 14, 40, 49, 58]
    panel.session.undo_stack.undo()
    settle()
    assert frames_on(panel, 0) == [0, 16, 28, 40, 49, 58]


def test_a_frame_is_put_in_and_taken_out(panel: AnimatePanel) -> None:
    panel.session.frames.show(20)
    actions = {action.objectName().partition(".")[2]: action for action in panel.actions()}
    actions["insert_time"].trigger()
    settle()
    assert frames_on(panel, 0) == [0, 16, 29, 41, 50, 59]
    assert panel.session.frames.count == 60
    panel.session.frames.show(16)
    actions["remove_time"].trigger()
    settle()
    assert frames_on(panel, 0) == [0, 28, 40, 49, 58]


def test_a_key_of_the_path_is_dragged_in_its_own_frame(qtbot, panel: AnimatePanel) -> None:
    session = panel.session
    panel.choose_tool("select")
    session.frames.show(34)
    settle()
    grips = (handle for handle in panel.canvas.overlay.handles if handle.shape == "square")
    on_path = [handle for handle in grips if handle.id.startswith("path/")]
    assert [handle.id for handle in on_path] == [f"path/{frame}" for frame in (0, 16, 28, 40, 49, 58)]
    drag(qtbot, panel, (212, 26), (208, 34), (204, 42))
    assert session.frames.number == 49
    ball = session.shown.figures[-1]
    assert (ball.points_world[0].x, ball.points_world[0].y) == (204.0, 42.0)
    assert frames_on(panel, 0) == [0, 16, 28, 40, 49, 58]
    assert frames_on(panel, 1) == [0, 49, 58]
    session.undo_stack.undo()
    settle()
    assert frames_on(panel, 1) == [0, 58]
    assert session.shown.figures[-1].points_world[0].y == 26.0


def test_a_late_word_of_a_run_of_other_keys_moves_nothing(qtbot, panel: AnimatePanel) -> None:
    session = panel.session
    session.frames.show(34)
    qtbot.waitUntil(lambda: session.run.number == 7, timeout=5000)
    panel.pages.axis.choose([panel.timeline.shown.tracks[0].keys[2].id])
    panel.keys.drag(3)
    session.frames.settled.emit()
    session.run.moved.emit()  # the run still goes from frame 28 to 40
    assert (session.frames.number, session.state.step) == (34, 4)
    panel.keys.drop()
    qtbot.waitUntil(lambda: session.run.number == 4, timeout=5000)
    assert session.frames.number == 34
