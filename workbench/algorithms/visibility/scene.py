"""Two triangles that pierce one another, as the example of the visibility algorithms."""

from random import Random
from typing import Any

import numpy as np

from workbench.algorithms.entry import Parameter

SCENE = (
    Parameter("image", "image", "image", np.zeros((10, 14), np.int64), meaning="the picture, drawn into"),
    Parameter("depth", "depth", "depth", np.ones((10, 14)), meaning="depth buffer, 1 is the farthest"),
    Parameter(
        "vertices",
        "vertices",
        "points",
        np.array(
            [[0, 1, 0.25], [12, 1, 0.75], [0, 9, 0.25], [2, 0, 0.5], [13, 4, 0.5], [4, 9, 0.5]], np.float64
        ),
        meaning="x and y in pixels, z from 0 (near) to 1 (far)",
    ),
    Parameter("faces", "faces", "ints", np.array([[0, 1, 2], [3, 4, 5]]), meaning="corners of each triangle"),
    Parameter("colours", "colours", "ints", np.array([1, 2]), meaning="colour of each triangle"),
)


def scene(chance: Random) -> tuple[Any, ...]:
    """One or two triangles on quarters of a pixel, partly outside, some edge on, some at equal depths."""
    count = chance.randint(1, 2)
    vertices = [
        (chance.randint(-8, 40) / 4, chance.randint(-8, 32) / 4, chance.randint(0, 15) / 16)
        for _corner in range(3 * count)
    ]
    match chance.randint(0, 3):
        case 0:
            vertices[-3:] = vertices[:3]
        case 1:
            vertices[2] = vertices[1]
        case 2:
            vertices[2] = vertices[1][0], vertices[1][1], vertices[0][2]
    faces = np.arange(3 * count).reshape(-1, 3)
    return (
        np.zeros((6, 8), np.int64),
        np.ones((6, 8)),
        np.array(vertices),
        faces,
        np.arange(1, count + 1),
    )
