"""The depth buffer against every pixel reckoned on its own in fractions.

Corners lie on quarters of a pixel and depths on sixteenths: then two exact depths that differ do so by
far more than the arithmetic errs, and a division that should come out whole does. Only exact ties are
excepted.
"""

from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from workbench.algorithms.visibility import depth_buffer

WIDTH, HEIGHT = 10, 8
Corner = tuple[Fraction, Fraction, Fraction]
Triangle = tuple[Corner, Corner, Corner]
Place = tuple[Fraction | int, ...]

corners = st.tuples(
    st.integers(-12, 52).map(lambda n: Fraction(n, 4)),
    st.integers(-12, 44).map(lambda n: Fraction(n, 4)),
    st.integers(0, 15).map(lambda n: Fraction(n, 16)),
)
scenes = st.lists(st.tuples(corners, corners, corners), min_size=1, max_size=5)


def arrays(scene: list[Triangle]) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.uint32]]:
    vertices = np.array([[float(v) for v in corner] for triangle in scene for corner in triangle])
    faces = np.arange(3 * len(scene)).reshape(-1, 3)
    return vertices, faces, np.arange(1, len(scene) + 1, dtype=np.uint32)


def render(
    scene: list[Triangle],
) -> tuple[NDArray[np.uint32], NDArray[np.float64], list[tuple[int, int, float, int]]]:
    image, depth = np.zeros((HEIGHT, WIDTH), np.uint32), np.ones((HEIGHT, WIDTH))
    return image, depth, list(depth_buffer(image, depth, *arrays(scene)))


def covers(triangle: Triangle, x: int, y: int) -> bool:
    """Half-open: y_low <= y < y_high of an edge makes a crossing, and x_left <= x < x_right between them."""
    crossings = []
    for (ax, ay, _), (bx, by, _) in zip(triangle, triangle[1:] + triangle[:1], strict=True):
        if min(ay, by) <= y < max(ay, by):
            crossings.append(ax + (y - ay) * (bx - ax) / (by - ay))
    return len(crossings) == 2 and min(crossings) <= x < max(crossings)


def depth_at(triangle: Triangle, x: int, y: int) -> Fraction:
    """By the shares of the triangle's area opposite each corner."""

    def area(p: Place, q: Place, r: Place) -> Fraction:
        return Fraction((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]))

    a, b, c = triangle
    here = (x, y)
    whole = area(a, b, c)
    return (area(here, b, c) * a[2] + area(a, here, c) * b[2] + area(a, b, here) * c[2]) / whole


@given(scene=scenes)
def test_at_each_pixel_the_exactly_nearest_wins(scene: list[Triangle]) -> None:
    image, depth, emitted = render(scene)
    tested: dict[tuple[int, int], list[tuple[float, int]]] = {}
    for x, y, z, won in emitted:
        tested.setdefault((x, y), []).append((z, won))
    for y in range(HEIGHT):
        for x in range(WIDTH):
            here = [(depth_at(t, x, y), n) for n, t in enumerate(scene, 1) if covers(t, x, y)]
            assert len(tested.get((x, y), [])) == len(here)
            if not here:
                assert image[y, x] == 0
                assert depth[y, x] == 1.0
                continue
            nearest = min(here)[0]
            assert image[y, x] in [number for z, number in here if z == nearest]
            assert abs(depth[y, x] - float(nearest)) < 1e-12
            assert depth[y, x] == min(z for z, _ in tested[x, y])


@given(scene=scenes)
def test_won_says_what_became_of_the_fragment(scene: list[Triangle]) -> None:
    stored: dict[tuple[int, int], float] = {}
    for x, y, z, won in render(scene)[2]:
        assert won == (z < stored.get((x, y), 1.0))
        if won:
            stored[x, y] = z


@given(scene=scenes, again=st.integers(0, 4))
def test_on_equal_depth_the_first_stays(scene: list[Triangle], again: int) -> None:
    """A triangle drawn a second time, in another colour, wins nowhere."""
    image, depth, _emitted = render(scene)
    repeated, same_depth, emitted = render([*scene, scene[again % len(scene)]])
    assert np.array_equal(image, repeated)
    assert np.array_equal(depth, same_depth)
    assert sum(won for *_place, won in emitted) == sum(won for *_place, won in _emitted)


@given(scene=scenes)
def test_the_order_matters_only_where_depths_are_equal(scene: list[Triangle]) -> None:
    forwards = render(scene)[0]
    backwards = render(scene[::-1])[0]
    for y, x in np.argwhere(forwards + backwards != np.where(forwards, len(scene) + 1, 0)):
        depths = [depth_at(t, x, y) for t in scene if covers(t, x, y)]
        assert depths.count(min(depths)) > 1


