"""Wireframes without hidden lines, against rays cast at points of the edges, in exact fractions."""

from collections.abc import Callable
from fractions import Fraction
from random import Random

import numpy as np
import pytest

from tests.visibility.exact_scenes import KINDS, Scene, arrays, corner, scenes
from tests.visibility.test_depth_buffer import Corner, Triangle
from workbench.algorithms.visibility import hidden_lines
from workbench.algorithms.visibility.hidden_lines import edges_of_triangles

SHARES = [Fraction(2 * k + 1, 34) for k in range(17)]
NEAR = Fraction(1, 10**6)


def drawn(scene: Scene) -> list[tuple[float, float, float, float, int]]:
    vertices, faces, _colours = arrays(scene)
    return list(hidden_lines(vertices, faces, edges_of_triangles(faces)))


def turn(a: Corner, b: Corner, x: Fraction, y: Fraction) -> Fraction:
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])


def stops(triangle: Triangle, place: Corner) -> bool | None:
    """Whether a triangle stops the ray from the eye to a place; None where it just touches."""
    x, y, z = place
    a, b, c = triangle
    whole = turn(a, b, c[0], c[1])
    if whole == 0:
        return False
    shares = [turn(b, c, x, y) / whole, turn(c, a, x, y) / whole, turn(a, b, x, y) / whole]
    if min(shares) < -NEAR:
        return False
    before = z - sum(share * p[2] for share, p in zip(shares, triangle, strict=True))
    if before == 0 or before < -NEAR:
        return False
    return True if min(shares) > NEAR and before > NEAR else None


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_a_point_of_an_edge_is_drawn_where_no_ray_is_stopped(kind: Callable[[Random], Scene]) -> None:
    hidden = 0
    for scene in scenes(kind, 20):
        vertices, faces, _colours = arrays(scene)
        parts: dict[int, list[tuple[float, ...]]] = {}
        for *ends, edge in drawn(scene):
            parts.setdefault(int(edge), []).append(tuple(ends))
        for number, (i, j) in enumerate(edges_of_triangles(faces)):
            start, end = sorted([corner(*vertices[i]), corner(*vertices[j])])
            axis = 0 if start[0] != end[0] else 1
            if start[:2] == end[:2]:
                continue
            for share in SHARES:
                place = tuple(a + share * (b - a) for a, b in zip(start, end, strict=True))
                told = [stops(triangle, place) for triangle in scene]  # type: ignore[arg-type]
                if None in told and True not in told:
                    continue
                here = float(place[axis])
                seen = [
                    min(p[axis], p[axis + 2]) <= here <= max(p[axis], p[axis + 2])
                    for p in parts.get(number, [])
                ]
                ends_near = any(abs(p[axis + k] - here) < 1e-6 for p in parts.get(number, []) for k in (0, 2))
                assert any(seen) == (True not in told) or ends_near
                hidden += True in told
    assert hidden > 100


def test_the_order_of_surfaces_does_not_matter() -> None:
    for kind in KINDS:
        for scene in scenes(kind, 10):
            vertices, faces, _colours = arrays(scene)
            edges = edges_of_triangles(faces)
            there = np.array(list(hidden_lines(vertices, faces, edges)))
            back = np.array(list(hidden_lines(vertices, faces[::-1], edges[:, ::-1])))
            assert there.shape == back.shape
            assert np.abs(there - back).max(initial=0.0) < 1e-9


def test_a_cube_shows_nine_of_its_edges() -> None:
    """Seen from before a corner; each face is two triangles, whose diagonals are no edges."""
    places = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], np.float64)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
    edges = np.array([(i, j) for i in range(8) for j in range(i) if (i ^ j) in (1, 2, 4)])
    along = np.array([[1, -1, 0], [1, 1, -2], [2, 2, 2]], np.float64)
    seen = list(hidden_lines(places @ along.T, faces, edges))
    assert len(seen) == len({edge for *_ends, edge in seen}) == 9


def test_a_bar_hides_the_middle_of_an_edge_behind_it() -> None:
    bar = corner(4, -5, "1/4"), corner(6, -5, "1/4"), corner(5, 50, "1/4")
    line = corner(0, 0, "1/2"), corner(10, 0, "1/2"), corner(5, 0, "1/2")
    parts = [row[:4] for row in drawn([line, bar]) if row[4] == 0]
    (left, right) = sorted(parts)
    assert left == pytest.approx((0, 0, 4 + 1 / 11, 0))
    assert right == pytest.approx((6 - 1 / 11, 0, 10, 0))


def test_of_nothing_nothing_is_drawn() -> None:
    none = np.zeros((0, 3)), np.zeros((0, 3), np.int64), np.zeros((0, 2), np.int64)
    assert list(hidden_lines(*none)) == []


def test_an_edge_behind_the_seam_of_two_triangles_is_hidden() -> None:
    square = [(0, 0, 0.25), (8, 0, 0.25), (8, 8, 0.25), (0, 8, 0.25), (1, 1, 0.5), (7, 7, 0.5)]
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    assert list(hidden_lines(np.array(square, np.float64), faces, np.array([[4, 5]]))) == []
