"""What the curve algorithms take, with the curve of the course."""

from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

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
    "tolerance",
    "tolerance",
    "float",
    0.05,
    low=1e-9,
    meaning="how far the chain of lines may be from the curve",
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
        meaning="the knots, ascending, degree + 1 more than there are points",
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
HERMITE = (
    Parameter(
        "points",
        "P_k",
        "points",
        np.array([[1, 1], [7, 3]], np.float64),
        meaning="the points where the piece begins and ends",
    ),
    Parameter(
        "tangents",
        "DP_k",
        "points",
        np.array([[4, 8], [6, -6]], np.float64),
        meaning="the derivatives by u there",
    ),
)
THROUGH = (
    Parameter(
        "points",
        "P_i",
        "points",
        np.array([[1, 1], [3, 5], [6, 4], [9, 6]], np.float64),
        meaning="the points that the curve passes",
    ),
    Parameter(
        "knots",
        "t_i",
        "floats",
        np.array([0, 1, 2, 3], np.float64),
        meaning="the parameter at each point, strictly ascending",
    ),
)

_Array = NDArray[np.float64]


def _points(chance: Random, count: int) -> _Array:
    """Points on a small grid or far from it, now and then one in the place of another."""
    rows = [[_coordinate(chance), _coordinate(chance)] for _point in range(count)]
    if chance.randint(0, 1):
        rows[chance.randrange(count)] = rows[chance.randrange(count)]
    return np.array(rows, np.float64)


def _coordinate(chance: Random) -> float:
    return float(chance.randint(-6, 6)) if chance.randint(0, 2) else chance.uniform(-1e3, 1e3)


def _part(chance: Random) -> float:
    """A part of the whole, at an end or all but there more often than not."""
    return chance.choice((0.0, 0.5, 1.0, 1e-9, 1.0 - 1e-9, chance.random(), chance.random()))


def _knots(chance: Random, count: int, degree: int) -> _Array:
    """Ascending knots, none inside repeated more than degree + 1 times; some spans empty or all but empty."""
    knots = [float(chance.randint(-3, 3))]
    while len(knots) < count + degree + 1:
        step = chance.choice((0.0, 0.0, 1e-9, 1.0, 2.0, chance.uniform(0.0625, 4.0)))
        if step == 0.0 and knots.count(knots[-1]) > degree:
            step = 1.0
        knots.append(knots[-1] + step)
    ascending = np.array(knots)
    if chance.randint(0, 1):
        ascending[:degree] = ascending[degree]
        ascending[count + 1 :] = ascending[count]
    if ascending[degree] == ascending[count]:
        ascending[count:] += 1.0
    return ascending


def _weight(chance: Random) -> float:
    return chance.choice((1e-9, 0.5, 1.0, 3.0, 1e9, chance.uniform(0.1, 10.0)))


def _b_spline(chance: Random) -> tuple[_Array, _Array, int]:
    degree = chance.randint(1, 7)
    count = degree + chance.randint(1, 6)
    return _points(chance, count), _knots(chance, count, degree), degree


def bezier_and_u(chance: Random) -> tuple[Any, ...]:
    """Two to seven control points, and a place on the curve."""
    return _points(chance, chance.randint(2, 7)), _part(chance)


def hermite_and_u(chance: Random) -> tuple[Any, ...]:
    """Two points, two tangents, and a place between."""
    return _points(chance, 2), _points(chance, 2), _part(chance)


def points_to_pass(chance: Random) -> tuple[Any, ...]:
    """Two to seven points, and ascending parameters, some of them close to each other."""
    count = chance.randint(2, 7)
    lengths = [
        chance.choice((1.0, 1.0, 2.0, 1e-3, chance.uniform(0.0625, 4.0))) for _piece in range(count - 1)
    ]
    return _points(chance, count), np.append(0.0, np.cumsum(lengths))


def bezier_and_tolerance(chance: Random) -> tuple[Any, ...]:
    """Two to five control points, and a tolerance that takes few chords or many."""
    return _points(chance, chance.randint(2, 5)), chance.choice((0.5, 3.0, 100.0))


def b_spline_and_u(chance: Random) -> tuple[Any, ...]:
    """A B-spline of any degree, and a place on it, also at its ends and knots."""
    points, knots, degree = _b_spline(chance)
    first, last = float(knots[degree]), float(knots[len(points)])
    u = chance.choice(knots.tolist()) if chance.randint(0, 2) == 0 else first + _part(chance) * (last - first)
    return points, knots, degree, min(max(u, first), last)


def b_spline_and_samples(chance: Random) -> tuple[Any, ...]:
    """A B-spline of any degree, and how often it is sampled."""
    return *_b_spline(chance), chance.randint(2, 20)


def nurbs_and_u(chance: Random) -> tuple[Any, ...]:
    """The same with weights, some of them very far apart."""
    points, knots, degree, u = b_spline_and_u(chance)
    return points, np.array([_weight(chance) for _point in points]), knots, degree, u


def pieces_and_point(chance: Random) -> tuple[Any, ...]:
    """Pieces that need not join, some without length in the parameter, and a point, now and then theirs."""
    count, degree = chance.randint(1, 3), chance.randint(1, 4)
    lengths = [chance.choice((0.0, 0.5, 1.0, 3.0)) for _piece in range(count)]
    lengths[chance.randrange(count)] = 1.0
    points = _points(chance, count * (degree + 1))
    weighted = chance.randint(0, 1)
    weights = [_weight(chance) if weighted else 1.0 for _point in points]
    x, y = points[0].tolist() if chance.randint(0, 3) == 0 else (_coordinate(chance), _coordinate(chance))
    return np.append(0.0, np.cumsum(lengths)), points, np.array(weights), degree, x, y