@given(
    hub=st.tuples(st.floats(1.5, 7.5), st.floats(1.5, 5.5)),
    above=st.lists(st.integers(1280, 8191), max_size=4, unique=True),
    right=st.lists(st.integers(1280, 6143), max_size=4, unique=True),
)
def test_a_fan_of_triangles_has_neither_overlap_nor_gap(
    hub: tuple[float, float], above: list[int], right: list[int]
) -> None:
    """Whatever the hub, its triangles share out the rectangle 1.25 <= x < 8, 1.25 <= y < 6."""
    ring = [(1.25, 1.25), (8.0, 1.25)]
    ring += [(8.0, n / 1024) for n in sorted(right) if n > 1280] + [(8.0, 6.0)]
    ring += [(n / 1024, 6.0) for n in sorted(above, reverse=True) if n > 1280] + [(1.25, 6.0)]
    n = len(ring)
    vertices = np.array([(*hub, 0.5), *((x, y, 0.5) for x, y in ring)])
    faces = np.array([(0, 1 + k, 1 + (k + 1) % n) for k in range(n)])
    image, depth = np.zeros((HEIGHT, WIDTH), np.int64), np.ones((HEIGHT, WIDTH))
    fragments = depth_buffer(image, depth, vertices, faces, np.ones(n, np.int64))
    assert sorted((x, y) for x, y, *_ in fragments) == [(x, y) for x in range(2, 8) for y in range(2, 6)]


def test_two_triangles_that_pierce_one_another() -> None:
    slope = ((0, 0, 0), (32, 0, 1), (0, 32, 0))
    wall = ((0, 0, Fraction(9, 64)), (32, 0, Fraction(9, 64)), (0, 32, Fraction(9, 64)))
    scene = [tuple(tuple(map(Fraction, corner)) for corner in triangle) for triangle in (slope, wall)]
    image = render(scene)[0]  # type: ignore[arg-type]
    assert ["".join(map(str, row)) for row in image[::-1]] == ["1111122222"] * HEIGHT


def test_an_edge_that_crosses_a_row_at_a_pixel_is_not_rounded_past_it() -> None:
    """The edge up to (58, 14) crosses row 7 at exactly 29; its slope times 7 is a little more."""
    vertices = np.array([[0, 0, 0.5], [58, 14, 0.5], [0, 14, 0.5]])
    image, depth = np.zeros((14, 40), np.int64), np.ones((14, 40))
    fragments = depth_buffer(image, depth, vertices, np.array([[0, 1, 2]]), np.array([1]))
    assert 7 * (58 / 14) > 29
    assert [x for x, y, *_ in fragments if y == 7] == list(range(29))


def test_a_triangle_seen_edge_on_draws_nothing() -> None:
    line = [tuple((Fraction(n), Fraction(n), Fraction(0)) for n in (0, 3, 7))]
    assert render(line)[2] == []  # type: ignore[arg-type]


@given(heights=st.lists(st.integers(0, 15), min_size=9, max_size=9), turned=st.integers(0, 2**8 - 1))
def test_each_pixel_of_a_mesh_is_painted_once(heights: list[int], turned: int) -> None:
    """A net of eight triangles over whole corners and quarters, each turned either way, edges shared."""
    xs, ys = (Fraction(1, 4), Fraction(4), Fraction(35, 4)), (Fraction(0), Fraction(13, 4), Fraction(7))
    net = [(xs[k % 3], ys[k // 3], Fraction(h, 16)) for k, h in enumerate(heights)]
    faces = [face for k in (0, 1, 3, 4) for face in ((k, k + 1, k + 4), (k, k + 4, k + 3))]
    faces = [face[::-1] if turned >> n & 1 else face for n, face in enumerate(faces)]
    scene = [(net[a], net[b], net[c]) for a, b, c in faces]
    image, depth, emitted = render(scene)
    painted = sorted((x, y) for x, y, *_ in emitted)
    assert painted == [(x, y) for x in range(1, 9) for y in range(7)]
    assert all(won for *_place, won in emitted)
    backwards = render(scene[::-1])
    assert np.array_equal(depth, backwards[1])
    assert np.array_equal(image, np.where(image, 9 - backwards[0], 0))
    for x, y in painted:
        triangle = scene[image[y, x] - 1]
        assert covers(triangle, x, y)
        assert abs(depth[y, x] - float(depth_at(triangle, x, y))) < 1e-12
