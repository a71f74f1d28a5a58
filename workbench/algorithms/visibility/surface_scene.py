"""What the methods take that keep no depths: a picture and surfaces; and scenes on which they may err."""

from random import Random
from typing import Any

import numpy as np

from workbench.algorithms.entry import Law
from workbench.algorithms.visibility.scene import SCENE, scene

ONE_PICTURE = Law(
    "The picture is that of the depth buffer, also where surfaces pierce one another, overlap in a cycle or "
    "lie in one plane.",
    "visibility/test_one_picture.py::test_they_give_the_picture_of_the_depth_buffer",
)

SURFACES = tuple(parameter for parameter in SCENE if parameter.name != "depth")
"""image, vertices, faces, colours, with two triangles that pierce one another."""


def surfaces_at_will(chance: Random) -> tuple[Any, ...]:
    """Up to four triangles: any, copies in one plane, pieces of a mesh, or four that overlap in a cycle."""
    image, _depth, vertices, faces, colours = scene(chance)
    match chance.randint(0, 3):
        case 0:
            return image, vertices, faces, colours
        case 1:
            corners = [_in_one_plane(chance) for _corner in range(9)]
        case 2:
            heights = [chance.randint(0, 15) / 16 for _corner in range(4)]
            net = [(x, y, z) for (x, y), z in zip(((0, 0), (6, 1), (7, 5), (1, 5)), heights, strict=True)]
            corners = [net[k] for k in (0, 1, 2, 0, 2, 3)]
            corners += [(float(chance.randint(0, 7)), float(chance.randint(0, 5)), 0.5) for _corner in "abc"]
        case _:
            corners = cycle(chance.randint(0, 2) / 4)
    count = len(corners) // 3
    return image, np.array(corners, np.float64), np.arange(3 * count).reshape(-1, 3), np.arange(1, count + 1)


def _in_one_plane(chance: Random) -> tuple[float, float, float]:
    x, y = float(chance.randint(-1, 8)), float(chance.randint(-1, 6))
    return x, y, 0.25 + x / 32 + y / 64


def cycle(move: float = 0.0) -> list[tuple[float, float, float]]:
    """Four slats round a rectangle, each under the one before and over the next: corners, three for each."""
    slats = [
        ((7, 5, 0.125), (0, 5, 0.75), (0, 3.5, 0.75)),
        ((0, 5, 0.125), (0, 0, 0.75), (1.75, 0, 0.75)),
        ((0, 0, 0.125), (7, 0, 0.75), (7, 1.25, 0.75)),
        ((7, 0, 0.125), (7, 5, 0.75), (4.75, 5, 0.75)),
    ]
    return [(x + move, y, z) for slat in slats for x, y, z in slat]
