"""Numbers that were reckoned by hand."""

import math

import numpy as np
import pytest

from tests.projection.inputs import image
from workbench.algorithms.projection import (
    STANDARD_VIEWS,
    axonometric,
    cabinet,
    cavalier,
    dimetric,
    distance_of,
    isometric,
    oblique,
    orthographic,
    parallel_depth,
    perspective,
    perspective_depth,
    perspective_from_plane,
    perspective_placement,
    standard_view,
    trimetric,
    vanishing_points,
    view,
    view_from_plane,
)

SQUARE = math.radians(45)


def test_perspective_divides_by_z_over_d() -> None:
    assert (perspective(2) @ (3, 4, 8, 1)).tolist() == [3, 4, 8, 4]
    assert image(perspective(2), (3, 4, 8)).tolist() == [0.75, 1, 2]
    assert image(perspective_from_plane(4), (3, 6, 8))[:2].tolist() == [1, 2]


@pytest.mark.parametrize(("z", "depth"), [(1, 0), (2, 0.5625), (3, 0.75), (6, 0.9375), (9, 1)])
def test_depth_goes_from_0_at_the_near_plane_to_1_at_the_far_one(z: float, depth: float) -> None:
    assert image(perspective_depth(1, 1, 9), (0, 0, z))[2] == pytest.approx(depth, abs=1e-15)
    assert image(parallel_depth(1, 9), (0, 0, z))[2] == pytest.approx((z - 1) / 8)


def test_a_step_of_8_bits_in_depth() -> None:
    """By how much z has to grow at 50 for the depth to grow by 1/255: the slope there tells."""
    just_before, just_behind = (image(perspective_depth(1, 1, 100), (0, 0, 50 + s))[2] for s in (-1e-3, 1e-3))
    assert 2e-3 / (just_behind - just_before) / 255 == pytest.approx(9.706, abs=1e-3)


def test_receding_lines_of_cavalier_and_cabinet() -> None:
    assert image(cabinet(SQUARE), (1, 1, 2))[:2] == pytest.approx([1.7071, 1.7071], abs=5e-5)
    assert image(cavalier(SQUARE), (1, 1, 2))[:2] == pytest.approx([2.4142, 2.4142], abs=5e-5)
    np.testing.assert_allclose(oblique(math.atan(1), 0.7), cavalier(0.7), atol=1e-15)
    np.testing.assert_allclose(oblique(math.atan(2), 0.7), cabinet(0.7), atol=1e-15)
    np.testing.assert_allclose(oblique(math.pi / 2, 0.7), orthographic(), atol=1e-15)


def test_isometric_is_seen_from_1_1_1() -> None:
    assert image(isometric(), (2, 3, 4))[:2] == pytest.approx([-math.sqrt(2), 0], abs=1e-15)
    assert np.hypot(*isometric()[:2, :3]) == pytest.approx([0.8165] * 3, abs=5e-5)
    seen = view((1, 1, 1), (0, 0, 0))
    np.testing.assert_allclose(isometric()[:2], seen[:2], atol=1e-15)
    np.testing.assert_allclose(dimetric(math.sqrt(2 / 3)), isometric(), atol=1e-15)


def test_dimetric_and_trimetric_foreshorten_as_asked() -> None:
    assert np.hypot(*dimetric(0.5)[:2, :3]) == pytest.approx([math.sqrt(0.875)] * 2 + [0.5])
    assert np.hypot(*trimetric(0.9, 0.8)[:2, :3]) == pytest.approx([0.9, 0.8, math.sqrt(0.55)])
    assert np.hypot(*axonometric(0.3, 0.4)[:2, :3]) ** 2 @ (1, 1, 1) == pytest.approx(2)


def test_a_view_looks_from_the_eye() -> None:
    assert image(view((3, 4, 12), (0, 0, 0)), (1, 2, 2)) == pytest.approx([0.4851, 1.2313, 10.3077], abs=5e-5)


