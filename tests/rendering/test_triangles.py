"""Triangles on two threads, against an oracle in exact fractions, and what is refused."""

from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from typing import Any
from unittest.mock import patch

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.algorithms.visibility import depth_buffer
from workbench.algorithms.visibility.depth_front_first import depth_buffer_front_first
from workbench.algorithms.visibility.depth_tiles import parts_in_sight
from workbench.algorithms.visibility.device_plane import Corner, row_ends
from workbench.document.samples.examples import example
from workbench.engine import compiled
from workbench.engine.compiled import Stop, Stopped
from workbench.rendering import depth_buffer_triangles, triangles
from workbench.rendering.scene import render_scene

Place = tuple[int, int, float]
corner = st.tuples(st.integers(-3, 14), st.integers(-3, 11), st.sampled_from([0.25, 0.5, 0.75]))
scene = st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=6)


def covered(triangle: tuple[Place, ...], x: int, y: int) -> Fraction | None:
    """Depth of a triangle at a pixel, exactly; None outside (half-open towards the right and the top)."""
    crossings = []
    for (x0, y0, z0), (x1, y1, z1) in zip(triangle, (*triangle[1:], triangle[0]), strict=True):
        if min(y0, y1) <= y < max(y0, y1):
            along = Fraction(y - y0, y1 - y0)
            crossings.append((x0 + along * (x1 - x0), Fraction(z0) + along * (Fraction(z1) - Fraction(z0))))
    if len(crossings) != 2:
        return None
    (left, near), (right, far) = sorted(crossings)
    if not left <= x < right:
        return None
    return near + (far - near) * (x - left) / (right - left)


@given(triangles=scene)
@settings(max_examples=40)
def test_the_nearest_triangle_wins_and_the_first_on_equal_depths(triangles: list[tuple[Place, ...]]) -> None:
    vertices = np.array(triangles, np.float64).reshape(-1, 3)
    faces = np.arange(len(vertices)).reshape(-1, 3)
    image, depth = depth_buffer_triangles(vertices, faces, np.arange(1, len(faces) + 1), (12, 9))
    for y in range(9):
        for x in range(12):
            depths = {k: covered(t, x, y) for k, t in enumerate(triangles, 1)}
            found = {k: z for k, z in depths.items() if z is not None}
            if not found:
                assert image[y, x] == 0
                assert depth[y, x] == 1.0
                continue
            nearest = min(found.values())
            assert abs(depth[y, x] - float(nearest)) < 1e-12
            # Depths that differ by less than rounding may fall either way
            assert image[y, x] in {k for k, z in found.items() if z - nearest < Fraction(1, 10**12)}


far_corner = st.tuples(st.integers(-20, 90), st.integers(-20, 80), st.sampled_from([0.0, 0.25, 0.5, 1.0]))
tall = st.lists(st.tuples(far_corner, far_corner, far_corner), min_size=1, max_size=12)


@given(triangles=st.one_of(scene, tall), step=st.sampled_from([0, 1 / 3, 1 / 4096]))
@settings(max_examples=60)
def test_in_bands_the_picture_is_that_of_the_text(triangles: list[tuple[Place, ...]], step: float) -> None:
    vertices = np.array(triangles, np.float64).reshape(-1, 3)
    vertices[:, :2] *= 1 + step
    faces, colours = np.arange(len(vertices)).reshape(-1, 3), np.arange(1, len(triangles) + 1)
    image, depth = depth_buffer_triangles(vertices, faces, colours, (70, 130))
    plain, plain_depth = np.zeros((130, 70), np.int64), np.ones((130, 70))
    compiled.paint(depth_buffer, plain, 0, plain, plain_depth, vertices, faces, colours)
    assert np.array_equal(image, plain)
    assert depth.tobytes() == plain_depth.tobytes()


near_corner = st.tuples(st.integers(-9, 9), st.integers(-9, 9), st.sampled_from([-0.125, 0.0, 0.125, 0.25]))
tetrahedron = st.tuples(
    st.tuples(st.integers(0, 70), st.integers(0, 60), st.sampled_from([0.25, 0.5])),
    st.lists(near_corner, min_size=4, max_size=4),
)


def faces_of_tetrahedron(middle: Place, ways: list[Place]) -> list[list[Place]]:
    """Its faces, counter-clockwise seen from outside; z grows away from the eye."""
    a, b, c, d = (tuple(np.add(middle, way).tolist()) for way in ways)
    inside_out = np.linalg.det(np.subtract([b, c, d], a)) < 0
    return [face[::-1] if inside_out else face for face in ([a, b, c], [a, c, d], [a, d, b], [b, d, c])]


