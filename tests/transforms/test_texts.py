"""What holds of the texts that multiply matrices and carry points, against exact fractions and NumPy."""

import math
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.algorithms.runs import arguments
from tests.transforms.inputs import moved
from workbench.algorithms import catalogue
from workbench.algorithms.numerals import numeral
from workbench.algorithms.transforms import (
    axis_steps,
    matrix_product,
    product,
    rotate_about_axis,
    rotation,
    rotation_about,
    rotation_about_axis,
    rotation_by_quaternion,
    transform_point,
    transform_points,
    translation,
)
from workbench.engine.observation import Steps
from workbench.engine.recorder import record
from workbench.geometry.quaternions import quaternion_about, quaternion_matrix, quaternion_product, rotated

EPS = 2.0**-52
SMALLEST = Fraction(1, 2**1020)  # products end there
Pair = tuple[np.ndarray, np.ndarray]
products = arguments(catalogue.get("matrix_product"))
images = arguments(catalogue.get("transform_point"))
turns = arguments(catalogue.get("rotate_about_axis"))


def multiplied(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The matrix whose cells the text emits, row by row."""
    cells = list(matrix_product(a, b))
    assert [cell[:2] for cell in cells] == [(i, j) for i in range(len(a)) for j in range(b.shape[1])]
    return np.array([value for *_place, value in cells]).reshape(len(a), b.shape[1])


def rows_of(slug: str, *run: object) -> list[tuple[object, ...]]:
    entry = catalogue.get(slug)
    return [step.row for step in list(Steps(entry, record(entry.function, *run)))[1:]]


@given(pair=products)
def test_a_product_is_that_of_exact_fractions(pair: Pair) -> None:
    a, b = pair
    result = multiplied(a, b)
    np.testing.assert_allclose(result, a @ b, rtol=1e-12, atol=1e-9)
    for (i, j), value in np.ndenumerate(result):
        terms = [Fraction(x) * Fraction(y) for x, y in zip(a[i].tolist(), b[:, j].tolist(), strict=True)]
        assert abs(Fraction(float(value)) - sum(terms)) <= 8 * EPS * sum(map(abs, terms)) + SMALLEST


@given(pair=products)
def test_the_identity_changes_nothing(pair: Pair) -> None:
    a, _b = pair
    assert np.array_equal(multiplied(np.eye(len(a)), a), a)
    assert np.array_equal(multiplied(a, np.eye(a.shape[1])), a)


@given(pair=products, data=st.data())
def test_products_may_be_taken_in_any_order_of_working(pair: Pair, data: st.DataObject) -> None:
    a, b = pair
    cells = st.floats(-9, 9)
    c = np.array([[data.draw(cells), data.draw(cells)] for _row in range(b.shape[1])])
    sizes = np.abs(a) @ np.abs(b) @ np.abs(c)
    left, right = multiplied(multiplied(a, b), c), multiplied(a, multiplied(b, c))
    assert (np.abs(left - right) <= 64 * EPS * sizes + 1e-300).all()


def test_the_chain_of_the_course_is_multiplied_out_from_the_right() -> None:
    theta = math.radians(45)
    chain = multiplied(translation(3, 3), multiplied(rotation(theta), translation(-3, -3)))
    np.testing.assert_allclose(chain, rotation_about(theta, 3, 3), atol=1e-15)
    assert not np.allclose(multiplied(translation(-3, -3), rotation(theta)), rotation_about(theta, 3, 3))


def test_the_hand_table_has_the_factors_and_their_sum() -> None:
    rows = rows_of(
        "matrix_product", np.array([[0.0, -1, 6], [1, 0, 0], [0, 0, 1]]), np.array([[5.0], [6], [1]])
    )
    assert rows == [
        ("1, 1", "0·5 + (−1)·6 + 6·1", 0.0),
        ("2, 1", "1·5 + 0·6 + 0·1", 5.0),
        ("3, 1", "0·5 + 0·6 + 1·1", 1.0),
    ]


def test_the_factors_of_the_hand_table_have_four_decimals_and_small_ones_stay() -> None:
    rows = rows_of("matrix_product", np.array([[math.sqrt(0.5), -3e-7]]), np.array([[-4.2426406871], [1.0]]))
    assert rows[0][:2] == ("1, 1", "0.7071·(−4.2426) + (−3e−07)·1")


@given(pair=products)
def test_who_is_asked_first_finds_the_sum_among_others(pair: Pair) -> None:
    entry = catalogue.get("matrix_product")
    for step in list(Steps(entry, record(entry.function, *pair)))[1:]:
        assert 2 <= len(step.options) <= 3
        assert step.options.count(step.answer) == 1
        assert step.answer == numeral(step.row[-1])


@pytest.mark.parametrize(
    ("a", "b"), [(np.eye(3), np.eye(4)), (np.eye(3), np.ones((1, 3))), (np.ones((2, 0)), np.ones((0, 2)))]
)
def test_matrices_that_do_not_fit_are_refused(a: np.ndarray, b: np.ndarray) -> None:
    with pytest.raises(ValueError, match="as many columns"):
        list(matrix_product(a, b))


@given(pair=images)
def test_a_point_is_the_matrix_times_its_column(pair: Pair) -> None:
    matrix, point = pair
    first, *divided = transform_point(matrix, point)
    column = matrix @ [*point, 1.0]
    close = 1e-12 * max(1.0, np.abs(matrix).max() * max(1.0, np.abs(point).max()))
    np.testing.assert_allclose(first, column, atol=close, rtol=0)
    w = first[2]
    assert len(divided) == (w not in (0.0, 1.0))
    if divided:
        assert divided[0] == (first[0] / w, first[1] / w, 1.0)


@given(pair=images)
def test_under_an_affine_matrix_nothing_is_divided(pair: Pair) -> None:
    matrix, point = pair
    matrix[2] = 0.0, 0.0, 1.0
    ((x, y, w),) = transform_point(matrix, point)
    assert w == 1.0
    (image,) = transform_points(matrix, point[np.newaxis])
    np.testing.assert_allclose((x, y), image, rtol=1e-12, atol=1e-9)


@given(pair=images, factor=st.sampled_from([-3.0, 0.1, 7.0]))
def test_a_multiple_of_a_matrix_is_the_same_transformation(pair: Pair, factor: float) -> None:
    matrix, point = pair
    matrix[2] = 0.0, 0.0, 1.0
    *_first, (x, y, w) = transform_point(factor * matrix, point)
    ((x_once, y_once, _w),) = transform_point(matrix, point)
    close = 1e-12 * max(1.0, np.abs(matrix).max() * max(1.0, np.abs(point).max()))
    assert w == 1.0
    np.testing.assert_allclose((x, y), (x_once, y_once), atol=close)


def test_the_corners_of_the_course_through_the_text() -> None:
    matrix = rotation_about(math.radians(45), 3, 3)
    for corner, image in (((5, 6), (2.2929, 6.5355)), ((6, 2), (5.8284, 4.4142)), ((4, 1), (5.1213, 2.2929))):
        ((x, y, _w),) = transform_point(matrix, np.array(corner, float))
        assert (x, y) == pytest.approx(image, abs=5e-5)


def test_a_point_and_a_matrix_that_do_not_fit_are_refused() -> None:
    for matrix, point in ((np.eye(4), np.zeros(2)), (np.eye(3), np.zeros(3)), (np.ones((3, 2)), np.zeros(2))):
        with pytest.raises(ValueError, match="3 rows and 3 columns"):
            list(transform_point(matrix, point))


def split(turn: tuple[float, ...]) -> tuple[float, tuple[float, ...], tuple[float, ...], tuple[float, ...]]:
    return turn[0], turn[1:4], turn[4:7], turn[7:]


@given(turn=turns)
def test_the_seven_steps_are_the_product_of_seven_matrices(turn: tuple[float, ...]) -> None:
    theta, point, first, second = split(turn)
    places = [point, *rotate_about_axis(*turn)]
    steps = axis_steps(theta, first, second)
    assert len(places) == len(steps) + 1 == 8
    for (before, after), step in zip(pairwise(places), steps, strict=True):
        np.testing.assert_allclose(moved(step.matrix, before), after, atol=1e-11)
    np.testing.assert_allclose(
        moved(product(*(step.matrix for step in reversed(steps))), point), places[-1], atol=1e-10
    )
    np.testing.assert_allclose(
        moved(rotation_about_axis(theta, first, second), point), places[-1], atol=1e-10
    )


@given(turn=turns)
def test_the_seven_steps_are_the_quaternion(turn: tuple[float, ...]) -> None:
    theta, point, first, second = split(turn)
    *_steps, last = rotate_about_axis(*turn)
    np.testing.assert_allclose(moved(rotation_by_quaternion(theta, first, second), point), last, atol=1e-10)
    along = np.subtract(second, first)
    axis = tuple((along / np.linalg.norm(along)).tolist())
    arm = tuple(np.subtract(point, first).tolist())
    about = rotated(quaternion_about(theta, axis), arm)  # type: ignore[arg-type]
    np.testing.assert_allclose(np.add(about, first), last, atol=1e-10)
    np.testing.assert_allclose(
        rotation_by_quaternion(theta, first, second), rotation_about_axis(theta, first, second), atol=1e-10
    )


@given(turn=turns)
def test_the_point_stays_as_far_from_the_axis(turn: tuple[float, ...]) -> None:
    theta, point, first, second = split(turn)
    *_steps, last = rotate_about_axis(*turn)
    along = np.subtract(second, first)
    unit = along / np.linalg.norm(along)
    before, after = np.subtract(point, first), np.subtract(last, first)
    assert after @ unit == pytest.approx(before @ unit, abs=1e-10)
    feet = [arm - (arm @ unit) * unit for arm in (before, after)]
    assert np.linalg.norm(feet[1]) == pytest.approx(np.linalg.norm(feet[0]), abs=1e-10)
    # It turns to the left, seen with the axis pointing at the eye
    size = feet[0] @ feet[0]
    assert feet[0] @ feet[1] == pytest.approx(size * math.cos(theta), abs=1e-9 * max(size, 1.0))
    assert np.cross(feet[0], feet[1]) @ unit == pytest.approx(
        size * math.sin(theta), abs=1e-9 * max(size, 1.0)
    )


@given(one=turns, other=turns)
def test_quaternions_multiply_as_their_matrices_do(one: tuple[float, ...], other: tuple[float, ...]) -> None:
    p, q = (
        quaternion_about(turn[0], tuple((np.array(turn[1:4]) / (np.linalg.norm(turn[1:4]) or 1)).tolist()))
        for turn in (one, other)
    )
    together = quaternion_matrix(quaternion_product(p, q))
    np.testing.assert_allclose(together, quaternion_matrix(p) @ quaternion_matrix(q), atol=1e-14)


def test_no_quaternion_is_refused_but_what_is_no_rotation() -> None:
    np.testing.assert_allclose(quaternion_matrix((1e-200, 0, 0, 1e-200)), [[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    for bad in ((0.0, 0.0, 0.0, 0.0), (math.nan, 0.0, 0.0, 1.0), (1.0, math.inf, 0.0, 0.0)):
        with pytest.raises(ValueError, match="not a rotation"):
            quaternion_matrix(bad)


def test_the_hand_table_of_a_turn_names_its_seven_matrices() -> None:
    rows = rows_of("rotate_about_axis", *catalogue.get("rotate_about_axis").example)
    assert [row[:2] for row in rows] == [
        *((1, "T(−P_1)"), (2, "R_x(α)"), (3, "R_y(−β)"), (4, "R_z(θ)")),
        *((5, "R_y(β)"), (6, "R_x(−α)"), (7, "T(P_1)")),
    ]
    assert rows[-1][2:] == pytest.approx((0.7778, 2.2222, 0.8889), abs=5e-5)


def test_a_turn_about_no_axis_is_refused() -> None:
    with pytest.raises(ValueError, match="no direction"):
        list(rotate_about_axis(1.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 1.0, 2.0, 3.0))
