"""The View workspace as a person uses it: rectangles dragged, typed and nudged, points sent through."""

from itertools import pairwise

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication

from tests.panels.by_hand import recorded, settle
from workbench.document.model import MODES, Rectangle
from workbench.document.samples.examples import example
from workbench.document.storage.files import read
from workbench.document.view_edits import set_mode, set_window
from workbench.panels.viewing.panel import ViewingPanel
from workbench.rendering import frame_buffer
from workbench.rendering.mapping import box, view_map
from workbench.session.session import Session
from workbench.widgets.look.tokens import DARK

LEFT, SHIFT, ALT = (
    Qt.MouseButton.LeftButton,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.AltModifier,
)
NO_KEYS = Qt.KeyboardModifier.NoModifier


@pytest.fixture
def session(qtbot):
    made = Session(document=example("view-numbers").document)
    yield made
    made.close()


@pytest.fixture
def panel(qtbot, session):
    made = ViewingPanel(session)
    qtbot.addWidget(made)
    qtbot.addWidget(made.card)
    qtbot.addWidget(made.point)
    made.resize(1000, 640)
    made.show()
    made.card.resize(420, 600)
    made.card.show()
    made.point.resize(420, 400)
    made.point.show()
    settle()
    return made


def drag(qtbot, picture, *places):
    plane = picture.plane
    spots = [plane.position(*place).toPoint() for place in places]
    qtbot.mousePress(plane, LEFT, NO_KEYS, spots[0])
    for spot in spots[1:]:
        qtbot.mouseMove(plane, spot)
        settle()
    qtbot.mouseRelease(plane, LEFT, NO_KEYS, spots[-1])
    settle()


def type_into(qtbot, field, text):
    field.field.setFocus()
    field.field.selectAll()
    qtbot.keyClicks(field.field, text)
    qtbot.keyClick(field.field, Qt.Key.Key_Return)
    settle()


def window(panel):
    return box(panel.view.window_world)


def viewport(panel):
    return box(panel.view.viewport_device)


def test_the_numbers_of_the_course_come_out(qtbot, session, panel):
    recorded(qtbot, session)
    assert session.run.total_steps == 16
    session.run.go_to_number(12)
    settle()
    said = "".join(part.text for part in session.run.sentence)
    assert said == "x_v = 3 + 1 = 4, y_v = 2 + 1.33333 = 3.33333."
    assert panel.point.fields["x_v"].value() == 4.0
    assert panel.point.fields["y_v"].value() == pytest.approx(10 / 3, abs=1e-6)
    assert "s<sub>y</sub> = 4/3 = 1.3333" in panel.card.factors.text()
    assert "Taller by a third: s<sub>y</sub> = 1.3333 s<sub>x</sub>" in panel.card.warning.text()
    for point, there in (((1, 1), (3, 2)), ((1, 2), (3, 10 / 3)), ((2, 2), (4, 10 / 3)), ((3, 4), (5, 6))):
        assert view_map(panel.view).point(*point) == pytest.approx(there)


def test_sides_corners_and_the_inside_of_both_rectangles_are_dragged(qtbot, session, panel):
    drag(qtbot, panel.left, (4.0, 2.0), (4.5, 2.2), (5.0, 2.4))
    assert window(panel) == (1.0, 1.0, 5.0, 4.0)
    drag(qtbot, panel.left, (1.0, 1.0), (0.0, 0.0))
    assert window(panel) == (0.0, 0.0, 5.0, 4.0)
    drag(qtbot, panel.left, (1.5, 1.5), (2.5, 2.5))
    assert window(panel) == pytest.approx((1.0, 1.0, 6.0, 5.0))
    drag(qtbot, panel.right, (6.0, 6.0), (8.0, 7.0))
    assert viewport(panel) == (3.0, 2.0, 8.0, 7.0)
    assert session.undo_stack.count() == 4
    for _each in range(4):
        session.undo_stack.undo()
    settle()
    assert window(panel) == (1.0, 1.0, 4.0, 4.0)
    assert viewport(panel) == (3.0, 2.0, 6.0, 6.0)


