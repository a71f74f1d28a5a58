"""Flat, Phong and fast Phong shading against closed forms, and against the depth buffer."""

from collections.abc import Callable
from itertools import pairwise
from random import Random
from typing import Any

import numpy as np
import pytest

from tests.shading.test_illuminate import formula
from workbench.algorithms import catalogue
from workbench.algorithms.shading import fast_phong, flat_shading, phong
from workbench.algorithms.shading.normal_corners import NormalCorner
from workbench.algorithms.shading.series import begun, bend_of, onward, series_of
from workbench.algorithms.shading.shaded_scene import PARAMETERS, shaded_scene
from workbench.algorithms.visibility import depth_buffer
from workbench.algorithms.visibility.back_faces import SpaceVector
from workbench.engine.observation import Steps
from workbench.engine.recorder import record

SHADINGS = flat_shading, phong, fast_phong
UNLIT = -1.0


def lit(shading: Callable[..., Any], arguments: tuple[Any, ...]) -> Any:
    """The picture, UNLIT where nothing is written, and the depths."""
    light, *rest, depth = (np.copy(value) if isinstance(value, np.ndarray) else value for value in arguments)
    light[:] = UNLIT
    list(shading(light, *rest, depth))
    return light, depth


def example() -> list[Any]:
    return [parameter.example for parameter in PARAMETERS]


def one_triangle(number: int) -> tuple[Any, ...]:
    """A generated scene, with its first triangle only."""
    arguments = list(shaded_scene(Random(number)))
    arguments[2], arguments[5] = arguments[2][:1], arguments[5][:1]
    return tuple(arguments)


def shares(vertices: Any, face: Any, x: int, y: int) -> Any:
    """Barycentric coordinates of a pixel."""
    matrix = np.vstack([vertices[face][:, :2].T, np.ones(3)])
    return np.linalg.solve(matrix, (x, y, 1.0))


@pytest.mark.parametrize("shading", SHADINGS)
def test_the_pixels_are_those_of_the_depth_buffer(shading: Callable[..., Any]) -> None:
    for number in range(60):
        arguments = shaded_scene(Random(number))
        light, depth = lit(shading, arguments)
        image, stored = np.zeros(light.shape, np.int64), np.array(arguments[-1])
        faces = arguments[2]
        list(depth_buffer(image, stored, arguments[1], faces, np.arange(1, len(faces) + 1)))
        assert np.array_equal(light != UNLIT, image > 0)
        assert np.array_equal(depth, stored)


def test_flat_is_the_light_of_the_middle() -> None:
    for number in range(60):
        arguments = one_triangle(number)
        light, _depth = lit(flat_shading, arguments)
        _light, _vertices, (face,), places, normals, (material,), eye, lights, by_halfway, blockers, _ = (
            arguments
        )
        a, b, c = places[face]
        normal = np.cross(b - a, c - a)
        normal = -normal if normal @ normals[face[0]] < 0 else normal
        expected = formula((a + b + c) / 3, normal, eye, lights, material, by_halfway, blockers)
        assert light[light != UNLIT] == pytest.approx(expected, abs=1e-9)


def test_phong_is_the_model_at_each_pixel() -> None:
    lit_pixels = 0
    for number in range(200):
        arguments = one_triangle(number)
        light, _depth = lit(phong, arguments)
        _light, vertices, (face,), places, normals, (material,), eye, lights, by_halfway, blockers, _ = (
            arguments
        )
        if len(blockers):  # its own plane is in the way or not by the last digit
            continue
        for y, x in np.argwhere(light != UNLIT).tolist():
            share = shares(vertices, face, x, y)
            place, normal = share @ places[face], share @ normals[face]
            if np.linalg.norm(normal) < 1e-9:
                continue
            expected = formula(place, normal, eye, lights, material, by_halfway, blockers)
            assert light[y, x] == pytest.approx(expected, abs=1e-7)
            lit_pixels += 1
    assert lit_pixels > 300


def test_far_lights_on_a_plane_make_phong_flat() -> None:
    arguments = example()
    arguments[4] = np.tile((0.0, 0, 1), (6, 1))
    arguments[3] = arguments[3] * (1, 1, 0)
    arguments[6], arguments[7] = np.array([1.0, 2, 3, 0]), np.array([[3.0, 2, 9, 0, 1, 1, 0, 0]])
    arguments[2] = np.array([[0, 1, 2]])
    pictures = [lit(shading, tuple(arguments))[0] for shading in SHADINGS]
    for other in pictures[1:]:
        assert other == pytest.approx(pictures[0], abs=1e-12)


def corner(x: float, y: float, normal: Any) -> NormalCorner:
    return NormalCorner(x, y, 0.5, SpaceVector(x, y, 0.0), SpaceVector(*normal))


