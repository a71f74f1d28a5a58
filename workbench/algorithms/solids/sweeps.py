"""Solids that an outline sweeps: along a straight way, or round the y axis.

Source: Hearn and Baker, Computer Graphics, C Version, section 10-13.
"""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.algorithms.solids.polyhedra import refuse_sizes
from workbench.geometry.meshes import Faces, Mesh

Array = NDArray[np.float64]

MOST_STEPS = 2_000


def extruded(outline: ArrayLike, depth: float = 1.0) -> Mesh:
    """The solid of an outline (n, 2) in x and y, which may turn either way and dent, from z = -depth / 2 on.

    Raises: ValueError for fewer than three corners, no area, or a depth that is not above 0.
    """
    refuse_sizes(depth)
    flat = _outline(outline, 3)
    area = _area(flat)
    if area == 0:
        raise ValueError("The outline has no area; give it corners that do not lie on one line.")
    flat = flat if area > 0 else flat[::-1]
    n = len(flat)
    back, front = (np.column_stack([flat, np.full(n, z)]) for z in (-depth / 2, depth / 2))
    number = np.arange(n)
    after = np.roll(number, -1)
    sides = np.stack([number, after, after + n, number + n], axis=1)
    return Mesh(
        np.concatenate([back, front]),
        Faces.of([number[::-1].tolist(), *sides.tolist(), (number + n).tolist()]),
    )


def turned(profile: ArrayLike, slices: int = 24, closed: bool = False) -> Mesh:
    """The solid of a profile (n, 2), points (r, y) upwards outside, carried round the y axis in ``slices``.

    A closed profile runs counter-clockwise and makes a ring. The ends of an open one lie on the axis (r = 0)
    or are closed with a lid. Raises: ValueError for r < 0, an inner point on the axis, or a bad number.
    """
    points = _outline(profile, 3 if closed else 2)
    _refuse_steps(slices)
    inner = points if closed else points[1:-1]
    if (points[:, 0] < 0).any() or (inner[:, 0] == 0).any():
        raise ValueError("A point of the profile lies beyond the axis or on it; only its ends may lie on it.")
    angles = 2 * math.pi * np.arange(slices) / slices
    vertices: list[Array] = []
    rings: list[list[int]] = []
    for r, y in points.tolist():
        count = slices if r > 0 else 1
        begin = sum(map(len, vertices))
        rings.append([begin + k % count for k in range(slices + 1)])
        round_it = np.column_stack([r * np.cos(angles), np.full(slices, y), -r * np.sin(angles)])
        vertices.append(round_it[:count])
    faces = [] if closed or points[0, 0] == 0 else [rings[0][-2::-1]]
    for low, high in zip(rings, [*rings[1:], *([rings[0]] if closed else [])], strict=False):
        for k in range(slices):
            corners = (low[k], low[k + 1], high[k + 1], high[k])
            faces.append(list(dict.fromkeys(corners)))
    if not closed and points[-1, 0] > 0:
        faces.append(rings[-1][:-1])
    return Mesh(np.concatenate(vertices), Faces.of(faces))


def prism(sides: int = 6, radius: float = 1.0, height: float = 2.0) -> Mesh:
    """A prism on y = 0 over a regular polygon; ``radius`` reaches to its corners. Raises: ValueError."""
    refuse_sizes(radius, height)
    return turned([(radius, 0.0), (radius, height)], sides)


def pyramid(sides: int = 4, radius: float = 1.0, height: float = 2.0) -> Mesh:
    """A pyramid on y = 0 over a regular polygon; ``radius`` reaches to its corners. Raises: ValueError."""
    refuse_sizes(radius, height)
    return turned([(radius, 0.0), (0.0, height)], sides)


def cylinder(radius: float = 1.0, height: float = 2.0, slices: int = 24) -> Mesh:
    """A cylinder on y = 0, in flat ``slices``. Raises: ValueError."""
    return prism(slices, radius, height)


def cone(radius: float = 1.0, height: float = 2.0, slices: int = 24) -> Mesh:
    """A cone on y = 0, in flat ``slices``. Raises: ValueError."""
    return pyramid(slices, radius, height)


def sphere(radius: float = 1.0, slices: int = 24, stacks: int = 12) -> Mesh:
    """A sphere around the origin, in ``slices`` round the y axis and ``stacks`` along it.

    Raises: ValueError.
    """
    refuse_sizes(radius)
    _refuse_steps(stacks, least=2)
    angles = math.pi * (np.arange(1, stacks) / stacks - 0.5)
    inner = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    return turned(np.concatenate([[[0.0, -radius]], inner, [[0.0, radius]]]), slices)


def ellipsoid(
    r_x: float = 1.5, r_y: float = 1.0, r_z: float = 0.75, slices: int = 24, stacks: int = 12
) -> Mesh:
    """An ellipsoid around the origin with these half axes. Raises: ValueError."""
    refuse_sizes(r_x, r_y, r_z)
    vertices, faces = sphere(1.0, slices, stacks)
    return Mesh(vertices * (r_x, r_y, r_z), faces)


def torus(radius: float = 2.0, thickness: float = 0.75, slices: int = 32, sections: int = 16) -> Mesh:
    """A ring around the y axis; ``thickness`` is the radius of its section. Raises: ValueError."""
    refuse_sizes(radius, thickness)
    if thickness >= radius:
        raise ValueError(
            f"The thickness of the ring is {thickness:g} and its radius {radius:g}; "
            "make the thickness smaller than the radius."
        )
    _refuse_steps(sections)
    angles = 2 * math.pi * np.arange(sections) / sections
    section = np.column_stack([radius + thickness * np.cos(angles), thickness * np.sin(angles)])
    return turned(section, slices, closed=True)


def _outline(points: ArrayLike, least: int) -> Array:
    flat = np.asarray(points, float)
    if flat.ndim != 2 or flat.shape[1] != 2 or not np.isfinite(flat).all():
        raise ValueError("The outline is not a list of points; give each two finite numbers.")
    if len(flat) < least:
        raise ValueError(f"The outline has {len(flat)} points; give it {least} or more.")
    return flat


def _area(flat: Array) -> float:
    x, y = (flat - flat[0]).T
    return float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum()) / 2


def _refuse_steps(count: int, least: int = 3) -> None:
    if not least <= count <= MOST_STEPS:
        raise ValueError(f"The solid would have {count} slices; choose {least} to {MOST_STEPS}.")
