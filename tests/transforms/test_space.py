"""The transformations of space: the numbers of the course, and what holds for all numbers."""

import math

import numpy as np
import pytest
from hypothesis import assume, given

from tests.transforms.inputs import angles, coordinates, factors, moved, points_3d
from workbench.algorithms.transforms import (
    axis_steps,
    product,
    reflection_3d,
    rotation_about,
    rotation_about_axis,
    rotation_x,
    rotation_y,
    rotation_z,
    scaling_3d,
    scaling_about_3d,
    shear_3d,
    transform_points,
    translation_3d,
)

Point = tuple[float, float, float]


def test_rotation_about_an_axis_as_the_course_has_it() -> None:
    matrix = rotation_about_axis(math.radians(90), (1, 0, 1), (2, 2, 3))
    np.testing.assert_allclose(moved(matrix, (3, 1, 1)), (0.7778, 2.2222, 0.8889), atol=5e-5)


def test_quarter_turns_about_the_axes_are_exact_and_right_handed() -> None:
    quarter = math.radians(90)
    assert moved(rotation_x(quarter), (0, 1, 0)).tolist() == [0, 0, 1]
    assert moved(rotation_y(quarter), (0, 0, 1)).tolist() == [1, 0, 0]
    assert moved(rotation_z(quarter), (1, 0, 0)).tolist() == [0, 1, 0]


@given(theta=angles)
def test_about_an_axis_of_the_frame_it_is_that_rotation(theta: float) -> None:
    for end, about in (((5, 0, 0), rotation_x), ((0, 5, 0), rotation_y), ((0, 0, 5), rotation_z)):
        np.testing.assert_allclose(rotation_about_axis(theta, (0, 0, 0), end), about(theta), atol=1e-15)
        back = tuple(-value for value in end)
        np.testing.assert_allclose(rotation_about_axis(theta, (0, 0, 0), back), about(-theta), atol=1e-15)


@given(theta=angles, first=points_3d, second=points_3d, point=points_3d)
def test_a_rotation_keeps_the_axis_lengths_and_the_hand(
    theta: float, first: Point, second: Point, point: Point
) -> None:
    assume(first != second)
    matrix = rotation_about_axis(theta, first, second)
    turn = matrix[:3, :3]
    np.testing.assert_allclose(turn.T @ turn, np.eye(3), atol=1e-13)
    assert np.linalg.det(turn) == pytest.approx(1, abs=1e-13)
    for place in (first, second):
        np.testing.assert_allclose(moved(matrix, place), place, atol=1e-9)
    before, after = math.dist(point, first), math.dist(moved(matrix, point), first)
    assert after == pytest.approx(before, abs=1e-9)


@given(theta=angles, first=points_3d, second=points_3d)
def test_the_seven_matrices_bring_the_axis_to_z_and_back(theta: float, first: Point, second: Point) -> None:
    assume(first != second)
    steps = axis_steps(theta, first, second)
    names = [step.name for step in steps]
    assert names == ["T(−P_1)", "R_x(α)", "R_y(−β)", "R_z(θ)", "R_y(β)", "R_x(−α)", "T(P_1)"]
    matrices = [step.matrix for step in steps]
    np.testing.assert_allclose(
        product(*matrices[::-1]), rotation_about_axis(theta, first, second), atol=1e-9, rtol=0
    )
    for one, other in zip(matrices, matrices[:3:-1], strict=False):
        np.testing.assert_allclose(one @ other, np.eye(4), atol=1e-12)
    length = math.dist(first, second)
    to_z = product(*matrices[2::-1])
    np.testing.assert_allclose(moved(to_z, first), (0, 0, 0), atol=1e-9)
    np.testing.assert_allclose(moved(to_z, second), (0, 0, length), atol=1e-9)
    in_the_plane = moved(matrices[1] @ matrices[0], second)
    assert abs(in_the_plane[1]) <= 1e-9
    assert in_the_plane[2] >= -1e-9


@pytest.mark.parametrize("second", [(1, 2, 3), (math.inf, 0, 0), (math.nan, 0, 0)])
def test_an_axis_without_direction_is_refused(second: Point) -> None:
    with pytest.raises(ValueError, match="no direction"):
        rotation_about_axis(1.0, (1, 2, 3), second)


