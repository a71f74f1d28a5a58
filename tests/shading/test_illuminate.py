"""The light of a point against the formula, written with NumPy."""

from random import Random
from typing import Any

import numpy as np
import pytest

from workbench.algorithms.shading import illuminate
from workbench.algorithms.shading.directions import attenuation
from workbench.algorithms.shading.illumination import light_at
from workbench.algorithms.shading.model_parameters import lit_point
from workbench.algorithms.visibility.back_faces import SpaceVector

UP, NOWHERE, EYE = np.array([0.0, 0, 1]), np.zeros(3), np.array([0.0, 0, 9, 1])
NOTHING_BETWEEN = np.zeros((0, 3))


def total(*arguments: Any) -> float:
    rows = list(illuminate(*arguments))
    return float(rows[-1][3]) if rows else float(arguments[4][0])


def hit(start, way, corners) -> float:  # type: ignore[no-untyped-def]
    """After which share of the way a ray meets a triangle, by Cramer's rule; -1 where it does not."""
    a, b, c = corners
    columns = np.stack([b - a, c - a, -way], axis=1)
    if abs(np.linalg.det(columns)) < 1e-9:
        return -1.0
    s, t, share = np.linalg.solve(columns, start - a)
    return float(share) if min(s, t, 1 - s - t) >= -1e-12 else -1.0


def formula(place, normal, eye, lights, material, by_halfway, blockers) -> float:  # type: ignore[no-untyped-def]
    def unit(v):  # type: ignore[no-untyped-def]
        size = np.linalg.norm(v)
        return v / size if size else v

    k_a, k_d, k_s, n = material
    N, V, light = unit(normal), unit(eye[:3] - eye[3] * place), k_a
    for x, y, z, w, intensity, *fading in lights:
        way = np.array([x, y, z]) - w * place
        d, L = np.linalg.norm(way), unit(way)
        divisor = np.polyval(fading[::-1], d) if w else 1.0
        f = min(1.0, 1 / divisor) if divisor > 0 else 1.0
        shares = [hit(place, way, corners) for corners in blockers.reshape(-1, 3, 3)]
        if N @ L > 0 and not any(1e-6 < share < (1 if w else np.inf) for share in shares):
            angle = N @ unit(L + V) if by_halfway else V @ (2 * (N @ L) * N - L)
            light += f * intensity * (k_d * (N @ L) + k_s * max(angle, 0.0) ** n)
    return float(light)


@pytest.mark.parametrize(("by_halfway", "expected"), [(False, 0.5052), (True, 0.6206)])
def test_the_worked_example(by_halfway: bool, expected: float) -> None:
    lights, material = np.array([[1.0, 2, 2, 1, 1, 1, 0, 0]]), np.array([0.1, 0.6, 0.3, 10])
    arguments = NOWHERE, UP, EYE, lights, material, by_halfway, NOTHING_BETWEEN
    assert total(*arguments) == pytest.approx(expected, abs=5e-5)


def test_the_light_is_that_of_the_formula() -> None:
    for number in range(300):
        arguments = lit_point(Random(number))
        assert total(*arguments) == pytest.approx(formula(*arguments), abs=1e-12)


def test_light_from_behind_and_from_farther_away() -> None:
    material, fading = np.array([0.1, 0.6, 0.3, 10]), (0.5, 0.25, 0.125)

    def at(x: float, y: float, z: float) -> float:
        lights = np.array([[x, y, z, 1, 1, *fading]])
        return total(NOWHERE, UP, EYE, lights, material, False, NOTHING_BETWEEN)

    assert at(1, 2, -2) == 0.1
    ahead = [at(k, 2.0 * k, 2 * k) for k in range(1, 9)]
    assert ahead == sorted(ahead, reverse=True)
    assert ahead[0] > ahead[-1] > 0.1


def test_lights_add_up() -> None:
    for number in range(60):
        place, normal, eye, lights, material, *rest = lit_point(Random(number))
        dark = np.array([0.0, *material[1:]])
        apart = [total(place, normal, eye, lights[k : k + 1], dark, *rest) for k in range(len(lights))]
        for order in (lights, lights[::-1]):
            together = total(place, normal, eye, order, material, *rest)
            assert together == pytest.approx(material[0] + sum(apart), abs=1e-12)


def test_what_is_between_takes_the_light_away() -> None:
    material, light = np.array([0.1, 0.6, 0.0, 1]), np.array([[0.0, 0, 4, 1, 1, 1, 0, 0]])
    sheet = np.array([[-9.0, -9, 0], [9, -9, 0], [0, 9, 0]])
    for height, expected in ((2.0, 0.1), (3.99, 0.1), (4.01, 0.7), (0.0, 0.7), (-1.0, 0.7)):
        blockers = sheet + np.array([0, 0, height])
        assert total(NOWHERE, UP, EYE, light, material, False, blockers) == pytest.approx(expected)
    far = np.array([[0.0, 0, 4, 0, 1, 1, 0, 0]])
    assert total(NOWHERE, UP, EYE, far, material, False, sheet + np.array([0, 0, 100])) == 0.1


def test_a_light_in_the_point_itself_adds_nothing() -> None:
    lights, material = np.array([[0.0, 0, 0, 1, 1, 0, 0, 0]]), np.array([0.1, 0.6, 0.3, 10])
    assert total(NOWHERE, UP, EYE, lights, material, False, NOTHING_BETWEEN) == 0.1


def test_the_function_comes_to_the_total_of_the_text() -> None:
    for number in range(200):
        place, normal, eye, lights, material, *rest = lit_point(Random(number))
        at = light_at(SpaceVector(*place), SpaceVector(*normal), material, eye, lights, *rest)
        assert at == pytest.approx(total(place, normal, eye, lights, material, *rest), abs=1e-14)


def test_coefficients_that_make_attenuation_0_leave_the_light_as_it_is() -> None:
    assert attenuation(0.0, 0.0, 0.0, 3.0) == 1.0
    assert attenuation(1.0, 0.0, 1.0, 2.0) == 0.2
