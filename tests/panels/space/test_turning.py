"""What is drawn while a scene is turned, and what waits until the hand rests."""

from collections.abc import Iterator

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.panels.space.by_hand import LEFT, NONE, drag, settle, shown
from workbench.document.scene.model import Camera
from workbench.document.scene.viewing import view_matrix
from workbench.panels.space import scene_picture
from workbench.panels.space.projection_page import ProjectionPage
from workbench.panels.space.scene_worker import SceneJob
from workbench.rendering.scene.edge_picture import edge_picture


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[ProjectionPage]:
    yield from shown(qtbot)


def hold_and_move(qtbot: QtBot, page: ProjectionPage, moves: int) -> QPointF:
    """Turn the scene by so many moves, and keep the button down; where the pointer is then."""
    where = QPointF(page.eye.rect().center())
    qtbot.mousePress(page.eye, LEFT, pos=where.toPoint())
    for _move in range(moves):
        where += QPointF(15, 4)
        place = page.eye.mapToGlobal(where)
        QApplication.sendEvent(
            page.eye, QMouseEvent(QEvent.Type.MouseMove, where, place, NONE, LEFT, Qt.KeyboardModifier(0))
        )
        QApplication.processEvents()
    return where


def test_while_a_large_scene_is_turned_nothing_but_its_picture_is_drawn_and_all_once_the_hand_rests(
    qtbot: QtBot, page: ProjectionPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(scene_picture, "_MANY_FACES", 1)
    shown_by: list[Camera] = []
    asked: list[SceneJob] = []
    monkeypatch.setattr(page.strip, "show_camera", lambda camera, _anew: shown_by.append(camera))
    monkeypatch.setattr(page.outside.worker, "ask", asked.append)
    page._rest.setInterval(60_000)
    turned: list[Camera] = []
    page.eye.pictured.connect(turned.append)
    where = hold_and_move(qtbot, page, 4)
    qtbot.waitUntil(lambda: page.eye.picture_is_current, timeout=20_000)
    assert turned[-1] == page.looking.camera
    assert np.array_equal(page.cube._view, view_matrix(page.looking.camera))  # it turns with the picture
    assert shown_by == []
    assert asked == []
    page._rest.timeout.emit()  # the hand rests, and holds on
    assert shown_by == [page.looking.camera]
    assert page.outside.seen.camera == page.looking.camera
    assert len(asked) == 1
    assert not page._rest.isActive()
    qtbot.mouseRelease(page.eye, LEFT, pos=where.toPoint())
    settle(qtbot, page)
    eye = page.eye
    whole = edge_picture(eye.scene, eye.device_size, eye.window_world).pixels
    assert eye._picture is not None
    assert np.array_equal(eye._picture.pixels, whole)


def test_a_large_scene_is_not_at_rest_before_the_last_move(
    qtbot: QtBot, page: ProjectionPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    starts: list[int] = []
    start = page._rest.start
    monkeypatch.setattr(page._rest, "start", lambda: (starts.append(1), start()))
    page._rest.setInterval(60_000)
    for many, again in ((10_000, False), (1, True)):
        monkeypatch.setattr(scene_picture, "_MANY_FACES", many)
        where = hold_and_move(qtbot, page, 6)
        assert starts
        assert (len(starts) > 1) == again
        qtbot.mouseRelease(page.eye, LEFT, pos=where.toPoint())
        settle(qtbot, page)
        starts.clear()


def test_a_hidden_outside_view_draws_nothing_and_shows_the_scene_as_it_is_when_it_is_seen(
    qtbot: QtBot, page: ProjectionPage, monkeypatch: pytest.MonkeyPatch
) -> None:
    page.show_beside("eye")
    asked: list[SceneJob] = []
    ask = page.outside.worker.ask
    monkeypatch.setattr(page.outside.worker, "ask", lambda job: (asked.append(job), ask(job)))
    before = page.outside.scene
    drag(qtbot, page.eye, (20, 300), (60, -30))
    settle(qtbot, page)
    assert page.outside.scene is before
    assert asked == []
    page.show_beside("both")
    settle(qtbot, page)
    assert page.outside.seen.camera == page.looking.camera
    assert asked[-1].scene == page.outside.scene
    assert page.outside.scene != before
