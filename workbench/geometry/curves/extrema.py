"""How far a curve reaches: its bounding box, and the places where a coordinate turns back."""

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.derivatives import local_derivatives
from workbench.geometry.curves.halving import evening
from workbench.geometry.curves.pieces import Pieces, piece_points, with_length
from workbench.geometry.curves.polynomials import derivative_numerator
from workbench.geometry.curves.roots import roots, sign_changes

Array = NDArray[np.float64]


def bounding_box(pieces: Pieces) -> tuple[Array, Array]:
    """The lowest and the highest coordinates (k,) of the curve: those of its extrema and its ends."""
    low, high = piece_boxes(pieces)
    return low.min(axis=0), high.max(axis=0)


def piece_boxes(pieces: Pieces) -> tuple[Array, Array]:
    """The lowest and the highest coordinates (m, k) of each piece with a length."""
    _knots, controls, weights = with_length(pieces)
    ends = controls[:, [0, -1]]
    low, high = ends.min(axis=1), ends.max(axis=1)
    # A piece whose control points all lie in the box of its ends cannot leave it
    beyond = np.flatnonzero(((controls < low[:, None]) | (controls > high[:, None])).any(axis=(1, 2)))
    # Balanced, a piece reaches as far, and its extrema are not crowded where no u tells them apart
    pulls = None if weights is None else weights[beyond] * evening(weights[beyond])
    tops, sizes = derivative_numerator(controls[beyond], pulls)
    for axis in range(controls.shape[2]):
        rows, v = roots(tops[:, axis], sizes[:, axis])
        own = None if pulls is None else pulls[rows]
        reached = local_derivatives(controls[beyond[rows]], own, v, 0)[0, :, axis]
        np.minimum.at(low[:, axis], beyond[rows], reached)
        np.maximum.at(high[:, axis], beyond[rows], reached)
    return low, high


def extrema(pieces: Pieces) -> list[tuple[float, int, Array]]:
    """Every place where a coordinate changes from growing to falling or back: u, the axis, the point (k,).

    Corners between pieces count too, and so do both ends where a curve that ends where it began turns there.
    """
    kept = with_length(pieces)
    turning = []
    for axis, u in enumerate(_turns(kept)):
        turning += [(float(at), axis, point) for at, point in zip(u, piece_points(kept, u), strict=True)]
    return sorted(turning, key=lambda turn: turn[:2])


def meets_itself(pieces: Pieces) -> bool:
    """Whether the curve ends where it began, but for rounding."""
    begin, end = pieces.controls[0, 0], pieces.controls[-1, -1]
    return bool(np.abs(end - begin).max() <= 2.0**-44 * np.abs(pieces.controls).max())


def _turns(pieces: Pieces) -> list[Array]:
    """For each axis the u (n,) of its extrema."""
    tops, sizes = derivative_numerator(pieces.controls, pieces.weights)
    closed = meets_itself(pieces)
    turning = [sign_changes(tops[:, axis], sizes[:, axis], closed) for axis in range(tops.shape[1])]
    return [pieces.u_at(rows, v) for rows, v in turning]