def test_a_side_stops_before_the_other_and_escape_brings_a_drag_back(qtbot, session, panel):
    drag(qtbot, panel.left, (4.0, 2.5), (-3.0, 2.5))
    xmin, _ymin, xmax, _ymax = window(panel)
    assert 0 < xmax - xmin < 0.5
    session.undo_stack.undo()
    settle()
    plane = panel.left.plane
    qtbot.mousePress(plane, LEFT, NO_KEYS, plane.position(2.0, 1.5).toPoint())
    qtbot.mouseMove(plane, plane.position(3.0, 2.5).toPoint())
    settle()
    assert window(panel) != (1.0, 1.0, 4.0, 4.0)
    assert panel.numbers._highlights
    assert panel.card.rectangles["window"].fields["xmin"].property("lit")
    qtbot.keyClick(plane, Qt.Key.Key_Escape)
    qtbot.mouseRelease(plane, LEFT, NO_KEYS, plane.position(3.0, 2.5).toPoint())
    settle()
    assert window(panel) == (1.0, 1.0, 4.0, 4.0)
    assert session.undo_stack.isClean() or session.undo_stack.index() == 0
    assert not panel.numbers._highlights


def test_what_a_drag_changes_is_lit_and_nothing_else(qtbot, session, panel):
    plane = panel.right.plane
    qtbot.mousePress(plane, LEFT, NO_KEYS, plane.position(6.0, 4.0).toPoint())
    qtbot.mouseMove(plane, plane.position(8.0, 4.0).toPoint())
    settle()
    lit = [side for side, field in panel.card.rectangles["viewport"].fields.items() if field.property("lit")]
    assert lit == ["xmax"]
    assert [(h.term, h.row, h.column) for h in panel.numbers._highlights] == [(1, 0, 0), (1, 0, 2), (4, 0, 0)]
    assert "<b" in panel.card.factors.text().partition("<br>")[0]
    assert "<b" not in panel.card.factors.text().partition("<br>")[2]
    qtbot.mouseRelease(plane, LEFT, NO_KEYS, plane.position(8.0, 4.0).toPoint())


def test_keys_move_and_resize_the_rectangle_of_the_focused_picture(qtbot, session, panel):
    plane = panel.left.plane
    plane.setFocus()
    step = plane.grid / 10
    qtbot.keyClick(plane, Qt.Key.Key_Right)
    settle()
    assert window(panel) == pytest.approx((1 + step, 1, 4 + step, 4))
    qtbot.keyClick(plane, Qt.Key.Key_Up, ALT)
    settle()
    assert window(panel) == pytest.approx((1 + step, 1, 4 + step, 4 + step))
    other = panel.right.plane
    step = other.grid / 10
    qtbot.keyClick(other, Qt.Key.Key_Left)
    settle()
    assert viewport(panel) == pytest.approx((3 - step, 2, 6 - step, 6))


def test_a_rectangle_without_area_is_said_in_place_and_the_last_good_picture_stays(qtbot, session, panel):
    before = frame_buffer(session.sheet)
    fields = panel.card.rectangles["window"].fields
    type_into(qtbot, fields["xmax"], "1")
    assert panel.card.complaint.text() == (
        "The window has no width: x_min and x_max are both 1. Drag one of its sides, or type another value."
    )
    assert window(panel) == (1.0, 1.0, 4.0, 4.0)
    assert np.array_equal(before, frame_buffer(session.sheet))
    type_into(qtbot, panel.card.rectangles["viewport"].fields["ymin"], "7")
    assert panel.card.complaint.text().startswith(
        "The viewport has no height: y_min = 7 is beyond y_max = 6."
    )
    type_into(qtbot, fields["xmax"], "5")
    assert panel.card.complaint.isHidden()
    assert window(panel) == (1.0, 1.0, 5.0, 4.0)


