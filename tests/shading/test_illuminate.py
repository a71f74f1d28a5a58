"""The light of a point against the formula, written with NumPy."""

from random import Random
from typing import Any

import numpy as np
import pytest

from workbench.algorithms.shading import illuminate
from workbench.algorithms.shading.directions import attenuation
from workbench.algorithms.shading.illuminate import lit_point

UP, NOWHERE = np.array([0.0, 0, 1]), np.zeros(3)
NO_FADING = np.array([1.0, 0, 0])


def total(*arguments: Any) -> float:
    rows = list(illuminate(*arguments))
    return float(rows[-1][3]) if rows else float(arguments[4][0])


def formula(place, normal, eye, lights, material, fading, by_halfway) -> float:  # type: ignore[no-untyped-def]
    def unit(v):  # type: ignore[no-untyped-def]
        size = np.linalg.norm(v)
        return v / size if size else v

    k_a, k_d, k_s, n = material
    N, V, light = unit(normal), unit(eye - place), k_a
    for *position, intensity in lights:
        d = np.linalg.norm(position - place)
        L = unit(position - place)
        divisor = np.polyval(fading[::-1], d)
        f = min(1.0, 1 / divisor) if divisor > 0 else 1.0
        if N @ L > 0:
            angle = N @ unit(L + V) if by_halfway else V @ (2 * (N @ L) * N - L)
            light += f * intensity * (k_d * (N @ L) + k_s * max(angle, 0.0) ** n)
    return float(light)


@pytest.mark.parametrize(("by_halfway", "expected"), [(False, 0.5052), (True, 0.6206)])
def test_the_worked_example(by_halfway: bool, expected: float) -> None:
    lights, material = np.array([[1.0, 2, 2, 1]]), np.array([0.1, 0.6, 0.3, 10])
    arguments = NOWHERE, UP, 9 * UP, lights, material, NO_FADING, by_halfway
    assert total(*arguments) == pytest.approx(expected, abs=5e-5)


def test_the_light_is_that_of_the_formula() -> None:
    for number in range(150):
        arguments = lit_point(Random(number))
        assert total(*arguments) == pytest.approx(formula(*arguments), abs=1e-12)


def test_light_from_behind_and_from_farther_away() -> None:
    material, fading = np.array([0.1, 0.6, 0.3, 10]), np.array([0.5, 0.25, 0.125])
    behind = np.array([[1.0, 2, -2, 1]])
    assert total(NOWHERE, UP, UP, behind, material, fading, False) == 0.1
    ahead = [
        total(NOWHERE, UP, UP, np.array([[k, 2.0 * k, 2 * k, 1]]), material, fading, False)
        for k in range(1, 9)
    ]
    assert ahead == sorted(ahead, reverse=True)
    assert ahead[0] > ahead[-1] > 0.1


def test_lights_add_up() -> None:
    for number in range(60):
        place, normal, eye, lights, material, fading, by_halfway = lit_point(Random(number))
        dark = np.array([0.0, *material[1:]])
        apart = [
            total(place, normal, eye, lights[k : k + 1], dark, fading, by_halfway) for k in range(len(lights))
        ]
        for order in (lights, lights[::-1]):
            together = total(place, normal, eye, order, material, fading, by_halfway)
            assert together == pytest.approx(material[0] + sum(apart), abs=1e-12)


def test_coefficients_that_make_attenuation_0_leave_the_light_as_it_is() -> None:
    assert attenuation(0.0, 0.0, 0.0, 3.0) == 1.0
    assert attenuation(1.0, 0.0, 1.0, 2.0) == 0.2
