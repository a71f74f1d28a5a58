"""Transform, Clip, Curves and Space show what a track moves as it is in the frame that is shown."""

from collections.abc import Iterator

import pytest

from tests.document.motion.moving import track, with_tracks
from tests.panels.by_hand import keep_until_the_end, settle
from workbench.document.motion.tracks import track_on
from workbench.document.samples.examples import example
from workbench.panels.clip.panel import ClipPanel
from workbench.panels.curves.panel import CurvesPanel
from workbench.panels.space.projection_page import ProjectionPage
from workbench.panels.transform.panel import TransformPanel
from workbench.session.session import Session


def session_of(slug: str, target: str, low: float, high: float) -> Session:
    """An example with one number that a track moves; in frame 10 it is the second one."""
    moving = track(target, (0, (low,)), (10, (high,)))
    session = Session(document=with_tracks(example(slug).document, moving))
    session.frames.show(10)
    return session


@pytest.fixture
def sessions(qtbot) -> Iterator[list[Session]]:
    made: list[Session] = []
    yield made
    for session in made:
        session.close()


def test_a_curve_is_worked_on_where_it_is(qtbot, sessions: list[Session]) -> None:
    figure = example("curve-interpolation").document.sheets[0].figures[-1]
    session = session_of("curve-interpolation", f"{figure.id}/{figure.points_world[0].id}/x", 1.0, 33.0)
    sessions.append(session)
    panel = CurvesPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.show()
    settle()
    assert panel.focus.curve is not None
    assert panel.focus.curve.points_world[0].x == 33.0
    session.frames.show(0)
    assert panel.focus.curve.points_world[0].x == 1.0


def test_the_tables_of_a_chain_are_those_of_the_frame(qtbot, sessions: list[Session]) -> None:
    figure = example("transform-pivot").document.sheets[0].figures[-1]
    session = session_of("transform-pivot", f"{figure.id}/{figure.points_world[0].id}/x", 1.0, 33.0)
    sessions.append(session)
    session.update_state(active=figure.id)
    panel = TransformPanel(session)
    keep_until_the_end(qtbot, panel)
    ((_title, table),) = panel.tables()
    assert any(33.0 in row or "33" in map(str, row) for row in table.rows)


def test_what_is_clipped_is_counted_in_the_frame(qtbot, sessions: list[Session]) -> None:
    session = session_of("clip-lab", "f4/p8/x", 26.0, 400.0)
    sessions.append(session)
    panel = ClipPanel(session)
    keep_until_the_end(qtbot, panel)
    panel.show()
    settle()
    assert "1 inside" in panel.card.outcome.text()
    session.frames.show(0)
    settle()
    assert "2 inside" in panel.card.outcome.text()


def test_space_is_seen_by_the_camera_of_the_frame(qtbot, sessions: list[Session]) -> None:
    session = Session(document=example("animate-drive").document)
    sessions.append(session)
    page = ProjectionPage(session)
    qtbot.addWidget(page)
    page.show()
    session.frames.show(46)
    settle()
    assert page.eye.scene.camera.eye.xyz == (0.0, 0.8, 3.5)
    assert not page.looking.around
    page.glance("isometric")
    settle()
    assert page.looking.around
    session.frames.show(60)
    settle()
    assert page.looking.around
    assert page.eye.scene.camera.projection == "isometric"
    assert page.card.back.isVisibleTo(page.card)
    page.card.back.click()
    settle()
    assert not page.looking.around
    assert not page.card.back.isVisibleTo(page.card)
    assert page.eye.scene.camera.eye.xyz == (0.2, 0.8, 1.9)


def test_playing_goes_by_the_moving_camera_until_one_looks_around(qtbot, sessions: list[Session]) -> None:
    session = Session(document=example("animate-drive").document)
    sessions.append(session)
    page = ProjectionPage(session)
    qtbot.addWidget(page)
    page.show()
    now = [0.0]
    session.frames._clock = lambda: now[0]
    session.frames.play()
    for frame in (10, 28, 46):
        now[0] = (frame + 0.5) / 24.0
        session.frames.tick()
        settle()
        assert page.eye.scene.camera == session.shown.scene.camera
    looked = page.eye.scene.camera
    assert looked.eye.xyz == (0.0, 0.8, 3.5)
    page.looking.orbit(0.4, 0.2)
    around = page.looking.camera
    for frame in (52, 60):
        now[0] = (frame + 0.5) / 24.0
        session.frames.tick()
        settle()
        assert session.frames.number == frame
        assert page.eye.scene.camera == around
    session.frames.stop()


def test_a_kept_view_of_a_moving_camera_is_a_key_there(qtbot, sessions: list[Session]) -> None:
    session = Session(document=example("animate-drive").document)
    sessions.append(session)
    page = ProjectionPage(session)
    qtbot.addWidget(page)
    page.show()
    session.frames.show(40)
    settle()
    before = session.document
    page.looking.orbit(0.4, 0.2)
    kept = page.looking.camera
    settle()
    page.card.keep.click()
    settle()
    assert not page.looking.around
    assert session.shown.scene.camera.eye.xyz == pytest.approx(kept.eye.xyz)
    eye = track_on(session.sheet, "scene.camera.eye")
    assert eye is not None
    assert [key.frame for key in eye.keys] == [0, 28, 40, 46, 60, 84]
    assert session.sheet.scene == before.sheets[0].scene
    session.undo_stack.undo()
    assert session.document == before