@pytest.mark.parametrize("mode", ["fit", "fill"])
def test_fit_and_fill_never_distort(qtbot, session, panel, mode):
    button = panel.card.modes.button(MODES.index(mode))
    qtbot.mouseClick(button, LEFT)
    settle()
    assert panel.view.mode == mode
    scale = view_map(panel.view)
    assert scale.sx == pytest.approx(scale.sy)
    assert scale.sx == pytest.approx(1.0 if mode == "fit" else 4 / 3)
    assert panel.card.warning.text() == ""


def test_numbers_of_the_matrices_edit_what_they_stand_for(qtbot, session, panel):
    panel.numbers.edited.emit(4, 0, 0, 2.0)
    panel.numbers.edit_ended.emit()
    settle()
    assert viewport(panel) == (3.0, 2.0, 9.0, 6.0)
    panel.numbers.edited.emit(5, 1, 2, -2.0)
    panel.numbers.edit_ended.emit()
    settle()
    assert window(panel) == (1.0, 2.0, 4.0, 5.0)
    panel.numbers.edited.emit(3, 0, 2, 0.0)
    panel.numbers.edit_ended.emit()
    settle()
    assert viewport(panel) == (0.0, 2.0, 6.0, 6.0)
    panel.numbers.edited.emit(4, 1, 1, 0.0)
    panel.numbers.edit_ended.emit()
    settle()
    assert "leaves nothing of the picture" in panel.card.complaint.text()
    assert viewport(panel) == (0.0, 2.0, 6.0, 6.0)
    assert panel.numbers.terms[4].cells[1][1].value == pytest.approx(4 / 3)


def test_a_number_of_a_matrix_is_dragged_where_it_stands(qtbot, session, panel):
    spot = panel.numbers.cell_box((5, 0, 2)).center().toPoint()
    qtbot.mousePress(panel.numbers, LEFT, NO_KEYS, spot)
    for right in (5, 10, 20, 40):
        qtbot.mouseMove(panel.numbers, spot + QPoint(right, 0))
        settle()
    assert panel.card.rectangles["window"].fields["xmin"].property("lit")
    qtbot.mouseRelease(panel.numbers, LEFT, NO_KEYS, spot + QPoint(40, 0))
    settle()
    xmin, _ymin, xmax, _ymax = window(panel)
    assert xmin < 1.0
    assert xmax - xmin == pytest.approx(3.0)
    assert session.undo_stack.count() == 1


def test_a_click_sends_a_point_there_and_back(qtbot, session, panel):
    drag(qtbot, panel.left, (2.0, 2.0))
    recorded(qtbot, session)
    assert session.run.total_steps == 4
    text = panel.point.way.text()
    assert "x<sub>v</sub> = 3 + (2 − 1) · 1 = 4" in text
    assert "y<sub>w</sub> = 1 + (3.3333 − 2) / 1.3333 = 2" in text
    assert "y<sub>n</sub> = (2 − 1) / (4 − 1) = 0.3333" in text
    drag(qtbot, panel.right, (4.0, 10 / 3), (5.0, 5.0))
    assert panel.point.fields["x_w"].value() == pytest.approx(3.0)
    assert panel.point.fields["y_w"].value() == pytest.approx(3.25)
    type_into(qtbot, panel.point.fields["x_v"], "6")
    assert panel.point.fields["x_w"].value() == pytest.approx(4.0)
    assert not session.dirty
    qtbot.mouseClick(panel.point.figure, LEFT)
    recorded(qtbot, session)
    assert session.run.total_steps == 16


def test_asked_first_the_place_in_the_viewport_is_kept_back(qtbot, session, panel):
    recorded(qtbot, session)
    session.update_state(ask_first=True, step=0)
    settle()
    assert session.run.options
    words = [each for each in panel.right.plane.plane.drawn if "P′" in getattr(each, "text", "")]
    assert not words
    session.run.choose("the picture is distorted")
    settle()
    assert session.run.right == 1