def walls_and_chips(seed: int) -> list[list[Place]]:
    """Walls towards the eye, with gaps between them, and small faces that look away: before them, behind
    them, through them."""
    at, each = np.random.default_rng(seed), []
    for _wall in range(12):
        (x, y), z = at.integers(0, 70, 2).tolist(), at.uniform(0.3, 0.7)
        each.append([(x, y, z), (x + 40, y, z), (x, y + 30, z)])
    for _chip in range(200):
        middle, ways = at.uniform(0, 70, 2), at.uniform(-6, 6, (3, 2))
        corners = np.column_stack([np.round((middle + ways) * 16) / 16, at.uniform(0.2, 0.8, 3)])
        away = np.linalg.det(ways[1:] - ways[0]) < 0
        each.append([tuple(corner) for corner in (corners if away else corners[::-1]).tolist()])
    return each


@given(
    triangles_=st.one_of(
        scene,
        tall,
        st.integers(0, 1 << 30).map(walls_and_chips),
        st.lists(tetrahedron, min_size=1, max_size=12).map(
            lambda solids: [face for solid in solids for face in faces_of_tetrahedron(*solid)]
        ),
    ),
    step=st.sampled_from([0, 1 / 3, 1 / 4096]),
)
@settings(max_examples=80)
def test_front_faces_first_the_picture_is_that_of_the_text(triangles_: Any, step: float) -> None:
    """Piercing one another, and as deep as one another."""
    vertices = np.array(triangles_, np.float64).reshape(-1, 3)
    vertices[:, :2] *= 1 + step
    faces, colours = np.arange(len(vertices)).reshape(-1, 3), np.arange(1, len(triangles_) + 1)
    with patch.object(triangles, "_MANY_TRIANGLES", 0):
        image, depth = triangles.drawn(vertices, faces, colours, (70, 60))
    plain, plain_depth = np.zeros((60, 70), np.int64), np.ones((60, 70))
    compiled.paint(depth_buffer, plain, 0, plain, plain_depth, vertices, faces, colours)
    assert np.array_equal(image, plain)
    assert depth.tobytes() == plain_depth.tobytes()


def front_first(*corners: list[Any]) -> tuple[set[int], int, set[int]]:
    """The numbers of the triangles that were drawn, whether depths were equal, the colours seen: 1 and on."""
    image, depth, ties = np.zeros((40, 40), np.int64), np.ones((40, 40)), np.zeros(1, np.int64)
    vertices, faces = np.array(corners).reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3)
    drawn = compiled.collect(
        depth_buffer_front_first, image, depth, ties, vertices, faces, np.arange(1, len(faces) + 1), 0
    )
    compiled.paint(
        depth_buffer_front_first,
        image,
        0,
        image,
        depth,
        ties,
        vertices,
        faces,
        np.arange(1, len(faces) + 1),
        0,
    )
    return set(drawn[:, 0].astype(int).tolist()), int(ties[0]), set(np.unique(image).tolist())


WALL = [[(-9.0, -9.0, 0.5), (99.0, -9.0, 0.5), (-9.0, 99.0, 0.5)]]


def looking_away(z: float) -> list[Place]:
    return [(10, 10, z), (10, 16, z), (16, 10, z)]


def test_what_looks_away_is_left_out_behind_a_later_face_and_drawn_before_it() -> None:
    assert front_first(looking_away(0.75), *WALL) == ({1}, 0, {2})
    assert front_first(looking_away(0.25), *WALL) == ({0, 1}, 0, {1, 2})


@pytest.mark.parametrize(("right", "top"), [(16, 40), (40, 8), (16, 8)])
def test_what_looks_away_is_drawn_where_it_looks_out_from_behind_tiles(right: int, top: int) -> None:
    """A tile is 16 columns and 8 rows: the wall fills the first of them, and what is behind begins there."""
    wall: list[list[Place]] = [
        [(0, 0, 0.5), (right, 0, 0.5), (right, top, 0.5)],
        [(0, 0, 0.5), (right, top, 0.5), (0, top, 0.5)],
    ]
    behind: list[Place] = [(12, 5, 0.75), (12, 11, 0.75), (20, 11, 0.75)]
    assert front_first(behind, *wall) == ({0, 1, 2}, 0, {0, 1, 2, 3})


