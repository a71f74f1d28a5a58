"""Euler's angles against SciPy's, and where their rings lock."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from workbench.geometry.euler import Triple, euler_angles, euler_between, euler_quaternion, gimbal_axes
from workbench.geometry.quaternions import quaternion_about, quaternion_matrix

angles = st.tuples(*(st.floats(-3.1, 3.1) for _axis in range(3)))
tame = st.tuples(st.floats(-3.1, 3.1), st.floats(-1.5, 1.5), st.floats(-3.1, 3.1))


@settings(max_examples=40)
@given(angles)
def test_they_turn_about_x_then_y_then_z(turn: Triple) -> None:
    theirs = Rotation.from_euler("xyz", turn).as_matrix()  # small letters: axes that stay
    np.testing.assert_allclose(quaternion_matrix(euler_quaternion(turn)), theirs, atol=1e-12)


@settings(max_examples=40)
@given(tame)
def test_an_orientation_gives_its_angles_back(turn: Triple) -> None:
    assert euler_angles(euler_quaternion(turn)) == pytest.approx(turn, abs=1e-9)


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize(("x", "z"), [(0.3, 0.9), (-2.0, 1.0), (0.0, 0.0)])
def test_where_the_rings_lock_the_angles_still_make_the_orientation(side: float, x: float, z: float) -> None:
    locked = euler_quaternion((x, side * math.pi / 2, z))
    other = euler_angles(locked)
    assert other[0] == 0.0
    assert math.remainder(other[2] - (z - side * x), math.tau) == pytest.approx(0.0, abs=1e-9)
    np.testing.assert_allclose(
        quaternion_matrix(euler_quaternion(other)), quaternion_matrix(locked), atol=1e-12
    )


@settings(max_examples=40)
@given(angles)
def test_the_axes_span_as_much_space_as_the_cosine_of_the_middle_angle(turn: Triple) -> None:
    assert abs(np.linalg.det(np.array(gimbal_axes(turn)))) == pytest.approx(abs(math.cos(turn[1])), abs=1e-12)
    about_x, _about_y, _about_z = gimbal_axes(turn)
    step = 1e-6
    more = quaternion_matrix(euler_quaternion((turn[0] + step, turn[1], turn[2])))
    here = quaternion_matrix(euler_quaternion(turn))
    carried = quaternion_matrix(quaternion_about(step, about_x))
    np.testing.assert_allclose(carried @ here, more, atol=1e-12)


def test_each_angle_goes_the_shorter_way_round() -> None:
    first, second = (3.0, 0.0, -1.0), (-3.0, 1.0, 1.0)
    assert euler_between(first, second, 0.5) == pytest.approx((math.pi, 0.5, 0.0))
