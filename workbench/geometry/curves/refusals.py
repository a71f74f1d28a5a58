"""What stands at the door of the texts that are stepped and compiled, and of what takes a tolerance.

Compiled, a sentence cannot hold numbers; ``faults`` finds where something is wrong.
"""

import math
from typing import Any

from numpy.typing import NDArray


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


def refuse_hermite(points: NDArray[Any], tangents: NDArray[Any], u: float) -> None:
    """Raise ValueError unless there are two points with a tangent each, and every number is finite."""
    if len(points) != 2 or len(tangents) != 2:
        raise ValueError("A Hermite piece has two points and two tangents; give two of each.")
    if not_finite(points) > 0 or not_finite(tangents) > 0 or not math.isfinite(u):
        raise ValueError("A coordinate or the parameter is not a finite number; give it a value.")


def refuse_interpolation(points: NDArray[Any], knots: NDArray[Any]) -> None:
    """Raise ValueError unless there are two points or more, each with a knot above the one before it."""
    if len(points) < 2:
        raise ValueError("A curve through points needs two points or more; add points.")
    if len(knots) != len(points):
        raise ValueError("There must be one knot for each point; add knots, or remove some.")
    if not_finite(points) > 0 or not_finite(knots) > 0:
        raise ValueError("A coordinate or a knot is not a finite number; give it a value.")
    if len([i for i in range(len(knots) - 1) if not knots[i] < knots[i + 1]]) > 0:
        raise ValueError("The knots do not ascend; make each larger than the one before it.")


def refuse_pieces(
    knots: NDArray[Any], points: NDArray[Any], weights: NDArray[Any], degree: int, x: float, y: float
) -> None:
    """Raise ValueError unless these are pieces of this degree, and (x, y) is a point."""
    if degree < 1 or len(knots) < 2:
        raise ValueError("A curve in pieces has two knots or more, and degree 1 or more; add some.")
    if len(points) != (len(knots) - 1) * (degree + 1):
        raise ValueError("Each piece needs degree + 1 points; add points, or remove some.")
    if not_finite(points) > 0 or not_finite(knots) > 0 or not math.isfinite(x) or not math.isfinite(y):
        raise ValueError("A coordinate or a knot is not a finite number; give it a value.")
    if decreases(knots) > 0:
        raise ValueError("The knots decrease; make each at least as large as the one before it.")
    refuse_weights(weights, len(points))


def refuse_b_spline(points: NDArray[Any], knots: NDArray[Any], degree: int) -> None:
    """Raise ValueError unless these points and knots make a B-spline of this degree."""
    if degree < 1:
        raise ValueError("The degree of a B-spline is 1 or more; raise it.")
    if len(points) < degree + 1:
        raise ValueError("There are fewer points than degree + 1; add points, or lower the degree.")
    if len(knots) != len(points) + degree + 1:
        raise ValueError("There must be degree + 1 more knots than points; add knots, or remove some.")
    if not_finite(points) > 0 or not_finite(knots) > 0:
        raise ValueError("A coordinate or a knot is not a finite number; give it a value.")
    if decreases(knots) > 0:
        raise ValueError("The knots decrease; make each at least as large as the one before it.")
    if knots[degree] == knots[len(points)]:
        raise ValueError(
            "The curve has no length in u: its first and its last knot are equal; move them apart."
        )


def refuse_parameter(knots: NDArray[Any], degree: int, count: int, u: float) -> None:
    """Raise ValueError unless a B-spline of ``count`` points is defined at u."""
    if not knots[degree] <= u <= knots[count]:
        raise ValueError("The parameter u is outside the curve; keep it from knot t_p to knot t_{n+1}.")


def refuse_weights(weights: NDArray[Any], count: int) -> None:
    """Raise ValueError unless there is a finite weight above 0 for each of ``count`` points."""
    if len(weights) != count:
        raise ValueError("There must be one weight for each point; add weights, or remove some.")
    if len([w for w in weights if not 0.0 < w < math.inf]) > 0:
        raise ValueError("A weight is not a finite number above 0; give it one.")


def refuse_tolerance(tolerance: float) -> None:
    """Raise ValueError unless the tolerance is a finite number above 0."""
    if not (math.isfinite(tolerance) and tolerance > 0):
        raise ValueError(f"The tolerance is {tolerance:g}; choose a finite one above 0.")


def refuse_many_pieces(count: int, most: float, tolerance: float) -> None:
    """Raise ValueError where a curve within ``tolerance`` of its points takes more than ``most`` pieces."""
    if count > most:
        raise ValueError(
            f"Within {tolerance:.3g}, these points take more than {most:,} pieces; "
            "give fewer points, or allow more distance."
        )