def test_what_looks_away_and_is_as_deep_as_a_later_face_is_told() -> None:
    _drawn, ties, seen = front_first(looking_away(0.5), *WALL)
    assert (ties, seen) == (1, {2})  # in order it would be {1, 2}
    vertices, faces = np.array([looking_away(0.5), *WALL]).reshape(-1, 3), np.arange(6).reshape(-1, 3)
    with patch.object(triangles, "_MANY_TRIANGLES", 0):
        image, _depth = triangles.drawn(vertices, faces, np.array([1, 2]), (40, 40))
    assert set(np.unique(image).tolist()) == {1, 2}


def test_a_triangle_of_a_single_row_is_drawn_in_whichever_band_that_lies() -> None:
    rows = np.arange(130)
    flat = [[(0.0, y, 0.5), (4.0, y, 0.5), (0.0, y + 1.0, 0.5)] for y in range(130)]
    image, _depth = depth_buffer_triangles(
        np.reshape(flat, (-1, 3)), np.arange(390).reshape(-1, 3), rows + 1, (4, 130)
    )
    assert np.array_equal(image, np.repeat(rows[:, None] + 1, 4, axis=1))


def test_a_tile_that_a_nearer_triangle_fills_is_left_out() -> None:
    """In front of everything stands one triangle: what is drawn behind it looks at no pixel of the tiles."""
    front = [(-100.0, -10.0, 0.1), (300.0, -10.0, 0.1), (100.0, 300.0, 0.1)]
    behind = [(0.0, 0.0, 0.2), (64.0, 0.0, 0.2), (32.0, 64.0, 0.2)]
    parts, farthest = np.zeros((99, 4), np.int64), np.full((9, 5), np.inf)
    kept = []
    for corners in (front, behind):
        low, middle, high = (Corner(*corner) for corner in corners)
        ends = np.array([row_ends(low, middle, high, y) for y in range(64)])
        starts, stops = (np.clip(np.ceil(side), 0, 64).astype(np.int64) for side in ends.T)
        kept.append(parts_in_sight(parts, farthest, starts, stops, 0, 0, 64, 64, low, 0.0, 0.0))
    assert kept == [8, 0]  # a part for each strip of eight rows; nothing
    assert (farthest[:8, :4] == 0.1).all()


def test_equal_depths_keep_the_first() -> None:
    vertices = [[0, 0, 0.5], [8, 0, 0.5], [0, 8, 0.5]]
    image, _depth = depth_buffer_triangles(vertices, [[0, 1, 2], [2, 1, 0]], [5, 6], (8, 8))
    assert set(np.unique(image)) == {0, 5}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"vertices": [[0, 0]]}, "three numbers"),
        ({"faces": [[0, 1]]}, "three indices"),
        ({"faces": [[0, 1, 3]]}, "does not exist"),
        ({"faces": [[0, 1, -1]]}, "does not exist"),
        ({"colours": [1, 2]}, "one number for each face"),
        ({"vertices": [[0, 0, 0], [1, float("nan"), 0], [0, 1, 0]]}, "finite"),
        ({"size": (0, 5)}, "1 or more"),
    ],
)
def test_a_wrong_scene_is_refused(change: dict[str, Any], words: str) -> None:
    given: dict[str, Any] = {
        "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
        "faces": [[0, 1, 2]],
        "colours": [1],
        "size": (4, 4),
    }
    with pytest.raises(ValueError, match=words):
        depth_buffer_triangles(**(given | change))


def test_no_triangles_leave_an_empty_picture() -> None:
    image, depth = depth_buffer_triangles(np.zeros((0, 3)), np.zeros((0, 3), int), [], (3, 2))
    assert not image.any()
    assert (depth == 1.0).all()
    assert image.shape == (2, 3)


def test_drawing_can_be_stopped() -> None:
    stop = Stop()
    stop.set()
    with pytest.raises(Stopped):
        depth_buffer_triangles([[0, 0, 0], [8, 0, 0], [0, 8, 0]], [[0, 1, 2]], [1], (8, 8), stop)


def test_threads_that_have_ended_stop_the_work(monkeypatch: pytest.MonkeyPatch) -> None:
    """As when the program is quit while a scene is drawn."""
    ended = ThreadPoolExecutor(1)
    ended.shutdown()
    monkeypatch.setattr(triangles, "_threads", lambda: ended)
    with pytest.raises(Stopped):
        triangles.begin(print)
    house = example("space-street").document.sheets[0].scene
    assert house is not None
    with pytest.raises(Stopped):
        render_scene(house, "depth_buffer", (8, 8))
