"""Blobby balls: what the sum of densities about some middles makes solid.

Source: Hearn and Baker, Computer Graphics, C Version, section 10-5 (blobby objects); the surface is found by
marching tetrahedra, as by Doi and Koide, An Efficient Method of Triangulating Equi-Valued Surfaces, 1991.
"""

import math
from itertools import permutations

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.solids.polyhedra import refuse_sizes
from workbench.geometry.meshes import Faces, Mesh

Array = NDArray[np.float64]

MOST_BALLS, MOST_CELLS = 8, 48

_TETRAHEDRA = np.array(
    [
        np.cumsum([(0, 0, 0), *(np.eye(3, dtype=np.int64)[axis] for axis in order)], axis=0)
        for order in permutations(range(3))
    ]
)
"""The six tetrahedra (6, 4, 3) of a unit cube, one for each way from its lowest corner to its highest."""


def blob_middles(balls: int, spread: float) -> Array:
    """The middles (n, 3) of so many balls, evenly round a circle of this radius in the plane y = 0."""
    angles = 2 * math.pi * np.arange(balls) / balls
    return spread * np.column_stack([np.cos(angles), np.zeros(balls), -np.sin(angles)])


def density(points: Array, middles: Array, a: float) -> Array:
    """The sum over the balls of exp(-a r^2), r from the middle of each: points (..., 3), middles (n, 3)."""
    squares = ((points[..., None, :] - middles) ** 2).sum(axis=-1)
    total: Array = np.exp(-a * squares).sum(axis=-1)
    return total


def blobs(
    balls: int = 2, spread: float = 0.75, tightness: float = 2.0, threshold: float = 0.5, cells: int = 20
) -> Mesh:
    """Where the density of some balls is the threshold T; ``cells`` of the grid that finds it go across.

    Each ball has the density exp(-a r^2), a its tightness. Raises: ValueError.
    """
    refuse_sizes(tightness, threshold)
    if not 1 <= balls <= MOST_BALLS or not 4 <= cells <= MOST_CELLS:
        raise ValueError(f"Give 1 to {MOST_BALLS} balls, and 4 to {MOST_CELLS} cells across.")
    if threshold >= 1.0:
        raise ValueError(f"No ball alone reaches the density {threshold:g}; choose a threshold below 1.")
    middles = blob_middles(balls, spread)
    # Beyond this distance of every middle all balls together stay below the threshold
    reach = math.sqrt(math.log(balls / threshold) / tightness)
    half = np.array([spread, 0.0, spread]) + reach
    counts = np.maximum(np.ceil(cells * half / half.max()), 2).astype(np.int64) + 1
    steps = [np.linspace(-side, side, count) * 1.0001 for side, count in zip(half, counts, strict=True)]
    grid = np.stack(np.meshgrid(*steps, indexing="ij"), axis=-1)
    return equal_surface(grid, density(grid, middles, tightness) - threshold)


def equal_surface(grid: Array, values: Array) -> Mesh:
    """The surface on which values (i, j, k) at the points (i, j, k, 3) of a grid are 0, positive inside.

    No value at the border of the grid may be positive. Each edge of the mesh has two faces.
    """
    points, values = grid.reshape(-1, 3), values.reshape(-1)
    shape = np.array(grid.shape[:3])
    cubes = np.stack(np.meshgrid(*(np.arange(n - 1) for n in shape), indexing="ij"), axis=-1).reshape(
        -1, 1, 1, 3
    )
    corners = np.ravel_multi_index(tuple(np.moveaxis(cubes + _TETRAHEDRA, -1, 0)), tuple(shape)).reshape(
        -1, 4
    )
    inside = values[corners] > 0
    count = inside.sum(axis=1)
    pairs: list[NDArray[np.int64]] = []
    # Corners inside come first
    order = np.argsort(~inside, axis=1, kind="stable")
    sorted_in = np.take_along_axis(corners, order, axis=1)
    for number in (1, 2, 3):
        a, b, c, d = sorted_in[count == number].T
        if number == 1:
            pairs.append(np.stack([[a, b], [a, c], [a, d]]))
        elif number == 3:
            pairs.append(np.stack([[d, a], [d, b], [d, c]]))
        else:
            pairs.append(np.stack([[a, c], [a, d], [b, d]]))
            pairs.append(np.stack([[a, c], [b, d], [b, c]]))
    ends = np.sort(np.concatenate([np.moveaxis(pair, -1, 0) for pair in pairs]), axis=2)
    edges, faces = np.unique(ends.reshape(-1, 2), axis=0, return_inverse=True)
    low, high = edges.T
    share = values[low] / (values[low] - values[high])
    vertices = points[low] + share[:, None] * (points[high] - points[low])
    return Mesh(vertices, Faces.of(_outwards(vertices, faces.reshape(-1, 3), points, values, ends)))


def _outwards(
    vertices: Array, faces: NDArray[np.int64], points: Array, values: Array, ends: NDArray[np.int64]
) -> NDArray[np.int64]:
    """The faces, each turned counter-clockwise as seen from where values are negative."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    first, second = ends[:, 0, 0], ends[:, 0, 1]
    out = (points[second] - points[first]) * np.where(values[first] > 0, 1.0, -1.0)[:, None]
    turned = (np.cross(b - a, c - a) * out).sum(axis=1) < 0
    faces[turned] = faces[turned][:, ::-1]
    return faces
