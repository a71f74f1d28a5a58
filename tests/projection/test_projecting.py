"""What the paper's questions 1 and 5 say of projections, measured on the stepped text and on the matrices."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.algorithms.runs import arguments
from tests.projection.inputs import Matrix, distances, parallels, perspectives, points, views
from workbench.algorithms import catalogue
from workbench.algorithms.projection import (
    distance_of,
    orthographic,
    perspective,
    perspective_from_plane,
    project_point,
    vanishing_points,
    view,
    with_vanishing_point,
    with_vanishing_points,
)

Point = np.ndarray
SCREEN = np.array([[10.0, 0, 20], [0, 10, 15], [0, 0, 1]])
UNIT = np.eye(3)
STILL = np.eye(4)
runs = arguments(catalogue.get("project_point"))
directions = points.filter(lambda p: np.linalg.norm(p) > 0.1)


def on_plane(seen: Matrix, projection: Matrix, point: Point) -> Point:
    """x and y on the view plane, as the text emits them."""
    _world, _view, _homogeneous, divided, _device = project_point(STILL, seen, projection, UNIT, point)
    return np.array(divided[:2])


def in_front(seen: Matrix, *places: Point) -> None:
    """Only points well before the eye."""
    assume(all((seen @ np.append(place, 1))[2] > 0.5 for place in places))


@given(run=runs)
def test_a_point_is_projected_by_the_product_of_the_matrices(run: tuple[np.ndarray, ...]) -> None:
    model, seen, projection, viewport, point = run
    emitted = list(project_point(*run))
    whole = projection @ seen @ model @ np.append(point, 1)
    np.testing.assert_allclose(emitted[2], whole, atol=1e-12)
    assert len(emitted) == (5 if emitted[2][3] > 0 else 3)
    if len(emitted) == 5:
        np.testing.assert_allclose(emitted[3][:3], whole[:3] / whole[3], rtol=1e-9, atol=1e-9)
        device = viewport @ (*emitted[3][:2], 1)
        np.testing.assert_allclose(emitted[4][:2], device[:2], rtol=1e-12, atol=1e-9)
        assert emitted[4][2] == emitted[3][2]


@given(d=distances, point=points)
def test_centre_point_and_image_lie_on_one_line(d: float, point: Point) -> None:
    """For both ways of laying the view plane; the image is on that plane."""
    assume(point[2] > 0.1)
    x, y = on_plane(STILL, perspective(d), point)
    np.testing.assert_allclose(np.cross(point, (x, y, d)), 0, atol=1e-9 * (1 + d) ** 2)
    x, y = on_plane(STILL, perspective_from_plane(d), point)
    centre = np.array([0, 0, -d])
    np.testing.assert_allclose(np.cross(point - centre, (x, y, 0) - centre), 0, atol=1e-9 * (1 + d) ** 2)


@given(
    seen=views(), projection=parallels, start=points, way=directions, shift=points, along=st.floats(0.1, 2)
)
def test_a_parallel_projection_keeps_parallels_and_their_ratios(
    seen: Matrix, projection: Matrix, start: Point, way: Point, shift: Point, along: float
) -> None:
    def run(a: Point, b: Point) -> Point:
        return on_plane(seen, projection, b) - on_plane(seen, projection, a)

    here, there = run(start, start + way), run(start + shift, start + shift + along * way)
    np.testing.assert_allclose(there, along * here, atol=1e-9)
    assert vanishing_points(projection @ seen) == (None, None, None)


@given(a=points, b=points, projection=parallels)
def test_a_parallel_projection_keeps_true_size_parallel_to_the_view_plane_only(
    a: Point, b: Point, projection: Matrix
) -> None:
    b = np.array([b[0], b[1], a[2]])
    measured = math.dist(on_plane(STILL, projection, a), on_plane(STILL, projection, b))
    assert measured == pytest.approx(math.dist(a, b), abs=1e-9)
    assert math.dist(*(on_plane(STILL, orthographic(), p) for p in ((0, 0, 0), (3, 0, 4)))) == 3 != 5


@given(d=distances, near=st.floats(1, 9), times=st.floats(1.5, 9))
def test_in_perspective_what_is_twice_as_far_is_half_as_large(d: float, near: float, times: float) -> None:
    def height(z: float) -> float:
        return math.dist(*(on_plane(STILL, perspective(d), p) for p in ((1, 0, z), (1, 2, z))))

    assert height(near) == pytest.approx(times * height(times * near))


@given(seen=views(), projection=perspectives, axis=st.integers(0, 2), start=points)
def test_parallel_lines_run_together_at_the_vanishing_point(
    seen: Matrix, projection: Matrix, axis: int, start: Point
) -> None:
    """Far out on a line along the axis its image nears the vanishing point, or is parallel."""
    point = vanishing_points(projection @ seen)[axis]
    depth = seen[2, axis]
    if point is None:
        assert abs(depth) < 1e-9
        in_front(seen, start)
        way = np.eye(3)[axis]
        first = on_plane(seen, projection, start + way) - on_plane(seen, projection, start)
        np.testing.assert_allclose(first[0] * seen[1, axis] - first[1] * seen[0, axis], 0, atol=1e-6)
        return
    distance = []
    for far in (1e5, 1e6):
        place = start + np.eye(3)[axis] * math.copysign(far, depth)
        distance.append(math.dist(on_plane(seen, projection, place), point))
    size = 1 + math.hypot(*point) + 1 / projection[3, 2]
    assert distance[1] < 1e-3 * size / depth**2
    assert distance[1] < distance[0] / 5 + 1e-8 * size / depth**2


@given(point=points, exponent=st.integers(3, 9))
def test_as_d_grows_only_the_plane_at_0_gives_the_parallel_projection(point: Point, exponent: int) -> None:
    assume(point[2] > 0.5)
    d = 10.0**exponent
    from_plane = on_plane(STILL, perspective_from_plane(d), point)
    np.testing.assert_allclose(from_plane, on_plane(STILL, orthographic(), point), atol=200 / d)
    np.testing.assert_allclose(perspective_from_plane(d), orthographic(), atol=2 / d)
    w = list(project_point(STILL, STILL, perspective(d), UNIT, point))[2][3]
    assert w == pytest.approx(point[2] / d)
    assert abs(np.linalg.det(perspective(d))) < 1e-15
    if abs(point[0]) > 0.1:
        assert abs(on_plane(STILL, perspective(d), point)[0]) > 0.01 * d


@given(
    eye=st.tuples(*[st.integers(1, 9)] * 3),
    axis=st.integers(0, 2),
    at=st.tuples(st.floats(-30, 30), st.floats(-30, 30)),
    d=distances,
)
def test_a_vanishing_point_goes_where_it_is_dragged(
    eye: tuple[int, int, int], axis: int, at: tuple[float, float], d: float
) -> None:
    look_at = (1.0, 0.0, -1.0)
    before = view(eye, look_at)
    to_eye, up = with_vanishing_point(eye, look_at, (0, 1, 0), axis, at, d)
    after = view(to_eye, look_at, up)
    assert vanishing_points(perspective(d) @ after)[axis] == pytest.approx(at, rel=1e-6, abs=1e-6)
    assert math.dist(to_eye, look_at) == pytest.approx(math.dist(eye, look_at))
    target = np.array([*at, d]) / np.linalg.norm([*at, d])
    turned = after[:3, :3] @ before[:3, :3].T
    angle = math.acos(np.clip((np.trace(turned) - 1) / 2, -1, 1))
    assert angle == pytest.approx(math.acos(min(abs(target @ before[:3, axis]), 1)), abs=1e-6)


@given(
    eye=st.tuples(*[st.integers(1, 9)] * 3),
    axes=st.permutations(range(3)),
    at=st.tuples(*[st.floats(-30, 30)] * 2),
    other=st.tuples(*[st.floats(-30, 30)] * 2),
)
def test_a_pinned_vanishing_point_stays_while_another_moves(
    eye: tuple[int, int, int], axes: list[int], at: tuple[float, float], other: tuple[float, float]
) -> None:
    product = at[0] * other[0] + at[1] * other[1]
    assume(abs(product) > 1e-3)
    pinned, moved = (axes[0], at), (axes[1], other)
    if product > 0:
        with pytest.raises(ValueError, match="would have to be positive"):
            with_vanishing_points(eye, (0, 0, 0), (0, 1, 0), pinned, moved)
        return
    to_eye, up, d = with_vanishing_points(eye, (0, 0, 0), (0, 1, 0), pinned, moved)
    assert d == distance_of(at, other) == pytest.approx(math.sqrt(-product))
    found = vanishing_points(perspective(d) @ view(to_eye, (0, 0, 0), up))
    assert found[axes[0]] == pytest.approx(at, rel=1e-5, abs=1e-5)
    assert found[axes[1]] == pytest.approx(other, rel=1e-5, abs=1e-5)
    assert math.hypot(*to_eye) == pytest.approx(math.hypot(*eye))