def test_principal_vanishing_points() -> None:
    x, y, z = vanishing_points(perspective(5) @ view((5, 0, 5), (0, 0, 0)))
    assert x == pytest.approx((-5, 0))
    assert y is None
    assert z == pytest.approx((5, 0))
    found = vanishing_points(perspective(10) @ view((6, 6, 6), (0, 0, 0)))
    for point, wanted in zip(found, [(-12.247, 7.071), (0, -14.142), (12.247, 7.071)], strict=True):
        assert point == pytest.approx(wanted, abs=5e-4)
    assert distance_of((-4, 0), (9, 0)) == 6


@pytest.mark.parametrize(
    ("name", "right", "up"),
    [
        ("front", (1, 0, 0), (0, 1, 0)),
        ("back", (-1, 0, 0), (0, 1, 0)),
        ("left", (0, 0, 1), (0, 1, 0)),
        ("right", (0, 0, -1), (0, 1, 0)),
        ("top", (1, 0, 0), (0, 0, -1)),
        ("bottom", (1, 0, 0), (0, 0, 1)),
    ],
)
def test_a_standard_view_shows_its_side(name: str, right: tuple[float, ...], up: tuple[float, ...]) -> None:
    matrix = standard_view(name)
    assert matrix[0, :3].tolist() == list(right)
    assert matrix[1, :3].tolist() == list(up)
    assert matrix[2, :3].tolist() == list(STANDARD_VIEWS[name][0])
    assert np.linalg.det(matrix) == -1


@pytest.mark.parametrize("points", [1, 2, 3])
def test_a_placement_has_as_many_vanishing_points(points: int) -> None:
    eye = perspective_placement(points, (1, 2, 3), 7)
    assert math.dist(eye, (1, 2, 3)) == pytest.approx(7)
    matrix = perspective(2) @ view(eye, (1, 2, 3))
    assert sum(point is not None for point in vanishing_points(matrix)) == points


def test_a_view_given_by_its_plane() -> None:
    """From a point of the plane, and with the projection reference point as the origin."""
    by_plane = view_from_plane((0, 0, 0), (3, 4, 12), (0, 1, 0))
    np.testing.assert_allclose(by_plane[:3, :3], view((3, 4, 12), (0, 0, 0))[:3, :3], atol=1e-15)
    prp = view_from_plane((0, 0, 0), (3, 4, 12), (0, 1, 0), (0, 0, 13))
    np.testing.assert_allclose(prp, view((3, 4, 12), (0, 0, 0)), atol=1e-14)
    aside = view_from_plane((1, 2, 3), (0, 0, 1), (0, 1, 0), (4, 5, 6))
    assert image(aside, (1 + 4, 2 + 5, 3 + 6)).tolist() == [0, 0, 0]
    assert image(aside, (1, 2, 3)).tolist() == [-4, -5, 6]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: perspective(0), "more than 0"),
        (lambda: perspective_from_plane(math.inf), "more than 0"),
        (lambda: perspective_depth(1, 0, 9), "0 < near < far"),
        (lambda: parallel_depth(2, 2), "near < far"),
        (lambda: oblique(0, 1), "between 0 and 180"),
        (lambda: dimetric(1.5), "from 0 to 1"),
        (lambda: trimetric(0.2, 0.3), "sum of their squares"),
        (lambda: view((1, 2, 3), (1, 2, 3)), "at the point it looks at"),
        (lambda: view((0, 5, 0), (0, 0, 0)), "along the line of sight"),
        (lambda: view((0, math.nan, 0), (0, 0, 0)), "three finite numbers"),
        (lambda: view_from_plane((0, 0, 0), (0, 0, 0), (0, 1, 0)), "no length"),
        (lambda: perspective_placement(4, (0, 0, 0), 1), "1, 2 or 3"),
        (lambda: perspective_placement(1, (0, 0, 0), 0), "more than 0"),
        (lambda: distance_of((1, 0), (2, 0)), "would have to be positive"),
        (lambda: vanishing_points(np.eye(3)), "4 x 4"),
    ],
)
def test_what_cannot_be_is_refused(call: object, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        call()  # type: ignore[operator]
    with pytest.raises(LookupError, match="front, back"):
        standard_view("above")