def test_the_differences_are_the_expansion() -> None:
    """Its six numbers by central differences of the function itself."""
    rng = np.random.default_rng(5)
    for _case in range(40):
        normals = rng.normal(size=(3, 3)) + np.array([0, 0, 4])
        a, b, c = (
            corner(*place, n) for place, n in zip(((0.0, 0.0), (9.0, 1.0), (3.0, 7.0)), normals, strict=True)
        )
        L = rng.normal(size=3)
        L /= np.linalg.norm(L)
        matrix = np.linalg.inv(np.array([[0, 0, 1], [9, 1, 1], [3, 7, 1.0]]))

        def cosine(u: float, v: float, normals=normals, matrix=matrix, L=L) -> float:  # type: ignore[no-untyped-def]
            N = np.array([4 + u, 8 / 3 + v, 1]) @ matrix @ normals
            return float(N @ L / np.linalg.norm(N))

        h = 1e-3
        expected = (
            cosine(0, 0),
            (cosine(h, 0) - cosine(-h, 0)) / (2 * h),
            (cosine(0, h) - cosine(0, -h)) / (2 * h),
            (cosine(h, 0) - 2 * cosine(0, 0) + cosine(-h, 0)) / (2 * h * h),
            (cosine(h, h) - cosine(h, -h) - cosine(-h, h) + cosine(-h, -h)) / (4 * h * h),
            (cosine(0, h) - 2 * cosine(0, 0) + cosine(0, -h)) / (2 * h * h),
        )
        series = series_of(bend_of(a, b, c), SpaceVector(*L))
        assert tuple(series) == pytest.approx(expected, abs=1e-5)
        u, v = rng.normal(size=2) * 3
        at = begun(series, u, v)
        for k in range(8):
            powers = 1, u + k, v, (u + k) ** 2, (u + k) * v, v * v
            assert at.value == pytest.approx(float(np.dot(series, powers)), abs=1e-12)
            at = onward(at)
    # And what the text lights a matt triangle with
    arguments = example()
    arguments[2], arguments[5] = np.array([[0, 1, 2]]), np.array([[0.0, 1.0, 0.0, 1]])
    arguments[7] = np.array([[0.0, 0, 9, 0, 1, 1, 0, 0]])
    light, _depth = lit(fast_phong, tuple(arguments))
    vertices, normals = arguments[1], arguments[4]
    bend = bend_of(*(corner(x, y, n) for (x, y, _z), n in zip(vertices[:3].tolist(), normals, strict=False)))
    series = series_of(bend, SpaceVector(0.0, 0.0, 1.0))
    for y, x in np.argwhere(light != UNLIT).tolist():
        u, v = x - bend.x, y - bend.y
        value = float(np.dot(series, (1, u, v, u * u, u * v, v * v)))
        assert light[y, x] == pytest.approx(min(max(value, 0.0), 1.0), abs=1e-12)


def test_fast_phong_comes_to_phong() -> None:
    """Half the bend, an eighth of the difference, or less."""
    differences = []
    for bend in (0.4, 0.2, 0.1):
        arguments = example()
        arguments[2] = np.array([[0, 1, 2]])
        middle = arguments[1][:3, :2].mean(axis=0)
        outwards = (arguments[1][:, :2] - middle) * bend / 6
        arguments[4] = np.column_stack([outwards, np.ones(6)])
        arguments[6], arguments[7] = np.array([0.0, 0, 1, 0]), np.array([[3.0, 2, 9, 0, 1, 1, 0, 0]])
        arguments[5] = np.array([[0.1, 0.8, 0.0, 1]])  # a highlight has powers of its own
        first, second = (lit(shading, tuple(arguments))[0] for shading in (phong, fast_phong))
        differences.append(float(abs(first - second).max()))
    assert 0 < differences[-1] < differences[0] < 0.05
    for larger, smaller in pairwise(differences):
        assert smaller < larger / 7


def test_a_light_inside_a_face_and_coefficients_of_zero_leave_numbers() -> None:
    arguments = example()
    arguments[7] = np.array([[*arguments[3][0], 1, 1, 0, 0, 0], [4, 4, -5, 1, 1, 0, 0, 0]])
    for shading in SHADINGS:
        light, _depth = lit(shading, tuple(arguments))
        assert np.isfinite(light).all()
        assert light.max() > 0.1


@pytest.mark.parametrize(("z", "said"), [(1.0, ","), (2.0, ", not yet of length 1,")])
def test_a_normal_is_said_not_to_have_length_1_only_where_it_has_not(z: float, said: str) -> None:
    arguments = [np.copy(value) if isinstance(value, np.ndarray) else value for value in example()]
    arguments[4] = np.tile([0.0, 0.0, z], (len(arguments[4]), 1))
    entry = catalogue.get("phong")
    steps = Steps(entry, record(phong, *arguments))
    told = "".join(part.text for part in steps[1].sentence)
    assert f"with the normal (0, 0, {z:g}){said} the light is" in told
