"""What the polygon algorithms take, with the triangle of the course."""

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
