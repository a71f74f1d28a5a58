"""The A-buffer against layers of glass in fractions."""

from fractions import Fraction
from random import Random

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.visibility.exact_scenes import (
    HEIGHT,
    KINDS,
    WIDTH,
    Scene,
    arrays,
    at,
    buffered,
    corner,
    piercing,
    scenes,
)
from workbench.algorithms.visibility import a_buffer

Numbers = NDArray[np.float64]


def lit(scene: Scene, ground: float, intensities: Numbers, opacities: Numbers) -> Numbers:
    light = np.full((HEIGHT, WIDTH), ground)
    vertices, faces, _colours = arrays(scene)
    emitted = list(a_buffer(light, vertices, faces, intensities, opacities))
    assert all(light[y, x] == value for x, y, value in emitted)
    return light


def test_of_two_panes_before_a_ground() -> None:
    """0.8 and 0.4, both half transparent, ground 0.2: 0.55."""
    pane = [(0, 0), (20, 0), (0, 20)]
    scene: Scene = [
        tuple(corner(x, y, z) for x, y in pane)
        for z in (Fraction(1, 4), Fraction(1, 2))  # type: ignore[misc]
    ]
    light = lit(scene, 0.2, np.array([0.8, 0.4]), np.array([0.5, 0.5]))
    assert light[3, 3] == pytest.approx(0.55)
    assert lit(scene[::-1], 0.2, np.array([0.4, 0.8]), np.array([0.5, 0.5]))[3, 3] == pytest.approx(0.55)


def shares(chance: Random, count: int) -> list[Fraction]:
    return [Fraction(chance.randint(0, 8), 8) for _surface in range(count)]


def test_the_light_is_that_of_layers_in_fractions() -> None:
    chance = Random("layers")
    for kind in KINDS:
        for scene in scenes(kind, 10):
            intensities, opacities = shares(chance, len(scene)), shares(chance, len(scene))
            light = lit(scene, 0.25, np.array(intensities, float), np.array(opacities, float))
            for y in range(HEIGHT):
                for x in range(WIDTH):
                    exact = Fraction(1, 4)
                    for _z, colour in sorted(at(scene, x, y), key=lambda here: (-here[0], -here[1])):
                        share = opacities[colour - 1]
                        exact = share * intensities[colour - 1] + (1 - share) * exact
                    assert light[y, x] == pytest.approx(float(exact), abs=1e-12)


def test_opaque_surfaces_hide_as_in_the_depth_buffer() -> None:
    for kind in KINDS:
        for scene in scenes(kind, 10):
            colours = np.arange(1.0, len(scene) + 1)
            light = lit(scene, 0.0, colours / 8, np.ones(len(scene)))
            assert np.array_equal(light * 8, buffered(scene))


def test_the_order_of_the_surfaces_does_not_matter() -> None:
    chance = Random("order")
    for scene in scenes(piercing, 10):
        count = len(scene)
        intensities, opacities = (np.array(shares(chance, count), float) for _kind in "io")
        forwards = lit(scene, 0.5, intensities, opacities)
        backwards = lit(scene[::-1], 0.5, intensities[::-1], opacities[::-1])
        for y, x in np.argwhere(np.abs(forwards - backwards) > 1e-12).tolist():
            depths = [z for z, _colour in at(scene, x, y)]
            assert len(set(depths)) < len(depths)
