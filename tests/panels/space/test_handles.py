"""The handles of an object: moved, turned and scaled by the hand, each drag one step of undo."""

import math
from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPointF
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.panels.space.by_hand import SHIFT, drag, scene_of, settle, shown
from workbench.document.edits import add_figure
from workbench.document.model import Polygon
from workbench.document.samples.figures import points_at
from workbench.document.scene.links import Rotate3D, Scale3D, Translate3D
from workbench.document.scene.solids import Surface
from workbench.exchange.objects import MIME
from workbench.geometry.meshes import Array
from workbench.panels.space.object_handles import Handle, Handles, Mode
from workbench.panels.space.projection_page import ProjectionPage
from workbench.panels.space.solids_offered import offers
from workbench.rendering.scene.render import placed

SHED = "o3"


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[ProjectionPage]:
    yield from shown(qtbot)


def begin(page: ProjectionPage, qtbot: QtBot, mode: Mode) -> Handles:
    page.session.update_state(thing=SHED)
    page.eye.zoom(2.5, QPointF(*page.eye.projected(np.array([[-2.6, 0.7, 1.4]]))[0].tolist()))
    settle(qtbot, page)
    while page.eye.mode != mode:
        page.tools.actions_by_name["handles"].trigger()
    handles = page.eye.handles
    assert handles is not None
    return handles


def corners(page: ProjectionPage) -> Array:
    return placed(scene_of(page))[2][0].vertices


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_an_arrow_moves_along_its_axis_as_far_as_the_hand(
    qtbot: QtBot, page: ProjectionPage, axis: int
) -> None:
    handles, before = begin(page, qtbot, "move"), corners(page)
    tip = page.eye.projected(handles.line(axis))[-1]
    middle = page.eye.projected(handles.centre[None])[0]
    by = (tip - middle) * 0.5
    drag(qtbot, page.eye, tuple(tip.tolist()), (round(by[0]), round(by[1])))
    settle(qtbot, page)
    moved = corners(page) - before
    assert np.ptp(moved, axis=0) == pytest.approx(0, abs=1e-9)
    others = [k for k in range(3) if k != axis]
    assert moved[0, others] == pytest.approx(0, abs=1e-9)
    assert moved[0, axis] == pytest.approx(handles.reach / 2, rel=0.1)
    links = scene_of(page).objects[2].transforms
    assert [type(link) for link in links].count(Translate3D) == 1  # what was there already moves it
    page.session.undo_stack.undo()
    settle(qtbot, page)
    assert corners(page) == pytest.approx(before)


def test_a_ring_turns_about_the_middle_and_twice_is_one_link(qtbot: QtBot, page: ProjectionPage) -> None:
    handles, before = begin(page, qtbot, "turn"), corners(page)
    count = len(scene_of(page).objects[2].transforms)
    for _again in range(2):
        ring = page.eye.projected(handles.line(1))
        middle = page.eye.projected(handles.centre[None])[0]
        place = ring[int(np.argmax(ring[:, 0]))]
        drag(qtbot, page.eye, tuple(place.tolist()), (-4, -14))
        settle(qtbot, page)
        assert math.dist(middle, page.eye.projected(handles.centre[None])[0]) < 1e-6
    links = scene_of(page).objects[2].transforms
    assert len(links) == count + 1
    assert isinstance(links[-1], Rotate3D)
    after = corners(page)
    away = [np.hypot(*(each - handles.centre)[:, [0, 2]].T) for each in (before, after)]
    assert away[0] == pytest.approx(away[1])
    assert after[:, 1] == pytest.approx(before[:, 1])
    # Seen from above the axis points to the viewer: up at the right is counter-clockwise
    assert links[-1].angle > 0


@pytest.mark.parametrize("every", [False, True])
def test_a_square_scales_from_the_middle(qtbot: QtBot, page: ProjectionPage, every: bool) -> None:
    handles, before = begin(page, qtbot, "scale"), corners(page)
    tip = page.eye.projected(handles.line(1))[-1]
    middle = page.eye.projected(handles.centre[None])[0]
    by = (tip - middle) * 0.5
    held = SHIFT if every else SHIFT ^ SHIFT
    drag(qtbot, page.eye, tuple(tip.tolist()), (round(by[0]), round(by[1])), held=held)
    settle(qtbot, page)
    factors = np.ptp(corners(page), axis=0) / np.ptp(before, axis=0)
    assert factors[1] == pytest.approx(1.5, rel=0.05)
    assert factors[[0, 2]] == pytest.approx(factors[1] if every else 1.0)
    assert isinstance(scene_of(page).objects[2].transforms[-1], Scale3D)


