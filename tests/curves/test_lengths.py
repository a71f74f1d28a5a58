"""Lengths against SciPy's quadrature and curves whose lengths are known."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from tests.curves import exact
from tests.curves.rational_curves import pieces_of_any_kind, whole_circle
from workbench.algorithms.curves import (
    Pieces,
    arc_length,
    at_length,
    curvature,
    derivatives,
    equal_lengths,
    piece_points,
)

ONE = np.array([0.0, 1.0])


def test_known_lengths() -> None:
    assert arc_length(whole_circle()) == pytest.approx(6 * math.pi, rel=1e-12)
    assert arc_length(whole_circle(), 0.5, 3.5) == pytest.approx(4.5 * math.pi, rel=1e-12)
    semicubical = Pieces(np.array([-1.0, 1.0]), np.array([[[1, -1], [-1 / 3, 1], [-1 / 3, -1], [1, 1]]]))
    assert piece_points(semicubical, 0.5).tolist() == pytest.approx([0.25, 0.125])
    assert arc_length(semicubical) == pytest.approx(2 * (13**1.5 - 8) / 27, rel=1e-9)
    there_and_back = Pieces(ONE, np.array([[[0.0, 0], [8, 0], [8, 0], [0, 0]]]))
    assert arc_length(there_and_back) == pytest.approx(12, rel=1e-9)
    assert arc_length(there_and_back, 0.0, 0.5) == pytest.approx(6, rel=1e-9)


@settings(max_examples=60)
@given(pieces_of_any_kind(most=2, degrees=(1, 4)), st.floats(0, 1), st.floats(0, 1))
def test_the_length_is_the_integral_of_the_speed(pieces: Pieces, one: float, other: float) -> None:
    if pieces.weights is not None:
        pieces = Pieces(pieces.knots, pieces.controls, np.clip(pieces.weights, 0.05, 20))
    first, last = sorted((one * pieces.knots[-1], other * pieces.knots[-1]))
    size = max(exact.size_of(pieces.controls), 1e-300)
    inner = [float(k) for k in pieces.knots if first < k < last]

    def speed(u: float) -> float:
        return float(np.hypot(*derivatives(pieces, u, 1)[1]))

    # A curve may turn back near an end of a piece, where an integrator at large would not see it.
    nearer = 0.5 ** np.arange(1, 16)
    grades = np.unique([0.0, *nearer, *(1.0 - nearer), 1.0])
    spans = [
        span
        for a, b in zip([first, *inner], [*inner, last], strict=True)
        for span in pairwise((a + (b - a) * grades).tolist())
    ]
    truth, slack = np.sum([quad(speed, a, b, limit=400, epsabs=1e-12 * size) for a, b in spans], axis=0)
    assert arc_length(pieces, first, last) == pytest.approx(truth, rel=2e-9, abs=2 * slack + 1e-11 * size)


@given(pieces_of_any_kind())
def test_a_length_is_never_less_than_the_chords_nor_more_than_the_polygons(pieces: Pieces) -> None:
    if pieces.weights is not None:
        pieces = Pieces(pieces.knots, pieces.controls, np.clip(pieces.weights, 1e-3, 1e3))
    found = arc_length(pieces)
    kept = pieces.controls[np.diff(pieces.knots) > 0]
    size = exact.size_of(pieces.controls)
    assert found <= np.sqrt((np.diff(kept, axis=1) ** 2).sum(axis=2)).sum() * (1 + 1e-9) + 1e-12 * size
    chords = np.sqrt(((kept[:, -1] - kept[:, 0]) ** 2).sum(axis=1)).sum()
    assert found >= chords * (1 - 1e-9) - 1e-12 * size


@given(st.floats(1e-6, 1e6), st.floats(0, 1))
def test_a_curve_that_turns_back_is_measured_there_and_back(height: float, where: float) -> None:
    turning = Pieces(np.array([0.0, 1.0]), np.array([[[0.0, 0.0], [0.0, -where], [0.0, height]]]))
    # y = a u^2 - 2 w u falls to -w^2 / a, and rises from there
    low = where**2 / (height + 2 * where)
    assert arc_length(turning) == pytest.approx(height + 2 * low, rel=1e-9)


@settings(max_examples=40)
@given(pieces_of_any_kind(), st.integers(2, 9))
def test_equal_steps_are_equally_long(pieces: Pieces, count: int) -> None:
    if pieces.weights is not None:
        pieces = Pieces(pieces.knots, pieces.controls, np.clip(pieces.weights, 0.01, 100))
    u = equal_lengths(pieces, count)
    whole = arc_length(pieces)
    assert (u[0], u[-1]) == (pieces.knots[0], pieces.knots[-1])
    assert (np.diff(u) >= -1e-12).all()
    if whole > 1e-6 * exact.size_of(pieces.controls):
        steps = [
            arc_length(pieces, max(a, 0.0), b) for a, b in zip(u, np.maximum(u[1:], u[:-1]), strict=False)
        ]
        assert steps == pytest.approx([whole / (count - 1)] * (count - 1), rel=1e-6, abs=1e-8 * whole)


@given(st.floats(-1, 20))
def test_a_length_is_found_again(along: float) -> None:
    u = float(at_length(whole_circle(), along))
    asked = min(max(along, 0.0), 6 * math.pi)
    assert arc_length(whole_circle(), 0.0, u) == pytest.approx(asked, rel=1e-9, abs=1e-12)


@given(pieces_of_any_kind(rational=True))
def test_any_weights_have_finite_lengths(pieces: Pieces) -> None:
    u = equal_lengths(pieces, 7)
    assert np.isfinite(u).all()
    assert math.isfinite(arc_length(pieces, float(u[2]), max(float(u[2]), float(u[5]))))


def test_a_curve_in_one_place_has_no_length() -> None:
    still = Pieces(ONE, np.ones((1, 4, 2)))
    assert arc_length(still) == 0
    assert np.isfinite(equal_lengths(still, 5)).all()


def test_what_is_not_on_the_curve_is_refused() -> None:
    with pytest.raises(ValueError, match="From u = 1 to 5 is not along the curve, 0 to 4"):
        arc_length(whole_circle(), 1, 5)
    with pytest.raises(ValueError, match="1 points make no step; ask for 2 or more"):
        equal_lengths(whole_circle(), 1)


@given(pieces_of_any_kind(most=2), st.floats(-3, 3), st.sampled_from([1e-6, 0.5, 1e6]))
def test_measures_go_with_what_is_done_to_the_points(pieces: Pieces, angle: float, scale: float) -> None:
    turn = scale * np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    turned = pieces._replace(controls=pieces.controls @ turn)
    size = max(exact.size_of(pieces.controls), 1e-90)
    before, after = arc_length(pieces), arc_length(turned)
    assert after == pytest.approx(scale * before, rel=1e-8, abs=1e-9 * scale * size)
    u = 0.37 * float(pieces.knots[-1])
    speed = float(np.hypot(*derivatives(pieces, u)[1]))
    if speed > 1e-3 * size:
        bend = float(curvature(pieces, u))
        assert scale * float(curvature(turned, u)) == pytest.approx(bend, rel=1e-6, abs=1e-5 / size)
