"""The curve of a track by hand and by keyboard: keys in time and in value, handles, numbers, zoom, undo."""

import math

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QPixmap, QWheelEvent
from PySide6.QtWidgets import QApplication
from pytestqt.exceptions import capture_exceptions

from tests.panels.by_hand import LEFT, settle
from workbench.document.motion.edits import set_key
from workbench.document.motion.evaluation import at, values_along
from workbench.document.motion.model import Track
from workbench.document.motion.tracks import motion_of, track_on
from workbench.panels.animate.panel import AnimatePanel

SHIFT = Qt.KeyboardModifier.ShiftModifier
CTRL = Qt.KeyboardModifier.ControlModifier
ALT = Qt.KeyboardModifier.AltModifier
Y, X, COLOUR = 0, 1, 3


@pytest.fixture
def curves(panel: AnimatePanel) -> AnimatePanel:
    panel.transport.curves.trigger()
    settle()
    assert panel.curves.isVisible()
    return panel


def track_of(panel: AnimatePanel) -> Track:
    track = track_on(panel.session.sheet, panel.curves.shown.chosen)
    assert track is not None
    return track


def choose(panel: AnimatePanel, row: int) -> Track:
    panel.curves.track_chosen.emit(panel.curves.shown.tracks[row].target)
    settle()
    return track_of(panel)


def place(panel: AnimatePanel, number: int) -> QPoint:
    return panel.curves.place_of(track_of(panel).keys[number].id).toPoint()


def pull(qtbot, panel: AnimatePanel, start: QPoint, way: QPoint, modifier=Qt.KeyboardModifier.NoModifier):
    qtbot.mousePress(panel.curves, LEFT, pos=start)
    for part in (0.5, 1.0):
        where = start + QPoint(round(way.x() * part), round(way.y() * part))
        event_move(panel, where, modifier)
    qtbot.mouseRelease(panel.curves, LEFT, pos=start + way)
    settle()


def event_move(panel: AnimatePanel, where: QPoint, modifier: Qt.KeyboardModifier) -> None:
    at_global = QPointF(panel.curves.mapToGlobal(where))
    moved = QMouseEvent(QEvent.Type.MouseMove, QPointF(where), at_global, LEFT, LEFT, modifier)
    QApplication.sendEvent(panel.curves, moved)
    settle()


def test_the_line_of_each_number_is_what_the_frames_show(panel: AnimatePanel) -> None:
    sheet = panel.session.sheet
    for track in motion_of(sheet).tracks[:3]:
        frames = np.arange(motion_of(sheet).frames, dtype=np.float64)
        drawn = values_along(track, frames)
        name, *_rest, attribute = track.target.split("/")
        for frame in range(motion_of(sheet).frames):
            figure = next(each for each in at(sheet, frame).figures if each.id == name)
            holder = figure.points_world[0] if attribute in ("x", "y") else figure
            assert drawn[frame, 0] == pytest.approx(getattr(holder, attribute), abs=1e-12)
    half = values_along(motion_of(sheet).tracks[Y], np.array([34.5]))  # also between two frames
    assert half[0, 0] == pytest.approx(46 - 36 * (1 - math.cos(math.pi * (6.5 / 12) / 2)))


def test_a_key_is_dragged_in_time_and_in_value_as_one_step_of_undo(qtbot, curves: AnimatePanel) -> None:
    before = track_of(curves).keys[2]
    steps = curves.session.undo_stack.index()
    scale = curves.curves.scale
    per_px = 80.0 / abs(curves.curves._values.y(0) - curves.curves._values.y(80))
    pull(qtbot, curves, place(curves, 2), QPoint(round(3 * scale.pixels), -20))
    after = track_of(curves).keys[2]
    assert after.id == before.id
    assert after.frame == before.frame + 3
    assert after.value[0] == pytest.approx(before.value[0] + 20 * per_px, abs=curves.curves._values.rounding)
    assert curves.session.undo_stack.index() == steps + 1
    curves.session.undo_stack.undo()
    settle()
    assert track_of(curves).keys[2] == before


def test_shift_keeps_a_drag_to_one_direction(qtbot, curves: AnimatePanel) -> None:
    before = track_of(curves).keys[2]
    pull(qtbot, curves, place(curves, 2), QPoint(6, -40), SHIFT)
    assert track_of(curves).keys[2].frame == before.frame
    assert track_of(curves).keys[2].value > before.value
    curves.session.undo_stack.undo()
    settle()
    pull(qtbot, curves, place(curves, 2), QPoint(60, -10), SHIFT)
    assert track_of(curves).keys[2].frame > before.frame
    assert track_of(curves).keys[2].value == before.value


