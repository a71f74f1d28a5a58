"""Surfaces to begin with: exact ones of revolution, a Bézier patch, a B-spline surface."""

import math
from collections.abc import Callable

import numpy as np

from workbench.algorithms.surfaces.patches import Patches, b_spline_patch, bezier_patch
from workbench.algorithms.surfaces.revolution import revolved
from workbench.geometry.curves.knots import open_uniform_knots
from workbench.geometry.curves.rational import Nurbs, circle

_ROOT = math.sqrt(0.5)


def sphere(radius: float = 1.0) -> Patches:
    """A whole sphere around the origin, exact. Raises: ValueError for a radius that is not above 0."""
    _refuse_size(radius)
    points = radius * np.array([[0, -1], [1, -1], [1, 0], [1, 1], [0, 1]], float)
    half = Nurbs(points, np.array([1, _ROOT, 1, _ROOT, 1]), np.array([0, 0, 0, 1, 1, 2, 2, 2], float), 2)
    return revolved(half)


def cylinder(radius: float = 1.0, height: float = 2.0) -> Patches:
    """The round side of a cylinder around the y axis, from y = 0 upwards, exact. Raises: ValueError."""
    _refuse_size(radius)
    _refuse_size(height)
    side = np.array([[radius, 0.0], [radius, height]])
    return revolved(Nurbs(side, np.ones(2), np.array([0.0, 0.0, 1.0, 1.0]), 1))


def torus(radius: float = 2.0, thickness: float = 0.75) -> Patches:
    """A ring around the y axis, exact; ``thickness`` is the radius of its section. Raises: ValueError."""
    _refuse_size(thickness)
    _refuse_size(radius - thickness)
    return revolved(circle(radius, 0.0, thickness))


def hill() -> Patches:
    """A bicubic Bézier patch: a hill over a square."""
    x, z = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    y = np.array([[0, 0, 0.5, 0], [0, 3, 2, 0], [0.5, 2, 4, 0], [0, 0, 0, 1]])
    return bezier_patch(np.stack([x, y, -z], axis=-1))


def wave() -> Patches:
    """A bicubic B-spline surface over seven by six points."""
    x, z = np.meshgrid(np.arange(7.0), np.arange(6.0), indexing="ij")
    y = np.round(np.sin(1.3 * x) + np.cos(1.1 * z), 2)
    return b_spline_patch(np.stack([x, y, -z], axis=-1), open_uniform_knots(7, 3), open_uniform_knots(6, 3))


EXAMPLES: dict[str, Callable[[], Patches]] = {
    "sphere": sphere,
    "cylinder": cylinder,
    "torus": torus,
    "hill": hill,
    "wave": wave,
}


def _refuse_size(size: float) -> None:
    if not (math.isfinite(size) and size > 0):
        raise ValueError(f"A radius or height is {size:g}; choose a finite one above 0.")
