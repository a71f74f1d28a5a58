"""Knots taken out: insertion undone, the error a bound, as often as the tolerance allows; against SciPy."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.interpolate import BSpline, insert

from workbench.algorithms.curves import (
    b_spline_point,
    circle,
    gap_between,
    homogeneous,
    insert_knot,
    multiplicity,
    open_uniform_knots,
    projected,
    remove_knot,
)

places = st.floats(-50, 50, allow_subnormal=False)


@st.composite
def splines(draw: st.DrawFn) -> tuple[np.ndarray, np.ndarray, int]:
    """Points, knots and degree of a B-spline, whose knots inside may be repeated and lie near one another."""
    degree = draw(st.integers(1, 5))
    inner = np.cumsum(draw(st.lists(st.sampled_from([0.0, 0.01, 0.5, 1.0, 3.0]), min_size=1, max_size=6)))
    inner = inner[inner > 0]
    assume(all(multiplicity(inner, u) < degree for u in inner))
    ends = [0.0] * (degree + 1), [float(inner[-1] if len(inner) else 0.0) + 1.0] * (degree + 1)
    knots = np.concatenate([ends[0], inner, ends[1]])
    count = len(knots) - degree - 1
    rows = draw(st.lists(st.tuples(places, places), min_size=count, max_size=count))
    return np.array(rows), knots, degree


@given(splines(), st.floats(0.02, 0.98), st.integers(1, 3))
def test_knots_that_were_put_in_come_out_again(
    spline: tuple[np.ndarray, np.ndarray, int], share: float, times: int
) -> None:
    points, knots, degree = spline
    u = float(knots[0] + share * (knots[-1] - knots[0]))
    times = min(times, degree - multiplicity(knots, u))
    assume(times > 0 and np.abs(knots - u)[knots != u].min() > 1e-3)
    more, finer = insert_knot(points, knots, degree, u, times)
    found = remove_knot(more, finer, degree, u, times, 1e-9 * 50)
    assert found.times == times
    np.testing.assert_array_equal(found.knots, knots)
    np.testing.assert_allclose(found.points, points, atol=1e-9 * 50)


@settings(max_examples=60)
@given(splines(), st.data(), st.integers(1, 5))
def test_the_curve_is_off_by_the_error_at_most(
    spline: tuple[np.ndarray, np.ndarray, int], data: st.DataObject, times: int
) -> None:
    points, knots, degree = spline
    assume(len(knots) > 2 * degree + 2)
    u = data.draw(st.sampled_from(knots[degree + 1 : -degree - 1].tolist()))
    found = remove_knot(points, knots, degree, u, times)
    assert found.times == min(times, multiplicity(knots, u))
    us = np.linspace(knots[0], knots[-1], 301)
    ours = BSpline(found.knots, found.points, degree)(us)
    apart = np.hypot(*(BSpline(knots, points, degree)(us) - ours).T)
    assert float(apart.max()) <= found.error + 1e-9
    kept = remove_knot(points, knots, degree, u, times, 0.5 * found.error)
    assert kept.times < found.times or found.error <= 1e-9
    assert kept.error <= 0.5 * found.error


@settings(max_examples=60)
@given(splines(), st.data())
def test_a_rational_curve_is_off_by_the_error_at_most(
    spline: tuple[np.ndarray, np.ndarray, int], data: st.DataObject
) -> None:
    points, knots, degree = spline
    assume(len(knots) > 2 * degree + 2)
    u = data.draw(st.sampled_from(knots[degree + 1 : -degree - 1].tolist()))
    weights = st.lists(st.floats(0.2, 5.0), min_size=len(points), max_size=len(points))
    rows = homogeneous(points, data.draw(weights))
    found = remove_knot(rows, knots, degree, u, rational=True)
    if not np.isfinite(found.error):
        assert found.points[:, -1].min() <= 0.0 or degree > 1
        return
    us = np.linspace(knots[0], knots[-1], 301)
    one, other = (projected(BSpline(t, r, degree)(us))[0] for t, r in ((knots, rows), found[1::-1]))
    assert float(np.hypot(*(one - other).T).max()) <= found.error + 1e-9


def test_a_knot_that_scipy_put_in_is_taken_out_and_a_circle_stays_a_circle() -> None:
    knots = open_uniform_knots(7, 3)
    points = np.array([[0, 0], [2, 5], [4, 1], [6, 6], [9, 0], [11, 3], [14, 2]], float)
    finer, more, degree = insert(1.7, (knots, points.T, 3), 2)
    found = remove_knot(np.array(more).T[: len(finer) - 4], finer, degree, 1.7, 2, 1e-9)
    assert found.times == 2
    np.testing.assert_allclose(found.points, points, atol=1e-12)

    whole = circle(3.0, -2.0, 5.0)
    rows = homogeneous(whole.points, whole.weights)
    more, finer = insert_knot(rows, whole.knots, 2, 0.3)
    less = remove_knot(more, finer, 2, 0.3, tolerance=1e-9, rational=True)
    assert less.times == 1
    np.testing.assert_allclose(less.points, rows, atol=1e-12)
    # A knot where two quarters meet smoothly comes out once only with a change.
    assert remove_knot(rows, whole.knots, 2, 1.0, 2, 1e-3, rational=True).times == 0


def test_a_gap_is_never_less_than_between_the_curves() -> None:
    knots = open_uniform_knots(5, 2)
    one = homogeneous([[0, 0], [1, 4], [3, 3], [4, 0], [6, 1]], [1, 2, 0.5, 1, 3])
    other = one + np.outer(np.arange(5.0), [0.01, -0.02, 0.03])
    us = np.linspace(0, 3, 200)
    ours, theirs = (projected(b_spline_point(rows, knots, 2, us))[0] for rows in (one, other))
    apart = float(np.hypot(*(ours - theirs).T).max())
    assert 0.02 < apart <= gap_between(one, other, True) < 10.0 * apart
    assert gap_between(one, one - [0, 0, 1], True) == np.inf


@pytest.mark.parametrize(
    ("u", "words"), [(0.0, "no knot 0 between"), (1.5, "no knot 1.5"), (2.0, "two parts")]
)
def test_what_cannot_be_taken_out_is_refused(u: float, words: str) -> None:
    knots = np.array([0, 0, 0, 1, 2, 2, 2, 3, 3, 3], float)
    with pytest.raises(ValueError, match=words):
        remove_knot(np.zeros((7, 2)), knots, 2, u)
