"""A curve in Bézier pieces: what every spline here can be turned into."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.algorithms.curves.bernstein import bernstein

Array = NDArray[np.float64]


class Pieces(NamedTuple):
    """A piecewise Bézier curve.

    ``knots`` (m+1,) ascending: piece j lies from knot j to knot j + 1 of the parameter. ``controls``
    (m, degree + 1, k): its control points; ``weights`` (m, degree + 1) those of rational pieces.
    """

    knots: Array
    controls: Array
    weights: Array | None = None

    @property
    def degree(self) -> int:
        """The degree of every piece."""
        return int(self.controls.shape[1]) - 1


def piece_points(pieces: Pieces, u: ArrayLike) -> Array:
    """The points of the curve at each u (...,): (..., k). Before its begin and after its end the outer pieces
    go on; a piece without length is passed over."""
    where = np.asarray(u, float)
    knots, controls, weights = pieces
    last = int(np.searchsorted(knots, knots[-1], side="left")) - 1
    number = np.clip(np.searchsorted(knots, where, side="right") - 1, 0, max(last, 0))
    length = knots[number + 1] - knots[number]
    v = (where - knots[number]) / np.where(length > 0, length, 1.0)
    basis = bernstein(pieces.degree, v)
    if weights is not None:
        pulls = basis * weights[number]
        basis = pulls / pulls.sum(axis=-1, keepdims=True)
    found: Array = (basis[..., None] * controls[number]).sum(axis=-2)
    return found


def piece_derivative(pieces: Pieces) -> Pieces:
    """The derivative by the parameter, one degree lower; 0 on a piece without length."""
    length = np.diff(pieces.knots)[:, None, None]
    legs = np.diff(pieces.controls, axis=1)
    per_length = np.divide(pieces.degree, length, out=np.zeros_like(length), where=length > 0)
    return Pieces(pieces.knots, per_length * legs)
