"""Curves as chains of chords: every kind, any weights, parted and without length, within the tolerance."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.curves import exact
from tests.curves.rational_curves import dense_points, pieces_of_any_kind, whole_circle
from tests.curves.test_whole_curves import distance_to_chain
from workbench.algorithms.curves import (
    Pieces,
    b_spline_to_bezier,
    chord_counts,
    distances,
    natural_cubic,
    polyline,
)


@settings(max_examples=40)
@given(pieces_of_any_kind(degrees=(1, 6)), st.sampled_from([1e-3, 0.02, 0.3]))
def test_a_chain_is_within_the_tolerance(pieces: Pieces, part: float) -> None:
    size = max(exact.size_of(pieces.controls), 1e-3)
    chain = polyline(pieces, part * size)
    off = distance_to_chain(dense_points(pieces, 100), chain)
    assert off.max() <= part * size * (1 + 1e-9) + 1e-12 * size
    assert distances(pieces, chain[:: max(len(chain) // 20, 1)]).max() <= 1e-7 * size
    kept = np.diff(pieces.knots) > 0
    ends = pieces.controls[kept][[0, -1], [0, -1]]
    assert np.abs(chain[[0, -1]] - ends).max() <= 1e-15 * size


@pytest.mark.parametrize("weighted", [False, True])
def test_a_parted_curve_is_followed_to_the_end_of_each_part(weighted: bool) -> None:
    points = np.array([[0, 0], [1, 4], [2, 0], [5, 5], [6, 9], [7, 5]], float)
    pieces = b_spline_to_bezier(points, np.array([0, 0, 0, 1, 1, 1, 2, 2, 2.0]), 2)
    if weighted:
        pieces = pieces._replace(weights=np.ones((2, 3)))
    chain = polyline(pieces, 0.5).tolist()
    assert chain.index([2, 0]) + 1 == chain.index([5, 5])


def test_chords_are_no_more_than_the_bend_asks_for() -> None:
    straight = Pieces(np.array([0.0, 1]), np.array([[[0.0, 0], [1, 1], [2, 2], [3, 3]]]))
    assert chord_counts(straight, 1e-9).tolist() == [1]
    for tolerance in (1.0, 0.1):
        pieces = natural_cubic(np.random.default_rng(6).uniform(0, 100, (12, 2)))
        chain = polyline(pieces, tolerance)
        coarser = distance_to_chain(dense_points(pieces, 60), chain[::3])
        assert coarser.max() > tolerance
    assert len(polyline(whole_circle(), 0.01)) < 100


@pytest.mark.parametrize("count", [7, 20, 400])
def test_of_a_parabola_no_chord_can_be_spared(count: int) -> None:
    """Its second derivative is 8 everywhere, so n chords are off by 1 / n^2."""
    parabola = Pieces(np.array([0.0, 1.0]), np.array([[[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]]))
    tolerance = 1.001 / count**2
    assert chord_counts(parabola, tolerance).tolist() == [count]
    assert chord_counts(parabola._replace(weights=np.full((1, 3), 2.0)), tolerance).min() >= count


@pytest.mark.parametrize("tolerance", [0.0, -1.0, np.nan])
def test_no_tolerance_is_refused(tolerance: float) -> None:
    with pytest.raises(ValueError, match=r"tolerance is .*; choose a finite one above 0"):
        polyline(whole_circle()._replace(weights=None), tolerance)
