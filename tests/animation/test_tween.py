"""The in-betweens of two keys against the course's formula in exact fractions."""

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given

from tests.algorithms.runs import arguments
from workbench.algorithms import catalogue
from workbench.algorithms.animation import eased, tween
from workbench.algorithms.animation.easings import BEZIER
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

runs = arguments(catalogue.get("tween"))
Run = tuple[Any, ...]


@given(run=runs)
def test_a_key_s_frame_shows_exactly_the_key_s_value(run: Run) -> None:
    rows = list(tween(*run))
    assert rows[0] == (run[0], run[2])
    assert rows[-1] == (run[1], run[3])
    assert [frame for frame, _value in rows] == list(range(run[0], run[1] + 1))


@given(run=runs)
def test_in_betweens_are_those_of_the_formula(run: Run) -> None:
    first_frame, second_frame, first, second, easing, *handles = run
    for frame, value in list(tween(*run))[1:-1]:
        part = eased(easing, *handles, (frame - first_frame) / (second_frame - first_frame))
        exact = Fraction(first) + Fraction(part) * (Fraction(second) - Fraction(first))
        assert value == pytest.approx(float(exact), rel=1e-12, abs=1e-11)


@given(run=runs)
def test_a_value_never_turns_back(run: Run) -> None:
    if run[4] == BEZIER:
        return
    values = [value for _frame, value in tween(*run)]
    steps = np.diff(values) * (1.0 if run[3] >= run[2] else -1.0)
    assert (steps >= -1e-12).all()


def test_the_falling_ball_of_the_course() -> None:
    entry = catalogue.get("tween")
    rows = [step.row for step in list(Steps(entry, record(entry.function, *entry.example)))[1:]]
    assert len(rows) == 13
    assert rows[6][:4] == (6, 34, 0.5, pytest.approx(0.2929, abs=5e-5))
    assert [row[4] for row in rows[3:9]] == pytest.approx(
        [43.260, 41.177, 38.561, 35.456, 31.915, 28.0], abs=5e-4
    )


@pytest.mark.parametrize("second_frame", [28, 5])
def test_keys_out_of_order_are_refused(second_frame: int) -> None:
    with pytest.raises(ValueError, match="later frame"):
        list(tween(28, second_frame, 46.0, 10.0, 1, 0.0, 0.0, 1.0, 1.0))
