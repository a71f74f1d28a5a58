"""What ray casting through boxes is shown on, and what its laws are tried on."""

from dataclasses import replace
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.visibility.surface_scene import SURFACES


def _row_of_triangles() -> NDArray[np.float64]:
    """Ten triangles (30, 3) in two rows, those below nearer and wider."""
    corners = []
    for k in range(5):
        x, z = 2.5 * k, 0.25 + k / 16
        corners += [(x, 0.5, z), (x + 4, 1.0, z), (x + 1, 5.5, z + 0.125)]
        corners += [(x + 0.5, 4.25, 0.75), (x + 3, 4.75, 0.75 - k / 16), (x + 1, 9.0, 0.5)]
    return np.array(corners)


_OWN = {
    "vertices": _row_of_triangles(),
    "faces": np.arange(30).reshape(10, 3),
    "colours": np.arange(1, 11),
}
EXAMPLE = tuple(
    replace(parameter, example=_OWN[parameter.name]) if parameter.name in _OWN else parameter
    for parameter in SURFACES
)
"""image, vertices, faces, colours, with more triangles than one box keeps."""


def many_surfaces(chance: Random) -> tuple[Any, ...]:
    """Up to a dozen triangles on quarters of a pixel, some of them twice, some edge on."""
    triangles: list[list[tuple[float, float, float]]] = []
    for _triangle in range(chance.randint(0, 12)):
        if triangles and chance.random() < 0.2:
            triangles.append(chance.choice(triangles))
            continue
        x, y = chance.randint(-8, 32) / 4, chance.randint(-8, 24) / 4
        triangles.append(
            [
                (x + chance.randint(-8, 8) / 4, y + chance.randint(-8, 8) / 4, chance.randint(0, 15) / 16)
                for _corner in range(3)
            ]
        )
    count = len(triangles)
    corners = np.array(triangles, np.float64).reshape(-1, 3)
    faces = np.arange(3 * count).reshape(-1, 3)
    return np.zeros((6, 8), np.int64), corners, faces, np.arange(1, count + 1)
