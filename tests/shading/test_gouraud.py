"""Gouraud shading against shares of areas in fractions, and against the depth buffer."""

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tests.visibility.exact_scenes import HEIGHT, KINDS, WIDTH, arrays, piercing, scenes
from tests.visibility.test_depth_buffer import covers, depth_at
from workbench.algorithms.shading import gouraud
from workbench.algorithms.visibility import depth_buffer
from workbench.algorithms.visibility.packed_light import FIELD, FULL, packed
from workbench.display.exposure import srgb_encoded
from workbench.engine.compiled import paint
from workbench.rendering.gouraud_triangles import gouraud_drawn

Array = NDArray[Any]


def test_the_worked_example() -> None:
    """0.52 at (4, 5) between 0.2, 0.8 and 0.6."""
    light, depth = np.zeros((12, 12)), np.ones((12, 12))
    vertices = np.array([[0.0, 0, 0.5], [10, 0, 0.5], [4, 10, 0.5]])
    list(gouraud(light, vertices, np.array([[0, 1, 2]]), np.array([0.2, 0.8, 0.6]), depth))
    assert light[5, 4] == pytest.approx(0.52)


def test_in_a_triangle_the_light_is_linear() -> None:
    """The plane through the corners' light is found as that through their depths is."""
    for scene in scenes(piercing, 40):
        triangle = scene[0]
        shares = [Fraction(k, 8) for k in (1, 8, 3)]
        lit = tuple((x, y, share) for (x, y, _z), share in zip(triangle, shares, strict=True))
        light, depth = np.full((HEIGHT, WIDTH), -1.0), np.ones((HEIGHT, WIDTH))
        vertices, faces, _colours = arrays([triangle])
        list(gouraud(light, vertices, faces, np.array(shares, float), depth))
        for y in range(HEIGHT):
            for x in range(WIDTH):
                if covers(triangle, x, y):
                    assert light[y, x] == pytest.approx(float(depth_at(lit, x, y)), abs=1e-9)  # type: ignore[arg-type]
                else:
                    assert light[y, x] == -1.0


def test_the_pixels_are_those_of_the_depth_buffer() -> None:
    for kind in KINDS:
        for scene in scenes(kind, 10):
            vertices, faces, colours = arrays(scene)
            light, depth = np.zeros((HEIGHT, WIDTH)), np.ones((HEIGHT, WIDTH))
            # One light for all corners of a triangle, as flat shading has it: its colour
            emitted = list(gouraud(light, vertices, faces, np.repeat(colours, 3).astype(float), depth))
            stored = np.ones((HEIGHT, WIDTH))
            image = np.zeros((HEIGHT, WIDTH), np.int64)
            fragments = list(depth_buffer(image, stored, vertices, faces, colours))
            assert [(x, y) for x, y, _light in emitted] == [(x, y) for x, y, _z, won in fragments if won]
            assert np.array_equal(light, image)
            assert np.array_equal(depth, stored)


def assert_lit_as_the_text_does(vertices: Array, faces: Array, lights: Array, size: tuple[int, int]) -> None:
    """To one step of 255, with the same depths."""
    image, depth = gouraud_drawn(lambda: [(vertices, faces, lights)], size)
    for channel, shift in enumerate((16, 8, 0)):
        light, nearest = np.zeros(size[::-1]), np.ones(size[::-1])
        paint(gouraud, light, 0, light, vertices, faces, np.ascontiguousarray(lights[:, channel]), nearest)
        assert depth.tobytes() == nearest.tobytes()
        coded = srgb_encoded(light) * 255
        assert np.abs((image >> shift & 255) - coded).max() <= 1.01


@given(seed=st.integers(0, 2**32 - 1), brightest=st.sampled_from([0.01, 1.0, 1.5, 4.0]))
@settings(max_examples=40)
def test_whole_pictures_are_lit_as_the_text_does(seed: int, brightest: float) -> None:
    rng = np.random.default_rng(seed)
    vertices = np.column_stack([rng.integers(-8, 48, (15, 2)) / rng.choice([1, 4]), rng.uniform(0, 1, 15)])
    faces, lights = rng.integers(0, 15, (6, 3)), rng.integers(0, 9, (15, 3)) / 8 * brightest
    assert_lit_as_the_text_does(vertices, faces, lights, (40, 36))


@given(seed=st.integers(0, 2**32 - 1), brightest=st.sampled_from([0.01, 1.0, 4.0]))
@settings(max_examples=15)
def test_light_does_not_drift_over_wide_and_tall_triangles(seed: int, brightest: float) -> None:
    """Far beyond the picture, where rounding would add up, and in the dark, where it is seen first."""
    rng = np.random.default_rng(seed)
    vertices = np.column_stack([rng.uniform(-900, 1500, 9), rng.uniform(-200, 300, 9), rng.uniform(0, 1, 9)])
    faces, lights = np.arange(9).reshape(3, 3), rng.uniform(0, 0.01, (9, 3))
    lights[0] = brightest
    assert_lit_as_the_text_does(vertices, faces, lights, (600, 90))


def test_fields_keep_to_themselves() -> None:
    """Red, green and blue step by one addition, also where one of them falls while the others rise."""
    value, step = packed(50.0, 4e5, 7.0), packed(3.0, -2000.0, 1.0)
    for k in range(100):
        here = value + k * step
        assert (here >> 2 * FIELD, here >> FIELD & FULL, here & FULL) == (
            50 + 3 * k,
            400000 - 2000 * k,
            7 + k,
        )
