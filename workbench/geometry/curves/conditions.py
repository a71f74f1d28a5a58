"""What points, knots and weights must be before a curve can be made of them.

``faults`` finds everything that is wrong, each fault with its place and a sentence about it.
"""

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray


class Fault(NamedTuple):
    """What is wrong: at which point, weight or knot (-1: all of them), and what to do about it."""

    what: Literal["points", "weights", "knots", "degree"]
    number: int
    sentence: str


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
    faulty = []
    if shape.ndim != 2:
        faulty.append(Fault("points", -1, "The points are not rows of coordinates; give each its x and y."))
        return faulty
    for i in np.flatnonzero(~np.isfinite(shape).all(axis=1)):
        faulty.append(Fault("points", int(i), f"Point {i} is not finite; give it numbers."))
    least = max(least, (degree or 0) + 1)
    if len(shape) < least:
        there = there_are(len(shape), "point")
        sentence = f"{there}, and {least} are needed; add {least - len(shape)}."
        faulty.append(Fault("points", -1, sentence))
    if degree is not None and degree < 1:
        faulty.append(Fault("degree", -1, f"The degree is {degree}; it must be 1 or more."))
    if weights is not None:
        faulty += _weight_faults(np.asarray(weights, float), len(shape))
    if knots is not None and degree is not None:
        faulty += _knot_faults(np.asarray(knots, float), len(shape), degree)
    return faulty


def refuse(found: list[Fault]) -> None:
    """Raise ValueError with the sentence of the first fault, if there is one."""
    if found:
        raise ValueError(found[0].sentence)


def there_are(count: int, noun: str) -> str:
    """How a sentence begins that tells how many there are."""
    return f"There is 1 {noun}" if count == 1 else f"There are {count} {noun}s"


def _weight_faults(weights: NDArray[np.float64], count: int) -> list[Fault]:
    if weights.shape != (count,):
        there = there_are(weights.size, "weight")
        return [Fault("weights", -1, f"{there} for {count} points; give each one.")]
    return [
        Fault("weights", int(i), f"Weight {i} is {weights[i]:g}; it must be a finite number above 0.")
        for i in np.flatnonzero(~(np.isfinite(weights) & (weights > 0)))
    ]


def _knot_faults(knots: NDArray[np.float64], count: int, degree: int) -> list[Fault]:
    needed = count + degree + 1
    if knots.shape != (needed,):
        what = f"{there_are(knots.size, 'knot')}, and {count} points of degree {degree} need {needed}"
        more = knots.size - needed
        return [Fault("knots", -1, f"{what}; {'take away' if more > 0 else 'add'} {abs(more)}.")]
    unbounded = [
        Fault("knots", int(i), f"Knot {i} is not finite; give it a number.")
        for i in np.flatnonzero(~np.isfinite(knots))
    ]
    if unbounded:
        return unbounded
    faulty = [
        Fault(
            "knots",
            int(i) + 1,
            f"Knot {i + 1} is {knots[i + 1]:g}, less than knot {i}, {knots[i]:g}; raise it.",
        )
        for i in np.flatnonzero(np.diff(knots) < 0)
    ]
    if not faulty and 1 <= degree < count and knots[degree] == knots[count]:
        sentence = f"Knots {degree} and {count}, where the curve begins and ends, are equal; part them."
        faulty.append(Fault("knots", count, sentence))
    return faulty
