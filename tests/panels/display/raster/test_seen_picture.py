"""The run of the page Raster scans what its tube shows: the sheet in its frame, from where one looks."""

import numpy as np
from msgspec.structs import replace
from pytestqt.qtbot import QtBot

from tests.panels.display.conftest import put_on_screen
from workbench.document.motion.evaluation import at
from workbench.document.state import as_seen, with_look
from workbench.panels.display.comparison.page import ComparisonPage
from workbench.panels.display.raster.page import RasterPage
from workbench.rendering import frame_buffer
from workbench.rendering.display_program import strokes_of
from workbench.rendering.scene.backdrop import whole_picture, with_scene
from workbench.session.session import Session


def look_from_elsewhere(session: Session) -> None:
    scene = session.sheet.scene
    assert scene is not None
    with_scene(frame_buffer(session.sheet), session.sheet)  # from now on it can be lit
    eye = scene.camera.eye
    camera = replace(scene.camera, eye=replace(eye, x=eye.x + 3.0, y=eye.y + 1.0))
    session.update_state(looks=with_look(session.state, session.sheet, camera))
    session.flush()


def test_the_run_is_of_the_frame_that_is_shown(qtbot: QtBot, session: Session) -> None:
    session.open_example("animate-letter")
    page = RasterPage(session)
    put_on_screen(qtbot, page, 900, 600)
    session.visit("raster", page.usual)
    session.frames.show(session.frames.count // 2)
    session.flush()
    expected = frame_buffer(at(session.sheet, session.frames.number))
    assert not np.array_equal(expected, frame_buffer(session.sheet))
    qtbot.waitUntil(lambda: page.tube._image is not None and page.tube._image.any())
    assert page.setting.scan is not None
    for shown in (page.tube._image, page.setting.scan.buffer.shown, session.run.calls[0][0]):
        assert np.array_equal(np.asarray(shown), expected)


def test_the_run_is_of_the_picture_from_where_one_looks(qtbot: QtBot, session: Session) -> None:
    session.open_example("space-house")
    page = RasterPage(session)
    put_on_screen(qtbot, page, 900, 600)
    session.visit("raster", page.usual)
    session.flush()
    before = session.run.calls[0][0].copy()
    look_from_elsewhere(session)
    expected = whole_picture(as_seen(session.state, session.sheet))
    assert expected.any()
    assert np.array_equal(session.run.calls[0][0], expected)
    assert not np.array_equal(session.run.calls[0][0], before)
    qtbot.waitUntil(lambda: np.array_equal(page.tube._image, expected))


def test_both_tubes_of_a_comparison_look_from_there(qtbot: QtBot, session: Session) -> None:
    session.open_example("space-house")
    page = ComparisonPage(session)
    put_on_screen(qtbot, page, 900, 600)
    session.visit("comparison", page.usual)
    look_from_elsewhere(session)
    seen = as_seen(session.state, session.sheet)
    qtbot.waitUntil(lambda: np.array_equal(page.raster._image, whole_picture(seen)))
    assert page.facts is not None
    assert np.array_equal(page.facts.program.strokes.ends, strokes_of(seen).ends)
    assert not np.array_equal(strokes_of(seen).ends, strokes_of(session.sheet).ends)
    assert len(session.run.calls[0][0]) == len(page.facts.program)
    assert np.array_equal(session.run.calls[0][0], page.facts.program.rows)
