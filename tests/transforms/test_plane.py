"""The transformations of the plane: the numbers of the course, and what holds for all numbers."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.transforms.inputs import angles, coordinates, factors, moved, points
from workbench.algorithms.transforms import (
    inverse,
    inverse_of_chain,
    product,
    reflection,
    rotation,
    rotation_about,
    scaling,
    scaling_about,
    shear,
    transform_points,
    translation,
)

Point = tuple[float, float]
QUARTERS = [(1, 0), (0, 1), (-1, 0), (0, -1)]


def test_rotation_about_a_pivot_as_the_course_has_it() -> None:
    matrix = rotation_about(math.radians(45), 3, 3)
    corners = transform_points(matrix, np.array([[5.0, 6], [6, 2], [4, 1]]))
    np.testing.assert_allclose(corners, [(2.2929, 6.5355), (5.8284, 4.4142), (5.1213, 2.2929)], atol=5e-5)


def test_reflection_in_a_line_as_the_course_has_it() -> None:
    np.testing.assert_allclose(moved(reflection(0, 2, math.atan(0.5)), (2, 4)), (2.8, 2.4), atol=1e-12)


def test_a_shear_relative_to_a_base_line_as_the_course_has_it() -> None:
    square = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
    sheared = transform_points(shear(0.5, 0, 0, -1), square)
    assert sheared.tolist() == [[0.5, 0], [1.5, 0], [2, 1], [1, 1]]


def test_moved_and_turned_axes_as_the_course_has_them() -> None:
    axes = product(rotation(math.radians(-30)), translation(-2, -1))
    np.testing.assert_allclose(moved(axes, (5, 5)), (4.5981, 1.9641), atol=5e-5)


@pytest.mark.parametrize("turns", range(-9, 10))
def test_quarter_turns_are_exact(turns: int) -> None:
    cos, sin = QUARTERS[turns % 4]
    for theta in (turns * math.pi / 2, math.radians(90 * turns), turns * math.radians(90)):
        assert rotation(theta).tolist() == [[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]]
        assert "-0." not in repr(rotation(theta).tolist())
    beside = rotation(turns * math.pi / 2 + 1e-9)
    assert 0 < abs(beside[0, 0] - cos) + abs(beside[1, 0] - sin) < 2e-9


def test_halfway_between_quarter_turns_cosine_and_sine_have_one_size() -> None:
    for turns in range(-9, 9):
        matrix = rotation(math.radians(45 + 90 * turns))
        assert (np.abs(matrix[:2, :2]) == math.sqrt(0.5)).all()
        angle = math.radians(45 + 90 * turns)
        np.testing.assert_allclose(matrix[:2, 0], (math.cos(angle), math.sin(angle)), atol=1e-14)


@given(theta=st.floats(-1e9, 1e9))
def test_no_angle_is_taken_for_a_quarter_turn_far_away(theta: float) -> None:
    matrix = rotation(theta)
    assert abs(matrix[0, 0] - math.cos(theta)) <= 1e-12
    assert abs(matrix[1, 0] - math.sin(theta)) <= 1e-12


def test_reflections_in_axes_and_diagonals_are_exact() -> None:
    assert reflection(0, 0, 0).tolist() == [[1, 0, 0], [0, -1, 0], [0, 0, 1]]
    assert reflection(0, 0, math.radians(90)).tolist() == [[-1, 0, 0], [0, 1, 0], [0, 0, 1]]
    assert reflection(0, 0, math.radians(45)).tolist() == [[0, 1, 0], [1, 0, 0], [0, 0, 1]]
    assert reflection(0, 0, math.radians(135)).tolist() == [[0, -1, 0], [-1, 0, 0], [0, 0, 1]]


@given(x=coordinates, y=coordinates, tx=coordinates, ty=coordinates, sx=factors, sy=factors)
def test_what_each_does_to_a_point(x: float, y: float, tx: float, ty: float, sx: float, sy: float) -> None:
    assert moved(translation(tx, ty), (x, y)).tolist() == [x + tx, y + ty]
    assert moved(scaling(sx, sy), (x, y)).tolist() == [sx * x, sy * y]
    np.testing.assert_allclose(
        moved(shear(sx, sy, tx, ty), (x, y)), (x + sx * (y - ty), y + sy * (x - tx)), atol=1e-10, rtol=1e-12
    )


@given(theta=angles, pivot=points, a=points, b=points)
def test_a_rotation_keeps_lengths_angles_and_the_pivot(
    theta: float, pivot: Point, a: Point, b: Point
) -> None:
    matrix = rotation_about(theta, *pivot)
    np.testing.assert_allclose(moved(matrix, pivot), pivot, atol=1e-11)
    before = np.column_stack([np.subtract(a, pivot), np.subtract(b, pivot)])
    turned = matrix[:2, :2] @ before
    close = 1e-12 * max(1.0, np.abs(before).max() ** 2)
    np.testing.assert_allclose(turned.T @ turned, before.T @ before, atol=close)
    assert np.linalg.det(matrix) == pytest.approx(1, abs=1e-12)


@given(theta=angles, pivot=points)
def test_about_a_pivot_is_there_turned_and_back(theta: float, pivot: Point) -> None:
    x, y = pivot
    chain = translation(x, y) @ rotation(theta) @ translation(-x, -y)
    np.testing.assert_allclose(rotation_about(theta, x, y), chain, atol=1e-12 * max(1, abs(x), abs(y)))


@given(sx=factors, sy=factors, fixed=points)
def test_scaling_about_a_point_is_there_scaled_and_back(sx: float, sy: float, fixed: Point) -> None:
    x, y = fixed
    chain = translation(x, y) @ scaling(sx, sy) @ translation(-x, -y)
    close = 1e-14 * max(1, abs(x), abs(y)) * max(1, abs(sx), abs(sy))
    np.testing.assert_allclose(scaling_about(sx, sy, x, y), chain, atol=close)


@given(place=points, angle=angles)
def test_a_reflection_is_there_turned_mirrored_and_back(place: Point, angle: float) -> None:
    x, y = place
    turned = rotation(angle) @ scaling(1, -1) @ rotation(-angle)
    chain = translation(x, y) @ turned @ translation(-x, -y)
    close = 1e-12 * max(1, abs(x), abs(y))
    matrix = reflection(x, y, angle)
    np.testing.assert_allclose(matrix, chain, atol=close)
    np.testing.assert_allclose(matrix @ matrix, np.eye(3), atol=close)
    on_the_line = (x + 3 * math.cos(angle), y + 3 * math.sin(angle))
    np.testing.assert_allclose(moved(matrix, on_the_line), on_the_line, atol=close)
    assert np.linalg.det(matrix) == pytest.approx(-1, abs=1e-12)


links = st.one_of(
    st.builds(translation, coordinates, coordinates),
    st.builds(rotation, angles),
    st.builds(rotation_about, angles, coordinates, coordinates),
    st.builds(reflection, coordinates, coordinates, angles),
    st.builds(scaling, st.sampled_from([-3.0, -1.0, 0.25, 2.0]), st.sampled_from([-1.5, 0.5, 4.0])),
    st.builds(shear, st.floats(-3, 3), st.just(0.0), coordinates, coordinates),
)


@given(chain=st.lists(links, min_size=1, max_size=4), point=points)
def test_the_last_matrix_of_a_product_acts_first(chain: list[np.ndarray], point: Point) -> None:
    matrix = product(*chain)
    place: tuple[float, ...] = point
    for link in reversed(chain):
        place = tuple(moved(link, place))
    close = 1e-11 * max(1.0, np.abs(matrix).max()) * 1e3
    np.testing.assert_allclose(moved(matrix, point), place, atol=close)
    np.testing.assert_allclose(transform_points(matrix, np.array([point]))[0], place, atol=close)


@given(chain=st.lists(links, min_size=1, max_size=4))
def test_the_inverse_brings_back(chain: list[np.ndarray]) -> None:
    matrix = product(*chain)
    for back in (inverse(matrix), inverse_of_chain(*chain)):
        assert back[2].tolist() == [0, 0, 1]
        sizes = np.abs(matrix) @ np.abs(back) + np.abs(back) @ np.abs(matrix)
        assert (np.abs(back @ matrix - np.eye(3)) <= 1e-9 * sizes.max()).all()
    assert inverse_of_chain(translation(5, 3), rotation(math.pi / 2)).tolist() == [
        [0, 1, -3],
        [-1, 0, 5],
        [0, 0, 1],
    ]


@pytest.mark.parametrize("matrix", [scaling(0, 1), scaling(math.nan, 1), np.zeros((3, 3))])
def test_what_cannot_be_undone_is_refused(matrix: np.ndarray) -> None:
    with pytest.raises(ValueError, match="cannot be undone"):
        inverse(matrix)
    with pytest.raises(ValueError, match="cannot be undone"):
        inverse_of_chain(translation(1, 2), matrix)


def test_points_are_divided_by_w_and_infinity_is_refused() -> None:
    matrix = np.array([[1.0, 0, 0], [0, 1, 0], [0, 0.5, 0]])
    assert transform_points(matrix, np.array([[3.0, 4.0], [2.0, -1.0]])).tolist() == [[1.5, 2], [-4, 2]]
    with pytest.raises(ValueError, match="infinity"):
        transform_points(matrix, np.array([[3.0, 0.0]]))
