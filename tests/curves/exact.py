"""Curves in fractions: what their evaluation is held against. Every float is a fraction, so this is exact."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import comb
from typing import Any

import numpy as np
from numpy.typing import NDArray


def fractions(values: Any) -> list[Any]:
    """Numbers, or rows of them, as fractions."""
    return [fractions(v) if isinstance(v, (list, tuple, np.ndarray)) else Fraction(float(v)) for v in values]


def bezier(points: NDArray[Any], u: float) -> list[Fraction]:
    """A Bézier point as the sum over the Bernstein polynomials, by their closed formula."""
    v, n = Fraction(u), len(points) - 1
    parts = [comb(n, i) * v**i * (1 - v) ** (n - i) for i in range(n + 1)]
    return _sum(parts, fractions(points))


def all_basis(knots: NDArray[Any], degree: int, u: float) -> list[Fraction]:
    """Every basis function at u by the recursion, where 0 / 0 is 0; at the end of the curve from the left."""
    t, where = fractions(knots), Fraction(u)
    last = t[len(t) - degree - 1]

    def holds(left: Fraction, right: Fraction) -> bool:
        return left < where <= right if where == last else left <= where < right

    values = [Fraction(holds(left, right)) for left, right in pairwise(t)]
    for p in range(1, degree + 1):
        for i in range(len(values) - 1):
            left, right = t[i + p] - t[i], t[i + p + 1] - t[i + 1]
            up = (where - t[i]) / left * values[i] if left else 0
            down = (t[i + p + 1] - where) / right * values[i + 1] if right else 0
            values[i] = Fraction(up + down)
        values.pop()
    return values


def b_spline(points: NDArray[Any], knots: NDArray[Any], degree: int, u: float) -> list[Fraction]:
    """A B-spline point."""
    return _sum(all_basis(knots, degree, u), fractions(points))


def nurbs(
    points: NDArray[Any], weights: NDArray[Any], knots: NDArray[Any], degree: int, u: float
) -> list[Fraction]:
    """A point of a rational B-spline."""
    parts = [n * w for n, w in zip(all_basis(knots, degree, u), fractions(weights), strict=True)]
    return [value / sum(parts) for value in _sum(parts, fractions(points))]


def _sum(parts: Sequence[Fraction], points: Sequence[Sequence[Fraction]]) -> list[Fraction]:
    rows = zip(*points, strict=True)
    return [sum((p * x for p, x in zip(parts, row, strict=True)), Fraction(0)) for row in rows]


def close(found: Any, exact: Sequence[Fraction], size: float) -> None:
    """Assert that ``found`` is finite and within 1e-12 of ``size``, the largest coordinate, of the truth."""
    for value, truth in zip(np.asarray(found, float).tolist(), exact, strict=True):
        assert abs(Fraction(value) - truth) <= Fraction(max(size, 1e-300)) / 10**12


def size_of(points: Any) -> float:
    """The largest coordinate."""
    return float(np.abs(points).max())
