"""The mapping of one point, as a text: against the matrix and against exact fractions."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given

from tests.algorithms.runs import arguments
from workbench.algorithms import catalogue
from workbench.algorithms.viewing import window_to_viewport, window_to_viewport_point
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

ENTRY = catalogue.get("window_to_viewport_point")
runs = arguments(ENTRY)
Run = tuple[float, ...]
COURSE = (1.0, 1.0, 4.0, 4.0, 3.0, 2.0, 6.0, 6.0)


@pytest.mark.parametrize(
    ("point", "place"),
    [((1, 1), (3, 2)), ((1, 2), (3, 3.3333)), ((2, 2), (4, 3.3333)), ((3, 4), (5, 6))],
)
def test_the_example_of_the_course(point: tuple[float, float], place: tuple[float, float]) -> None:
    (found,) = window_to_viewport_point(*point, *COURSE)
    assert found == pytest.approx(place, abs=5e-5)


def test_its_hand_table() -> None:
    steps = Steps(ENTRY, record(ENTRY.function, 2.0, 2.0, *COURSE))
    rows = [step.row for step in list(steps)[1:]]
    assert [row[0] for row in rows] == [
        "scale factors",
        "window to the origin",
        "scaled to its size",
        "to the viewport",
    ]
    assert rows[0][1:] == (1.0, 4 / 3)
    assert steps[1].answer == "the picture is distorted"
    assert [row[1:] for row in rows[1:]] == [(1.0, 1.0), (1.0, 4 / 3), (4.0, 2 + 4 / 3)]


@given(run=runs)
def test_the_relative_position_stays(run: Run) -> None:
    (place,) = window_to_viewport_point(*run)
    for axis in (0, 1):
        at, low, high, to_low, to_high = (Fraction(run[k]) for k in (axis, *range(2 + axis, 10, 2)))
        exact = to_low + (at - low) / (high - low) * (to_high - to_low)
        spread = abs(to_low) + abs(to_high) + (abs(at) + abs(low)) * (to_high - to_low) / (high - low)
        assert abs(Fraction(place[axis]) - exact) <= Fraction(1, 2**48) * spread


@given(run=runs)
def test_the_lower_left_corner_goes_to_the_lower_left_corner(run: Run) -> None:
    assert list(window_to_viewport_point(*run[2:4], *run[2:])) == [run[6:8]]


@given(run=runs)
def test_the_steps_are_the_matrix(run: Run) -> None:
    (place,) = window_to_viewport_point(*run)
    x, y, window, viewport = run[0], run[1], run[2:6], run[6:]
    matrix = window_to_viewport(window, viewport)
    expected = (matrix @ (x, y, 1.0))[:2]
    sizes = np.abs(matrix[:2]) @ (abs(x), abs(y), 1.0)
    assert (np.abs(expected - place) <= 1e-12 * (sizes + np.abs(viewport[:2]))).all()


@pytest.mark.parametrize(
    "sides", [(1, 1, 1, 4, 3, 2, 6, 6), (1, 1, 4, 4, 3, 6, 6, 6), (4, 1, 1, 4, 3, 2, 6, 6)]
)
def test_a_rectangle_without_area_is_refused(sides: tuple[float, ...]) -> None:
    with pytest.raises(ValueError, match="no area"):
        list(window_to_viewport_point(2.0, 2.0, *sides))
