"""Methods that paint from back to front: what the order is, and that each pixel is painted in that order."""

from collections.abc import Callable
from fractions import Fraction
from itertools import permutations
from random import Random
from typing import Any

import numpy as np
import pytest

from tests.visibility.exact_scenes import (
    HEIGHT,
    KINDS,
    WIDTH,
    Scene,
    arrays,
    assert_same_but_for_ties,
    at,
    buffered,
    corner,
    cyclic,
    picture,
    piercing,
    scenes,
)
from workbench.algorithms.visibility import bsp_tree, depth_sort, painter
from workbench.algorithms.visibility.surface_scene import cycle


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_the_painter_shows_the_surface_whose_greatest_depth_is_least(kind: Callable[[Random], Scene]) -> None:
    for scene in scenes(kind, 15):
        image = picture(painter, scene)
        greatest = [max(z for _x, _y, z in triangle) for triangle in scene]
        for y in range(HEIGHT):
            for x in range(WIDTH):
                here = [(greatest[colour - 1], colour) for _z, colour in at(scene, x, y)]
                assert image[y, x] == min(here, default=(0, 0))[1]


def test_layers_are_painted_as_by_the_depth_buffer() -> None:
    chance = Random("layers")
    for scene in scenes(piercing, 40):
        levels = chance.sample(range(len(scene)), len(scene))
        layers = [
            tuple(corner(x, y, (level + z * Fraction(15, 16)) / len(scene)) for x, y, z in triangle)
            for level, triangle in zip(levels, scene, strict=True)
        ]
        assert np.array_equal(picture(painter, layers), buffered(layers))  # type: ignore[arg-type]


def test_the_painter_fails_on_a_cycle() -> None:
    """In most orders some slat hides a part of another that is seen; the depth sort never does."""
    corners = [corner(*place) for place in cycle()]
    slats = [tuple(corners[k : k + 3]) for k in range(0, len(corners), 3)]
    orders: list[Scene] = list(map(list, permutations(slats)))  # type: ignore[arg-type]
    assert sum((picture(painter, scene) != buffered(scene)).any() for scene in orders) >= 20
    for scene in orders:
        assert_same_but_for_ties(picture(depth_sort, scene), scene)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
@pytest.mark.parametrize("method", [depth_sort, bsp_tree], ids=lambda method: method.__name__)
def test_each_surface_paints_its_pixels_once_and_the_farther_one_first(
    method: Callable[..., Any], kind: Callable[[Random], Scene]
) -> None:
    """Nothing of a surface is lost or painted twice by its pieces; of equal depths any may come first."""
    for scene in scenes(kind, 15):
        image = np.zeros((HEIGHT, WIDTH), np.int64)
        painted: dict[tuple[int, int], list[int]] = {}
        for y, left, right, surface in method(image, *arrays(scene)):
            assert (image[y, left : right + 1] == surface + 1).all()
            for x in range(left, right + 1):
                painted.setdefault((x, y), []).append(surface + 1)
        for y in range(HEIGHT):
            for x in range(WIDTH):
                depths = {colour: z for z, colour in at(scene, x, y)}
                order = painted.get((x, y), [])
                assert sorted(order) == sorted(depths)
                assert [depths[colour] for colour in order] == sorted(depths.values(), reverse=True)


def test_the_depth_sort_ends_where_no_order_helps() -> None:
    """Cycles, one outline at many depths, copies of one surface, fans about one corner, all in any order."""
    chance = Random("ends")
    outline = ((0, 0), (11, 1), (4, 8))
    for _scene in range(25):
        count = chance.randint(3, 7)
        depths = [[chance.randint(0, 4) for _corner in outline] for _triangle in range(count)]
        scene: Scene = [
            tuple(corner(x, y, Fraction(z, 8)) for (x, y), z in zip(outline, row, strict=True))  # type: ignore[misc]
            for row in depths
        ]
        scene += cyclic(chance)
        scene += [scene[chance.randrange(len(scene))] for _copy in range(2)]
        chance.shuffle(scene)
        assert_same_but_for_ties(picture(depth_sort, scene), scene)
