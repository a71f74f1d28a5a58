"""Copy, paste and Delete act on keys while a timeline has the focus; figures take their tracks along."""

from collections.abc import Iterator

import pytest

from tests.shell.keys.focus import press, settle
from workbench.document.motion.evaluation import at
from workbench.document.motion.tracks import motion_of, track_on
from workbench.panels.animate.panel import AnimatePanel
from workbench.shell.window import MainWindow
from workbench.shell.workspaces import panel_of


@pytest.fixture
def animate(window: MainWindow) -> Iterator[AnimatePanel]:
    window.open_example("animate-ball")
    settle()
    yield panel_of(window.panels("animate"), AnimatePanel)
    window.session.frames.stop()


def test_keys_are_copied_pasted_cut_and_deleted_by_the_keys_of_the_window(
    window: MainWindow, animate: AnimatePanel
) -> None:
    session, timeline = window.session, animate.timeline
    figures = session.sheet.figures
    target = timeline.shown.tracks[1].target

    def frames() -> list[int]:
        track = track_on(session.sheet, target)
        return [key.frame for key in track.keys] if track is not None else []

    timeline.track_chosen.emit(target)
    timeline.setFocus()
    settle()
    press(timeline, "Return")
    press(timeline, "Ctrl+C")
    session.frames.show(30)
    settle()
    press(timeline, "Ctrl+V")
    settle()
    assert frames() == [0, 30, 58]
    press(timeline, "Esc")
    press(timeline, "Return")
    press(timeline, "Ctrl+X")
    settle()
    assert frames() == [0, 58]
    press(timeline, "Ctrl+Z")
    settle()
    assert frames() == [0, 30, 58]
    press(timeline, "Ctrl+A")
    assert len(timeline.selected) == sum(len(track.keys) for track in timeline.shown.tracks)
    window.menus.actions["delete"].trigger()
    settle()
    assert motion_of(session.sheet).tracks == ()
    assert session.sheet.figures == figures


def test_a_figure_that_moves_is_pasted_with_its_tracks_on_the_same_sheet_and_in_another_picture(
    window: MainWindow, animate: AnimatePanel
) -> None:
    session = window.session
    ball = session.sheet.figures[-1]
    tracks = len(motion_of(session.sheet).tracks)
    session.update_state(selection=(ball.id,), active=ball.id)
    animate.canvas.setFocus()
    settle()
    before = at(session.sheet, 34).figures[-1].points_world[0]
    press(animate.canvas, "Ctrl+C")
    press(animate.canvas, "Ctrl+V")
    settle()
    assert len(motion_of(session.sheet).tracks) == 2 * tracks
    beside = at(session.sheet, 34).figures[-1].points_world[0]
    assert (beside.x - before.x, beside.y - before.y) == pytest.approx((1.0, -1.0))
    press(animate.canvas, "Ctrl+Z")
    settle()
    assert len(motion_of(session.sheet).tracks) == tracks
    session.new()
    settle()
    press(animate.canvas, "Ctrl+V")
    settle()
    there = at(session.sheet, 34).figures[-1].points_world[0]
    assert (there.x, there.y) == pytest.approx((before.x, before.y))
    assert session.frames.count == 59


def test_keys_go_with_a_figure_and_come_back_with_undo(window: MainWindow, animate: AnimatePanel) -> None:
    session = window.session
    motion = session.sheet.motion
    ball = session.sheet.figures[-1]
    session.update_state(selection=(ball.id,), active=ball.id)
    settle()
    press(animate.canvas, "Delete")
    settle()
    assert motion_of(session.sheet).tracks == ()
    press(animate.canvas, "Ctrl+Z")
    settle()
    assert session.sheet.motion == motion
