"""Patches against SciPy and the surfaces they must be."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.interpolate import BSpline

from tests.surfaces.scipy_points import patch_points
from workbench.algorithms.curves import Nurbs, open_uniform_knots, uniform_knots
from workbench.algorithms.surfaces import (
    EXAMPLES,
    b_spline_patch,
    bezier_patch,
    cylinder,
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
    x, y, z = patch_points(cylinder(size, 3 * size), u, b)
    assert math.hypot(x, z) == pytest.approx(size, rel=1e-12)
    assert y == pytest.approx(3 * size * b, abs=1e-12 * size)
    x, y, z = patch_points(torus(2 * size, size), u, 4 * b)
    assert math.hypot(math.hypot(x, z) - 2 * size, y) == pytest.approx(size, rel=1e-11)


def test_each_example_is_a_surface() -> None:
    for made in EXAMPLES.values():
        patches = made()
        us = patches.u_knots[0] + PARTS * (patches.u_knots[-1] - patches.u_knots[0])
        vs = patches.v_knots[0] + PARTS * (patches.v_knots[-1] - patches.v_knots[0])
        assert np.isfinite(patch_points(patches, us[:, None], vs)).all()


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
