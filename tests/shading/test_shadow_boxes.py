"""Boxes around blockers: they hold what is in them, and no ray is judged otherwise for them."""

import numpy as np
import pytest

from workbench.algorithms import catalogue
from workbench.algorithms.shading import illuminate
from workbench.algorithms.shading.illumination import in_shadow
from workbench.algorithms.shading.shadow_boxes import boxed_blockers, is_box
from workbench.algorithms.visibility.back_faces import SpaceVector
from workbench.engine import compiled


def crowd(count: int, seed: int) -> np.ndarray:
    """Corners (3 count, 3) of triangles on whole coordinates, some level, some in one place."""
    chance = np.random.default_rng(seed)
    corners = chance.integers(-9, 10, (count, 1, 3)) + chance.integers(-2, 3, (count, 3, 3))
    corners[::4, :, 1] = corners[::4, :1, 1]
    corners[::7] = corners[:1]
    return corners.reshape(-1, 3).astype(float)


def boxed(blockers: np.ndarray) -> np.ndarray:
    return np.array(list(boxed_blockers(blockers)), float).reshape(-1, 3)


@pytest.mark.parametrize("count", [0, 1, 4, 5, 60])
def test_rows_are_the_triangles_and_boxes_that_hold_what_is_in_them(count: int) -> None:
    blockers = crowd(count, 1)
    rows = boxed(blockers)
    kept = []
    for k in range(0, len(rows), 3):
        if not is_box(rows, k):
            kept.append(rows[k : k + 3])
            continue
        inside = rows[k + 3 : k + 3 + int(rows[k + 2, 0])]
        finite = inside[[n for n in range(len(inside)) if not is_box(inside, n - n % 3) or n % 3 < 2]]
        assert len(finite)
        assert (rows[k] <= finite).all()
        assert (finite <= rows[k + 1]).all()
    assert sorted(np.array(kept).reshape(-1, 9).tolist()) == sorted(blockers.reshape(-1, 9).tolist())
    assert (len(kept) < len(rows) / 3) == (count > 4)


@pytest.mark.parametrize("seed", range(4))
def test_the_same_places_are_in_shadow(seed: int) -> None:
    """Rays on whole coordinates, many of them along an axis, in a face or to a corner."""
    blockers = crowd(60, seed)
    rows, chance = boxed(blockers), np.random.default_rng(seed + 100)
    dark = 0
    for number in range(400):
        place = SpaceVector(*chance.integers(-12, 13, 3).astype(float).tolist())
        way = chance.integers(-12, 13, 3).astype(float) * (chance.random(3) < 0.7)
        reach = 1.0 if number % 2 else float("inf")
        plain = in_shadow(place, SpaceVector(*way.tolist()), reach, blockers)
        assert in_shadow(place, SpaceVector(*way.tolist()), reach, rows) == plain
        dark += plain
    assert 20 < dark < 380


@pytest.mark.parametrize("seed", range(4))
def test_light_is_the_same_through_boxes(seed: int) -> None:
    """What ``illuminate`` emits beside a crowd of blockers, as they are and in boxes."""
    place, *given, _blockers = catalogue.get(illuminate.__name__).example
    blockers, dark = crowd(60, seed) / 8.0 + (0.0, 0.0, 1.25), set()
    for x, y in np.random.default_rng(seed).uniform(-2.0, 2.0, (40, 2)).tolist():
        there = place + np.array([x, y, 0.0])
        plain = list(illuminate(there, *given, blockers))
        assert list(illuminate(there, *given, boxed(blockers))) == plain
        dark.add(plain != list(illuminate(there, *given, blockers[:0])))
    assert dark == {True, False}


def test_compiled_they_are_the_same() -> None:
    blockers = crowd(60, 3)
    assert np.array_equal(compiled.collect(boxed_blockers, blockers, flavour="checked"), boxed(blockers))


def test_of_four_times_as_many_a_ray_tries_few_more() -> None:
    """Sheets above one another, cut ever finer: of a ray upwards."""

    def tried(side: int) -> int:
        x, y = np.meshgrid(np.arange(side) / side, np.arange(side) / side)
        low = np.stack([x, y, np.ones_like(x)], -1).reshape(-1, 1, 3)
        rows = boxed((low + np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]]) / side).reshape(-1, 3))
        looked, k = 0, 0
        place, way = SpaceVector(0.51, 0.98, 0.0), SpaceVector(0.0, 0.0, 1.0)
        while k < len(rows):
            inside = int(rows[k + 2, 0]) if is_box(rows, k) else 0
            looked += 1
            misses = inside and not in_shadow(place, way, 9.0, rows[k : k + 3 + inside])
            k += 3 + (inside if misses else 0)
        return looked

    assert tried(32) < 2 * tried(8)
