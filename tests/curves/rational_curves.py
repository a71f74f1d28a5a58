"""Generated curves in pieces, and their derivatives in fractions by the quotient rule."""

from fractions import Fraction
from itertools import pairwise
from math import comb
from typing import Any

import numpy as np
from hypothesis import strategies as st

from tests.curves.exact import fractions
from tests.curves.made_curves import Array, point_lists, weight
from workbench.algorithms.curves import (
    Pieces,
    b_spline_to_bezier,
    circle,
    homogeneous,
    piece_points,
    projected,
)


def whole_circle() -> Pieces:
    """Four quarters of degree 2 around (1, 2), radius 3."""
    points, weights, knots, degree = circle(1, 2, 3)
    whole = b_spline_to_bezier(homogeneous(points, weights), knots, degree)
    return Pieces(whole.knots, *projected(whole.controls))


@st.composite
def pieces_of_any_kind(
    draw: st.DrawFn, most: int = 4, degrees: tuple[int, int] = (1, 5), rational: bool | None = None
) -> Pieces:
    """Pieces that need not join, some without length in the parameter, plain or with weights."""
    count, degree = draw(st.integers(1, most)), draw(st.integers(*degrees))
    controls = np.array([draw(point_lists(degree + 1, degree + 1)) for _ in range(count)])
    lengths = draw(st.lists(st.sampled_from([0.0, 0.5, 1.0, 3.0]), min_size=count, max_size=count))
    lengths[draw(st.integers(0, count - 1))] = 1.0
    weights = None
    if draw(st.booleans()) if rational is None else rational:
        rows = st.lists(weight, min_size=degree + 1, max_size=degree + 1)
        weights = np.array([draw(rows) for _ in range(count)])
    return Pieces(np.append(0.0, np.cumsum(lengths)), controls, weights)


def exact_derivatives(points: Any, weights: Any, v: float, order: int) -> list[list[Fraction]]:
    """The derivatives by v of one rational Bézier curve: the quotient rule on (w x, w y) / w."""
    xs, pulls = fractions(points), fractions(weights)
    lifted = [[w * x for x in row] + [w] for row, w in zip(xs, pulls, strict=True)]
    above = []
    for _order in range(order + 1):
        degree, where = len(lifted) - 1, Fraction(v)
        parts = [comb(degree, i) * where**i * (1 - where) ** (degree - i) for i in range(degree + 1)]
        above.append(
            [
                sum((p * row[c] for p, row in zip(parts, lifted, strict=True)), Fraction(0))
                for c in range(len(lifted[0]))
            ]
        )
        lifted = [
            [degree * (b - a) for a, b in zip(one, other, strict=True)] for one, other in pairwise(lifted)
        ] or [[Fraction(0)] * len(above[0])]
    found: list[list[Fraction]] = []
    for r in range(order + 1):
        found.append(
            [
                (
                    above[r][c]
                    - sum((comb(r, i) * above[i][-1] * found[r - i][c] for i in range(1, r + 1)), Fraction(0))
                )
                / above[0][-1]
                for c in range(len(above[0]) - 1)
            ]
        )
    return found


def dense_points(pieces: Pieces, count: int = 2000) -> Array:
    """Points of the curve at even steps and crowded towards the ends of each piece."""
    v = np.concatenate([np.linspace(0, 1, count), np.logspace(-12, -1, 200), 1 - np.logspace(-12, -1, 200)])
    lengths = np.diff(pieces.knots)
    kept = lengths > 0
    u = pieces.knots[:-1][kept, None] + v[v < 1] * lengths[kept, None]
    return piece_points(pieces, u.ravel())
