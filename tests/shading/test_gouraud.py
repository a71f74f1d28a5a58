"""Gouraud shading against shares of areas in fractions, and against the depth buffer."""

from fractions import Fraction

import numpy as np
import pytest

from tests.visibility.exact_scenes import HEIGHT, KINDS, WIDTH, arrays, piercing, scenes
from tests.visibility.test_depth_buffer import covers, depth_at
from workbench.algorithms.shading import gouraud
from workbench.algorithms.visibility import depth_buffer


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
