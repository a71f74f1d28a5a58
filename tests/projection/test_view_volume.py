"""Polygons clipped to the view volume: against half-spaces, exact fractions, and points by chance."""

from fractions import Fraction

import numpy as np
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.algorithms.runs import arguments
from workbench.algorithms import catalogue
from workbench.algorithms.projection import clip_to_view_volume, perspective_depth
from workbench.engine.compiled import collect

WINDOW = (-1.0, -1.0, 1.0, 1.0)
runs = arguments(catalogue.get("clip_to_view_volume"))
whole = st.integers(-6, 6)
triangles = st.lists(st.tuples(whole, whole, st.integers(-4, 9)), min_size=3, max_size=3)
PROJECTION = perspective_depth(1.0, 1.0, 6.0)


def clipped(vertices: np.ndarray, window: tuple[float, ...] = WINDOW) -> np.ndarray:
    """What is left of one ring (n, 4), a row for each corner."""
    rows = list(clip_to_view_volume(vertices, np.array([len(vertices)]), *window))
    return np.array(rows, np.float64).reshape(-1, 5)[:, 1:]


def projected(triangle: list[tuple[int, int, int]]) -> np.ndarray:
    return np.array([[*corner, 1.0] for corner in triangle]) @ PROJECTION.T


@given(run=runs)
def test_what_is_left_lies_in_the_view_volume(run: tuple[object, ...]) -> None:
    _vertices, _ends, xmin, ymin, xmax, ymax = run
    for _ring, x, y, z, w in clip_to_view_volume(*run):  # type: ignore[arg-type]
        room = 1e-12 * (1 + abs(w))
        assert -room <= z <= w + room
        assert xmin * w - room <= x <= xmax * w + room  # type: ignore[operator]
        assert ymin * w - room <= y <= ymax * w + room  # type: ignore[operator]


@given(
    triangle=triangles, shares=st.lists(st.tuples(st.floats(0, 1), st.floats(0, 1)), min_size=20, max_size=20)
)
def test_of_a_convex_polygon_exactly_what_lies_in_the_volume_is_left(
    triangle: list[tuple[int, int, int]], shares: list[tuple[float, float]]
) -> None:
    """Its points are those of the triangle that all six tests keep: none is lost, none is gained."""
    vertices = projected(triangle)
    corners = np.array(triangle, np.float64)
    normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    assume(np.linalg.norm(normal) > 0)
    kept = clipped(vertices)
    back = kept @ np.linalg.inv(PROJECTION).T
    left = back[:, :3] / back[:, 3:]
    for corner in left:  # in the triangle
        u, v = np.linalg.lstsq((corners[1:] - corners[0]).T, corner - corners[0], rcond=None)[0]
        assert min(u, v, 1 - u - v) > -1e-9
        assert abs((corner - corners[0]) @ normal) < 1e-6
    for a, b in shares:
        u, v = (a, b) if a + b <= 1 else (1 - a, 1 - b)
        point = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0])
        x, y, z = point
        margin = min(z - 1, 6 - z, x + z, z - x, y + z, z - y)
        if abs(margin) < 1e-6:
            continue
        sides = [
            normal @ np.cross(q - p, point - p) for p, q in zip(left, np.roll(left, -1, axis=0), strict=True)
        ]
        if margin > 0:
            assert len(left) >= 3
            assert min(sides) > -1e-6
        elif len(left) >= 3:
            assert min(sides) < 1e-6


@given(
    behind=st.tuples(whole, whole, st.integers(-4, 0)),
    before=st.tuples(whole, whole, st.integers(1, 9)),
    apex=st.tuples(whole, whole, st.integers(2, 9)),
)
def test_a_shared_side_is_cut_at_the_same_points(
    behind: tuple[int, int, int], before: tuple[int, int, int], apex: tuple[int, int, int]
) -> None:
    """By the near plane, exactly: z of the side is 0 there, and both polygons have the point, bit for bit."""
    a, b = behind, before
    window = (-1e3, -1e3, 1e3, 1e3)
    one = clipped(projected([a, b, apex]), window)
    other = clipped(projected([b, a, apex]), window)
    u = Fraction(1 - a[2], b[2] - a[2])
    x, y = (float(a[k] + u * (b[k] - a[k])) for k in (0, 1))
    met = [set(map(tuple, rows[np.abs(rows[:, 2]) < 1e-12].tolist())) for rows in (one, other)]
    shared = [p for p in met[0] & met[1] if abs(p[0] - x) < 1e-9 and abs(p[1] - y) < 1e-9]
    assert shared
    assert abs(shared[0][3] - 1) < 1e-12


def test_what_is_behind_the_eye_does_not_come_out_before_it() -> None:
    """A side from behind the eye to before it: divided first, its image would lie on the wrong side."""
    behind = projected([(1, 0, -1), (0, 0, 3), (0, 1, 3)])
    assert (behind[0, :2] / behind[0, 3]).tolist() == [-1, 0]
    left = clipped(behind)
    assert (left[:, 3] >= 1 - 1e-12).all()
    assert (left[:, 0] >= 0).all()


@given(run=runs)
def test_compiled_it_is_the_same_text(run: tuple[object, ...]) -> None:
    rows = np.array(list(clip_to_view_volume(*run)), np.float64).reshape(-1, 5)  # type: ignore[arg-type]
    assert collect(clip_to_view_volume, *run).tobytes() == rows.tobytes()


def test_a_polygon_of_many_corners_stays_one_polygon() -> None:
    ring = [(np.cos(t), np.sin(t), 0.5, 1.0) for t in np.linspace(0, 2 * np.pi, 12, endpoint=False)]
    assert np.array_equal(clipped(np.array(ring)), ring)
    half = clipped(np.array(ring), (0.25, -1.0, 1.0, 1.0))
    assert len(half) == 7
    assert half[:, 0].min() == 0.25
