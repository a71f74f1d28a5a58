"""Keys and physics: a fall, a swing, a spacing chart, and a ball that keeps its area."""

import math

import numpy as np
import pytest
from msgspec.structs import replace

from tests.document.motion.moving import sheet_of, track
from tests.panels.by_hand import LEFT, settle
from workbench.algorithms.animation.pendulum import swing
from workbench.document.errors import DocumentError
from workbench.document.model import Document
from workbench.document.motion.edits import keep_area, remove_keys
from workbench.document.motion.evaluation import at
from workbench.document.motion.tracks import motion_of, track_on
from workbench.document.samples.examples import example
from workbench.panels.animate.panel import AnimatePanel
from workbench.panels.animate.physics import by_equation, equation_of
from workbench.panels.animate.spacing import chart_of


@pytest.fixture
def physics(qtbot, panel: AnimatePanel) -> AnimatePanel:
    qtbot.addWidget(panel.physics)
    panel.physics.resize(320, 520)
    panel.physics.show()
    panel.session.frames.show(34)
    settle()
    return panel


def test_a_fall_is_told_with_its_numbers(physics: AnimatePanel) -> None:
    assert physics.physics.sums.text().splitlines()[:4] == [
        "g = 2 · 36 / 12² = 0.5",
        "v = 2 · 36 / 12 = 6 below",
        "frame 34: 35.4558, by law 37",
        "at most 2 apart, frame 36",  # t = 2 / 3: 36 (1/2 − 4/9)
    ]
    physics.session.frames.show(20)
    settle()
    assert "keeps √(36 / 64) = 0.75 of its speed" in physics.physics.sums.text()


def test_an_easing_that_does_not_fall_is_seen_beside_what_does(physics: AnimatePanel) -> None:
    target = physics.session.frames.motion.tracks[0].target
    before = equation_of(physics.session.sheet, target)
    physics.keys.ease_interval(physics.physics.key, "linear")
    settle()
    after = equation_of(physics.session.sheet, target)
    assert before is not None
    assert after is not None
    for frame in range(59):
        here, there = (at(by_equation(physics.session.sheet, law), frame) for law in (before, after))
        assert here.figures[-1].points_world[0].y == there.figures[-1].points_world[0].y
    assert "at most 9 apart, frame 34" in physics.physics.sums.text()  # 36 (1/2 - 1/4)


def test_a_pendulum_s_keys_are_beside_its_equation(physics: AnimatePanel) -> None:
    physics.session.open_example("animate-pendulum")
    physics.session.frames.show(8)
    settle()
    law = math.degrees(swing(math.radians(35.0), 8 / 24))
    lines = physics.physics.sums.text().splitlines()
    assert lines[:4] == [
        "θ'' = −(g / l) sin θ, from 35°",
        "T = 2 · 24 = 48 frames",
        "1.0238 times 2π √(l / g)",
        "g / l = 0.018",
    ]
    assert lines[4] == f"frame 8: 17.5, by law {law:.4f}"
    assert "dotted: a pendulum by its equation" in [
        getattr(mark, "text", "") for mark in physics.canvas.overlay.drawn
    ]


@pytest.mark.parametrize(
    ("values", "easing", "law"),
    [
        ((30.0, -50.0), "ease_in_out", "swing"),
        ((30.0, -50.0, 20.0), "linear", "swing"),
        ((0.0, -360.0), "linear", None),
        ((0.0, 30.0, 80.0), "linear", None),
        ((200.0, -200.0), "ease_in_out", None),
        ((10.0,), "ease_in_out", None),
    ],
)
def test_what_swings_is_told_from_what_turns(values, easing: str, law: str | None) -> None:
    sheet = example("animate-clock").document.sheets[0]
    target = motion_of(sheet).tracks[0].target
    keys = [(24 * number, (value,)) for number, value in enumerate(values)]
    sheet = replace(sheet, motion=replace(motion_of(sheet), tracks=(track(target, *keys, easing=easing),)))
    equation = equation_of(sheet, target)
    assert (equation.law if equation else None) == law
    if equation is not None:
        given = {key.frame: key.value for key in equation.track.keys}
        assert all(given[frame] == pytest.approx(value) for frame, value in keys)
        half = (values[0] - values[1]) / 2
        assert given[6][0] == pytest.approx(
            values[0] - half + math.degrees(math.copysign(swing(math.radians(abs(half)), 0.25), half))
        )


def test_the_chart_has_the_place_of_each_frame() -> None:
    moving = track("f1/p1/*", (0, (0.0, 0.0)), (10, (6.0, 8.0)), easing="ease_in")
    keys, even = chart_of(moving, (moving.keys[0], moving.keys[1]), None).rows
    places = [10.0 * (1.0 - math.cos(math.pi * frame / 20)) for frame in range(11)]
    np.testing.assert_allclose(keys.values, places, atol=1e-12)
    np.testing.assert_allclose(even.values, np.arange(11.0))
    assert chart_of(moving, (moving.keys[0], moving.keys[1]), None).apart.max() == 0.0


def test_what_is_squashed_keeps_its_area(qtbot, physics: AnimatePanel) -> None:
    session = physics.session
    wide = session.frames.motion.tracks[-1]
    assert wide.target.endswith("radius_x_world")
    session.apply(remove_keys(session.sheet.id, [key.id for key in wide.keys]), "without")
    session.frames.show(40)
    settle()
    assert "70 % of the area of frame 0" in physics.physics.sums.text()
    assert physics.physics.keep.isVisible()
    qtbot.mouseClick(physics.physics.keep, LEFT)
    settle()
    assert "r_x · r_y = 10 · 4.9 = 49" in physics.physics.sums.text()
    assert "100 % of the area of frame 0" in physics.physics.sums.text()
    assert not physics.physics.keep.isVisible()
    made = track_on(session.sheet, wide.target)
    assert made is not None
    assert [key.frame for key in made.keys] == [key.frame for key in wide.keys]
    session.undo_stack.undo()
    settle()
    assert track_on(session.sheet, wide.target) is None


def test_without_keys_on_one_radius_there_is_no_area_to_keep() -> None:
    with pytest.raises(DocumentError, match="two radii"):
        keep_area("s1", "f1")(Document((sheet_of(),)))