@given(place=points_3d, normal=points_3d, point=points_3d)
def test_a_reflection_keeps_its_plane_and_undoes_itself(place: Point, normal: Point, point: Point) -> None:
    assume(max(map(abs, normal)) > 0)
    matrix = reflection_3d(*place, *normal)
    close = 1e-12 * max(1.0, *map(abs, place))
    np.testing.assert_allclose(matrix @ matrix, np.eye(4), atol=close)
    assert np.linalg.det(matrix) == pytest.approx(-1, abs=1e-12)
    np.testing.assert_allclose(moved(matrix, place), place, atol=close)
    image = moved(matrix, point)
    # What joins a point to its image is along the normal, and its middle lies in the plane.
    unit = np.array(normal) / max(map(abs, normal))
    np.testing.assert_allclose(np.cross(image - point, unit), 0, atol=1e-9)
    assert ((image + point) / 2 - place) @ unit == pytest.approx(0, abs=1e-9)


def test_reflections_in_the_planes_of_the_frame_are_exact() -> None:
    assert reflection_3d(0, 0, 0, 0, 0, 7).tolist() == scaling_3d(1, 1, -1).tolist()
    assert reflection_3d(0, 0, 0, 3, 0, 0).tolist() == scaling_3d(-1, 1, 1).tolist()
    assert "-0." not in repr(reflection_3d(0, 0, 0, 0, -3, 0).tolist())
    for bad in ((0, 0, 0), (math.nan, 1, 0), (math.inf, 1, 0)):
        with pytest.raises(ValueError, match="normal"):
            reflection_3d(0, 0, 0, *bad)


@given(point=points_3d, by=points_3d, sx=factors, sy=factors, sz=factors)
def test_what_each_does_to_a_point(point: Point, by: Point, sx: float, sy: float, sz: float) -> None:
    x, y, z = point
    tx, ty, tz = by
    assert moved(translation_3d(tx, ty, tz), point).tolist() == [x + tx, y + ty, z + tz]
    assert moved(scaling_3d(sx, sy, sz), point).tolist() == [sx * x, sy * y, sz * z]
    chain = translation_3d(tx, ty, tz) @ scaling_3d(sx, sy, sz) @ translation_3d(-tx, -ty, -tz)
    np.testing.assert_allclose(scaling_about_3d(sx, sy, sz, tx, ty, tz), chain, atol=1e-10)
    along_z = shear_3d(sh_xz=sx, sh_yz=sy, z_ref=tz)
    np.testing.assert_allclose(moved(along_z, point), (x + sx * (z - tz), y + sy * (z - tz), z), atol=1e-9)


@given(
    point=points_3d,
    reference=points_3d,
    xy=factors,
    xz=factors,
    yx=factors,
    yz=factors,
    zx=factors,
    zy=factors,
)
def test_a_shear_leaves_its_reference_point(
    point: Point, reference: Point, xy: float, xz: float, yx: float, yz: float, zx: float, zy: float
) -> None:
    matrix = shear_3d(xy, xz, yx, yz, zx, zy, *reference)
    np.testing.assert_allclose(moved(matrix, reference), reference, atol=1e-9)
    expected = np.array([[1, xy, xz], [yx, 1, yz], [zx, zy, 1]]) @ np.subtract(point, reference)
    np.testing.assert_allclose(moved(matrix, point), np.array(reference) + expected, atol=1e-9)
    np.testing.assert_allclose(
        transform_points(matrix, np.array([point]))[0], moved(matrix, point), atol=1e-9
    )


@given(x=coordinates, y=coordinates, theta=angles)
def test_about_z_it_is_the_rotation_of_the_plane(x: float, y: float, theta: float) -> None:

    turned = moved(rotation_about(theta, x, y), (3, 4))
    about = rotation_about_axis(theta, (x, y, 0), (x, y, 2))
    np.testing.assert_allclose(moved(about, (3, 4, 5)), (*turned, 5), atol=1e-9)
