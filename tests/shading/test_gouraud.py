"""Gouraud shading against shares of areas in fractions, and against the depth buffer."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.visibility.exact_scenes import HEIGHT, KINDS, WIDTH, arrays, piercing, scenes
from tests.visibility.test_depth_buffer import covers, depth_at
from workbench.algorithms.shading import gouraud
from workbench.algorithms.visibility import depth_buffer
from workbench.display.exposure import srgb_encoded
from workbench.engine.compiled import paint
from workbench.rendering.gouraud_triangles import gouraud_drawn


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


@given(seed=st.integers(0, 2**32 - 1))
@settings(max_examples=40)
def test_whole_pictures_are_lit_as_the_text_does(seed: int) -> None:
    rng = np.random.default_rng(seed)
    vertices = np.column_stack([rng.integers(-8, 48, (15, 2)) / rng.choice([1, 4]), rng.uniform(0, 1, 15)])
    faces, lights = rng.integers(0, 15, (6, 3)), rng.integers(0, 9, (15, 3)) / 8
    image, depth = gouraud_drawn(vertices, faces, lights, (40, 36))
    for channel, shift in enumerate((16, 8, 0)):
        light, nearest = np.zeros((36, 40)), np.ones((36, 40))
        paint(gouraud, light, 0, light, vertices, faces, np.ascontiguousarray(lights[:, channel]), nearest)
        assert np.array_equal(depth, nearest)
        coded = srgb_encoded(light) * 255
        assert np.abs((image >> shift & 255) - coded).max() <= 1.01