def test_several_keys_go_up_together_and_are_held_in_their_range(qtbot, curves: AnimatePanel) -> None:
    track = choose(curves, COLOUR)
    curves.curves.choose_number(1)
    start = curves.curves.place_of(track.keys[0].id)
    qtbot.keyClick(curves.curves, Qt.Key.Key_A, CTRL)
    assert curves.curves.selected == {key.id for key in track.keys}
    pull(qtbot, curves, start.toPoint(), QPoint(0, -2000))
    reds, greens, blues = zip(*(key.value for key in track_of(curves).keys), strict=True)
    assert set(greens) == {255.0}
    old = [key.value for key in track.keys]
    assert (list(reds), list(blues)) == ([value[0] for value in old], [value[2] for value in old])


def test_a_handle_is_dragged_and_those_of_all_chosen_keys_go_with_it(qtbot, curves: AnimatePanel) -> None:
    said: list[str] = []
    curves.hover_text.connect(said.append)
    keys = track_of(curves).keys
    curves.session.frames.show(34)
    curves.pages.axis.choose([keys[2].id, keys[0].id])
    settle()
    grips = curves.curves.handles_seen()
    assert set(grips) == {(keys[number].id, side) for number in (0, 2) for side in (0, 1)}
    start = grips[keys[2].id, 0][1]
    span = (keys[3].frame - keys[2].frame) * curves.curves.scale.pixels
    pull(qtbot, curves, start.toPoint(), QPoint(round(span * 0.2), 0))
    first, other = track_of(curves).keys[2], track_of(curves).keys[0]
    for key in (first, other):  # both were eased in: their nearest handle is at x = 0.3603
        assert key.easing == "bezier"
        assert key.x1 == pytest.approx(0.3603 + 0.2, abs=0.02)
        assert key.y1 == pytest.approx(0.0, abs=0.03)
        assert (key.x2, key.y2) == pytest.approx((0.671, 0.4827), abs=1e-3)
    assert any("Bézier" in sentence for sentence in said)
    curves.session.undo_stack.undo()
    settle()
    assert track_of(curves).keys == keys


def test_a_handle_never_runs_back_in_time_and_that_is_said(qtbot, curves: AnimatePanel) -> None:
    said: list[str] = []
    curves.hover_text.connect(said.append)
    key = track_of(curves).keys[2]
    curves.session.frames.show(34)
    settle()
    start = curves.curves.handles_seen()[key.id, 1][1].toPoint()
    pull(qtbot, curves, start, QPoint(400, 0))
    assert track_of(curves).keys[2].x2 == 1.0
    assert any("back in time" in sentence for sentence in said)
    drawn = values_along(track_of(curves), np.linspace(28, 40, 200))[:, 0]
    assert np.isfinite(drawn).all()


def test_the_curve_is_worked_without_a_mouse(qtbot, curves: AnimatePanel) -> None:
    editor, session = curves.curves, curves.session
    editor.setFocus()
    session.frames.show(16)
    settle()
    qtbot.keyClick(editor, Qt.Key.Key_Right, CTRL)
    settle()
    assert session.frames.number == 28
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    before = track_of(curves).keys[2]
    step = 10 * editor._values.rounding
    qtbot.keyClick(editor, Qt.Key.Key_Up, ALT)
    settle()
    assert track_of(curves).keys[2].value[0] == pytest.approx(before.value[0] + step)
    qtbot.keyClick(editor, Qt.Key.Key_Right, ALT)
    settle()
    assert track_of(curves).keys[2].frame == 29
    qtbot.keyClick(editor, Qt.Key.Key_H)
    assert "first handle" in editor.accessibleDescription()
    qtbot.keyClick(editor, Qt.Key.Key_Right, ALT)
    settle()
    assert track_of(curves).keys[2].x1 == pytest.approx(0.3803, abs=1e-3)
    assert "first handle at 0.38" in editor.accessibleDescription()
    qtbot.keyClick(editor, Qt.Key.Key_Escape)
    assert "handle" not in editor.accessibleDescription()
    qtbot.keyClick(editor, Qt.Key.Key_Down)
    settle()
    assert "Ball, x" in editor.accessibleDescription()
    qtbot.keyClick(editor, Qt.Key.Key_C)
    settle()
    assert curves.timeline.isVisible()
    assert curves.timeline.hasFocus()


