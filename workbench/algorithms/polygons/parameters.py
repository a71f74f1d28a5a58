"""What the polygon algorithms take, with the triangle of the course."""

from random import Random
from typing import Any

import numpy as np

from workbench.algorithms.entry import Parameter

POLYGON = (
    Parameter(
        "vertices", "vertices", "points", np.array([[2, 1], [8, 1], [5, 7]], np.float64), meaning="x and y"
    ),
    Parameter("ring_ends", "ring ends", "ints", np.array([3]), meaning="one past each ring's last vertex"),
)
CLOSED = Parameter("closed", "closed", "bool", True, meaning="with the boundary, else half_open")
NONZERO = Parameter("nonzero", "nonzero", "bool", False, meaning="interior by winding number, else even_odd")


def polygon(chance: Random) -> tuple[Any, ...]:
    """Vertices and ring ends of one or two rings of any shape, that cross themselves more often than not.

    Corners lie on pixel centres, on quarters, a digit beside a centre, or anywhere; some come twice.
    """
    rings = [chance.randint(3, 6) for _ring in range(chance.randint(1, 2))]
    corners = [(_place(chance), _place(chance)) for _corner in range(sum(rings))]
    if chance.randint(0, 3) == 0:
        corners[-1] = corners[0]
    return np.array(corners, np.float64), np.cumsum(rings)


def _place(chance: Random) -> float:
    whole = float(chance.randint(-6, 9))
    beside = chance.choice((0.0, 0.0, 0.25, 0.5, 1e-12, -1e-12, -3e-16, 2.0**-11))
    return whole + beside if chance.randint(0, 3) else chance.uniform(-6.0, 9.0)


def polygon_and_rules(chance: Random) -> tuple[Any, ...]:
    """A polygon and both rules."""
    return *polygon(chance), bool(chance.randint(0, 1)), bool(chance.randint(0, 1))


def polygon_and_point(chance: Random) -> tuple[Any, ...]:
    """A polygon, a point that often is a corner or on a level with one, and the rule of the interior."""
    vertices, ring_ends = polygon(chance)
    x, y = _place(chance), _place(chance)
    corner = chance.choice(vertices.tolist())
    level = chance.randint(0, 3)
    return vertices, ring_ends, corner[0] if level == 1 else x, corner[1] if level < 2 else y, level == 3
