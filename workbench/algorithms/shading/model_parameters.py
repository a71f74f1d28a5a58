"""What the illumination model takes beside the surface: eye, highlight, blockers; and points to try it on."""

from random import Random
from typing import Any

import numpy as np

from workbench.algorithms.entry import Parameter

EYE = Parameter(
    "eye", "eye", "floats", np.array([0.0, 0, 5, 1]), meaning="where it is seen from; with w = 0 a direction"
)
BY_HALFWAY = Parameter("by_halfway", "N · H", "bool", False, meaning="by the halfway vector instead of V · R")
BLOCKERS = Parameter(
    "blockers",
    "blockers",
    "points",
    np.zeros((0, 3)),
    meaning="corners of triangles that may take the light away, three for each; none for no shadows",
)


def lit_point(chance: Random) -> tuple[Any, ...]:
    """Up to three lights round a point, some of them behind the surface or in the point itself."""

    def place() -> list[float]:
        return [float(chance.randint(-3, 3)) for _axis in range(3)]

    def light() -> list[float]:
        fading = [chance.randint(0, 4) / 4 for _power in range(3)]
        return [*place(), float(chance.random() < 0.7), chance.randint(0, 4) / 4, *fading]

    lights = np.array([light() for _light in range(chance.randint(0, 3))])
    material = np.array([chance.randint(0, 4) / 4 for _share in range(3)] + [float(chance.randint(1, 50))])
    point, normal, eye = (np.array(place()) for _point in range(3))
    eye = np.append(eye, float(chance.random() < 0.7))
    blockers = np.array([place() for _corner in range(3 * chance.randint(0, 2))]).reshape(-1, 3)
    return point, normal, eye, lights.reshape(-1, 8), material, chance.random() < 0.5, blockers
