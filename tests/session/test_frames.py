"""The frame that is shown, playing by a clock, and edits that become keys in it."""

from collections.abc import Iterator

import pytest

from tests.document.motion.moving import still, track, with_tracks
from workbench.document.edits import move_points, set_attribute
from workbench.document.model import Circle, Document
from workbench.session.frames import Frames, frame_after
from workbench.session.session import Session

RADIUS = "f1/radius_world"


@pytest.fixture
def moving(qtbot: object) -> Iterator[Session]:
    document = with_tracks(still(), track(RADIUS, (0, (2.0,)), (10, (12.0,))), frames=11)
    session = Session(document=document)
    yield session
    session.close()


def radius(session: Session) -> float:
    figure = session.shown.figures[0]
    assert isinstance(figure, Circle)
    return figure.radius_world


def keys(document: Document) -> list[tuple[int, tuple[float, ...]]]:
    motion = document.sheets[0].motion
    assert motion is not None
    return [(key.frame, key.value) for each in motion.tracks for key in each.keys]


def test_what_is_shown_is_the_sheet_in_its_frame(moving: Session) -> None:
    assert radius(moving) == 2.0
    moving.frames.show(4)
    assert radius(moving) == 6.0
    assert not moving.dirty
    moving.frames.show(99)
    assert moving.frames.number == 10
    moving.frames.show(-3)
    assert moving.frames.number == 0


def test_an_edit_in_a_frame_is_a_key_there_and_one_step_of_undo(moving: Session) -> None:
    moving.frames.show(5)
    moving.apply(set_attribute("s1/f1/radius_world", 3.0), "Change radius")
    assert keys(moving.document) == [(0, (2.0,)), (5, (3.0,)), (10, (12.0,))]
    assert moving.document.sheets[0].figures[0].radius_world == 4.0  # type: ignore[union-attr]
    moving.undo_stack.undo()
    assert keys(moving.document) == [(0, (2.0,)), (10, (12.0,))]


def test_without_auto_key_what_has_no_track_changes_everywhere(moving: Session) -> None:
    moving.frames.show(5)
    moving.apply(move_points({"s1/f1/p1/x": (1.0, 2.0)}), "Move")
    assert len(keys(moving.document)) == 2
    moving.update_state(auto_key=True)
    moving.apply(move_points({"s1/f1/p1/x": (5.0, 2.0)}), "Move")
    assert keys(moving.document)[2:] == [(0, (1.0, 2.0)), (5, (5.0, 2.0))]


def test_a_drag_keys_what_it_began_with(moving: Session) -> None:
    moving.update_state(auto_key=True)
    moving.frames.show(5)
    before = moving.document
    for x in (11.0, 12.0, 13.0):
        moving.apply(move_points({"s1/f1/p1/x": (x, 10.0)}), "Move", "drag", on=before)
    moving.end_merge()
    assert keys(moving.document)[2:] == [(0, (10.0, 10.0)), (5, (13.0, 10.0))]
    moving.undo_stack.undo()
    assert moving.document == before


def test_it_plays_by_the_clock(moving: Session) -> None:
    now = [0.0]
    frames = Frames(moving, clock=lambda: now[0])
    frames.play()
    assert frames.playing
    for passed, number in ((0.0, 0), (1 / 24 + 1e-6, 1), (10.5 / 24, 10), (11.5 / 24, 0)):
        now[0] = passed
        frames.tick()
        assert frames.number == number
    frames.set_speed(0.5)
    now[0] += 2.5 / 24
    frames.tick()
    assert frames.number == 1
    frames.mode = "once"
    now[0] += 9.0
    frames.tick()
    assert (frames.number, frames.playing) == (10, False)
    frames.play()
    frames.tick()
    assert frames.number == 0
    frames.stop()


@pytest.mark.parametrize(
    ("mode", "expected"),
    [
        ("loop", [0, 1, 2, 3, 0, 1, 2, 3]),
        ("ping_pong", [0, 1, 2, 3, 2, 1, 0, 1]),
        ("once", [0, 1, 2, 3, 3, 3, 3, 3]),
    ],
)
def test_what_comes_after_the_last_frame(mode: str, expected: list[int]) -> None:
    assert [frame_after(passed + 0.5, 4, mode) for passed in range(8)] == expected  # type: ignore[arg-type]
    assert frame_after(7.0, 1, mode) == 0  # type: ignore[arg-type]
