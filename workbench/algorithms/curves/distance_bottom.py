"""Where along part of a Bézier piece the distance from a point stops falling."""

import math
from typing import Any

from numpy.typing import NDArray


def place_and_leg(
    points: NDArray[Any], weights: NDArray[Any], first: int, v: float, level: NDArray[Any]
) -> tuple[float, float, float, float]:
    """The point at v of the piece that begins at ``first``, and the last leg of de Casteljau's construction.

    The leg has the direction of the tangent. ``level`` (degree + 1, 3) is room for homogeneous points.
    """
    degree = len(level) - 1
    for i in range(degree + 1):
        w = float(weights[first + i])
        level[i, 0] = w * float(points[first + i, 0])
        level[i, 1] = w * float(points[first + i, 1])
        level[i, 2] = w
    for r in range(1, degree):
        for i in range(degree + 1 - r):
            for k in range(3):
                level[i, k] = (1.0 - v) * level[i, k] + v * level[i + 1, k]
    w0, w1 = float(level[0, 2]), float(level[1, 2])
    x0, y0 = float(level[0, 0]) / w0, float(level[0, 1]) / w0
    x1, y1 = float(level[1, 0]) / w1, float(level[1, 1]) / w1
    share = v * w1 / ((1.0 - v) * w0 + v * w1)
    return x0 + share * (x1 - x0), y0 + share * (y1 - y0), x1 - x0, y1 - y0


def bottom(
    points: NDArray[Any],
    weights: NDArray[Any],
    first: int,
    x: float,
    y: float,
    low: float,
    high: float,
    level: NDArray[Any],
) -> tuple[float, float, float, float]:
    """Where from low to high in a piece the distance from (x, y) stops falling, by false position.

    Returns v, the point there and its distance: the closest of all that were looked at.
    """
    best_v, best_x, best_y, least = low, 0.0, 0.0, math.inf
    fall, rise = 0.0, 0.0
    for turn in range(160):
        v = 0.5 * (low + high)
        if turn < 2:
            v = low if turn == 0 else high
        elif rise > fall and (turn < 18 or turn % 2 == 0):
            guess = high - rise * (high - low) / (rise - fall)
            v = guess if low < guess < high else v
        at_x, at_y, dx, dy = place_and_leg(points, weights, first, v, level)
        if turn > 1 and dx == 0.0 and dy == 0.0:
            # Where the curve stands still, the slope says nothing; a little further on it does
            v += 1e-6 * (high - v)
            at_x, at_y, dx, dy = place_and_leg(points, weights, first, v, level)
        dx_to, dy_to = at_x - x, at_y - y
        squared = dx_to * dx_to + dy_to * dy_to
        if squared < least:
            best_v, best_x, best_y, least = v, at_x, at_y, squared
        slope = dx_to * dx + dy_to * dy
        # At an end the slope may be so small that its sign is that of a rounding error
        if turn == 0:
            fall = min(slope, 0.0)
        elif turn == 1:
            rise = max(slope, 0.0)
        elif slope < 0.0:
            low, fall, rise = v, slope, 0.5 * rise
        else:
            high, rise, fall = v, slope, 0.5 * fall
        done = slope == 0.0 or (v in (low, high) and not low < 0.5 * (low + high) < high)
        if high - low < 1e-16 or (turn > 1 and done):
            break
    return best_v, best_x, best_y, math.sqrt(least)


def closest_end(
    knots: NDArray[Any], points: NDArray[Any], degree: int, x: float, y: float
) -> tuple[float, float, float, float]:
    """The end of a piece that is closest to (x, y): its u, its place and its distance."""
    row, number = 0, 0
    best = math.inf
    for j in range(len(knots) - 1):
        if knots[j + 1] > knots[j] or knots[0] == knots[len(knots) - 1]:
            for side in range(2):
                end = j * (degree + 1) + side * degree
                dx, dy = float(points[end, 0]) - x, float(points[end, 1]) - y
                distance = math.sqrt(dx * dx + dy * dy)
                if distance < best:
                    row, number, best = end, j + side, distance
    return float(knots[number]), float(points[row, 0]), float(points[row, 1]), best
