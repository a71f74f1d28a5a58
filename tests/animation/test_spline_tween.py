"""Splines through keys against polynomials fitted by NumPy and against SciPy's cubic Hermite spline."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicHermiteSpline

from tests.algorithms.runs import arguments
from workbench.algorithms import catalogue
from workbench.algorithms.animation import spline_tween
from workbench.engine.recorder import record
from workbench.geometry.curves.kochanek_bartels import kochanek_bartels

runs = arguments(catalogue.get("spline_tween"))
Run = tuple[Any, ...]
keys = st.lists(
    st.tuples(st.integers(1, 9), st.integers(-20, 20).map(lambda v: v / 4)), min_size=3, max_size=6
)


def slopes(run: Run) -> tuple[list[float], list[float]]:
    recording = record(spline_tween, *run)
    last = recording.after(len(recording) - 1)
    return last["leaving"], last["arriving"]


def plain(track: list[tuple[int, float]]) -> Run:
    """Keys so many frames apart with these values, and no shapes."""
    frames = np.cumsum([gap for gap, _value in track])
    zeros = np.zeros(len(track))
    return frames, np.array([value for _gap, value in track]), zeros, zeros, zeros


@settings(max_examples=25)
@given(run=runs)
def test_a_spline_passes_through_its_keys(run: Run) -> None:
    rows = dict(spline_tween(*run))
    assert list(rows) == list(range(run[0][0], run[0][-1] + 1))
    for frame, value in zip(run[0].tolist(), run[1].tolist(), strict=True):
        assert rows[frame] == value


@settings(max_examples=25)
@given(track=keys)
def test_without_shapes_the_slope_is_that_of_the_parabola(track: list[tuple[int, float]]) -> None:
    run = plain(track)
    frames, values = run[0].astype(float), run[1]
    leaving, arriving = slopes(run)
    for k in range(1, len(frames) - 1):
        around = slice(k - 1, k + 2)
        parabola = np.polynomial.Polynomial.fit(frames[around], values[around], 2)
        assert leaving[k] == pytest.approx(float(parabola.deriv()(frames[k])), abs=1e-9)
        assert arriving[k] == leaving[k]


@settings(max_examples=25)
@given(run=runs)
def test_between_keys_it_is_hermite_s_cubic(run: Run) -> None:
    leaving, arriving = slopes(run)
    rows = dict(spline_tween(*run))
    for k in range(len(run[0]) - 1):
        ends = run[0][k : k + 2]
        cubic = CubicHermiteSpline(ends, run[1][k : k + 2], [leaving[k], arriving[k + 1]])
        for frame in range(ends[0], ends[1] + 1):
            assert rows[frame] == pytest.approx(float(cubic(frame)), rel=1e-9, abs=1e-6)


@settings(max_examples=25)
@given(run=runs)
def test_the_speed_does_not_jump_at_a_key(run: Run) -> None:
    frames, values, tensions, _continuities, biases = run
    leaving, arriving = slopes((frames, values, tensions, np.zeros(len(frames)), biases))
    assert leaving == pytest.approx(arriving, rel=1e-12, abs=1e-12)


@settings(max_examples=25)
@given(run=runs)
def test_over_equal_distances_it_is_kochanek_and_bartels_spline(run: Run) -> None:
    _frames, values, *shapes = run
    count = len(values)
    rows = dict(spline_tween(np.arange(0, 4 * count, 4), values, *shapes))
    pieces = kochanek_bartels(values[:, None], *shapes, ends="through")
    for k in range(count - 1):
        b0, b1, b2, b3 = pieces.controls[k, :, 0]
        middle = (b0 + 3 * b1 + 3 * b2 + b3) / 8
        assert rows[4 * k + 2] == pytest.approx(middle, rel=1e-9, abs=1e-9)


@settings(max_examples=25)
@given(
    gaps=st.lists(st.integers(1, 9), min_size=2, max_size=6),
    start=st.integers(-9, 9),
    speed=st.integers(-4, 4),
)
def test_keys_on_a_line_make_an_even_motion(gaps: list[int], start: int, speed: int) -> None:
    frames = np.cumsum(gaps)
    zeros = np.zeros(len(frames))
    for frame, value in spline_tween(frames, start + speed * frames.astype(float), zeros, zeros, zeros):
        assert value == pytest.approx(start + speed * frame, abs=1e-9)


@pytest.mark.parametrize("frames", [[0], [0, 0], [0, 5, 3]])
def test_keys_out_of_order_are_refused(frames: list[int]) -> None:
    zeros = np.zeros(len(frames))
    with pytest.raises(ValueError, match=r"another one|later frame"):
        list(spline_tween(np.array(frames), zeros, zeros, zeros, zeros))
