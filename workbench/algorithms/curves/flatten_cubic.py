"""A cubic Bézier curve as a chain of straight lines, from plain numbers, so that many are one table."""

from collections.abc import Iterator

import numpy as np

from workbench.algorithms.curves.flatten_bezier import flatten_bezier


def flatten_cubic(
    x0: float,
    y0: float,
    x1: float,
    y1: float,
    x2: float,
    y2: float,
    x3: float,
    y3: float,
    tolerance: float,
) -> Iterator[tuple[float, float]]:
    """``flatten_bezier`` for the cubic curve with these four control points.

    Emits: (x, y) of the corners of the chain, both ends of the curve included. Raises: ValueError.
    """
    yield from flatten_bezier(np.array([[x0, y0], [x1, y1], [x2, y2], [x3, y3]]), tolerance)
