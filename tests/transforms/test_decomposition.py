"""A matrix taken apart and put together again: any, singular, mirrored, all but singular."""

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.transforms.inputs import angles, coordinates
from workbench.algorithms.transforms import (
    Loss,
    decomposed,
    product,
    recomposed,
    reflection,
    rotation,
    rotation_about,
    scaling,
    shear,
    translation,
)

cells = st.one_of(
    st.integers(-3, 3).map(float),
    st.floats(-1e3, 1e3),
    st.sampled_from([1e-9, 1e-200, 1e200, 1e-320, -1e308]),
)
rows = st.tuples(cells, cells, cells)
sizes = st.one_of(st.floats(0.01, 100.0), st.sampled_from([1.0, 1e-9, 1e9]))
# The product of two smaller ones could not be told from 0
turns = angles.filter(lambda angle: angle == 0 or abs(angle) > 1e-100)


def affine(first: tuple[float, ...], second: tuple[float, ...]) -> np.ndarray:
    return np.array([first, second, (0.0, 0.0, 1.0)])


def assert_recomposed(matrix: np.ndarray) -> None:
    """To a relative 1e-12 of each column, or to the last bits where numbers end."""
    with np.errstate(over="raise", invalid="raise"):
        again = recomposed(decomposed(matrix))
    assert np.isfinite(again).all()
    sizes = np.abs(matrix).max(axis=0)
    sizes[:2] = np.maximum(sizes[:2], 1e-288 * sizes[1::-1])
    assert (np.abs(again - matrix) <= 1e-12 * sizes + 1e-322).all()


@given(first=rows, second=rows)
@example(first=(0.0, 1.0, 0.0), second=(0.0, 1.0, 0.0))
@example(first=(1e-320, 1e308, 0.0), second=(1e-320, 1.0, 0.0))
@example(first=(5e-324, 1.0, 0.0), second=(0.0, 2.0, 0.0))
def test_the_parts_make_the_matrix_again(first: tuple[float, ...], second: tuple[float, ...]) -> None:
    matrix = affine(first, second)
    assert_recomposed(matrix)
    parts = decomposed(matrix)
    assert parts.sx >= 0
    assert parts.loss.mirrored == (parts.sy < 0)
    assert -math.pi <= parts.theta <= math.pi


@given(
    tx=coordinates,
    ty=coordinates,
    theta=st.floats(-3.0, 3.0),
    sx=sizes,
    sy=sizes,
    mirrored=st.booleans(),
    sh=st.floats(-9, 9),
)
def test_what_was_put_together_is_found_again(
    tx: float, ty: float, theta: float, sx: float, sy: float, mirrored: bool, sh: float
) -> None:
    sy = -sy if mirrored else sy
    chain = product(translation(tx, ty), rotation(theta), scaling(sx, sy), shear(sh, 0))
    parts = decomposed(chain)
    assert parts[:2] == (tx, ty)
    assert parts.theta == pytest.approx(theta, abs=1e-12)
    assert parts.sx == pytest.approx(sx, rel=1e-12)
    assert parts.sh == pytest.approx(sh, abs=1e-12 * max(1.0, abs(sy / sx)))
    blur = 1e-12 * (abs(sy) + sx * abs(sh))
    assert parts.sy == pytest.approx(sy, abs=blur)
    if abs(sy) > 1e3 * blur:
        assert parts.loss == Loss(2, mirrored)


def test_the_parts_of_the_simple_ones_are_exact() -> None:
    nothing = Loss(2, False)
    assert decomposed(np.eye(3)) == (0, 0, 0, 1, 1, 0, nothing)
    assert decomposed(translation(3, -4)) == (3, -4, 0, 1, 1, 0, nothing)
    assert decomposed(rotation(math.radians(90))) == (0, 0, math.pi / 2, 1, 1, 0, nothing)
    assert decomposed(scaling(2, 3)) == (0, 0, 0, 2, 3, 0, nothing)
    assert decomposed(shear(0.5, 0)) == (0, 0, 0, 1, 1, 0.5, nothing)
    assert decomposed(scaling(1, -1)) == (0, 0, 0, 1, -1, 0, Loss(2, True))
    assert decomposed(scaling(-1, 1)) == (0, 0, math.pi, 1, -1, 0, Loss(2, True))
    assert decomposed(scaling(-2, -2)) == (0, 0, math.pi, 2, 2, 0, nothing)


@given(x=coordinates, y=coordinates, angle=angles)
def test_a_reflection_mirrors_and_keeps_sizes(x: float, y: float, angle: float) -> None:
    parts = decomposed(reflection(x, y, angle))
    assert parts.loss == Loss(2, True)
    assert (parts.sx, parts.sy) == pytest.approx((1, -1), abs=1e-12)
    assert parts.sh == pytest.approx(0, abs=1e-12)


@given(before=turns, after=turns, pivot=st.tuples(coordinates, coordinates), across=st.booleans())
def test_what_flattens_is_told_through_all_rounding(
    before: float, after: float, pivot: tuple[float, float], across: bool
) -> None:
    flat = scaling(0, 1.7) if across else scaling(1.7, 0)
    chain = product(rotation_about(after, *pivot), flat, rotation(before))
    assert decomposed(chain).loss == Loss(1, False)
    assert_recomposed(chain)


@given(factor=sizes, other=sizes)
def test_very_different_factors_lose_nothing(factor: float, other: float) -> None:
    assert decomposed(scaling(factor, other)).loss == Loss(2, False)
    assert decomposed(affine((factor, factor, 0), (other, 2 * other, 0))).loss == Loss(2, False)
    assert decomposed(affine((factor, other, 0), (factor, 2 * other, 0))).loss == Loss(2, False)


def test_nothing_but_a_point_is_left() -> None:
    assert decomposed(affine((0, 0, 5), (0, 0, 6))) == (5, 6, 0, 0, 0, 0, Loss(0, False))


@pytest.mark.parametrize("gap", [1e-6, 1e-9, 1e-11, -1e-9])
def test_all_but_singular_is_not_singular(gap: float) -> None:
    matrix = affine((1, 1, 0), (1, 1 + gap, 0))
    assert decomposed(matrix).loss == Loss(2, gap < 0)
    assert_recomposed(matrix)


@pytest.mark.parametrize(
    "matrix",
    [np.full((3, 3), math.nan), np.eye(4), np.array([[1.0, 0, 0], [0, 1, 0], [0, 0, 2]]), np.zeros((3, 3))],
)
def test_what_is_not_affine_is_refused(matrix: np.ndarray) -> None:
    with pytest.raises(ValueError, match="0 0 1"):
        decomposed(matrix)
