"""Inflections: between two of them the exact curvature keeps its sign."""

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings

from tests.curves import exact
from tests.curves.rational_curves import exact_derivatives, pieces_of_any_kind, whole_circle
from workbench.algorithms.curves import Pieces, curvature, inflections, natural_cubic

ONE = np.array([0.0, 1.0])
S = np.array([[0, 0], [1, 1], [1, -1], [2, 0]], float)


@settings(max_examples=60)
@given(pieces_of_any_kind(most=1, degrees=(2, 5)))
def test_between_inflections_the_sign_stays(pieces: Pieces) -> None:
    weights = np.ones(pieces.degree + 1) if pieces.weights is None else np.clip(pieces.weights[0], 0.05, 20)
    whole = Pieces(pieces.knots, pieces.controls, None if pieces.weights is None else weights[None])
    found = inflections(whole)
    size = max(exact.size_of(pieces.controls), 1e-300)
    for left, right in pairwise([0.0, *found, 1.0]):
        signs = set()
        for part in (0.05, 0.4, 0.6, 0.95):
            _point, first, second = exact_derivatives(
                pieces.controls[0], weights, left + part * (right - left), 2
            )
            turn = first[0] * second[1] - first[1] * second[0]
            if abs(turn) > Fraction(size * size * 1e-6):
                signs.add(turn > 0)
        assert len(signs) <= 1


def test_an_s_has_one_whatever_its_weights() -> None:
    assert inflections(Pieces(ONE, S[None])) == pytest.approx([0.5], abs=1e-12)
    for outer in (1e-9, 1e9):
        weights = np.array([[outer, 1, 1, outer]])
        assert inflections(Pieces(ONE, S[None], weights)) == pytest.approx([0.5], abs=1e-9)


def test_circles_lines_and_corners_have_none() -> None:
    assert len(inflections(whole_circle())) == 0
    assert len(inflections(Pieces(ONE, np.array([[[0.1, 0.1], [0.2, 0.2], [0.7, 0.7], [3.3, 3.3]]])))) == 0
    corner = np.array([[[0, 0], [1, 1], [2, 0]], [[2, 0], [3, -1], [3, 2]]], float)
    assert len(inflections(Pieces(np.arange(3.0), corner))) == 1
    turned = np.array([[[0, 0], [1, 1], [2, 0]], [[2, 0], [3, 1], [4, 3]]], float)
    assert len(inflections(Pieces(np.arange(3.0), turned))) == 0


def test_where_pieces_join_smoothly_the_change_is_at_the_knot() -> None:
    arcs = np.array([[[0, 0], [1, 1], [2, 0]], [[2, 0], [3, -1], [4, 0]]], float)
    assert inflections(Pieces(np.array([0.0, 2, 3]), arcs)).tolist() == [2]


def test_a_thousand_points_have_as_many_as_dense_samples_show() -> None:
    pieces = natural_cubic(np.random.default_rng(4).uniform(0, 9, (1000, 2)))
    inner = np.linspace(pieces.knots[0], pieces.knots[-1], 300_001)[1:-1]
    assert len(inflections(pieces)) == np.count_nonzero(np.diff(np.sign(curvature(pieces, inner))))
