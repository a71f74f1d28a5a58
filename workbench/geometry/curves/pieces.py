"""A curve in Bézier pieces: what every spline here can be turned into."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.bernstein import bernstein

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

    def u_at(self, number: int | NDArray[np.intp], v: ArrayLike) -> Array:
        """The parameters u (...,) of the pieces of these numbers at v, from 0 to 1 in each."""
        begin = self.knots[number]
        return np.asarray(begin + np.asarray(v, float) * (self.knots[number + 1] - begin))


def located(knots: Array, u: ArrayLike) -> tuple[NDArray[np.intp], Array, Array]:
    """For each u (...,) the number of its piece, where it is in it, from 0 to 1, and how long the piece is.

    Piece j lies from knot j to knot j + 1. Before the first knot and after the last the outer pieces go on; a
    piece without length is passed over, and if none has a length, it is taken to be 1.
    """
    where = np.asarray(u, float)
    first = np.searchsorted(knots, knots[0], side="right") - 1
    last = max(np.searchsorted(knots, knots[-1], side="left") - 1, 0)
    number = np.clip(np.searchsorted(knots, where, side="right") - 1, first, last)
    length = knots[number + 1] - knots[number]
    length = np.where(length > 0, length, 1.0)
    return number, (where - knots[number]) / length, length


def piece_points(pieces: Pieces, u: ArrayLike) -> Array:
    """The points of the curve at each u (...,): (..., k). Before its begin and after its end the outer pieces
    go on; a piece without length is passed over."""
    number, v, _length = located(pieces.knots, u)
    return points_within(pieces, number, v)


def points_within(pieces: Pieces, number: NDArray[np.intp], v: Array) -> Array:
    """The points (..., k) of the pieces of these numbers (...,) at v, from 0 to 1 in each."""
    basis = bernstein(pieces.degree, v)
    if pieces.weights is not None:
        pulls = basis * pieces.weights[number]
        basis = pulls / pulls.sum(axis=-1, keepdims=True)
    there: Array = np.einsum("...i,...ik->...k", basis, pieces.controls[number])
    return there


def with_length(pieces: Pieces) -> Pieces:
    """The pieces that the parameter comes to: those with a length; the curve is the same.

    If there are none, one piece of length 1 that stays where the curve is.
    """
    long = np.diff(pieces.knots) > 0
    if long.all():
        return pieces
    knots, controls, weights = pieces
    if not long.any():
        return Pieces(knots[0] + np.array([0.0, 1.0]), np.repeat(controls[:1, :1], controls.shape[1], axis=1))
    kept = np.append(knots[:-1][long], knots[-1])
    return Pieces(kept, controls[long], None if weights is None else weights[long])


def is_parted(pieces: Pieces) -> NDArray[np.bool_]:
    """After which pieces (m,) the curve does not go on where it is: the last, and those before a gap."""
    last = pieces.controls[:, -1]
    return np.append((last[:-1] != pieces.controls[1:, 0]).any(axis=1), True)


def with_ends(pieces: Pieces, corners: Array, ends: NDArray[np.int64], parted: NDArray[np.bool_]) -> Array:
    """The corners (n, k), those of piece j before number ``ends`` (m,), with the end of each piece put in
    after which the curve is ``parted`` (m,)."""
    return np.insert(corners, ends[parted], pieces.controls[parted, -1], axis=0)


def in_rows(pieces: Pieces) -> tuple[Array, Array, Array, int]:
    """Knots, control points (m (degree + 1), k) and weights, piece after piece, and the degree: what a text
    takes that is stepped and compiled."""
    controls = pieces.controls.reshape(-1, pieces.controls.shape[2])
    weights = np.ones(len(controls)) if pieces.weights is None else pieces.weights.ravel()
    return pieces.knots, controls, weights, pieces.degree
