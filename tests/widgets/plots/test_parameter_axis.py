"""The axis of a parameter: its ticks, and numbers as text."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from workbench.widgets.plots.parameter_axis import number_text, ticks


@given(st.floats(-1e6, 1e6), st.floats(1e-6, 1e6), st.integers(2, 12))
def test_ticks_are_round_inside_and_not_too_many(low, length, most):
    assume(length > 1e-6 * abs(low))
    made = ticks(low, low + length, most)
    assert len(made) <= most
    assert all(low - 1e-6 * length <= tick <= low + length * (1 + 1e-6) for tick in made)
    steps = np.diff(made)
    if len(steps):
        lead = float(f"{steps[0]:.3g}") / 10.0 ** math.floor(math.log10(float(f"{steps[0]:.3g}")) + 1e-9)
        assert round(lead, 3) in (1, 2, 5)


@given(st.floats(-1e300, 1e300), st.integers(2, 6))
def test_a_number_is_near_its_text(value, digits):
    text = number_text(value, digits).replace("\N{MINUS SIGN}", "-")
    assert float(text) == pytest.approx(value, rel=10.0 ** (2 - digits), abs=1e-300)
    assert len(text) <= digits + 8


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (-0.0, "0"), (356.2, "356"), (-0.5, "−0.5"), (1e-9, "1.0e−9"), (2e7, "2.0e7"),
     (math.nan, "–"), (math.inf, "∞"), (-math.inf, "−∞"), (100.0, "100")],
)  # fmt: skip
def test_texts_of_numbers(value, text):
    assert number_text(value) == text
