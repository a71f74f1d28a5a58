"""Ray casting through boxes: the picture of ray casting, and boxes that hold what is in them."""

from collections.abc import Callable
from itertools import pairwise
from random import Random
from typing import Any

import numpy as np
import pytest

from tests.visibility.exact_scenes import KINDS, Scene, picture, scenes
from workbench.algorithms.visibility import ray_casting, ray_casting_boxes
from workbench.algorithms.visibility.box_examples import many_surfaces
from workbench.algorithms.visibility.boxes import FEW, NONE, Boxes, extents_of
from workbench.algorithms.visibility.surfaces import in_view, surfaces_of
from workbench.engine.counts import counts
from workbench.rendering.scene.methods import picture_by, surfaces_seen


def crowd(count: int, seed: int = 0, reach: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """So many triangles anywhere in 32 x 24 pixels, corners on quarters, a fifth of them twice."""
    chance = np.random.default_rng(seed)
    corners = chance.integers(0, 4 * 32, (count, 1, 3)) + chance.integers(
        -4 * reach, 4 * reach, (count, 3, 3)
    )
    corners[::5] = corners[(np.arange(count) // 2)[::5]]
    return (corners / (4, 4, 256)).reshape(-1, 3), np.arange(3 * count).reshape(-1, 3)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_every_pixel_shows_what_ray_casting_shows(kind: Callable[[Random], Scene]) -> None:
    for scene in scenes(kind, 40):
        assert np.array_equal(picture(ray_casting_boxes, scene), picture(ray_casting, scene))


@pytest.mark.parametrize("seed", range(5))
def test_of_crowds_it_shows_the_same(seed: int) -> None:
    """Boxes many deep, equal depths among them: the lower number is seen."""
    one, other = (
        surfaces_seen(method, *crowd(300, seed), (32, 24)) for method in ("ray_casting", "ray_casting_boxes")
    )
    assert len(np.unique(one)) > 50
    assert np.array_equal(one, other)


def built(vertices: np.ndarray, faces: np.ndarray) -> tuple[Boxes, np.ndarray, int, np.ndarray]:
    """The boxes around some surfaces, their order, how many boxes there are, and the surfaces' extents."""
    image = np.zeros((40, 40), np.int64)
    text = ray_casting_boxes(image, vertices, faces, np.arange(1, len(faces) + 1))
    next(text)
    now = text.gi_frame.f_locals  # type: ignore[attr-defined]
    return now["boxes"], now["order"], now["total"], extents_of(surfaces_of(vertices, faces))


def test_boxes_hold_their_surfaces() -> None:
    for seed in range(5):
        vertices, faces = crowd(120, seed)
        boxes, order, total, extents = built(vertices, faces)
        assert sorted(order.tolist()) == in_view(surfaces_of(vertices, faces))
        ends = []
        for box in range(total):
            held = extents[order[boxes.first[box] : boxes.end[box]]]
            low, high = boxes.extents[box, ::2], boxes.extents[box, 1::2]
            assert np.array_equal(low, held[:, ::2].min(axis=0))
            assert np.array_equal(high, held[:, 1::2].max(axis=0))
            inner = boxes.inner[box]
            if inner == NONE:
                ends.append((int(boxes.first[box]), int(boxes.end[box])))
                continue
            assert boxes.first[box] == boxes.first[inner] < boxes.end[inner] == boxes.first[inner + 1]
            assert boxes.first[inner + 1] < boxes.end[inner + 1] == boxes.end[box]
            assert (low <= boxes.extents[inner : inner + 2, ::2]).all()
            assert (boxes.extents[inner : inner + 2, 1::2] <= high).all()
        ends.sort()
        assert ends[0][0] == 0
        assert ends[-1][1] == len(order)
        assert all(one[1] == other[0] for one, other in pairwise(ends))


def test_surfaces_in_one_place_are_not_parted_for_ever() -> None:
    vertices = np.tile([(0.0, 0.0, 0.5), (4.0, 0.0, 0.5), (0.0, 4.0, 0.5)], (3 * FEW, 1))
    boxes, _order, total, _extents = built(vertices, np.arange(9 * FEW).reshape(-1, 3))
    assert total == 1
    assert boxes.inner[0] == NONE


def test_twice_as_many_surfaces_are_far_from_twice_the_work() -> None:
    """Of a net over the picture a ray is tried on a few faces, however fine the net is."""

    def tests(method: Callable[..., Any], side: int) -> int:
        y, x = np.mgrid[: side + 1, : side + 1]
        corners = np.stack([x * 32 / side, y * 32 / side, 0.5 + x * y % 7 / 32], axis=-1).reshape(-1, 3)
        low = (y * (side + 1) + x)[:-1, :-1].reshape(-1, 1)
        above = side + 1
        faces = np.concatenate([low + np.array(each) for each in ((0, 1, above), (1, above + 1, above))])
        image = np.zeros((24, 32), np.uint32)
        work = counts(method, image, corners, faces, np.arange(len(faces)), compiling=False)
        return sum(n for title, n in work.block_visits.items() if title.startswith("Find where the ray"))

    coarse, fine = (tests(ray_casting_boxes, side) for side in (4, 8))
    assert fine < 1.6 * coarse
    assert tests(ray_casting, 4) > 3 * coarse


def test_a_picture_by_ray_casting_is_made_through_boxes(monkeypatch: pytest.MonkeyPatch) -> None:
    from workbench.engine import compiled

    painted: list[object] = []

    def paint(function: object, image: np.ndarray, *_rest: object, **_options: object) -> None:
        painted.append(function)

    monkeypatch.setattr(compiled, "paint", paint)
    vertices, faces = crowd(20)
    picture_by("ray_casting", vertices, faces, np.arange(20), (32, 24))
    assert painted == [ray_casting_boxes]


def test_what_is_generated_is_divided_at_times() -> None:
    deep = [built(*many_surfaces(Random(seed))[1:3])[2] for seed in range(30) if covered(seed)]
    assert max(deep) > 1


def covered(seed: int) -> bool:
    _image, *rest = many_surfaces(Random(seed))
    return any(True for _pixel in ray_casting_boxes(np.zeros((40, 40), np.int64), *rest))
