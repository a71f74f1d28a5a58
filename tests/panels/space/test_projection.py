"""The page Projection as a person uses it: dragged, clicked, typed into, undone."""

import math
from collections.abc import Iterator

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication, QStyle, QStyleOptionComboBox
from pytestqt.qtbot import QtBot

from tests.panels.space.by_hand import (
    CONTROL,
    LEFT,
    MIDDLE,
    NONE,
    SHIFT,
    camera_of,
    drag,
    scene_of,
    settle,
    shown,
)
from workbench.algorithms.projection import vanishing_points
from workbench.document.scene.looking import kind_of, kinds
from workbench.document.scene.model import Camera
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.panels.space.eye_view import horizon
from workbench.panels.space.projection_page import ProjectionPage
from workbench.panels.space.scene_picture import fine
from workbench.widgets.stepping.sentence_view import SentenceView


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[ProjectionPage]:
    yield from shown(qtbot)


# Looking around


def test_a_drag_looks_around_and_keep_writes_it_down(qtbot: QtBot, page: ProjectionPage) -> None:
    before = camera_of(page)
    drag(qtbot, page.eye, (20, 300), (60, -30))
    seen = page.looking.camera
    assert seen != before
    assert camera_of(page) == before  # the document stays as it was
    assert not page.session.dirty
    assert math.dist(seen.eye.xyz, seen.look_at.xyz) == pytest.approx(
        math.dist(before.eye.xyz, before.look_at.xyz)
    )
    assert page.card.keep.isVisible()
    qtbot.mouseClick(page.card.keep, LEFT)
    settle(qtbot, page)
    assert camera_of(page) == seen
    assert not page.card.keep.isVisible()
    page.session.undo_stack.undo()
    settle(qtbot, page)
    assert page.looking.camera == before


def test_home_goes_back_to_the_view_of_the_document(qtbot: QtBot, page: ProjectionPage) -> None:
    drag(qtbot, page.eye, (20, 300), (60, -30), MIDDLE)
    assert page.looking.around
    page.go_home()
    settle(qtbot, page)
    assert page.looking.camera == camera_of(page)


