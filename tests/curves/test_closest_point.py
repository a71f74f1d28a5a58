"""The closest point of a curve: never farther than any dense sample, on the curve, found by every reading."""

import math
from fractions import Fraction
from itertools import pairwise
from math import comb

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.curves import exact
from tests.curves.made_curves import coordinate
from tests.curves.rational_curves import dense_points, pieces_of_any_kind, whole_circle
from workbench.algorithms.curves import Pieces, closest_point, in_rows, natural_cubic, piece_points
from workbench.engine import compiled

ONE = np.array([0.0, 1.0])


@settings(max_examples=150)
@given(pieces_of_any_kind(), coordinate, coordinate)
def test_no_sample_is_closer(pieces: Pieces, x: float, y: float) -> None:
    found = compiled.collect(closest_point, *in_rows(pieces), x, y)
    size = max(exact.size_of(pieces.controls), abs(x), abs(y), 1e-300)
    u, at_x, at_y, distance = found[-1]
    assert np.hypot(*(dense_points(pieces) - [x, y]).T).min() >= distance - 1e-11 * size
    assert distance == pytest.approx(math.hypot(at_x - x, at_y - y), abs=1e-15 * size)
    assert (np.diff(found[:, 3]) < 0).all()
    if pieces.weights is None and (np.diff(pieces.knots) > 0).all():
        apart = np.hypot(*(piece_points(pieces, [u, np.nextafter(u, 0)]) - [at_x, at_y]).T)
        assert apart.min() <= 1e-11 * size


@settings(max_examples=60)
@given(pieces_of_any_kind(), coordinate, coordinate)
def test_each_point_lies_on_the_curve_at_its_u(pieces: Pieces, x: float, y: float) -> None:
    """In fractions; where pieces meet without joining, at the end of one or the start of the other."""
    if pieces.weights is not None:
        # Beside weights a million apart the curve runs from end to end within one step of u.
        pieces = pieces._replace(weights=np.clip(pieces.weights, 1e-3, 1e3))
    found = compiled.collect(closest_point, *in_rows(pieces), x, y)
    assert (np.diff(found[:, 3]) < 0).all()
    size = max(exact.size_of(pieces.controls), abs(x), abs(y), 1e-300)
    degree = pieces.controls.shape[1] - 1
    for u, at_x, at_y, distance in found.tolist():
        assert distance == pytest.approx(math.hypot(at_x - x, at_y - y), abs=1e-15 * size)
        apart = []
        for j, (begin, end) in enumerate(pairwise(pieces.knots.tolist())):
            if begin <= u <= end:
                v = (
                    (Fraction(u) - Fraction(begin)) / (Fraction(end) - Fraction(begin))
                    if begin < end
                    else Fraction(0)
                )
                shares = [comb(degree, i) * v**i * (1 - v) ** (degree - i) for i in range(degree + 1)]
                if pieces.weights is not None:
                    shares = [
                        s * Fraction(w) for s, w in zip(shares, pieces.weights[j].tolist(), strict=True)
                    ]
                points = exact.fractions(pieces.controls[j])
                where = [
                    sum(s * p[k] for s, p in zip(shares, points, strict=True)) / sum(shares) for k in (0, 1)
                ]
                apart.append(max(abs(where[0] - Fraction(at_x)), abs(where[1] - Fraction(at_y))))
        assert min(apart) <= 1e-7 * size


@pytest.mark.parametrize("heavy", [1e3, 1e8, 1e16])
def test_beside_a_heavy_weight_both_ways_to_it_are_searched(heavy: float) -> None:
    corners = np.array([[[0, 1], [0, 0], [0, -3], [0, 0], [0, 1]]], float)
    pieces = Pieces(ONE, corners, np.array([[1e-9, 1e-9, heavy * 1e-9, 1e-9, 1e-9]]))
    assert compiled.collect(closest_point, *in_rows(pieces), 0.0, -1.0)[-1, 3] <= 1e-7


@settings(max_examples=60)
@given(pieces_of_any_kind(most=1, rational=False), st.floats(0, 1))
def test_a_point_of_the_curve_is_found_again(pieces: Pieces, u: float) -> None:
    x, y = piece_points(pieces, u).tolist()
    found = compiled.collect(closest_point, *in_rows(pieces), x, y)
    assert found[-1, 3] <= 1e-12 * max(exact.size_of(pieces.controls), 1e-300)


@given(st.floats(-9, 9), st.floats(-9, 9))
def test_of_a_circle_it_lies_towards_the_point(x: float, y: float) -> None:
    found = compiled.collect(closest_point, *in_rows(whole_circle()), x, y)
    assert found[-1, 3] == pytest.approx(abs(math.hypot(x - 1, y - 2) - 3), abs=1e-12)


def test_the_centre_of_a_circle_is_as_far_from_all_of_it() -> None:
    found = compiled.collect(closest_point, *in_rows(whole_circle()), 1.0, 2.0)
    assert found[-1, 3] == pytest.approx(3, rel=1e-12)
    assert len(found) < 20


def test_it_is_that_of_dense_samples_on_a_long_curve() -> None:
    pieces = natural_cubic(np.random.default_rng(8).uniform(0, 9, (30, 2)))
    dense = piece_points(pieces, np.linspace(pieces.knots[0], pieces.knots[-1], 400_001))
    for x, y in np.random.default_rng(9).uniform(-1, 10, (40, 2)).tolist():
        least = np.hypot(*(dense - [x, y]).T).min()
        found = compiled.collect(closest_point, *in_rows(pieces), x, y)[-1]
        assert least - 1e-4 <= found[3] <= least + 1e-12


def test_a_curve_in_one_place_and_one_without_length() -> None:
    still = in_rows(Pieces(ONE, np.ones((1, 4, 2))))
    assert list(closest_point(*still, 4.0, 5.0)) == [(0.0, 1.0, 1.0, 5.0)]
    short = in_rows(Pieces(np.array([2.0, 2.0]), np.array([[[0.0, 0], [9, 9]]])))
    assert compiled.collect(closest_point, *short, 3.0, 4.0)[-1, 3] <= 5
