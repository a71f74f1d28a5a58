"""The squared distance of a point from a Bézier piece, as a quotient of two polynomials of twice the degree.

Their Bernstein coefficients say where it may be small: no quotient is less than the least quotient of two
coefficients, and if these fall and then grow, so does the distance.
"""

import math
from typing import Any, NamedTuple

from numpy.typing import NDArray

# Weights this many times as heavy as others on the same part hold the curve fast
UNEVEN = 1e6


def box_distance(points: NDArray[Any], first: int, degree: int, x: float, y: float) -> float:
    """The distance of (x, y) from the box around the control points of the piece that begins at ``first``."""
    x_low = x_high = float(points[first, 0])
    y_low = y_high = float(points[first, 1])
    for i in range(first + 1, first + degree + 1):
        x_low, x_high = min(x_low, float(points[i, 0])), max(x_high, float(points[i, 0]))
        y_low, y_high = min(y_low, float(points[i, 1])), max(y_high, float(points[i, 1]))
    dx = max(x_low - x, x - x_high, 0.0)
    dy = max(y_low - y, y - y_high, 0.0)
    return math.sqrt(dx * dx + dy * dy)


class Part(NamedTuple):
    """A part of a Bézier piece, from ``begin`` to ``end`` in it, with the coefficients (2 degree + 1,) of the
    squared distance: those ``above`` the line of the quotient, and those ``below`` it."""

    begin: float
    end: float
    above: list[float]
    below: list[float]


def whole_piece(
    points: NDArray[Any], weights: NDArray[Any], first: int, degree: int, x: float, y: float
) -> Part:
    """All of the piece that begins at ``first``."""
    above = [0.0 for _k in range(2 * degree + 1)]
    below = [0.0 for _k in range(2 * degree + 1)]
    row = 1.0
    for i in range(degree + 1):
        x_i, y_i = float(points[first + i, 0]) - x, float(points[first + i, 1]) - y
        share = row
        for j in range(degree + 1):
            pull = share * float(weights[first + i]) * float(weights[first + j])
            x_j, y_j = float(points[first + j, 0]) - x, float(points[first + j, 1]) - y
            above[i + j] += pull * (x_i * x_j + y_i * y_j)
            below[i + j] += pull
            share *= (degree - j) / (j + 1)
        row *= (degree - i) / (i + 1)
    whole = 1.0
    for k in range(2 * degree + 1):
        above[k] /= whole
        below[k] /= whole
        whole *= (2 * degree - k) / (k + 1)
    return Part(0.0, 1.0, above, below)


def outlook(part: Part) -> tuple[float, bool]:
    """A bound for the distance, which it is nowhere less than, and whether it has one minimum only.

    Beside heavy weights the curve all but stands still, and to a search both sides look alike: then that is
    not said.
    """
    last = part.above[0] / part.below[0]
    least = last
    grows = False
    valley = max(part.below) <= UNEVEN * min(part.below)
    for k in range(1, len(part.above)):
        quotient = part.above[k] / part.below[k]
        least = min(least, quotient)
        if quotient < last and grows:
            valley = False
        grows = grows or quotient > last
        last = quotient
    return math.sqrt(max(least, 0.0)), valley


def first_half(coefficients: list[float]) -> list[float]:
    """The coefficients of the first half, by de Casteljau's construction; the second half takes the place of
    the whole."""
    half = [coefficients[0]]
    for r in range(1, len(coefficients)):
        for k in range(len(coefficients) - r):
            coefficients[k] = 0.5 * (coefficients[k] + coefficients[k + 1])
        half.append(coefficients[0])
    return half


def halves(part: Part) -> tuple[Part, Part]:
    """The first and the second half of a part, whose lists become those of the second."""
    middle = part.begin + 0.5 * (part.end - part.begin)
    above, below = first_half(part.above), first_half(part.below)
    return Part(part.begin, middle, above, below), Part(middle, part.end, part.above, part.below)
