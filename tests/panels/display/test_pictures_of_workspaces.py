"""The picture of every workspace is on both tubes, in the dock and in Display, while it is stepped."""

from collections.abc import Callable, Iterator

import numpy as np
import pytest
from msgspec.structs import replace
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.panels.by_hand import keep_until_the_end
from workbench.document.scene.model import Point3D
from workbench.document.state import Look
from workbench.panels.display.tubes_page import TubesPage
from workbench.panels.shared.tube_dock import TubeDock
from workbench.rendering import frame_buffer
from workbench.rendering.scene import backdrop
from workbench.rendering.scene.backdrop import with_scene
from workbench.session.session import Session
from workbench.widgets.tube.view import TubeView

EXAMPLES = [
    "house",
    "pond",
    "clip",
    "transform-leaf",
    "view-house",
    "curve-bezier",
    "animate-clock",
    "overlapping-triangles",
]
SCENES = ["overlapping-triangles", "shading-ball"]


@pytest.fixture
def session(monkeypatch: pytest.MonkeyPatch) -> Iterator[Session]:
    monkeypatch.setattr(backdrop, "are_drawn_at_once", lambda: True)
    one = Session()
    yield one
    one.close()
    one.deleteLater()


def _dock(session: Session) -> tuple[QWidget, TubeView, TubeView]:
    dock = TubeDock(session)
    return dock, dock.raster, dock.vector


def _page(session: Session) -> tuple[QWidget, TubeView, TubeView]:
    page = TubesPage(session)
    return page, page.raster, page.vector


def seen(qtbot: QtBot, session: Session, make: Callable[[Session], tuple[QWidget, TubeView, TubeView]]):
    widget, raster, vector = make(session)
    keep_until_the_end(qtbot, widget)
    widget.resize(700, 420)
    with qtbot.waitExposed(widget):
        widget.show()
    return widget, raster, vector


def lit(tube: TubeView) -> bool:
    return tube.driver is not None and bool(tube.driver.beam.energy_per_frame().any())


@pytest.mark.parametrize("slug", EXAMPLES)
def test_both_tubes_of_display_show_the_picture_of_every_workspace(
    qtbot: QtBot, session: Session, slug: str
) -> None:
    session.open_example(slug)
    session.flush()
    _widget, raster, vector = seen(qtbot, session, _page)
    qtbot.waitUntil(lambda: lit(raster) and lit(vector))
    expected = with_scene(frame_buffer(session.shown), session.shown)
    assert np.array_equal(raster._image, expected)
    session.run.forward()
    session.flush()
    assert lit(raster)
    assert lit(vector)


@pytest.mark.parametrize("slug", EXAMPLES)
def test_both_tubes_of_the_dock_show_the_picture_of_every_workspace(
    qtbot: QtBot, session: Session, slug: str
) -> None:
    session.open_example(slug)
    session.flush()
    dock, raster, vector = seen(qtbot, session, _dock)
    assert isinstance(dock, TubeDock)
    qtbot.waitUntil(lambda: lit(raster))
    dock._choices.button(1).click()
    qtbot.waitUntil(lambda: lit(vector))


@pytest.mark.parametrize("slug", SCENES)
def test_a_scene_is_seen_on_the_tubes_from_where_somebody_looks(
    qtbot: QtBot, session: Session, slug: str
) -> None:
    session.open_example(slug)
    session.flush()
    _widget, raster, vector = seen(qtbot, session, _page)
    qtbot.waitUntil(lambda: lit(raster))
    before, strokes = raster._image.copy(), vector.driver and vector.driver.beam.energy_per_frame().copy()
    scene = session.sheet.scene
    assert scene is not None
    eye = scene.camera.eye
    moved = replace(scene.camera, eye=Point3D(eye.x + 1.0, eye.y + 0.5, eye.z))
    session.update_state(looks={session.sheet.id: Look(moved, scene.camera)})
    session.flush()
    assert (raster._image != before).any()
    assert vector.driver is not None
    assert (vector.driver.beam.energy_per_frame() != strokes).any()


def test_a_scene_waits_for_what_paints_it(
    qtbot: QtBot, session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(backdrop, "are_drawn_at_once", lambda: False)
    session.open_example("overlapping-triangles")
    session.flush()
    _widget, raster, vector = seen(qtbot, session, _page)
    qtbot.waitUntil(lambda: lit(vector))
    assert not raster._image.any()
    monkeypatch.setattr(backdrop, "are_drawn_at_once", lambda: True)
    qtbot.waitUntil(lambda: lit(raster))
