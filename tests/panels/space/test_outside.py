"""The view from outside, the view cube, the derivation and the comparison, under the hand."""

import math
from collections.abc import Iterator

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.panels.space.by_hand import CONTROL, LEFT, camera_of, drag, scene_of, settle, shown
from workbench.document.scene.looking import kind_of
from workbench.document.scene.viewing import projection_matrix, view_matrix
from workbench.panels.space.projection_page import ProjectionPage
from workbench.rendering.emissions import emitted
from workbench.rendering.scene.contrast import pair_of
from workbench.rendering.subjects.registry import calls_of

NO_KEY = Qt.KeyboardModifier.NoModifier


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[ProjectionPage]:
    yield from shown(qtbot)


def grip(page: ProjectionPage, name: str) -> tuple[float, float]:
    page.outside.grab()
    middle = next(place for each, place in page.outside.grips if each == name).center()
    return middle.x(), middle.y()


def test_the_eye_goes_where_it_is_dragged_and_the_document_keeps_its_own(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    before, kept = page.looking.camera, camera_of(page)
    view = view_matrix(page.outside.scene.camera)
    scale = page.outside.scale
    drag(qtbot, page.outside, grip(page, "eye"), (-24, -12))
    settle(qtbot, page)
    by = np.subtract(page.looking.camera.eye.xyz, before.eye.xyz)
    # In the plane of the outside view, as many units as pixels
    assert view[:3, :3] @ by * scale == pytest.approx([-24, 12, 0], abs=1.5)
    assert page.looking.camera.look_at == before.look_at
    assert camera_of(page) == kept


@pytest.mark.parametrize("name", ["distance", "near", "far"])
def test_a_plane_moves_along_the_line_of_sight(qtbot: QtBot, page: ProjectionPage, name: str) -> None:
    before = page.looking.camera
    start = grip(page, name)
    sight = view_matrix(page.outside.scene.camera)[:2, :3] @ view_matrix(before)[2, :3]
    along = np.array([sight[0], -sight[1]])
    by = along / np.hypot(*along) * 20
    drag(qtbot, page.outside, start, (round(by[0]), round(by[1])))
    settle(qtbot, page)
    after = page.looking.camera
    assert getattr(after, name) > getattr(before, name)
    assert after.eye == before.eye
    others = {"distance", "near", "far"} - {name}
    assert all(getattr(after, each) == getattr(before, each) for each in others)


def test_near_never_goes_behind_far_nor_before_the_eye(qtbot: QtBot, page: ProjectionPage) -> None:
    for by in ((-900, 0), (900, 0)):
        drag(qtbot, page.outside, grip(page, "near"), by)
        settle(qtbot, page)
        camera = page.looking.camera
        assert 0 < camera.near < camera.far


def test_the_volume_is_what_the_matrix_takes_to_the_window(page: ProjectionPage) -> None:
    camera, window = page.looking.camera, page.eye.window_world
    corners = page.outside.volume()
    view = corners.reshape(-1, 3) @ view_matrix(camera)[:3, :3].T + view_matrix(camera)[:3, 3]
    assert view[:4, 2] == pytest.approx(camera.near)
    assert view[4:, 2] == pytest.approx(camera.far)
    flat = view[:, :2] * (camera.distance / view[:, 2:])  # by similar triangles
    assert flat[:, 0].min() == pytest.approx(window.xmin)
    assert flat[:, 1].max() == pytest.approx(window.ymax)


def test_clipping_is_stepped_on_the_chosen_object_and_on_what_is_seen(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    session = page.session
    session.update_state(thing="o1")
    settle(qtbot, page)
    page.stepping.setCurrentIndex(1)
    page.stepping.activated.emit(1)
    page.eye.zoom(9.0, QPointF(*page.eye.projected(np.zeros((1, 3)))[0].tolist()))
    settle(qtbot, page)
    assert session.subject.ids == ("o1",)
    (call,) = calls_of(session.sheet, session.subject)
    rows = emitted(call)
    window = page.eye.window_world
    flat = rows[:, 1:3] / rows[:, 4:5]
    assert flat[:, 0].min() == pytest.approx(window.xmin)  # it was zoomed so far that the sides cut
    assert flat[:, 0].max() == pytest.approx(window.xmax)
    qtbot.waitUntil(lambda: session.run.done, timeout=10_000)
    session.run.last()
    settle(qtbot, page)
    assert page.outside.clipped is not None
    assert sum(map(len, page.outside.clipped.done)) == len(rows)
    assert page.eye.vertex is None


def test_the_vertex_has_as_many_coordinates_as_were_stepped(qtbot: QtBot, page: ProjectionPage) -> None:
    page.session.visit("space", page.usual)
    for stage in range(6):
        page.session.update_state(step=stage)
        settle(qtbot, page)
        qtbot.waitUntil(lambda: page.session.run.tellable == 5, timeout=10_000)
        settle(qtbot, page)
        vertex = page.outside.vertex
        assert vertex is not None
        assert vertex.stage == stage
    camera = page.looking.camera
    x, y, _z, w = projection_matrix(camera) @ view_matrix(camera) @ [*vertex.place, 1.0]
    assert vertex.rows[3][:2] == pytest.approx((x / w, y / w))


def test_a_side_of_the_cube_is_looked_at_and_its_corner_is_isometric(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    kept = camera_of(page)
    for name in ("right", "front"):
        middle = page.cube.sides()[name].mean(axis=0)
        qtbot.mouseClick(page.cube, LEFT, NO_KEY, QPoint(*map(round, middle.tolist())))
        settle(qtbot, page)
        forward = view_matrix(page.looking.camera)[2, :3]
        assert forward == pytest.approx({"right": (-1, 0, 0), "front": (0, 0, -1)}[name], abs=1e-9)
        drag(qtbot, page.eye, (20, 300), (40, 30))
        settle(qtbot, page)
    assert len(page.cube.sides()) == 3
    page.cube.chosen.emit("isometric")
    settle(qtbot, page)
    assert kind_of(page.looking.camera) == "isometric"
    assert page.cube.at(QPointF(page.cube.rect().center())) == "isometric"
    assert camera_of(page) == kept


def test_every_side_has_a_command(qtbot: QtBot, page: ProjectionPage) -> None:
    commands = {action.objectName(): action for action in page.commands()}
    for side, forward in (
        ("back", (0, 0, 1)),
        ("left", (1, 0, 0)),
        ("top", (0, -1, 0)),
        ("bottom", (0, 1, 0)),
    ):
        commands[f"space.{side}"].trigger()
        settle(qtbot, page)
        assert view_matrix(page.looking.camera)[2, :3] == pytest.approx(forward, abs=1e-9)


def test_a_turn_is_about_the_point_under_the_pointer(qtbot: QtBot, page: ProjectionPage) -> None:
    page.session.update_state(thing="")
    place = page.eye.projected(np.array([[-2.6, 0.6, 1.4]]))[0]  # on the shed
    from workbench.panels.space.pointing import at

    there = at(page.eye, QPointF(*place.tolist()))
    assert there is not None
    before = page.eye.projected(np.array([there.place]))[0]
    drag(qtbot, page.eye, tuple(place.tolist()), (50, 20))
    settle(qtbot, page)
    assert page.eye.projected(np.array([there.place]))[0] == pytest.approx(before, abs=0.5)


def test_a_trackball_has_no_pole(qtbot: QtBot, page: ProjectionPage) -> None:
    away = math.dist(page.looking.camera.eye.xyz, page.looking.camera.look_at.xyz)
    page.tools.actions_by_name["trackball"].trigger()
    for _turn in range(4):
        assert page.looking.orbit(0.0, 1.0) == ""
    camera = page.looking.camera
    assert view_matrix(camera)[1, 1] < 0  # over the top, head down
    assert math.dist(camera.eye.xyz, camera.look_at.xyz) == pytest.approx(away)


def test_the_centre_goes_to_infinity_by_the_slider(qtbot: QtBot, page: ProjectionPage) -> None:
    page.derived.show()
    radius = page.looking.radius
    look_at = np.array([*page.looking.camera.look_at.xyz, 1.0])
    for ticks in (50, 10, 1):
        page.derived.slider.setValue(ticks)
        settle(qtbot, page)
        camera = page.looking.camera
        assert 1 / camera.distance == pytest.approx(ticks / 100 / radius)
        # What lies in the view plane keeps its size, whatever d is: w is 1 there
        w = (projection_matrix(camera) @ view_matrix(camera) @ look_at)[3]
        assert w == pytest.approx(1)
    page.derived.slider.setValue(0)
    settle(qtbot, page)
    assert page.looking.camera.projection == "orthographic"
    assert "1/d" not in page.derived.inverse.text()
    assert page.derived.inverse.text() == "0"


def test_a_matrix_of_ones_own_is_parallel_only_where_its_projectors_are(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    dock = page.derived
    qtbot.addWidget(dock)
    dock.show()
    page.choose("matrix")
    settle(qtbot, page)
    camera = page.looking.camera
    assert camera.projection == "matrix"
    assert "your own, and its projectors meet at a point" in dock.words.text()
    assert "parallel now" not in dock.words.text()
    assert dock.inverse.text() == "\N{EN DASH}"
    point = dock.triangles.point
    w = projection_matrix(camera)[3] @ [point.x, point.y, point.z, 1]
    assert f"The last row of your matrix gives <i>w = {w:.4f}"[:-1] in dock.limit.text()
    page.look(replace(camera, entries=(*camera.entries[:12], 0.0, 0.0, 0.0, 2.0)))
    settle(qtbot, page)
    assert "The projectors are parallel now" in dock.words.text()
    assert dock.inverse.text() == "0"
    assert "gives <i>w = 2</i> now" in dock.limit.text()


def test_a_central_matrix_of_ones_own_is_not_compared_as_a_parallel_projection(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    page.choose("matrix")
    settle(qtbot, page)
    assert [each.projection for each in pair_of(page.looking.camera)] == ["orthographic", "perspective"]


def test_the_point_of_the_triangles_follows_the_mouse(qtbot: QtBot, page: ProjectionPage) -> None:
    dock = page.derived
    qtbot.addWidget(dock)
    dock.resize(420, 400)
    dock.show()
    own = dock.triangles.point
    place = QPointF(300, 40)
    where = dock.triangles.mapToGlobal(place)
    no, none = Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier
    QApplication.sendEvent(dock.triangles, QMouseEvent(QEvent.Type.MouseMove, place, where, no, no, none))
    assert dock.triangles.point != own
    moved, d = dock.triangles.point, page.looking.camera.distance
    aside = getattr(moved, own.aside)
    assert f"{aside * d / moved.z:.4g}"[:4].replace("-", "−") in dock.words.text()
    dock.triangles.leaveEvent(None)
    assert dock.triangles.point == own


def test_a_row_of_the_comparison_is_shown_and_its_cells_switch(qtbot: QtBot, page: ProjectionPage) -> None:
    dock = page.contrast
    qtbot.addWidget(dock)
    dock.resize(420, 400)
    dock.show()
    settle(qtbot, page)
    assert dock.contrast is not None
    row = next(k for k, each in enumerate(dock.contrast.rows) if len(each.segments))
    dock.table.setCurrentCell(row, 1)
    settle(qtbot, page)
    assert page.looking.camera.projection == "orthographic"
    assert np.array_equal(page.eye.marked, dock.contrast.rows[row].segments)
    dock.table.setCurrentCell(row, 2)
    settle(qtbot, page)
    assert page.looking.camera == camera_of(page)  # it was the perspective
    assert [title for title, _table in page.tables()][-1] == "Parallel and perspective"


@pytest.mark.parametrize("slug", ["isometric", "cabinet", "two-point", "front", "matrix"])
def test_every_projection_is_a_page(qtbot: QtBot, page: ProjectionPage, slug: str) -> None:
    from workbench.exchange.diagram_svg import write_diagram

    page.choose(slug)
    settle(qtbot, page)
    made = page.derivation()
    assert made is not None
    text = write_diagram(made)
    assert ("Similar" in text) == (slug == "two-point")
    assert "measured" in text


def test_the_keyboard_has_a_cursor_that_tells_and_chooses(qtbot: QtBot, page: ProjectionPage) -> None:
    said: list[str] = []
    page.hover_text.connect(said.append)
    page.eye.setFocus()
    qtbot.keyClick(page.eye, Qt.Key.Key_Return)  # without a cursor there is nothing to choose
    assert page.session.state.thing == ""
    vertex = page.eye.projected(np.array([[1.5, 0.0, 2.5]]))[0]
    middle = page.eye.rect().center()
    for key, distance in (
        (Qt.Key.Key_Right, vertex[0] - middle.x()),
        (Qt.Key.Key_Up, middle.y() - vertex[1]),
    ):
        opposite = {Qt.Key.Key_Right: Qt.Key.Key_Left, Qt.Key.Key_Up: Qt.Key.Key_Down}[key]
        for _press in range(round(abs(distance) / 6)):
            qtbot.keyClick(page.eye, key if distance > 0 else opposite, CONTROL)
    assert "House, vertex" in said[-1]
    qtbot.keyClick(page.eye, Qt.Key.Key_Return)
    settle(qtbot, page)
    assert page.session.state.thing == "o1"
    assert page.eye.vertex is not None
    assert page.eye.vertex.place == pytest.approx((1.5, 0.0, 2.5))
    page.eye.grab()


def test_a_light_is_dragged_from_outside_and_comes_back_in_one_step(
    qtbot: QtBot, page: ProjectionPage
) -> None:
    page.session.open_example("shading-lamps")
    page.session.visit("space", page.usual)
    settle(qtbot, page)
    before, eye = scene_of(page).lights, camera_of(page)
    x, y = grip(page, f"light {before[0].id}")
    drag(qtbot, page.outside, (x, y), (40, -25))
    settle(qtbot, page)
    moved = scene_of(page).lights
    assert moved[1:] == before[1:]
    assert camera_of(page) == eye
    by = np.subtract(moved[0].position.xyz, before[0].position.xyz)
    view = view_matrix(page.outside.scene.camera)
    assert view[:3, :3] @ by * page.outside.scale == pytest.approx([40, 25, 0], abs=2.0)
    page.session.undo_stack.undo()
    assert scene_of(page).lights == before
