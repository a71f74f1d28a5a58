"""The rounding of the course and the way up of a picture."""

from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from workbench.geometry.conventions import GRID, round_half_up, snapped, top_row_first


@given(quarters=st.integers(-(10**6), 10**6))
def test_halves_go_up_and_all_else_to_the_nearest(quarters: int) -> None:
    rounded = round_half_up(quarters / 4)
    assert isinstance(rounded, int)
    assert Fraction(-1, 2) < rounded - Fraction(quarters, 4) <= Fraction(1, 2)


@given(places=st.integers(-(10**9), 10**9))
def test_what_is_snapped_is_the_nearest_place_of_the_grid(places: int) -> None:
    (place,) = snapped(np.array([places / 3])) * GRID
    assert place == int(place)
    assert abs(Fraction(int(place), GRID) - Fraction(places / 3)) <= Fraction(1, 2 * GRID)


def test_the_beam_starts_at_the_last_row() -> None:
    image = np.arange(6).reshape(3, 2)
    shown = top_row_first(image)
    assert shown.tolist() == [[4, 5], [2, 3], [0, 1]]
    assert np.shares_memory(shown, image)
