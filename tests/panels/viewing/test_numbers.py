"""View in numbers: fields, modes, views, matrices, the point and its arithmetic, what is taken out."""

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QPoint, Qt

from tests.panels.by_hand import recorded, settle
from tests.panels.viewing.hand import LEFT, NO_KEYS, drag, type_into, viewport, window
from workbench.algorithms.marks import Word
from workbench.document.model import MODES, Rectangle
from workbench.document.storage.files import read
from workbench.document.view_edits import set_mode, set_window
from workbench.exchange.writing import write
from workbench.panels.stage.pages import formats_of
from workbench.rendering import frame_buffer
from workbench.rendering.mapping import view_map


def test_the_numbers_of_the_course_come_out(qtbot, session, panel):
    recorded(qtbot, session)
    assert session.run.total_steps == 16
    session.run.go_to_number(12)
    settle()
    said = "".join(part.text for part in session.run.sentence)
    assert said == "x_v = 3 + 1 = 4, y_v = 2 + 1.3333 = 3.3333."
    assert panel.point.fields["x_v"].value() == 4.0
    assert panel.point.fields["y_v"].value() == pytest.approx(10 / 3, abs=1e-6)
    assert "s<sub>y</sub> = 4/3 = 1.3333" in panel.card.factors.text()
    assert "Taller by a third: s<sub>y</sub> = 1.3333 s<sub>x</sub>" in panel.card.warning.text()
    for point, there in (((1, 1), (3, 2)), ((1, 2), (3, 10 / 3)), ((2, 2), (4, 10 / 3)), ((3, 4), (5, 6))):
        assert view_map(panel.view).point(*point) == pytest.approx(there)


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
    panel.matrices.numbers.edited.emit(4, 0, 0, 2.0)
    panel.matrices.numbers.edit_ended.emit()
    settle()
    assert viewport(panel) == (3.0, 2.0, 9.0, 6.0)
    panel.matrices.numbers.edited.emit(5, 1, 2, -2.0)
    panel.matrices.numbers.edit_ended.emit()
    settle()
    assert window(panel) == (1.0, 2.0, 4.0, 5.0)
    panel.matrices.numbers.edited.emit(3, 0, 2, 0.0)
    panel.matrices.numbers.edit_ended.emit()
    settle()
    assert viewport(panel) == (0.0, 2.0, 6.0, 6.0)
    panel.matrices.numbers.edited.emit(4, 1, 1, 0.0)
    panel.matrices.numbers.edit_ended.emit()
    settle()
    assert "nothing of the picture is left" in panel.card.complaint.text()
    assert viewport(panel) == (0.0, 2.0, 6.0, 6.0)
    assert panel.matrices.numbers.terms[4].cells[1][1].value == pytest.approx(4 / 3)


def test_a_number_of_a_matrix_is_dragged_where_it_stands(qtbot, session, panel):
    spot = panel.matrices.numbers.cell_box((5, 0, 2)).center().toPoint()
    qtbot.mousePress(panel.matrices.numbers, LEFT, NO_KEYS, spot)
    for right in (5, 10, 20, 40):
        qtbot.mouseMove(panel.matrices.numbers, spot + QPoint(right, 0))
        settle()
    assert panel.card.rectangles["window"].fields["xmin"].property("lit")
    qtbot.mouseRelease(panel.matrices.numbers, LEFT, NO_KEYS, spot + QPoint(40, 0))
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
    type_into(qtbot, panel.card.painting.sizes[0], "20")
    assert (session.sheet.width_px, session.sheet.height_px) == (20, 8)
    assert viewport(panel) == (3.0, 2.0, 6.0, 6.0)
    type_into(qtbot, panel.card.painting.sizes[1], "0")
    assert "too small" in panel.card.painting.sizes[1].complaint.text()


def test_all_of_it_is_saved(qtbot, session, panel, tmp_path):
    drag(qtbot, panel.left, (4.0, 2.0), (5.0, 2.0))
    drag(qtbot, panel.right, (8.0, 1.0))
    session.apply(set_mode(panel.view.id, "fit"), "Fit")
    session.save_as(tmp_path / "view.gwb")
    stored = read(tmp_path / "view.gwb")
    assert stored.document == session.document
    assert stored.session.positions["view"].subject.arguments["clicked"] is True


def test_a_view_is_taken_out_as_a_derivation(qtbot, session, panel, tmp_path):
    drag(qtbot, panel.left, (2.0, 2.0))
    page = panel.derivation()
    for file_format in formats_of("derivation"):
        (path,) = write(file_format, page, tmp_path / f"view{file_format.suffix}")
        assert path.stat().st_size > 1000
    words = (tmp_path / "view.svg").read_text(encoding="utf-8")
    assert "3.3333" in words
    assert {each.suffix for each in formats_of("derivation")} == {".svg", ".pdf"}


