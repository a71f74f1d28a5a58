"""Numbers as sentences say them."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.language import at_most


@given(st.floats(1e-12, 1e12))
def test_what_is_said_to_be_at_most_so_much_is(value: float) -> None:
    said = float(at_most(value))
    assert value * (1 - 1e-9) <= said <= 1.11 * value


@pytest.mark.parametrize(
    ("value", "said"),
    [(0.0344, "0.035"), (0.25, "0.25"), (0.99999, "1"), (0.0, "0"), (1e-320, "1e-320"), (math.inf, "inf")],
)
def test_a_bound_has_two_figures(value: float, said: str) -> None:
    assert at_most(value) == said
