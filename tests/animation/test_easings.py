"""Easings against their formulas in exact fractions or NumPy, and the Bézier easing against its own curve."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms.animation import (
    constant,
    cubic_bezier_easing,
    ease_in,
    ease_in_cubic,
    ease_in_out,
    ease_in_out_cubic,
    ease_out,
    ease_out_cubic,
    eased,
    linear,
)
from workbench.algorithms.animation.easings import BEZIER, NAMES, NEAREST_HANDLES

EASINGS = [
    constant,
    linear,
    ease_in,
    ease_out,
    ease_in_out,
    ease_in_cubic,
    ease_out_cubic,
    ease_in_out_cubic,
]
parts = st.floats(0.0, 1.0)
handles = st.tuples(parts, st.floats(-1.0, 2.0), parts, st.floats(-1.0, 2.0))
each = pytest.mark.parametrize("number", range(len(EASINGS)), ids=NAMES[:-1])


@each
def test_it_starts_at_0_ends_at_1_and_never_turns_back(number: int) -> None:
    values = [EASINGS[number](j / 1000) for j in range(1001)]
    assert values[0] == 0.0
    assert values[-1] == 1.0
    assert (np.diff(values) >= 0.0).all()


@each
@given(t=parts)
def test_each_has_its_number(number: int, t: float) -> None:
    assert eased(number, 0.1, 0.2, 0.3, 0.4, t) == EASINGS[number](t)


def test_the_accelerating_in_betweens_of_the_course() -> None:
    assert [ease_in(j / 6) for j in range(1, 6)] == pytest.approx(
        [0.0341, 0.1340, 0.2929, 0.5, 0.7412], abs=5e-5
    )


@given(t=parts)
def test_the_sine_forms_mirror_one_another(t: float) -> None:
    assert ease_out(t) == pytest.approx(1.0 - ease_in(1.0 - t), abs=1e-15)
    assert ease_in_out(t) == pytest.approx(math.sin(math.pi * t / 2) ** 2, abs=1e-15)


@given(t=parts)
def test_the_cubic_forms_are_those_of_exact_fractions(t: float) -> None:
    exact, rest = Fraction(t), 1 - Fraction(t)
    assert ease_in_cubic(t) == pytest.approx(float(exact**3), abs=1e-15)
    assert ease_out_cubic(t) == pytest.approx(float(1 - rest**3), abs=1e-15)
    joined = ease_in_cubic(2 * t) / 2 if t < 0.5 else (1 + ease_out_cubic(2 * t - 1)) / 2
    assert ease_in_out_cubic(t) == pytest.approx(joined, abs=1e-15)


def test_the_bezier_easing_of_the_course() -> None:
    assert cubic_bezier_easing(0.25, 0.1, 0.25, 1.0, 0.5) == pytest.approx(0.8024, abs=5e-5)


@given(shape=handles, t=parts)
def test_a_bezier_easing_lies_on_its_curve(shape: tuple[float, float, float, float], t: float) -> None:
    """Against the roots of the polynomial in x, by NumPy."""
    x1, y1, x2, y2 = shape
    roots = np.roots([1.0 + 3.0 * x1 - 3.0 * x2, 3.0 * x2 - 6.0 * x1, 3.0 * x1, -t])
    near = roots[np.argmin(np.abs(roots - roots.real.clip(0.0, 1.0)))].real
    value = cubic_bezier_easing(x1, y1, x2, y2, t)
    u = np.linspace(0.0, 1.0, 2001)
    x = 3 * (1 - u) ** 2 * u * x1 + 3 * (1 - u) * u * u * x2 + u**3
    y = 3 * (1 - u) ** 2 * u * y1 + 3 * (1 - u) * u * u * y2 + u**3
    assert -1e-6 <= near <= 1.0 + 1e-6
    inside = slice(max(np.searchsorted(x, t) - 2, 0), np.searchsorted(x, t) + 2)
    assert y[inside].min() - 1e-9 <= value <= y[inside].max() + 1e-9


@given(shape=handles)
def test_a_bezier_easing_starts_at_0_and_ends_at_1(shape: tuple[float, float, float, float]) -> None:
    assert eased(BEZIER, *shape, 0.0) == 0.0
    assert eased(BEZIER, *shape, 1.0) == 1.0


@pytest.mark.parametrize(
    ("number", "off"), [(1, 1e-12), (2, 1e-4), (3, 1e-4), (4, 3e-4), (5, 1e-12), (6, 1e-12), (7, 9e-3)]
)
def test_the_handles_that_are_drawn_at_an_easing_fit_it(number: int, off: float) -> None:
    times = np.linspace(0.0, 1.0, 101)
    fitted = [cubic_bezier_easing(*NEAREST_HANDLES[number], t) for t in times]
    assert np.abs(np.subtract(fitted, [EASINGS[number](t) for t in times])).max() <= off