def test_stages_open_at_the_left_and_with_shift_at_the_right(qtbot, panel):
    tiles = panel.strip.tiles
    qtbot.mouseClick(tiles["normalise"], LEFT)
    qtbot.mouseClick(tiles["device"], LEFT, SHIFT)
    assert (panel.left.stage.slug, panel.right.stage.slug) == ("normalise", "device")
    assert [slug for slug, tile in tiles.items() if tile.is_open] == ["normalise", "device"]
    qtbot.mouseClick(tiles["device"], LEFT)
    assert (panel.left.stage.slug, panel.right.stage.slug) == ("device", "normalise")


def test_the_device_shows_the_frame_buffer(qtbot, session, panel):
    session.open_example("view-house")
    settle()
    panel.open_stage("device", right=True)
    settle()
    shown = panel.right.plane.plane.pixels
    plain = frame_buffer(session.sheet)
    background = session.sheet.palette[session.sheet.background]
    canvas = int(DARK.canvas.removeprefix("#"), 16)
    assert shown.shape == plain.shape
    assert np.array_equal(shown != canvas, plain != background)
    assert (plain != background).sum() > 100


def test_the_pictures_show_what_the_device_paints(qtbot, session, panel):
    """Each lit pixel lies beside a curve of the viewport picture, none of which leaves the viewports."""
    session.open_example("view-house")
    settle()
    strokes = [
        each.points for each in panel.right.plane.plane.drawn if getattr(each, "ink", "").startswith("#")
    ]
    lit = np.argwhere(frame_buffer(session.sheet) != session.sheet.palette[0])[:, ::-1]
    corners = np.concatenate(strokes)
    inside = np.zeros(len(corners), bool)
    for view in session.sheet.views:
        xmin, ymin, xmax, ymax = box(view.viewport_device)
        inside |= (corners >= (xmin - 1e-9, ymin - 1e-9)).all(axis=1) & (
            corners <= (xmax + 1e-9, ymax + 1e-9)
        ).all(axis=1)
    assert inside.all()
    away = np.full(len(lit), np.inf)
    for stroke in strokes:
        for start, end in pairwise(stroke):
            along = end - start
            share = np.clip(((lit - start) @ along) / max(along @ along, 1e-12), 0, 1)
            away = np.minimum(away, np.hypot(*(lit - start - share[:, None] * along).T))
    assert away.max() <= 1.0