def test_numbers_are_chosen_by_keys_and_by_their_names(qtbot, curves: AnimatePanel) -> None:
    choose(curves, COLOUR)
    assert "number red" in curves.curves.accessibleDescription()
    qtbot.keyClick(curves.curves, Qt.Key.Key_PageDown)
    assert "number green" in curves.curves.accessibleDescription()
    qtbot.mouseClick(curves.curves, LEFT, pos=QPoint(60, 24 + 2 * 24 + 10))
    assert "number blue" in curves.curves.accessibleDescription()


def wheel(panel: AnimatePanel, where: QPoint, turned: int, modifiers: Qt.KeyboardModifier) -> None:
    place, at_global = QPointF(where), QPointF(panel.curves.mapToGlobal(where))
    event = QWheelEvent(
        place,
        at_global,
        QPoint(),
        QPoint(0, turned),
        Qt.MouseButton.NoButton,
        modifiers,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(panel.curves, event)


def test_the_wheel_zooms_where_it_is_and_the_middle_button_moves_the_page(
    qtbot, curves: AnimatePanel
) -> None:
    key = place(curves, 2)
    wheel(curves, key, 120, Qt.KeyboardModifier.NoModifier)
    assert place(curves, 2) == key
    away = abs(place(curves, 3).y() - key.y())
    wheel(curves, key, 120, Qt.KeyboardModifier.NoModifier)
    assert abs(place(curves, 3).y() - key.y()) == pytest.approx(1.25 * away, abs=2)
    wheel(curves, key, 120, CTRL)
    assert place(curves, 2).x() == pytest.approx(key.x(), abs=curves.curves.scale.pixels)
    before = place(curves, 2)
    pixels = curves.curves.scale.pixels
    qtbot.mousePress(curves.curves, Qt.MouseButton.MiddleButton, pos=QPoint(600, 60))
    qtbot.mouseMove(curves.curves, QPoint(600 - round(2 * pixels), 75))
    qtbot.mouseRelease(curves.curves, Qt.MouseButton.MiddleButton, pos=QPoint(600 - round(2 * pixels), 75))
    assert place(curves, 2).x() == pytest.approx(before.x() - 2 * pixels, abs=1.5)
    assert place(curves, 2).y() == pytest.approx(before.y() + 15, abs=1)
    qtbot.keyClick(curves.curves, Qt.Key.Key_F)
    assert place(curves, 2) == key


def test_an_outline_has_no_value_to_drag_but_keys_in_time(qtbot, panel: AnimatePanel) -> None:
    panel.session.open_example("animate-letter")
    panel.transport.curves.setChecked(True)
    settle()
    track = track_of(panel)
    assert track.target.endswith("points_world")
    pull(qtbot, panel, place(panel, 0), QPoint(round(2 * panel.curves.scale.pixels), -40))
    assert track_of(panel).keys[0].frame == track.keys[0].frame + 2
    assert track_of(panel).keys[0].value == track.keys[0].value


def test_an_empty_sheet_has_no_curve(panel: AnimatePanel) -> None:
    panel.transport.curves.setChecked(True)
    panel.session.new()
    settle()
    assert not panel.curves.grab().isNull()
    assert [*panel.curves.keys_seen()] == []
    assert panel.curves.handles_seen() == {}


def test_an_edit_of_a_key_elsewhere_is_seen_at_once(curves: AnimatePanel) -> None:
    sheet = curves.session.sheet
    curves.session.apply(set_key(sheet.id, curves.curves.shown.chosen, 34, [60.0]), "set")
    settle()
    assert [key.frame for key in track_of(curves).keys] == [0, 16, 28, 34, 40, 49, 58]
    assert len({round(at.x()) for _key, at in curves.curves.keys_seen()}) == 7


@pytest.mark.parametrize("size", [(1, 1), (40, 30), (170, 60), (176, 400)])
def test_it_is_painted_however_small_it_is(curves: AnimatePanel, size: tuple[int, int]) -> None:
    choose(curves, 0)
    picture = QPixmap(*size)
    for view in (curves.curves, curves.timeline):
        view.setMinimumSize(1, 1)
        view.resize(*size)
        with capture_exceptions() as raised:
            view.render(picture)
        assert not raised
