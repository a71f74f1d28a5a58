"""What a frame holds back is said, and speed is evened by hand."""

import math
from itertools import pairwise

import pytest
from msgspec.structs import replace

from tests.document.motion.moving import sheet_of, track
from tests.panels.by_hand import settle
from workbench.document.model import Document
from workbench.document.motion.evaluation import at, in_frame
from workbench.document.motion.tracks import track_on
from workbench.document.samples.examples import example
from workbench.panels.animate.names import held_text
from workbench.panels.animate.panel import AnimatePanel


def opened(panel: AnimatePanel, *tracks) -> None:
    panel.session.new(Document((sheet_of(*tracks),)))
    settle()


def test_a_radius_that_a_spline_takes_below_0_is_held_and_that_is_said(panel: AnimatePanel) -> None:
    said: list[str] = []
    panel.hover_text.connect(said.append)
    opened(
        panel, track("f1/radius_world", (0, (9.0,)), (6, (0.0,)), (12, (0.0,)), (18, (9.0,)), easing="spline")
    )
    panel.session.frames.show(9)
    settle()
    assert panel.session.shown.figures[0].radius_world == 0.0
    assert said[-1] == "Ball, r: held at the end of its range in this frame."


def test_a_number_of_the_camera_that_is_held_is_said_too() -> None:
    sheet = example("animate-drive").document.sheets[0]
    target = "scene.camera.distance"
    sheet = replace(sheet, motion=sheet_of(track(target, (0, (-3.0,)))).motion)
    assert held_text(sheet, in_frame(sheet, 0).held).startswith("Camera, ")
    assert "held at the end of its range" in held_text(sheet, in_frame(sheet, 0).held)


def test_a_camera_that_looks_at_where_it_stands_stays_and_that_is_said() -> None:
    sheet = example("animate-drive").document.sheets[0]
    assert sheet.scene is not None
    aim = sheet.scene.camera.look_at.xyz
    sheet = replace(sheet, motion=sheet_of(track("scene.camera.eye", (0, aim))).motion)
    assert at(sheet, 0).scene == sheet.scene
    told = held_text(sheet, in_frame(sheet, 0).held)
    assert (
        told == "Camera: its keys make something here that cannot be drawn, so it stays as the sheet has it."
    )


def test_the_speed_along_a_path_is_evened_by_its_command(panel: AnimatePanel) -> None:
    target = "f1/p1/*"
    opened(panel, track(target, (0, (0.0, 0.0)), (2, (30.0, 0.0)), (20, (30.0, 10.0)), easing="ease_in"))
    next(
        action for action in panel.actions() if action.text() == "Make the speed along the path constant"
    ).trigger()
    settle()
    places = [at(panel.session.sheet, frame).figures[0].points_world[0] for frame in range(21)]
    steps = [math.dist((a.x, a.y), (b.x, b.y)) for a, b in pairwise(places)]
    assert steps == pytest.approx([2.0] * 20)
    panel.session.undo_stack.undo()
    settle()
    again = track_on(panel.session.sheet, target)
    assert again is not None
    assert [key.frame for key in again.keys] == [0, 2, 20]
