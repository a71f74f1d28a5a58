"""A pendulum against SciPy: its elliptic functions, and its equation integrated."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.special import ellipj, ellipk

from workbench.algorithms.animation.easings import ease_in_out
from workbench.algorithms.animation.pendulum import lengthening, swing

amplitudes = st.floats(1e-6, 3.1)
parts = st.floats(0.0, 1.0)


@settings(max_examples=60)
@given(amplitudes, parts)
def test_it_is_the_elliptic_sine(amplitude: float, part: float) -> None:
    modulus = math.sin(amplitude / 2)
    sine, *_others = ellipj(ellipk(modulus**2) * (1 - 2 * part), modulus**2)
    assert swing(amplitude, part) == pytest.approx(2 * math.asin(modulus * sine), abs=1e-9)
    assert lengthening(amplitude) == pytest.approx(ellipk(modulus**2) * 2 / math.pi, rel=1e-12)


@pytest.mark.parametrize("amplitude", [0.3, math.radians(35), 2.0])
def test_it_fulfils_its_equation(amplitude: float) -> None:
    half = math.pi * lengthening(amplitude)  # half a period where g / l = 1
    times = np.linspace(0.0, half, 9)
    run = solve_ivp(
        lambda _t, y: (y[1], -math.sin(y[0])),
        (0.0, half),
        (amplitude, 0.0),
        "DOP853",
        times,
        rtol=1e-11,
        atol=1e-12,
    )
    ours = [swing(amplitude, t / half) for t in times.tolist()]
    np.testing.assert_allclose(ours, run.y[0], atol=1e-8)


@settings(max_examples=20)
@given(amplitudes)
def test_it_begins_and_ends_at_its_turning_points(amplitude: float) -> None:
    assert swing(amplitude, 0.0) == pytest.approx(amplitude)
    assert swing(amplitude, 1.0) == pytest.approx(-amplitude)
    assert swing(amplitude, 0.5) == 0.0


def test_a_small_swing_is_the_course_s_ease_in_and_out() -> None:
    small = math.radians(1.0)
    for part in np.linspace(0.0, 1.0, 11).tolist():
        assert swing(small, part) == pytest.approx(small * (1 - 2 * ease_in_out(part)), abs=1e-7)
    assert lengthening(small) == pytest.approx(1 + small**2 / 16, rel=1e-8)
