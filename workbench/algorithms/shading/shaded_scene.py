"""What the shadings take that light a scene themselves: device triangles, and where they are in the world."""

from random import Random
from typing import Any

import numpy as np

from workbench.algorithms.entry import Parameter
from workbench.algorithms.shading.model_parameters import BLOCKERS, BY_HALFWAY
from workbench.algorithms.visibility.scene import scene

_DEVICE = np.array([[0.0, 0, 0.5], [10, 0, 0.5], [4, 10, 0.5], [0, 4, 0.4], [9, 2, 0.8], [9, 9, 0.8]])
_MIDDLES = np.repeat(np.array([[14 / 3, 10 / 3, 0.0], [6.0, 5, 0]]), 3, axis=0)
_PER_DEPTH = 10.0


def _in_world(device: Any) -> Any:
    """Seen along z, ten units deep: x and y as on the device."""
    return device * (1.0, 1.0, -_PER_DEPTH)


# The normals lean outwards, as those of something round do.
_NORMALS = _in_world(_DEVICE) * (1.0, 1.0, 0.0) - _MIDDLES + (0.0, 0.0, 6.0)

PARAMETERS = (
    Parameter("light", "light", "depth", np.zeros((12, 12)), meaning="the picture, drawn into"),
    Parameter("vertices", "vertices", "points", _DEVICE, meaning="x and y in pixels, z from 0 to 1"),
    Parameter("faces", "faces", "ints", np.array([[0, 1, 2], [3, 4, 5]]), meaning="corners of each triangle"),
    Parameter("places", "places", "points", _in_world(_DEVICE), meaning="each vertex in the world"),
    Parameter("normals", "normals", "points", _NORMALS, meaning="normal of the surface at each vertex"),
    Parameter(
        "materials",
        "materials",
        "matrix",
        np.array([[0.1, 0.5, 0.4, 20], [0.2, 0.8, 0.0, 1]]),
        meaning="of each triangle the ambient light, k_d, k_s and n",
    ),
    Parameter("eye", "eye", "floats", np.array([4.0, 4, 20, 1]), meaning="where it is seen from"),
    Parameter(
        "lights",
        "lights",
        "matrix",
        np.array([[6.0, 4, 8, 1, 1, 1, 0, 0]]),
        meaning="x, y, z, w, intensity, then a0, a1, a2 of the distance",
    ),
    BY_HALFWAY,
    BLOCKERS,
    Parameter("depth", "depth", "depth", np.ones((12, 12)), meaning="depth buffer, 1 is the farthest"),
)
"""In the order of the arguments of the texts."""

MISSED = (
    "What it lights is what the eye sees: places and normals are spread evenly over the picture, also where "
    "perspective would have them closer together far away."
)


def shaded_scene(chance: Random) -> tuple[Any, ...]:
    """One or two triangles with normals at will, some of them 0; up to two lights, some in a corner."""
    image, depth, vertices, faces, _colours = scene(chance)
    places = _in_world(vertices)

    def somewhere() -> list[float]:
        return [float(chance.randint(-4, 9)), float(chance.randint(-4, 9)), float(chance.randint(-9, 9))]

    def light() -> list[float]:
        at = chance.choice(places).tolist() if chance.random() < 0.2 else somewhere()
        return [
            *at,
            float(chance.random() < 0.7),
            chance.randint(0, 4) / 4,
            chance.randint(0, 2) / 2,
            0.0,
            0.0,
        ]

    lights = np.array([light() for _light in range(chance.randint(0, 2))]).reshape(-1, 8)
    normals = np.array([somewhere() for _vertex in vertices])
    shares = [[chance.randint(0, 4) / 4 for _share in range(3)] for _face in faces]
    materials = np.array([[*row, float(chance.randint(1, 30))] for row in shares]).reshape(-1, 4)
    blockers = places[faces].reshape(-1, 3) if chance.random() < 0.3 else np.zeros((0, 3))
    eye = np.array([*somewhere(), float(chance.random() < 0.7)])
    by_halfway = chance.random() < 0.5
    rest = places, normals, materials, eye, lights, by_halfway, blockers
    return np.zeros(image.shape), vertices, faces, *rest, depth
