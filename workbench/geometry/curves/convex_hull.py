"""The convex hull of points in the plane, with the right corners whatever the numbers.

Source: Andrew, Another efficient algorithm for convex hulls in two dimensions, 1979.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse
from workbench.geometry.orientation import side_of

Array = NDArray[np.float64]
Point = tuple[float, float]


def convex_hull(points: ArrayLike) -> Array:
    """The corners (m, 2) of the hull of points (n, 2), counter-clockwise from the leftmost (the lowest such).

    Each is one of the points, and none lies on a line between others: two corners for points on one line, one
    for points in one place. Raises: ValueError for no points, or numbers that are not finite.
    """
    refuse(faults(points, least=1))
    ordered: list[Point] = [(x, y) for x, y in np.unique(np.asarray(points, float), axis=0).tolist()]
    if len(ordered) < 3:
        return np.array(ordered)
    lower, upper = _chain(ordered), _chain(ordered[::-1])
    return np.array(lower[:-1] + upper[:-1])


def _chain(ordered: list[Point]) -> list[Point]:
    """The corners that turn left, from the first of the points to the last."""
    chain: list[Point] = []
    for point in ordered:
        while len(chain) > 1 and side_of(*chain[-2], *chain[-1], *point) >= 0.0:
            chain.pop()
        chain.append(point)
    return chain
