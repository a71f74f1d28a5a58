"""Slerp against SciPy's, and its laws."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from scipy.spatial.transform import Rotation, Slerp

from tests.algorithms.runs import arguments
from workbench.algorithms import catalogue
from workbench.algorithms.animation import slerp
from workbench.algorithms.animation.turns import straight_turn_degrees

runs = arguments(catalogue.get("slerp"))
Run = tuple[Any, ...]


def between(run: Run) -> np.ndarray:
    return np.array(list(slerp(*run)))


def rotations(quaternions: np.ndarray) -> Rotation:
    return Rotation.from_quat(np.roll(quaternions, -1, axis=-1))


@settings(max_examples=25)
@given(run=runs)
def test_every_in_between_has_length_1(run: Run) -> None:
    assert np.linalg.norm(between(run), axis=1) == pytest.approx(1.0, abs=1e-12)


@settings(max_examples=25)
@given(run=runs)
def test_it_begins_and_ends_in_the_keys_orientations(run: Run) -> None:
    rows = between(run)
    assert len(rows) == run[2] + 2
    for row, key in ((rows[0], run[0]), (rows[-1], run[1])):
        assert abs(row @ key) == pytest.approx(float(np.linalg.norm(key)), rel=1e-12)


@settings(max_examples=25)
@given(run=runs)
def test_it_turns_evenly_about_one_axis(run: Run) -> None:
    turned = rotations(between(run))
    steps = (turned[:-1].inv() * turned[1:]).as_rotvec()
    assert np.abs(steps - steps[0]).max() <= 1e-7


@settings(max_examples=25)
@given(run=runs)
def test_the_shorter_arc_is_taken(run: Run) -> None:
    rows = between(run)
    assert rows[0] @ rows[-1] >= -1e-12
    whole = (rotations(rows[0]).inv() * rotations(rows[-1])).magnitude()
    assert whole <= math.pi + 1e-9


@settings(max_examples=25)
@given(run=runs)
def test_it_is_scipy_s(run: Run) -> None:
    rows = between(run)
    ends = rotations(rows[[0, -1]])
    if (ends[0].inv() * ends[1]).magnitude() > 3.14:
        return  # half a turn has two arcs
    theirs = Slerp([0.0, 1.0], ends)(np.linspace(0.0, 1.0, len(rows)))
    assert np.abs((rotations(rows).inv() * theirs).magnitude()).max() <= 1e-7


def test_a_quarter_of_a_quarter_turn() -> None:
    entry = catalogue.get("slerp")
    row = list(slerp(*entry.example))[1]
    assert 2.0 * math.degrees(math.atan2(row[3], row[0])) == pytest.approx(22.5, abs=1e-12)
    assert straight_turn_degrees(math.radians(45.0), 0.25) == pytest.approx(21.598, abs=5e-4)


@pytest.mark.parametrize("quaternion", [[0.0, 0, 0, 0], [math.nan, 0, 0, 0], [math.inf, 0, 0, 0]])
def test_what_is_no_orientation_is_refused(quaternion: list[float]) -> None:
    with pytest.raises(ValueError, match="not an orientation"):
        list(slerp(np.array([1.0, 0, 0, 0]), np.array(quaternion), 3))
