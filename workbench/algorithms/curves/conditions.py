"""What points, knots and weights must be before a curve can be made of them.

``refuse_bezier`` and ``refuse_b_spline`` stand at the door of the texts that are stepped and compiled;
``faults`` finds everything that is wrong, each fault with its place and a sentence about it.
"""

import math
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray


class Fault(NamedTuple):
    """What is wrong: at which point, weight or knot (-1: all of them), and what to do about it."""

    what: Literal["points", "weights", "knots", "degree"]
    number: int
    sentence: str


def not_finite(numbers: NDArray[Any]) -> int:
    """How many of the numbers are infinite or none at all."""
    return len([number for number in numbers.flat if not math.isfinite(number)])


def decreases(knots: NDArray[Any]) -> int:
    """How many knots are less than the one before."""
    return len([i for i in range(len(knots) - 1) if knots[i + 1] < knots[i]])


def refuse_bezier(points: NDArray[Any], u: float) -> None:
    """Raise ValueError unless there are two points or more, and every number is finite."""
    if len(points) < 2:
        raise ValueError("A Bezier curve needs two points or more; add points.")
    if not_finite(points) > 0 or not math.isfinite(u):
        raise ValueError("A coordinate or the parameter is not a finite number; give it a value.")


def refuse_pieces(
    knots: NDArray[Any], points: NDArray[Any], weights: NDArray[Any], degree: int, x: float, y: float
) -> None:
    """Raise ValueError unless these are pieces of this degree, and (x, y) is a point."""
    if degree < 1 or len(knots) < 2:
        raise ValueError("A curve in pieces has two knots or more, and degree 1 or more; add some.")
    if len(points) != (len(knots) - 1) * (degree + 1) or len(weights) != len(points):
        raise ValueError("Each piece needs degree + 1 points, and each point a weight; add what is missing.")
    if not_finite(points) > 0 or not_finite(knots) > 0 or not math.isfinite(x) or not math.isfinite(y):
        raise ValueError("A coordinate or a knot is not a finite number; give it a value.")
    if decreases(knots) > 0:
        raise ValueError("The knots decrease; make each at least as large as the one before it.")
    if len([w for w in weights if not 0.0 < w < math.inf]) > 0:
        raise ValueError("A weight is not a finite number above 0; give it one.")


def refuse_b_spline(points: NDArray[Any], knots: NDArray[Any], degree: int) -> None:
    """Raise ValueError unless these points and knots make a B-spline of this degree."""
    if degree < 1:
        raise ValueError("The degree of a B-spline is 1 or more; raise it.")
    if len(points) < degree + 1:
        raise ValueError("There are fewer points than degree + 1; add points, or lower the degree.")
    if len(knots) != len(points) + degree + 1:
        raise ValueError("There must be degree + 1 more knots than points; add knots, or take some away.")
    if not_finite(points) > 0 or not_finite(knots) > 0:
        raise ValueError("A coordinate or a knot is not a finite number; give it a value.")
    if decreases(knots) > 0:
        raise ValueError("The knots decrease; make each at least as large as the one before it.")
    if knots[degree] == knots[len(points)]:
        raise ValueError("The curve has no length in u: its first and its last knot are equal; part them.")


def refuse_parameter(knots: NDArray[Any], degree: int, count: int, u: float) -> None:
    """Raise ValueError unless a B-spline of ``count`` points is defined at u."""
    if not knots[degree] <= u <= knots[count]:
        raise ValueError("The parameter u is outside the curve; keep it from knot t_p to knot t_{n+1}.")


def faults(
    points: ArrayLike,
    knots: ArrayLike | None = None,
    degree: int | None = None,
    weights: ArrayLike | None = None,
    least: int = 2,
) -> list[Fault]:
    """Everything that is wrong with a curve's numbers, first things first; nothing if it can be made.

    Args: points (n, k); knots (m,) and degree of a B-spline; weights (n,); the least number of points.
    """
    shape = np.asarray(points, float)
    found = []
    if shape.ndim != 2:
        found.append(Fault("points", -1, "The points are not rows of coordinates; give each its x and y."))
        return found
    for i in np.flatnonzero(~np.isfinite(shape).all(axis=1)):
        found.append(Fault("points", int(i), f"Point {i} is not finite; give it numbers."))
    least = max(least, (degree or 0) + 1)
    if len(shape) < least:
        sentence = f"There are {len(shape)} points, and {least} are needed; add {least - len(shape)}."
        found.append(Fault("points", -1, sentence))
    if degree is not None and degree < 1:
        found.append(Fault("degree", -1, f"The degree is {degree}; it must be 1 or more."))
    if weights is not None:
        found += _weight_faults(np.asarray(weights, float), len(shape))
    if knots is not None and degree is not None:
        found += _knot_faults(np.asarray(knots, float), len(shape), degree)
    return found


def refuse(found: list[Fault]) -> None:
    """Raise ValueError with the sentence of the first fault, if there is one."""
    if found:
        raise ValueError(found[0].sentence)


def _weight_faults(weights: NDArray[np.float64], count: int) -> list[Fault]:
    if weights.shape != (count,):
        return [Fault("weights", -1, f"There are {weights.size} weights for {count} points; give each one.")]
    return [
        Fault("weights", int(i), f"Weight {i} is {weights[i]:g}; it must be a finite number above 0.")
        for i in np.flatnonzero(~(np.isfinite(weights) & (weights > 0)))
    ]


def _knot_faults(knots: NDArray[np.float64], count: int, degree: int) -> list[Fault]:
    needed = count + degree + 1
    if knots.shape != (needed,):
        what = f"There are {knots.size} knots, and {count} points of degree {degree} need {needed}"
        more = knots.size - needed
        return [Fault("knots", -1, f"{what}; {'take away' if more > 0 else 'add'} {abs(more)}.")]
    unbounded = [
        Fault("knots", int(i), f"Knot {i} is not finite; give it a number.")
        for i in np.flatnonzero(~np.isfinite(knots))
    ]
    if unbounded:
        return unbounded
    found = [
        Fault(
            "knots",
            int(i) + 1,
            f"Knot {i + 1} is {knots[i + 1]:g}, less than knot {i}, {knots[i]:g}; raise it.",
        )
        for i in np.flatnonzero(np.diff(knots) < 0)
    ]
    if not found and 1 <= degree < count and knots[degree] == knots[count]:
        sentence = f"Knots {degree} and {count}, where the curve begins and ends, are equal; part them."
        found.append(Fault("knots", count, sentence))
    return found
