"""Derivatives and hodographs against fractions, and joints of rational pieces."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.curves import exact
from tests.curves.made_curves import Array, part_of_one, point_lists, weight
from tests.curves.rational_curves import exact_derivatives, pieces_of_any_kind, whole_circle
from workbench.algorithms.curves import (
    Pieces,
    derivatives,
    homogeneous,
    joints,
    located,
    piece_derivative,
    piece_points,
    projected,
)


@given(point_lists(2, 6), part_of_one, st.integers(0, 7))
def test_plain_derivatives_are_exact_to_rounding(points: Array, v: float, order: int) -> None:
    pieces = Pieces(np.array([2.0, 6.0]), points[None])
    found = derivatives(pieces, 2.0 + 4.0 * v, order)
    truth = exact_derivatives(
        points, np.ones(len(points)), Fraction(2.0 + 4.0 * v) / 4 - Fraction(1, 2), order
    )
    for r in range(order + 1):
        size = exact.size_of(points) * (2 * len(points)) ** r
        exact.close(found[r], [part / 4**r for part in truth[r]], size)


@given(point_lists(2, 5), st.data(), part_of_one)
def test_rational_derivatives_bear_any_weights(points: Array, data: st.DataObject, v: float) -> None:
    weights = np.array(data.draw(st.lists(weight, min_size=len(points), max_size=len(points))))
    found = derivatives(Pieces(np.array([0.0, 1.0]), points[None], weights[None]), v, 2)
    truth = exact_derivatives(points, weights, v, 2)
    speed = max(
        1.0, *(abs(float(x)) for row in exact_derivatives(np.eye(len(points)), weights, v, 2) for x in row)
    )
    for r in range(3):
        exact.close(found[r], truth[r], exact.size_of(points) * speed**r)


@given(pieces_of_any_kind(), part_of_one)
def test_the_hodograph_is_the_derivative_of_every_kind(pieces: Pieces, part: float) -> None:
    u = part * pieces.knots[-1]
    first = derivatives(pieces, u, 1)
    assert np.isfinite(first).all()
    assert first[0] == pytest.approx(piece_points(pieces, u), abs=1e-12 * exact.size_of(pieces.controls))
    made = piece_derivative(pieces)
    assert made.degree == (pieces.degree - 1 if pieces.weights is None else 2 * pieces.degree)
    size = max(exact.size_of(made.controls), 1e-300)
    assert np.abs(piece_points(made, u) - first[1]).max() <= 1e-11 * size


def test_each_u_is_found_in_a_piece_with_a_length() -> None:
    knots = np.array([0.0, 0, 1, 1, 3, 3])
    number, v, length = located(knots, [-1, 0, 0.5, 1, 2, 3, 4])
    assert number.tolist() == [1, 1, 1, 3, 3, 3, 3]
    assert v.tolist() == [-1, 0, 0.5, 0, 0.5, 1, 1.5]
    assert length.tolist() == [1, 1, 1, 2, 2, 2, 2]
    assert [float(found) for found in located(np.array([2.0, 2.0]), 2.0)] == [0, 0, 1]


def test_the_hodograph_of_a_plain_piece_is_its_scaled_legs() -> None:
    points = np.array([[[0, 0], [1, 2], [3, 3], [5, 3]]], float)
    made = piece_derivative(Pieces(np.array([1.0, 3.0]), points))
    assert made.controls.tolist() == [[[1.5, 3], [3, 1.5], [3, 0]]]


def test_the_quarters_of_a_circle_join_in_curvature() -> None:
    found = joints(whole_circle(), closed=True)
    assert [joint.geometric for joint in found] == ["G2"] * 4
    assert max(joint.g2 for joint in found) <= 1e-15


@given(pieces_of_any_kind(most=3, degrees=(2, 4), rational=True), st.sampled_from([0.25, 0.5]))
def test_a_rational_piece_that_was_cut_joins_in_curvature(pieces: Pieces, v: float) -> None:
    assume(np.ptp(pieces.controls[0], axis=0).max() > 1e-3 * np.abs(pieces.controls[0]).max())
    whole = homogeneous(pieces.controls[0], np.clip(pieces.weights[0], 0.1, 10))  # type: ignore[index]
    level, first, second = whole, [whole[0]], [whole[-1]]
    while len(level) > 1:
        level = (1 - v) * level[:-1] + v * level[1:]
        first.append(level[0])
        second.append(level[-1])
    cut = Pieces(np.array([0.0, v, 1.0]), *projected(np.array([first, second[::-1]])))
    (joint,) = joints(cut, tolerance=1e-7)
    assert joint.parametric == "C2"


def test_a_joint_passes_over_a_piece_without_length() -> None:
    line = np.array([[[0, 0], [1, 0]], [[1, 0], [1, 0]], [[1, 0], [2, 1]]], float)
    (joint,) = joints(Pieces(np.array([0.0, 1, 1, 2]), line))
    assert joint.geometric == "G0"
    assert joint.g1 == pytest.approx(math.pi / 4)


def test_a_negative_order_is_refused() -> None:
    with pytest.raises(ValueError, match="order is -1; it must be 0 or more"):
        derivatives(whole_circle(), 0.5, -1)
