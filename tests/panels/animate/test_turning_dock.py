"""Ways to turn side by side: what their matrices do, where Euler's rings lock, and the way chosen by hand."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtCore import Qt
from scipy.spatial.transform import Rotation, Slerp

from tests.panels.by_hand import settle
from workbench.algorithms.animation.turns import entries_determinant
from workbench.document.motion.tracks import motion_of
from workbench.panels.animate.panel import AnimatePanel
from workbench.panels.animate.turning import lined_up, numbers_of, ways_in_plane, ways_in_space

parts = st.floats(0.0, 1.0)
angles = st.floats(-720.0, 720.0)
quaternions = st.tuples(*(st.floats(-1.0, 1.0) for _part in range(4))).filter(lambda q: math.hypot(*q) > 0.1)


def unit(quaternion):
    return tuple(part / math.hypot(*quaternion) for part in quaternion)


def rotation(quaternion) -> Rotation:
    return Rotation.from_quat(np.roll(quaternion, -1))


@settings(max_examples=40)
@given(angles, angles, parts)
def test_in_the_plane_entries_shrink_by_the_closed_form(first: float, second: float, part: float) -> None:
    (by_angle, entries), theta = ways_in_plane(first, second)
    turned = numbers_of(by_angle, part)
    assert (turned.determinant, turned.length) == pytest.approx((1.0, 1.0))
    assert turned.turned == pytest.approx(part * (second - first), abs=1e-9)
    shrunk = numbers_of(entries, part)
    assert shrunk.determinant == pytest.approx(entries_determinant(theta, part), abs=1e-12)
    assert shrunk.length**2 == pytest.approx(shrunk.determinant, abs=1e-12)
    np.testing.assert_allclose(entries.matrix(1.0), by_angle.matrix(1.0), atol=1e-12)


@settings(max_examples=40)
@given(quaternions, quaternions, parts)
def test_in_space_too_and_the_quaternion_goes_evenly(first, second, part: float) -> None:
    p, q = unit(first), unit(second)
    (by_quaternion, by_euler, entries), theta = ways_in_space(p, q)
    assert theta == pytest.approx((rotation(p).inv() * rotation(q)).magnitude(), abs=1e-7)
    for way in (by_quaternion, by_euler):
        assert numbers_of(way, part)[:2] == pytest.approx((1.0, 1.0), abs=1e-9)
        np.testing.assert_allclose(way.matrix(1.0), rotation(q).as_matrix(), atol=1e-7)
    shrunk = numbers_of(entries, part)
    assert shrunk.determinant == pytest.approx(entries_determinant(theta, part), abs=1e-9)
    assert shrunk.length == pytest.approx(math.sqrt(max(shrunk.determinant, 0.0)), abs=1e-6)
    if theta < 3.1:
        theirs = Slerp([0.0, 1.0], Rotation.concatenate([rotation(p), rotation(q)]))(part)
        np.testing.assert_allclose(by_quaternion.matrix(part), theirs.as_matrix(), atol=1e-7)
        assert numbers_of(by_quaternion, part).turned == pytest.approx(math.degrees(part * theta))


def test_half_of_a_quarter_turn_by_entries() -> None:
    (_by_angle, entries), _theta = ways_in_plane(0.0, 90.0)
    assert numbers_of(entries, 0.5) == pytest.approx((0.5, math.sqrt(0.5), 45.0))
    (_by_angle, entries), _theta = ways_in_plane(0.0, -360.0)
    for part in (0.25, 0.5):  # a whole turn has the matrix of none
        assert numbers_of(entries, part) == pytest.approx((1.0, 1.0, 0.0), abs=1e-9)


@pytest.mark.parametrize(("middle", "apart"), [(0.0, 90.0), (60.0, 30.0), (90.0, 0.0), (-90.0, 0.0)])
def test_the_axes_of_x_and_z_line_up_at_a_quarter_turn(middle: float, apart: float) -> None:
    assert lined_up((0.7, math.radians(middle), -0.4)) == pytest.approx(apart, abs=1e-6)


@pytest.fixture
def turning(qtbot, panel: AnimatePanel) -> AnimatePanel:
    panel.session.open_example("animate-turn")
    qtbot.addWidget(panel.turning)
    panel.turning.resize(320, 560)
    panel.turning.show()
    settle()
    panel.timeline.track_chosen.emit(panel.session.frames.motion.tracks[1].target)
    panel.session.frames.show(16)
    settle()
    return panel


def seen(panel: AnimatePanel, number: int) -> np.ndarray:
    scene = panel.session.shown.scene
    assert scene is not None
    return scene.objects[number].transforms[0].matrix


def test_the_timeline_tells_a_turn_by_its_angle_and_its_axis(turning: AnimatePanel) -> None:
    turning.session.frames.show(12)
    settle()
    values = turning.timeline.shown.values
    first = turning.timeline.shown.tracks[0].target
    assert values[first] == "67.5° (0, 1, 0)"  # three quarters of a quarter turn about y


def test_where_the_rings_lock_that_is_said(turning: AnimatePanel) -> None:
    assert "0.0°, 90.0°, 0.0°" in turning.turning.note.text()
    assert "gimbal lock" in turning.turning.note.text()
    turning.session.frames.show(48)
    settle()
    assert "90.0°, 0.0°, 90.0°" in turning.turning.note.text()
    assert "gimbal lock" not in turning.turning.note.text()


def test_the_way_is_chosen_beside_the_picture_and_undone(turning: AnimatePanel) -> None:
    turning.session.frames.show(32)
    settle()
    assert not np.allclose(seen(turning, 0), seen(turning, 1))
    before = seen(turning, 1)
    way = turning.turning.way
    assert way.currentData() == "euler"
    way.setCurrentIndex(0)
    way.activated.emit(0)
    settle()
    assert [key.turning for key in motion_of(turning.session.sheet).tracks[1].keys] == [
        "euler",
        "quaternion",
        "euler",
    ]
    np.testing.assert_allclose(seen(turning, 0), seen(turning, 1), atol=1e-12)
    turning.session.undo_stack.undo()
    settle()
    np.testing.assert_allclose(seen(turning, 1), before)


def test_a_swinging_angle_is_shown_beside_its_entries(turning: AnimatePanel) -> None:
    turning.session.open_example("animate-pendulum")
    turning.session.frames.show(12)
    settle()
    assert turning.turning.way.isHidden()
    assert "0.671" in turning.turning.sums.text()  # 1 - (1 - cos 70 degrees) / 2
    assert "= 0.671." in turning.turning.note.text()
    turning.session.open_example("animate-ball")
    settle()
    assert turning.turning.title.text() == "Nothing turns here"


def test_the_numbers_are_a_table_and_not_its_markup(panel: AnimatePanel) -> None:
    assert panel.turning.sums.textFormat() != Qt.TextFormat.PlainText
