"""The octree of a solid: beside the solid's own equation at points, and its volume by the formula."""

import itertools
import math
from random import Random
from typing import Any

import numpy as np
import pytest

from workbench.algorithms.solids.implicit import (
    BLOBS,
    BLOCK,
    CONE,
    CYLINDER,
    ELLIPSOID,
    EMPTY,
    FULL,
    HALF_SPACE,
    PARTIAL,
    TORUS,
)
from workbench.algorithms.solids.octree_cells import nodes_of
from workbench.algorithms.solids.octree_of_solid import octree_of_solid, solid_at_will
from workbench.algorithms.solids.octree_views import exact_volume

SOLIDS = [
    (ELLIPSOID, (1.0, 1.0, 1.0), 4 / 3 * math.pi),
    (ELLIPSOID, (1.5, 1.0, 0.75), 4 / 3 * math.pi * 1.5 * 0.75),
    (TORUS, (1.25, 0.5), 2 * math.pi**2 * 1.25 * 0.25),
    (CYLINDER, (1.0, 1.5), math.pi * 1.5),
    (CONE, (1.0, 1.5), math.pi * 0.5),
    (BLOCK, (1.0, 0.5, 0.25), 1.0),
]
CORNER, SIZE = np.array([-2.0, -2.0, -2.0]), 4.0


def inside(shape: int, numbers: Any, points: np.ndarray) -> np.ndarray:
    """Which points (n, 3) a solid holds, by its equation as the books have it."""
    x, y, z = points.T
    a, *rest = (float(value) for value in numbers)
    radius = np.hypot(x, z)
    if shape == ELLIPSOID:
        return (x / a) ** 2 + (y / rest[0]) ** 2 + (z / rest[1]) ** 2 < 1
    if shape == TORUS:
        return (x**2 + y**2 + z**2 + a**2 - rest[0] ** 2) ** 2 < 4 * a**2 * (x**2 + z**2)
    if shape == CYLINDER:
        return (radius < a) & (y > 0) & (y < rest[0])
    if shape == CONE:
        return (radius < a * (1 - y / rest[0])) & (y > 0) & (y < rest[0])
    if shape == BLOCK:
        return (abs(x) < a) & (abs(y) < rest[0]) & (abs(z) < rest[1])
    if shape == BLOBS:
        balls = np.array(rest[1:]).reshape(-1, 3)
        return sum(np.exp(-a * ((points - ball) ** 2).sum(axis=1)) for ball in balls) > rest[0]
    return a * x + rest[0] * y + rest[1] * z + rest[2] < 0


def cells(shape: int, numbers: Any, depth: int, inverse: np.ndarray | None = None) -> np.ndarray:
    moved = np.eye(3, 4) if inverse is None else inverse
    text = octree_of_solid(shape, np.array(numbers), moved, CORNER, SIZE, depth)
    return np.array(list(text))


def volumes(rows: np.ndarray) -> tuple[float, float]:
    cubes = rows[:, 3] ** 3
    return float(cubes[rows[:, 4] == FULL].sum()), float(cubes[rows[:, 4] != EMPTY].sum())


@pytest.mark.parametrize("number", range(60))
def test_cells_fill_the_cube_and_hold_the_solid(number: int) -> None:
    shape, numbers, inverse, corner, size, depth = solid_at_will(Random(number))
    rows = np.array(list(octree_of_solid(shape, numbers, inverse, corner, size, depth)))
    assert (rows[:, 3] ** 3).sum() == pytest.approx(size**3)
    points = np.random.default_rng(number).uniform(corner, corner + size, (300, 3))
    holds = (rows[:, None, :3] <= points) & (points < rows[:, None, :3] + rows[:, None, 3:4])
    which = holds.all(axis=2)
    assert (which.sum(axis=0) == 1).all()
    states = rows[which.argmax(axis=0), 4]
    held = inside(shape, numbers, points @ inverse[:, :3].T + inverse[:, 3])
    assert held[states == FULL].all()
    assert not held[states == EMPTY].any()
    smallest = size / 2**depth
    assert (rows[rows[:, 4] == PARTIAL, 3] == smallest).all()


@pytest.mark.parametrize(("shape", "numbers", "volume"), SOLIDS)
def test_the_volume_is_between_the_bounds(shape: int, numbers: Any, volume: float) -> None:
    least, most = volumes(cells(shape, numbers, 4))
    assert least <= volume <= most
    assert exact_volume(shape, np.array(numbers), np.eye(3, 4)) == pytest.approx(volume)
    twice = np.column_stack([np.eye(3) * 2, np.zeros(3)])
    assert exact_volume(shape, np.array(numbers), twice) == pytest.approx(volume / 8)


@pytest.mark.parametrize(("shape", "numbers", "_volume"), SOLIDS)
def test_deeper_the_bounds_come_nearer(shape: int, numbers: Any, _volume: float) -> None:
    bounds = [volumes(cells(shape, numbers, depth)) for depth in (1, 2, 3, 4)]
    for (low, high), (lower, higher) in itertools.pairwise(bounds):
        assert low <= lower <= higher <= high
    assert bounds[-1][1] - bounds[-1][0] < 0.6 * (bounds[0][1] - bounds[0][0])


def test_a_block_of_whole_cells_is_exact_and_is_not_divided_further() -> None:
    rows = cells(BLOCK, (1.0, 2.0, 1.0), 5)
    assert volumes(rows) == (16.0, 16.0)
    assert set(rows[:, 3]) == {1.0}
    assert not (rows[:, 4] == PARTIAL).any()


def test_a_turned_solid_is_told_by_bounds_that_are_never_too_narrow() -> None:
    turn = math.radians(30)
    inverse = np.array(
        [[math.cos(turn), -math.sin(turn), 0, 0], [math.sin(turn), math.cos(turn), 0, 0.5], [0, 0, 1, 0]]
    )
    least, most = volumes(cells(BLOCK, (1.0, 0.5, 0.25), 5, inverse))
    assert 0.3 < least <= 1.0 <= most < 2.5


def test_a_half_space_through_the_middle_fills_half_of_the_cube() -> None:
    assert volumes(cells(HALF_SPACE, (0.0, 1.0, 0.0, 0.0), 3)) == (32.0, 32.0)


@pytest.mark.parametrize("number", range(12))
def test_the_table_of_nodes_is_that_of_the_cells(number: int) -> None:
    arguments = solid_at_will(Random(number))
    text = octree_of_solid(*arguments)
    rows, nodes = [next(text)], []
    nodes = text.gi_frame.f_locals["nodes"]  # type: ignore[attr-defined]
    rows += list(text)
    *_solid, corner, size, _depth = arguments

    def leaves(node: int, low: np.ndarray, side: float) -> set[tuple[float, ...]]:
        """The cells that a table tells, depth first."""
        told: set[tuple[float, ...]] = set()
        for octant, value in enumerate(nodes[node - 1]):
            at = low + side / 2 * np.array([octant >> 2 & 1, octant >> 1 & 1, octant & 1])
            told |= leaves(-value, at, side / 2) if value < 0 else {(*at.tolist(), side / 2, value)}
        return told

    assert leaves(1, corner, size) == set(rows)
    other = nodes_of(np.array(rows), corner, size)
    assert sorted(map(sum, (np.array(nodes) >= 0))) == sorted(map(sum, other >= 0))
    nodes = other.tolist()
    assert leaves(1, corner, size) == set(rows)