def test_the_same_picture_stands_on_devices_of_other_sizes(session, panel):
    """In normalised device coordinates nothing moves, whatever the size; it is one step of undo."""

    def normalised():
        sheet = session.sheet
        return [
            ((x + 0.5) / sheet.width_px, (y + 0.5) / sheet.height_px)
            for view in sheet.views
            for rectangle in (view.viewport_device,)
            for x, y in ((rectangle.xmin, rectangle.ymin), (rectangle.xmax, rectangle.ymax))
        ]

    before, places = session.document, normalised()
    size = session.sheet.width_px, session.sheet.height_px
    half, twice, fourfold = panel.card.painting.same.menu().actions()
    for action, factor in ((twice, 2), (fourfold, 8), (half, 4)):
        action.trigger()
        settle()
        assert (session.sheet.width_px, session.sheet.height_px) == (factor * size[0], factor * size[1])
        np.testing.assert_allclose(normalised(), places, atol=1e-12)
    for _step in range(3):
        session.undo_stack.undo()
    assert session.document == before
    for _step in range(20):
        fourfold.trigger()  # a device too large is refused in place, with its size
    assert not panel.card.complaint.isHidden()
    np.testing.assert_allclose(normalised(), places, atol=1e-12)


def test_steps_are_taken_out_as_both_pictures_with_their_labels(qtbot, session, panel, tmp_path):
    recorded(qtbot, session)
    session.run.go_to_number(12)
    settle()
    for file_format in formats_of("step"):
        (path,) = write(file_format, panel.exporter.this_step(), tmp_path / f"step{file_format.suffix}")
        assert path.stat().st_size > 1000
    words = (tmp_path / "step.svg").read_text(encoding="utf-8")
    for label in ("Window in the world", "Viewport on the device", "(1, 1)", "(6, 6)", "P (2, 2)"):
        assert label in words
    assert "1.3333 = 3.3333." in words
    run = panel.exporter.this_run()
    assert run.parts == 17
    pages = [run.image(number) for number in (0, 12)]
    assert (pages[0] != pages[1]).any()


def test_a_view_that_is_not_there_any_more_is_the_first_one(qtbot, session, panel):
    panel.card.add_view()
    settle()
    added = panel.view.id
    session.undo_stack.undo()
    settle()
    assert session.state.subject.arguments["view"] == added
    assert panel.view is session.sheet.first_view


@pytest.mark.parametrize("slug", ["window", "viewport"])
def test_a_number_that_is_refused_is_said_without_the_path_of_a_file(qtbot, session, panel, slug):
    before = session.document
    fields = panel.card.rectangles[slug].fields
    type_into(qtbot, fields["xmax"], "1e300")
    assert panel.card.complaint.text() == (
        "The x_max is 1e+300; give a number between -1,000,000 and 1,000,000."
    )
    assert [side for side, field in fields.items() if field.field.property("wrong")] == ["xmax"]
    assert session.document == before


@pytest.mark.parametrize("repair", ["drag", "undo"])
def test_a_refusal_goes_as_soon_as_the_rectangle_is_put_right_elsewhere(qtbot, session, panel, repair):
    fields = panel.card.rectangles["window"].fields
    type_into(qtbot, fields["ymax"], "5")
    settle()
    type_into(qtbot, fields["xmax"], fields["xmin"].field.text())
    assert "no width" in panel.card.complaint.text()
    panel.center.setFocus()
    if repair == "undo":
        session.undo_stack.undo()
    else:
        window = replace(panel.view.window_world, ymin=-1.0)
        session.apply(set_window(panel.view.id, window), "Drag")
    settle()
    assert panel.card.complaint.text() == ""
    assert not any(field.field.property("wrong") for field in fields.values())
    assert fields["xmax"].field.text() == f"{panel.view.window_world.xmax:g}"


def test_during_a_drag_the_numbers_stand_beside_the_pointer_alone(qtbot, session, panel):
    def corners():
        return [each for each in panel.left.plane._plane.drawn if isinstance(each, Word) and each.carded]

    assert len(corners()) == 2
    plane = panel.left.plane
    right, top = window(panel)[2:]
    start = plane.position(right, top).toPoint()
    qtbot.mousePress(plane, LEFT, NO_KEYS, start)
    qtbot.mouseMove(plane, start + QPoint(12, -9))
    settle()
    assert "to" in plane._tag
    assert not corners()
    qtbot.mouseRelease(plane, LEFT, NO_KEYS, start + QPoint(12, -9))
    settle()
    assert len(corners()) == 2
