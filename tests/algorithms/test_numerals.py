"""Sentences, tables and matrices write one number in one way."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.algorithms import catalogue
from workbench.algorithms.numerals import numeral, settled, with_minus
from workbench.algorithms.projection.axonometric import isometric
from workbench.algorithms.projection.parallel import orthographic
from workbench.engine.observation import Steps
from workbench.engine.recorder import record
from workbench.engine.sentences import number_text
from workbench.exchange.formulas.terms import displayed
from workbench.exchange.tables import shown


@given(st.floats(-1e9, 1e9).filter(lambda value: value == 0.0 or abs(value) > 1e-9))
def test_a_number_is_written_alike_wherever_it_is_read(value: float) -> None:
    text = numeral(value)
    assert number_text(value) == displayed(value) == text
    assert shown(value).replace("-", "−") == text
    tolerance = 0.00005 if abs(value) >= 1e-4 else 0.0005 * abs(value)
    assert abs(float(text.replace("−", "-")) - value) <= tolerance * (1 + 1e-9)


@pytest.mark.parametrize(
    ("value", "text"),
    [(-1.2426406871192848, "−1.2426"), (-0.0, "0"), (2.0, "2"), (1.9e-7, "1.9e−07"), (0.00004, "4e−05")],
)
def test_four_decimals_at_most(value: float, text: str) -> None:
    assert numeral(value) == text


def test_what_rounding_left_is_zero_beside_numbers_of_its_size() -> None:
    assert settled(-1.1e-16, 2.0, 3.0) == (0.0, 2.0, 3.0)
    assert settled(1e-11, 0.5) == (1e-11, 0.5)
    assert settled(1e-9, 1e6) == (0.0, 1e6)


def test_no_corner_of_a_cube_in_isometric_projection_has_a_rounding_in_its_hand_table() -> None:
    import numpy as np

    entry = catalogue.get("project_point")
    viewport = np.array([[10.0, 0, 20], [0, 10, 15], [0, 0, 1]])
    for corner in np.ndindex(2, 2, 2):
        point = np.array(corner, float) * 2 - 1
        recording = record(entry.function, np.eye(4), isometric(), orthographic(), viewport, point)
        for row in map(Steps(entry, recording).row, range(1, 6)):
            numbers = [value for value in row if isinstance(value, float)]
            assert numbers
            assert all(value == 0.0 or math.fabs(value) > 1e-9 for value in numbers)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("(-3, 4) by (0, -0.5)", "(−3, 4) by (0, −0.5)"),
        ("-1e-05 is too small; the least is -2.", "−1e−05 is too small; the least is −2."),
        ("one-point, 4-connected, x-ray, - and -b", "one-point, 4-connected, x-ray, - and -b"),
        ("from −1 to -1", "from −1 to −1"),
        ("-inf is below all; re-inform, -info", "−inf is below all; re-inform, -info"),
    ],
)
def test_numbers_of_a_text_have_true_minus_signs_and_words_their_hyphens(text: str, shown: str) -> None:
    assert with_minus(text) == shown
