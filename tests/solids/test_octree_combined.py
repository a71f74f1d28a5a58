"""Two octrees combined: beside the sets themselves, at points, and by the measures of sets."""

from random import Random

import numpy as np
import pytest

from tests.solids.test_octree_of_solid import inside, volumes
from workbench.algorithms.solids.implicit import BLOCK, EMPTY, FULL, HALF_SPACE, PARTIAL
from workbench.algorithms.solids.octree_cells import nodes_of
from workbench.algorithms.solids.octree_combined import octree_combined
from workbench.algorithms.solids.octree_of_solid import octree_of_solid, solid_at_will
from workbench.algorithms.solids.octree_pairs import DIFFERENCE, INTERSECTION, UNION

CORNER, SIZE = np.full(3, -2.0), 4.0


def octree(shape: int, numbers: object, inverse: np.ndarray, depth: int) -> np.ndarray:
    text = octree_of_solid(shape, np.asarray(numbers), inverse, CORNER, SIZE, depth)
    return nodes_of(np.array(list(text)), CORNER, SIZE)


def combined(first: np.ndarray, second: np.ndarray, operation: int) -> np.ndarray:
    return np.array(list(octree_combined(first, second, operation, CORNER, SIZE)))


@pytest.mark.parametrize("operation", [UNION, INTERSECTION, DIFFERENCE])
@pytest.mark.parametrize("number", range(20))
def test_cells_are_those_of_the_sets(number: int, operation: int) -> None:
    chance = Random(number)
    solids = [solid_at_will(chance)[:3] for _which in range(2)]
    rows = combined(*(octree(*solid, chance.randint(1, 3)) for solid in solids), operation)
    assert (rows[:, 3] ** 3).sum() == pytest.approx(SIZE**3)
    points = np.random.default_rng(number).uniform(-2, 2, (300, 3))
    which = ((rows[:, None, :3] <= points) & (points < rows[:, None, :3] + rows[:, None, 3:4])).all(axis=2)
    assert (which.sum(axis=0) == 1).all()
    states = rows[which.argmax(axis=0), 4]
    one, other = (
        inside(shape, numbers, points @ inverse[:, :3].T + inverse[:, 3])
        for shape, numbers, inverse in solids
    )
    held = {UNION: one | other, INTERSECTION: one & other, DIFFERENCE: one & ~other}[operation]
    assert held[states == FULL].all()
    assert not held[states == EMPTY].any()


@pytest.mark.parametrize("number", range(8))
def test_union_and_intersection(number: int) -> None:
    chance = Random(number)
    one, other = (octree(*solid_at_will(chance)[:3], 2) for _which in range(2))
    for operation in (UNION, INTERSECTION):
        assert set(map(tuple, combined(one, other, operation))) == set(
            map(tuple, combined(other, one, operation))
        )
    whole = [np.array([[state] * 8]) for state in (EMPTY, FULL)]
    alone = [volumes(combined(each, whole[1], INTERSECTION)) for each in (one, other)]
    together = [volumes(combined(one, other, operation)) for operation in (UNION, INTERSECTION)]
    for bound in (0, 1):
        assert sum(each[bound] for each in alone) == pytest.approx(sum(each[bound] for each in together))
    assert volumes(combined(one, one, DIFFERENCE))[0] == 0.0
    assert volumes(combined(one, whole[0], DIFFERENCE)) == pytest.approx(alone[0])


def test_a_plane_cuts_a_block_in_halves() -> None:
    block = octree(BLOCK, [1.0, 1.0, 1.0], np.eye(3, 4), 3)
    half = octree(HALF_SPACE, [0.0, 0.0, 1.0, 0.0], np.eye(3, 4), 3)
    rows = combined(block, half, INTERSECTION)
    assert volumes(rows) == (4.0, 4.0)
    assert (rows[rows[:, 4] == FULL, 2] < 0).all()
    assert not (rows[:, 4] == PARTIAL).any()
