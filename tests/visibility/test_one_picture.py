"""All methods give one picture: pixel for pixel that of the depth buffer, exact ties excepted."""

from collections.abc import Callable
from random import Random
from typing import Any

import numpy as np
import pytest

from tests.visibility.exact_scenes import (
    HEIGHT,
    KINDS,
    WIDTH,
    Scene,
    assert_same_but_for_ties,
    at,
    buffered,
    coplanar,
    corner,
    cyclic,
    mesh,
    picture,
    piercing,
    scenes,
)
from workbench.algorithms.visibility import (
    area_subdivision,
    bsp_tree,
    depth_sort,
    octree,
    ray_casting,
    ray_casting_boxes,
    scan_line_surfaces,
)

METHODS = [depth_sort, bsp_tree, area_subdivision, ray_casting, ray_casting_boxes]
COUNT = 40


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
@pytest.mark.parametrize("method", METHODS, ids=lambda method: method.__name__)
def test_they_give_the_picture_of_the_depth_buffer(
    method: Callable[..., Any], kind: Callable[[Random], Scene]
) -> None:
    for scene in scenes(kind, COUNT):
        assert_same_but_for_ties(picture(method, scene), scene)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_the_octree_gives_it_too(kind: Callable[[Random], Scene]) -> None:
    for scene in scenes(kind, 10):
        assert_same_but_for_ties(picture(octree, scene), scene)


@pytest.mark.parametrize("method", [*METHODS, octree, scan_line_surfaces], ids=lambda m: m.__name__)
def test_in_one_plane_the_lower_number_is_seen(method: Callable[..., Any]) -> None:
    """These depths are exact in floats, so that ties are ties, and all methods decide them alike."""
    for scene in scenes(coplanar, 15):
        assert np.array_equal(picture(method, scene), buffered(scene))


def change_places(scene: Scene) -> bool:
    """Whether on some row now the one, now the other of two triangles is nearer, by exact depths."""
    for y in range(HEIGHT):
        nearer: set[tuple[int, int]] = set()
        for x in range(WIDTH):
            here = at(scene, x, y)
            nearer |= {(a, b) for z, a in here for other, b in here if z < other}
        if any((b, a) in nearer for a, b in nearer):
            return True
    return False


def test_the_scan_line_gives_it_where_no_surface_pierces_another() -> None:
    tried = 0
    for kind, count in ((mesh, 12), (coplanar, 30), (cyclic, 10), (piercing, 20)):
        for scene in scenes(kind, count):
            if not change_places(scene):
                tried += 1
                assert_same_but_for_ties(picture(scan_line_surfaces, scene), scene)
    assert tried > 40


def test_the_scan_line_fails_where_a_surface_pierces_another() -> None:
    """One comparison decides a whole span, as the book presumes."""
    slope = corner(0, 0, 0), corner(32, 0, 1), corner(0, 32, 0)
    wall = tuple(corner(x, y, "9/64") for x, y in ((0, 0), (32, 0), (0, 32)))
    scene: Scene = [slope, wall]  # type: ignore[list-item]
    assert change_places(scene)
    assert set(buffered(scene)[0]) == {1, 2}
    assert len(set(picture(scan_line_surfaces, scene)[0])) == 1


@pytest.mark.parametrize("method", [*METHODS, octree, scan_line_surfaces], ids=lambda m: m.__name__)
def test_of_nothing_they_paint_nothing(method: Callable[..., Any]) -> None:
    edge_on = corner(1, 1, 0), corner(5, 5, 0), corner(3, 3, 1)
    assert not picture(method, [edge_on]).any()
    image = np.zeros((2, 2), np.int64)
    nothing = np.zeros((0, 3)), np.zeros((0, 3), np.int64), np.zeros(0, np.int64)
    assert list(method(image, *nothing)) == []
