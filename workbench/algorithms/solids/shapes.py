"""Shapes to study hidden surfaces on: a house, a solid with a dent, planes that pierce one another."""

import numpy as np

from workbench.algorithms.solids.polyhedra import refuse_sizes
from workbench.algorithms.solids.sweeps import extruded
from workbench.geometry.meshes import Faces, Mesh


def house(width: float = 2.0, height: float = 1.5, depth: float = 3.0, roof: float = 1.0) -> Mesh:
    """A house on y = 0 with its gable to the front: walls of ``height``, a ``roof`` above them.

    Raises: ValueError for a size that is not above 0.
    """
    refuse_sizes(width, height, depth, roof)
    side = width / 2
    gable = [(-side, 0.0), (side, 0.0), (side, height), (0.0, height + roof), (-side, height)]
    return extruded(gable, depth)


def bracket(width: float = 2.0, height: float = 2.0, depth: float = 1.0, thickness: float = 0.5) -> Mesh:
    """An angle of two arms on y = 0, a solid that is not convex: parts of it hide others.

    Raises: ValueError for a size that is not above 0, or arms thicker than it is wide or high.
    """
    refuse_sizes(width, height, depth, thickness)
    if thickness >= min(width, height):
        raise ValueError(
            f"The thickness of the bracket is {thickness:g}, its width {width:g} and its height {height:g}; "
            "make the thickness smaller than either."
        )
    left, right = -width / 2, width / 2
    inner = left + thickness
    angle = [
        (left, 0.0),
        (right, 0.0),
        (right, thickness),
        (inner, thickness),
        (inner, height),
        (left, height),
    ]
    return extruded(angle, depth)


def piercing_planes(side: float = 2.0) -> Mesh:
    """Three squares through the origin, each in a plane of two axes; a surface without an inside.

    Raises: ValueError for a side that is not above 0.
    """
    refuse_sizes(side)
    square = side / 2 * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float)
    vertices = np.concatenate([np.roll(square, turn, axis=1) for turn in range(3)])
    return Mesh(vertices, Faces.of(np.arange(12).reshape(3, 4)))
