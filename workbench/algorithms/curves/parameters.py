"""What the curve algorithms take, with the curve of the course."""

import numpy as np

from workbench.algorithms.entry import Parameter

BEZIER_POINTS = Parameter(
    "points",
    "P_i",
    "points",
    np.array([[1, 1], [2, 3], [4, 3], [6, 4]], np.float64),
    meaning="the control points",
)
U = Parameter("u", "u", "float", 0.5, low=0, high=1, meaning="where on the curve, from 0 to 1")
TOLERANCE = Parameter(
    "tolerance", "tolerance", "float", 0.05, low=1e-9, meaning="how far the chain may be off"
)
B_SPLINE = (
    Parameter(
        "points",
        "P_i",
        "points",
        np.array([[1, 1], [2, 5], [5, 6], [7, 2], [10, 1], [12, 5]], np.float64),
        meaning="the control points",
    ),
    Parameter(
        "knots",
        "t_i",
        "floats",
        np.array([0, 0, 0, 0, 1, 2, 3, 3, 3, 3], np.float64),
        meaning="the knots, ascending, as many as points and degree + 1 more",
    ),
    Parameter(
        "degree", "p", "int", 3, low=1, high=7, meaning="degree of the curve; the course's d is one more"
    ),
)
B_SPLINE_U = Parameter("u", "u", "float", 1.25, meaning="from knot t_p to knot t_{n+1}")
WEIGHTS = Parameter(
    "weights", "w_i", "floats", np.array([1, 1, 3, 1, 0.5, 1], np.float64), meaning="their weights, above 0"
)
PIECES = (
    Parameter(
        "knots", "t_j", "floats", np.array([0, 1, 2], np.float64), meaning="where the pieces begin and end"
    ),
    Parameter(
        "points",
        "P_i",
        "points",
        np.array([[1, 1], [2, 5], [5, 6], [6, 3], [6, 3], [7, 0], [10, 1], [12, 5]], np.float64),
        meaning="the control points, piece after piece",
    ),
    Parameter("weights", "w_i", "floats", np.ones(8), meaning="their weights, 1 for a plain curve"),
    Parameter("degree", "p", "int", 3, low=1, high=7, meaning="degree of the pieces"),
)