def test_no_handle_without_an_object_and_none_of_a_hidden_one(qtbot: QtBot, page: ProjectionPage) -> None:
    begin(page, qtbot, "move")
    page.session.update_state(thing="")
    settle(qtbot, page)
    assert page.eye.handles is None
    assert Handles.of(page.eye.scene, "o9", "move") is None
    assert Handles.of(page.eye.scene, SHED, "") is None


def test_an_axis_seen_end_on_moves_nothing() -> None:
    handles = Handles("o1", np.zeros(3), 1.0, "move")

    def flat(points: Array) -> Array:
        return points[:, :2] * 50

    end = QPointF(40, 40)
    assert handles.dragged(Handle("move", 2), QPointF(0, 0), end, flat, 1.0) == 0
    scaling = handles._replace(mode="scale")
    assert scaling.dragged(Handle("scale", 2), QPointF(0, 0), end, flat, 1.0) == 1


def test_a_point_of_a_net_is_dragged_in_the_picture(qtbot: QtBot, page: ProjectionPage) -> None:
    for offer in (each for each in offers() if each.points):
        page.objects.add_solid(offer)
        settle(qtbot, page)
        net = page.eye.net
        assert net is not None
        number = len(net.places) - 1
        place = page.eye.projected(net.places)[number]
        before = scene_of(page).objects[-1].points
        drag(qtbot, page.eye, tuple(place.tolist()), (12, -8))
        settle(qtbot, page)
        thing = scene_of(page).objects[-1]
        changed = [k for k, point in enumerate(thing.points) if point != before[k]]
        after = page.eye.net
        assert after is not None
        assert len(changed) == 1
        if isinstance(thing.solid, Surface):  # an outline stays in its plane
            there = page.eye.projected(after.places)[changed[0]]
            assert there == pytest.approx(page.eye.projected(net.places)[changed[0]] + (12, -8), abs=1.0)
        page.session.undo_stack.undo()
        settle(qtbot, page)
        assert scene_of(page).objects[-1].points == before
        page.objects.delete()
        settle(qtbot, page)


def test_an_object_is_copied_and_pasted_aside_in_one_step(qtbot: QtBot, page: ProjectionPage) -> None:
    page.session.update_state(thing="o1")
    settle(qtbot, page)
    before = scene_of(page)
    assert page.copy()
    for count in (4, 5):
        assert page.paste()
        settle(qtbot, page)
        assert len(scene_of(page).objects) == count
    first, second = (placed(scene_of(page))[k][0].vertices for k in (3, 4))
    assert first[:, 0].min() != second[:, 0].min()  # neither covers the other
    colours = {each.id: each.colour for each in scene_of(page).materials}
    assert colours[scene_of(page).objects[-1].material] == colours[before.objects[0].material]
    assert page.session.state.thing == scene_of(page).objects[-1].id
    for _step in (1, 2):
        page.session.undo_stack.undo()
    settle(qtbot, page)
    assert scene_of(page) == before
    QApplication.clipboard().clear()
    assert not page.paste()


def test_a_clipboard_that_is_no_object_says_so(page: ProjectionPage) -> None:
    data = QMimeData()
    data.setData(MIME, b'{"thing": {}}')
    QApplication.clipboard().setMimeData(data)
    said: list[str] = []
    page.hover_text.connect(said.append)
    assert page.paste()
    assert said == ["The object on the clipboard cannot be read; copy it again."]
    QApplication.clipboard().clear()


def test_a_figure_of_the_sheet_is_extruded_and_turned(qtbot: QtBot, page: ProjectionPage) -> None:
    sheet = page.session.sheet
    corners = ((10.0, 10.0), (50.0, 10.0), (50.0, 30.0), (10.0, 90.0))
    polygon = Polygon("", points_at(*corners), "scan_line_exact")
    page.session.apply(add_figure(sheet.id, polygon), "Draw")
    figure = page.session.sheet.figures[-1]
    page.objects.sweep("extrude", figure)
    settle(qtbot, page)
    mesh = scene_of(page).objects[-1].mesh
    assert len(mesh.vertices) == 8
    assert np.ptp(mesh.vertices[:, :2], axis=0) == pytest.approx([1.0, 2.0], abs=0.1)
    page.objects.sweep("turn", figure)
    settle(qtbot, page)
    mesh = scene_of(page).objects[-1].mesh
    assert mesh.vertices[:, 0].max() == pytest.approx(1.25, abs=0.1)
    assert mesh.vertices[:, 2].max() == pytest.approx(1.25, abs=0.1)