def test_during_a_drag_the_picture_comes_first_and_at_its_end_all_is_shown(
    qtbot: QtBot, page: ProjectionPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown_by: list[Camera] = []
    monkeypatch.setattr(page.strip, "show_camera", lambda camera, _anew: shown_by.append(camera))
    page._rest.setInterval(60_000)
    middle = QPointF(page.eye.rect().center())
    qtbot.mousePress(page.eye, LEFT, pos=middle.toPoint())
    for k in range(1, 5):
        where = middle + QPointF(20.0 * k, 0)
        place = page.eye.mapToGlobal(where)
        QApplication.sendEvent(
            page.eye, QMouseEvent(QEvent.Type.MouseMove, where, place, NONE, LEFT, Qt.KeyboardModifier(0))
        )
        QApplication.processEvents()
    assert page.eye.scene.camera == page.looking.camera
    assert shown_by == []
    page._rest.timeout.emit()
    assert shown_by == [page.looking.camera]
    qtbot.mouseRelease(page.eye, LEFT, pos=where.toPoint())
    qtbot.waitUntil(lambda: len(shown_by) > 1)
    assert shown_by[-1] == page.looking.camera
    assert not page._rest.isActive()


def test_shift_pans_the_wheel_zooms_at_the_pointer_and_neither_turns(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    eye = page.eye
    place = QPointF(120, 200)
    held = eye.on_plane(place)
    where = eye.mapToGlobal(place)
    wheel = QWheelEvent(
        place, where, QPoint(), QPoint(0, 240), NONE, Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    scale = eye.scale
    QApplication.sendEvent(eye, wheel)
    assert eye.scale == pytest.approx(scale * 1.44)
    assert eye.on_plane(place) == pytest.approx(held)
    drag(qtbot, eye, (120, 200), (40, 12), LEFT, SHIFT)
    assert eye.on_plane(place + QPointF(40, 12)) == pytest.approx(held)
    assert not page.looking.around
    eye.fit()
    assert eye.scale == pytest.approx(scale)


def test_keys_look_from_the_sides_in_the_view_that_has_the_focus(qtbot: QtBot, page: ProjectionPage) -> None:
    page.looking.choose("orthographic", "")
    settle(qtbot, page)
    expected = {"1": "front", "3": "right", "7": "top"}
    opposite = {"1": "back", "3": "left", "7": "bottom"}
    page.eye.setFocus()
    for key in "137":
        qtbot.keyClick(page.eye, key)
        assert kind_of(page.looking.camera) == expected[key]
        qtbot.keyClick(page.eye, key, CONTROL)
        assert kind_of(page.looking.camera) == opposite[key]
    qtbot.keyClick(page.eye, "5")
    assert page.looking.camera.projection == "perspective"
    qtbot.keyClick(page.eye, "5")
    before = page.looking.camera
    assert before.projection == "orthographic"
    page.outside.setFocus()
    qtbot.keyClick(page.outside, Qt.Key.Key_Right, SHIFT)
    assert page.looking.camera == before  # the outside view has an eye of its own
    page.eye.setFocus()
    qtbot.keyClick(page.eye, Qt.Key.Key_Right, SHIFT)
    assert page.looking.camera != before


# Projections


def test_every_projection_is_chosen_shown_and_undone(qtbot: QtBot, page: ProjectionPage) -> None:
    before = camera_of(page)
    for slug in (kind.slug for kind in kinds()):
        page.card.kind.activated.emit(page.card.kind.findData(slug))
        page.session.flush()
        QApplication.processEvents()
        if slug == "orthographic":  # the same from where one stands
            continue
        assert kind_of(camera_of(page)) == slug
        assert page.card.kind.currentData() == slug
        assert page.family.tree.currentItem().data(0, Qt.ItemDataRole.UserRole) == slug
        words = page.family.words.text()
        assert ("Perspective" in words) == (slug in ("one-point", "two-point", "three-point", "matrix"))
    while page.session.undo_stack.canUndo():
        page.session.undo_stack.undo()
    settle(qtbot, page)
    assert camera_of(page) == before
    assert page.card.kind.currentData() == "two-point"


def test_numbers_are_typed_and_bad_ones_are_refused_in_the_field(qtbot: QtBot, page: ProjectionPage) -> None:
    page.card.set_open(True)

    def type_in(name: str, text: str) -> None:
        field = page.card.fields[name].field
        field.selectAll()
        qtbot.keyClicks(field, text)
        qtbot.keyClick(field, Qt.Key.Key_Return)
        settle(qtbot, page)

    type_in("distance", "3/2")
    assert camera_of(page).distance == 1.5
    before = camera_of(page)
    type_in("far", "0.05")
    assert camera_of(page) == before
    assert "near" in page.card.fields["far"].complaint.text()
    for axis, value in zip("xz", ("0", "0"), strict=True):
        type_in(f"eye.{axis}", value)
    assert camera_of(page).eye.z != 0.0  # there the eye would be at what it looks at
    assert "eye" in page.card.fields["eye.z"].complaint.text()


# The matrices


def test_a_number_of_m_makes_the_projection_a_matrix(qtbot: QtBot, page: ProjectionPage) -> None:
    before = camera_of(page)
    whole = projection_matrix(before) @ view_matrix(before)
    page.strip.row.edited.emit(0, 3, 1, 0.125)
    page.strip.row.edit_ended.emit()
    settle(qtbot, page)
    after = camera_of(page)
    assert after.projection == "matrix"
    whole = whole.copy()
    whole[3, 1] = 0.125
    assert np.allclose(projection_matrix(after) @ view_matrix(after), whole)
    assert page.card.kind.currentData() == "matrix"
    assert "three principal vanishing points" in page.family.words.text()
    page.session.undo_stack.undo()
    settle(qtbot, page)
    assert camera_of(page) == before


@pytest.mark.parametrize("from_a_corner", [False, True])
def test_a_singular_matrix_is_refused_in_words(
    qtbot: QtBot, page: ProjectionPage, from_a_corner: bool
) -> None:
    """Seen from a corner the row has two numbers, and zeros that are products which cancel."""
    said: list[str] = []
    page.hover_text.connect(said.append)
    if from_a_corner:
        page.strip.row.edited.emit(0, 0, 2, 0.0)
        page.strip.row.edit_ended.emit()
    else:
        page.looking.choose("front", "")
    settle(qtbot, page)
    before = camera_of(page)
    page.strip.row.edited.emit(0, 0, 0, 0.0)  # x of the picture is 0 everywhere
    page.strip.row.edit_ended.emit()
    assert camera_of(page) == before
    assert any("singular" in sentence for sentence in said)


# Vanishing points


@pytest.mark.parametrize("pinned", [False, True])
def test_a_vanishing_point_goes_where_it_is_dragged(qtbot: QtBot, page: ProjectionPage, pinned: bool) -> None:
    eye = page.eye
    points = dict(eye.vanishing())
    (at,) = eye.on_screen(np.array([points[0]]))
    assert eye.grip_at(QPointF(*at)) == 0
    held = SHIFT if pinned else Qt.KeyboardModifier.NoModifier
    drag(qtbot, eye, (at[0], at[1]), (24, 0), LEFT, held)
    settle(qtbot, page)
    camera = page.looking.camera
    after = vanishing_points(projection_matrix(camera) @ view_matrix(camera))
    wanted = eye.on_plane(QPointF(round(at[0]) + 24, round(at[1])))
    assert after[0] == pytest.approx(wanted, abs=1e-9)
    if pinned:
        assert after[2] == pytest.approx(points[2])
        assert camera.distance != camera_of(page).distance
    else:
        assert camera.distance == camera_of(page).distance


@pytest.mark.parametrize("seed", range(20))
def test_the_horizon_goes_through_the_vanishing_points_of_x_and_z(seed: int) -> None:
    matrix = np.random.default_rng(seed).uniform(-3, 3, (4, 4))
    line = horizon(matrix)
    assert line is not None
    assert math.hypot(*line[:2]) == pytest.approx(1)
    x, _y, z = vanishing_points(matrix)
    for place in (x, z):
        assert place is not None
        assert np.dot(line, (*place, 1)) == pytest.approx(0, abs=1e-9 * math.hypot(1, *place))


def test_where_x_and_z_look_alike_or_stay_parallel_there_is_no_horizon() -> None:
    depth_only = [
        [0, 0, 1, 0],
        [0, 1, 0, 0],
        [1, 0, 0, 0],
        [0, 0, 1, 1],
    ]  # x is seen end-on: regular all the same
    alike = [[1, 0, 2, 0], [0, 1, 0, 0], [0, 0, 1, 0], [1, 0, 2, 1]]
    with np.errstate(all="raise"):
        for matrix in (depth_only, alike, np.eye(4)):
            assert np.linalg.det(matrix) != 0
            assert horizon(np.array(matrix, np.float64)) is None


def test_a_parallel_projection_has_no_vanishing_point_to_take_hold_of(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    page.looking.choose("isometric", "")
    settle(qtbot, page)
    assert page.eye.vanishing() == []


# The view from outside


@pytest.mark.parametrize("slug", ["two-point", "isometric", "cabinet"])
def test_projectors_run_from_the_object_through_its_picture_on_the_plane(
    qtbot: QtBot, page: ProjectionPage, slug: str
) -> None:
    """In space: eye, image and point on one line; or projectors that are all parallel."""
    page.looking.choose(slug, "")
    settle(qtbot, page)
    camera = page.looking.camera
    points = scene_of(page).objects[0].mesh.vertices
    images = page.outside._images(points)
    depths = (np.column_stack([images, np.ones(len(images))]) @ view_matrix(camera).T)[:, 2]
    assert np.allclose(depths, camera.distance)  # all on the view plane
    if camera.projection == "perspective":
        eye = np.array(camera.eye.xyz)
        across = np.cross(images - eye, points - eye)
    else:
        ways = images - points
        across = np.cross(ways, ways[np.abs(ways).sum(axis=1).argmax()])
    assert np.allclose(across, 0.0, atol=1e-9)


def test_views_stand_side_by_side_and_either_alone(qtbot: QtBot, page: ProjectionPage) -> None:
    eye, outside = page.eye, page.outside
    assert eye.isVisible()
    assert outside.isVisible()
    assert page.views.orientation() == Qt.Orientation.Horizontal
    page.show_beside("eye")
    assert eye.isVisible()
    assert not outside.isVisible()
    page.show_beside("outside")
    assert outside.isVisible()
    assert not eye.isVisible()
    page.show_beside("both")
    panel = page.window()
    panel.resize(700, 1100)
    QApplication.processEvents()
    assert page.views.orientation() == Qt.Orientation.Vertical
    panel.resize(480, 420)
    QApplication.processEvents()
    assert eye.isVisible()
    assert not outside.isVisible()


# The run


def test_the_run_takes_a_vertex_through_what_is_seen(qtbot: QtBot, page: ProjectionPage) -> None:
    session = page.session
    drag(qtbot, page.eye, (20, 300), (60, -30))
    settle(qtbot, page)
    run = session.run
    qtbot.waitUntil(lambda: run.entry is not None and run.tellable == 5, timeout=10_000)
    assert run.entry is not None
    assert run.entry.slug == "project_point"
    camera = page.looking.camera
    assert session.subject.arguments["view"] == pytest.approx(view_matrix(camera).ravel())
    page.go_home()
    settle(qtbot, page)
    assert "view" not in session.subject.arguments


def test_an_empty_scene_has_no_vanishing_points(qtbot: QtBot, page: ProjectionPage) -> None:
    assert page.eye.vanishing()
    page.eye.show_scene(replace(page.eye.scene, objects=()))
    assert page.eye.vanishing() == []


def test_the_card_has_room_for_every_projection(page: ProjectionPage) -> None:
    box = page.card.kind
    option = QStyleOptionComboBox()
    box.initStyleOption(option)
    part = QStyle.SubControl.SC_ComboBoxEditField
    room = box.style().subControlRect(QStyle.ComplexControl.CC_ComboBox, option, part, box).width()
    assert max(box.fontMetrics().horizontalAdvance(kind.title) for kind in kinds()) <= room


def test_a_fine_mesh_is_drawn_in_fine_lines() -> None:
    assert fine(2.0, 100.0) == 2.0
    assert fine(2.0, 8.0) == 1.0
    assert fine(2.0, 0.0) > 0.0


@pytest.mark.parametrize("which", ["eye", "outside"])
def test_the_keys_of_the_step_bar_step_in_either_picture(
    qtbot: QtBot, page: ProjectionPage, which: str
) -> None:
    run, view = page.session.run, getattr(page, which)
    told = SentenceView(run)
    qtbot.addWidget(told)
    run.first()
    told.refresh()
    assert run.entry is not None
    assert told.plain == f"{run.entry.summary} Press the right arrow key for the first step."
    seen = []
    for key in (Qt.Key.Key_Right, Qt.Key.Key_Right, Qt.Key.Key_Left, Qt.Key.Key_End, Qt.Key.Key_Home):
        qtbot.keyClick(view, key)
        seen.append(run.position)
    assert seen == [1, 2, 1, run.last_position, 0]
    qtbot.keyClick(view, Qt.Key.Key_Right, SHIFT)
    assert run.position == 0  # it turns instead


def test_a_projection_that_is_seen_already_stays_as_it_is(page: ProjectionPage) -> None:
    camera, count = camera_of(page), page.session.undo_stack.count()
    page.card.chosen.emit(kind_of(camera))
    page.session.flush()
    assert (camera_of(page), page.session.undo_stack.count()) == (camera, count)
