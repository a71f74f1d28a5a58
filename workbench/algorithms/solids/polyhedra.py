"""The box, and the five regular solids, all around the origin."""

import math

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.meshes import Faces, Mesh

Array = NDArray[np.float64]

_GOLDEN = (1 + math.sqrt(5)) / 2
_SIGNS = (-1.0, 1.0)


def box(width: float = 2.0, height: float = 2.0, depth: float = 2.0) -> Mesh:
    """A box with its sides along x, y and z. Raises: ValueError for a side that is not above 0."""
    refuse_sizes(width, height, depth)
    return _around(np.array([width, height, depth]) / 2 * _cube_corners(), _octahedron_corners())


def cube(side: float = 2.0) -> Mesh:
    """A cube, the regular solid of six faces. Raises: ValueError."""
    return box(side, side, side)


def tetrahedron(radius: float = 1.0) -> Mesh:
    """The regular solid of four faces, its corners ``radius`` from the origin. Raises: ValueError."""
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
    return _around(_at(corners, radius), -corners)


def octahedron(radius: float = 1.0) -> Mesh:
    """The regular solid of eight faces, as ``tetrahedron``. Raises: ValueError."""
    return _around(_at(_octahedron_corners(), radius), _cube_corners())


def dodecahedron(radius: float = 1.0) -> Mesh:
    """The regular solid of twelve faces, pentagons, as ``tetrahedron``. Raises: ValueError."""
    corners = np.concatenate([_cube_corners(), _rectangles(1 / _GOLDEN, _GOLDEN)])
    return _around(_at(corners, radius), _rectangles(_GOLDEN, 1.0))


def icosahedron(radius: float = 1.0) -> Mesh:
    """The regular solid of twenty faces, as ``tetrahedron``. Raises: ValueError."""
    towards = np.concatenate([_cube_corners(), _rectangles(_GOLDEN, 1 / _GOLDEN)])
    return _around(_at(_rectangles(1.0, _GOLDEN), radius), towards)


def refuse_sizes(*sizes: float) -> None:
    """Raises: ValueError where one is not a finite number above 0."""
    for size in sizes:
        if not (math.isfinite(size) and size > 0):
            raise ValueError(f"A size of the solid is {size:g}; choose a finite number above 0.")


def _cube_corners() -> Array:
    return np.array([[x, y, z] for x in _SIGNS for y in _SIGNS for z in _SIGNS])


def _octahedron_corners() -> Array:
    return np.concatenate([np.eye(3), -np.eye(3)])


def _rectangles(a: float, b: float) -> Array:
    """The corners of three rectangles, 2a by 2b, each in a plane of two axes."""
    flat = [[0.0, a * s, b * t] for s in _SIGNS for t in _SIGNS]
    return np.concatenate([np.roll(flat, turn, axis=1) for turn in range(3)])


def _at(corners: Array, radius: float) -> Array:
    refuse_sizes(radius)
    return corners * (radius / math.sqrt(float((corners[0] ** 2).sum())))


def _around(vertices: Array, normals: Array) -> Mesh:
    """The convex solid of these vertices whose faces look along ``normals``: on each the farthest of them."""
    faces = []
    for normal in normals:
        along = vertices @ normal
        corners = np.flatnonzero(along > along.max() - 1e-9 * abs(along.max()))
        spokes = vertices[corners] - vertices[corners].mean(axis=0)
        up = spokes[0]
        angles = np.arctan2(spokes @ np.cross(normal, up) / math.sqrt(normal @ normal), spokes @ up)
        faces.append(corners[np.argsort(np.round(angles, 9) % (2 * math.pi))].tolist())
    return Mesh(vertices, Faces.of(faces))
