"""Patches against exact fractions, SciPy and the surfaces they must be; nothing depends on the frame."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.interpolate import BSpline

from tests.curves.exact import bezier, close
from workbench.algorithms.curves import Nurbs, open_uniform_knots, uniform_knots
from workbench.algorithms.surfaces import (
    EXAMPLES,
    b_spline_patch,
    bezier_patch,
    cylinder,
    patch_normals,
    patch_points,
    revolved,
    sphere,
    torus,
)

Array = NDArray[np.float64]
PARTS = np.linspace(0, 1, 9)


def nets(seed: int, a: int, b: int) -> Array:
    return np.random.default_rng(seed).uniform(-9, 9, (a, b, 3))


seeds = st.integers(0, 2**32 - 1)
inside = st.floats(0, 1)


@given(seeds, st.integers(2, 5), st.integers(2, 5), inside, inside)
def test_a_bezier_patch_is_a_curve_of_curves(seed: int, a: int, b: int, u: float, v: float) -> None:
    net = nets(seed, a, b)
    rows = [bezier(row, v) for row in net]
    exact = bezier(np.array([[float(x) for x in row] for row in rows]), u)
    close(patch_points(bezier_patch(net), u, v), exact, 9.0)


@settings(max_examples=40)
@given(seeds, st.tuples(st.integers(1, 4), st.integers(1, 4)), st.booleans())
def test_a_b_spline_surface_is_what_scipy_says(seed: int, degrees: tuple[int, int], open_: bool) -> None:
    p, q = degrees
    net = nets(seed, p + 4, q + 3)
    made = open_uniform_knots if open_ else uniform_knots
    u_knots, v_knots = made(p + 4, p), made(q + 3, q)
    us = u_knots[p] + PARTS * (u_knots[p + 4] - u_knots[p])
    vs = v_knots[q] + PARTS * (v_knots[q + 3] - v_knots[q])
    truth = BSpline(v_knots, BSpline(u_knots, net, p)(us).transpose(1, 0, 2), q)(vs).transpose(1, 0, 2)
    found = patch_points(b_spline_patch(net, u_knots, v_knots, degrees), us[:, None], vs)
    assert np.abs(found - truth).max() <= 1e-12 * 9 * 10


@given(inside, inside, st.floats(0.1, 100))
def test_sphere_cylinder_and_torus_are_exact(a: float, b: float, size: float) -> None:
    u, v = 4 * a, 2 * b
    x, y, z = patch_points(sphere(size), u, v)
    assert math.hypot(x, y, z) == pytest.approx(size, rel=1e-12)
    assert np.allclose(patch_normals(sphere(size), u, v), np.array([x, y, z]) / size, atol=2e-5)
    x, y, z = patch_points(cylinder(size, 3 * size), u, b)
    assert math.hypot(x, z) == pytest.approx(size, rel=1e-12)
    assert y == pytest.approx(3 * size * b, abs=1e-12 * size)
    x, y, z = patch_points(torus(2 * size, size), u, 4 * b)
    assert math.hypot(math.hypot(x, z) - 2 * size, y) == pytest.approx(size, rel=1e-11)


@given(seeds, inside, inside)
def test_a_patch_moves_with_the_frame(seed: int, u: float, v: float) -> None:
    rng = np.random.default_rng(seed)
    net, weights = nets(seed, 4, 3), rng.uniform(0.2, 5, (4, 3))
    matrix, shift = rng.uniform(-2, 2, (3, 3)), rng.uniform(-9, 9, 3)
    moved = patch_points(bezier_patch(net @ matrix.T + shift, weights), u, v)
    assert np.allclose(moved, matrix @ patch_points(bezier_patch(net, weights), u, v) + shift, atol=1e-10)


@given(seeds, st.floats(0.05, 0.95), st.floats(0.05, 0.95))
def test_normals_stand_on_the_surface(seed: int, u: float, v: float) -> None:
    rng = np.random.default_rng(seed)
    patch = bezier_patch(nets(seed, 4, 4), rng.uniform(0.5, 2, (4, 4)))
    normal = patch_normals(patch, u, v)
    h = 1e-6
    by_u = (patch_points(patch, u + h, v) - patch_points(patch, u - h, v)) / (2 * h)
    by_v = (patch_points(patch, u, v + h) - patch_points(patch, u, v - h)) / (2 * h)
    truth = np.cross(by_u, by_v)
    size = float(np.linalg.norm(truth))
    if size > 1e-2:
        assert np.allclose(normal, truth / size, atol=1e-3)


def test_a_pole_has_the_normal_of_its_surroundings() -> None:
    assert np.allclose(patch_normals(sphere(), [0.3, 2.7], [0.0, 2.0]), [[0, -1, 0], [0, 1, 0]], atol=1e-4)


def test_each_example_is_a_surface() -> None:
    for made in EXAMPLES.values():
        patches = made()
        us = patches.u_knots[0] + PARTS * (patches.u_knots[-1] - patches.u_knots[0])
        vs = patches.v_knots[0] + PARTS * (patches.v_knots[-1] - patches.v_knots[0])
        assert np.isfinite(patch_points(patches, us[:, None], vs)).all()
        assert np.allclose(np.linalg.norm(patch_normals(patches, us[:, None], vs), axis=-1), 1.0)


def test_what_makes_no_surface_is_said() -> None:
    net = nets(0, 4, 4)
    with pytest.raises(ValueError, match="control net has 2 rows"):
        bezier_patch(net[:1])
    with pytest.raises(ValueError, match="control net has 2 rows"):
        bezier_patch(net[..., :2])
    with pytest.raises(ValueError, match="Point 0 is not finite"):
        bezier_patch(net * np.nan)
    with pytest.raises(ValueError, match="Weight 3 is -1"):
        bezier_patch(net, np.where(np.arange(16) == 3, -1.0, 1.0).reshape(4, 4))
    with pytest.raises(ValueError, match="3 weights for 16 points"):
        bezier_patch(net, [1, 1, 1])
    with pytest.raises(ValueError, match="less than knot"):
        b_spline_patch(net, [0, 0, 0, 0, 1, 1, 0.5, 1], open_uniform_knots(4, 3))
    with pytest.raises(ValueError, match="need 8"):
        b_spline_patch(net, open_uniform_knots(4, 3), open_uniform_knots(5, 3))
    with pytest.raises(ValueError, match="distance below 0"):
        revolved(Nurbs(np.array([[-1.0, 0.0], [1.0, 1.0]]), np.ones(2), np.array([0.0, 0.0, 1.0, 1.0]), 1))
    with pytest.raises(ValueError, match="radius or height is 0"):
        sphere(0)