def test_the_wheel_and_the_hand_change_the_window(qtbot, session, panel):
    plane = panel.left.plane
    at = plane.position(2.0, 2.0)
    event = QWheelEvent(
        at, plane.mapToGlobal(at), QPoint(), QPoint(0, 120), Qt.MouseButton.NoButton, NO_KEYS,
        Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    place = plane.place(at)
    before = [(side - place[k % 2]) for k, side in enumerate(window(panel))]
    QApplication.sendEvent(plane, event)
    settle()
    after = [(side - place[k % 2]) for k, side in enumerate(window(panel))]
    assert after == pytest.approx([side / 1.25 for side in before], abs=1e-6)
    session.undo_stack.undo()
    settle()
    panel.choose_tool("pan")
    drag(qtbot, panel.right, (4.0, 4.0), (5.0, 4.0))
    xmin, ymin, _xmax, ymax = window(panel)
    assert xmin == pytest.approx(0.0, abs=0.05)
    assert (ymin, ymax) == (pytest.approx(1.0, abs=0.05), pytest.approx(4.0, abs=0.05))
    panel.fit()
    settle()
    assert window(panel)[0] < 0 < 5 < window(panel)[2]


def test_views_are_added_named_ordered_and_removed(qtbot, session, panel):
    card = panel.card
    qtbot.mouseClick(card.add, LEFT)
    settle()
    assert len(session.sheet.views) == 2
    assert panel.view is session.sheet.views[1]
    assert viewport(panel) == (6.0, 2.0, 9.0, 6.0)
    line = card.views.lineEdit()
    line.setFocus()
    line.selectAll()
    qtbot.keyClicks(line, "Detail")
    qtbot.keyClick(line, Qt.Key.Key_Return)
    settle()
    assert session.sheet.views[1].name == "Detail"
    card.earlier.trigger()
    settle()
    assert [view.name for view in session.sheet.views] == ["Detail", ""]
    assert panel.view.name == "Detail"
    card.remove.trigger()
    settle()
    assert len(session.sheet.views) == 1
    assert not card.remove.isEnabled()
    assert viewport(panel) == (3.0, 2.0, 6.0, 6.0)


def test_a_clip_window_of_its_own_is_switched_dragged_and_typed(qtbot, session, panel):
    qtbot.mouseClick(panel.card.clips, LEFT, NO_KEYS, QPoint(8, panel.card.clips.height() // 2))
    settle()
    assert panel.view.clip_world == panel.view.window_world
    type_into(qtbot, panel.card.rectangles["clip"].fields["xmax"], "2.5")
    assert panel.view.clip_world == Rectangle(1.0, 1.0, 2.5, 4.0)
    right = max(each.points[:, 0].max() for each in panel.right.plane.plane.drawn if each.ink.startswith("#"))
    assert right == pytest.approx(4.5)
    panel.open_stage("clip", right=False)
    settle()
    drag(qtbot, panel.left, (2.5, 2.0), (3.0, 2.0))
    assert panel.view.clip_world == Rectangle(1.0, 1.0, 3.0, 4.0)
    qtbot.mouseClick(panel.card.clips, LEFT, NO_KEYS, QPoint(8, panel.card.clips.height() // 2))
    settle()
    assert panel.view.clip_world is None


def test_the_device_changes_its_size(qtbot, session, panel):
    type_into(qtbot, panel.card.sizes[0], "20")
    assert (session.sheet.width_px, session.sheet.height_px) == (20, 8)
    assert viewport(panel) == (3.0, 2.0, 6.0, 6.0)
    type_into(qtbot, panel.card.sizes[1], "0")
    assert "too small" in panel.card.sizes[1].complaint.text()


def test_all_of_it_is_saved(qtbot, session, panel, tmp_path):
    drag(qtbot, panel.left, (4.0, 2.0), (5.0, 2.0))
    drag(qtbot, panel.right, (8.0, 1.0))
    session.apply(set_mode(panel.view.id, "fit"), "Fit")
    session.save_as(tmp_path / "view.gwb")
    stored = read(tmp_path / "view.gwb")
    assert stored.document == session.document
    assert stored.session.positions["view"].subject.arguments["clicked"] is True


def test_low_the_strip_is_names_only_and_the_matrices_numbers_only(qtbot, panel):
    panel.resize(620, 340)
    settle()
    assert not panel.strip.pictured
    assert panel.symbols.isHidden()
    assert not panel.numbers.isHidden()
    assert panel.left.plane.height() >= 180
    panel.resize(1000, 640)
    settle()
    assert panel.strip.pictured
    assert not panel.symbols.isHidden()


def test_an_empty_world_offers_the_house(qtbot, session, panel):
    session.new()
    settle()
    assert panel.empty.isVisible()
    qtbot.mouseClick(panel.empty.button, LEFT)
    settle()
    assert panel.empty.isHidden()
    assert len(session.sheet.views) == 2


def test_a_window_far_away_or_tiny_is_shown(qtbot, session, panel):
    for sides in ((9e5, 9e5, 9.5e5, 9.2e5), (2.0, 2.0, 2.000001, 2.000001)):
        session.apply(set_window(panel.view.id, Rectangle(*sides)), "Set")
        settle()
        assert not panel.grab().isNull()
        corner = panel.left.plane.position(*sides[2:])
        assert QPointF(0, 0) != corner
        assert panel.left.plane.rect().contains(corner.toPoint())
