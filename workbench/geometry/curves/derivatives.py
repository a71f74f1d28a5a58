"""Derivatives of curves in pieces, of rational ones too, and the hodograph: the derivative as a curve.

Source: Piegl and Tiller, The NURBS Book, sections 2.3 and 4.3; Farin, Curves and Surfaces for CAGD.
"""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.bernstein import bernstein
from workbench.geometry.curves.halving import product
from workbench.geometry.curves.pieces import Pieces, located
from workbench.geometry.curves.polynomials import derivative_numerator

Array = NDArray[np.float64]


def derivatives(pieces: Pieces, u: ArrayLike, order: int = 1) -> Array:
    """The points and the derivatives by u, up to ``order``, at each u (...,): (order + 1, ..., k).

    At a knot those of the piece to its right, at the end those of the last piece.
    Raises: ValueError for a negative order.
    """
    if order < 0:
        raise ValueError(f"The order is {order}; it must be 0 or more.")
    number, v, length = located(pieces.knots, u)
    by_order = derivatives_within(pieces, number, v, order)
    powers: Array = length ** np.arange(order + 1).reshape(-1, *[1] * length.ndim)
    return by_order / powers[..., None]


def derivatives_within(pieces: Pieces, number: NDArray[np.intp], v: Array, order: int) -> Array:
    """As ``derivatives``, by v from 0 to 1 in the pieces of these numbers (...,)."""
    weights = None if pieces.weights is None else pieces.weights[number]
    return local_derivatives(pieces.controls[number], weights, v, order)


def local_derivatives(controls: Array, weights: Array | None, v: ArrayLike, order: int) -> Array:
    """As ``derivatives``, by v from 0 to 1 in a piece: controls (..., n+1, k) and weights (..., n+1) for each
    v (...,), whose leading axes need only fit together.

    A rational piece is measured from its point that pulls most, and then from the point of the curve, so that
    not even weights of 1e-9 and 1e9 take more than rounding from what is left.
    """
    where = np.asarray(v, float)
    degree = controls.shape[-2] - 1
    if weights is None:
        return _polynomial(controls, where, order)
    pulls = bernstein(degree, where) * weights
    most = np.abs(pulls).argmax(axis=-1)[..., None, None]
    controls = np.broadcast_to(controls, (*pulls.shape, controls.shape[-1]))
    heavy = np.take_along_axis(controls, most, axis=-2)
    offsets = controls - heavy
    to_curve = np.einsum("...i,...ik->...k", pulls, offsets) / pulls.sum(axis=-1)[..., None]
    lifted = (offsets - to_curve[..., None, :]) * weights[..., None]
    whole = _polynomial(
        np.concatenate([lifted, np.broadcast_to(weights, pulls.shape)[..., None]], -1), where, order
    )
    by_order = np.zeros((order + 1, *to_curve.shape))
    weight = whole[..., -1:]
    for r in range(1, order + 1):
        rest = whole[r, ..., :-1]
        for i in range(1, r):
            rest = rest - math.comb(r, i) * weight[i] * by_order[r - i]
        by_order[r] = rest / weight[0]
    by_order[0] = heavy[..., 0, :] + to_curve
    return by_order


def _polynomial(controls: Array, v: Array, order: int) -> Array:
    """The derivatives by v of plain Bézier curves."""
    degree = controls.shape[-2] - 1
    shape = (*np.broadcast_shapes(controls.shape[:-2], v.shape), controls.shape[-1])
    by_order = np.zeros((order + 1, *shape))
    for r in range(min(order, degree) + 1):
        by_order[r] = np.einsum("...i,...ik->...k", bernstein(degree - r, v), controls)
        controls = (degree - r) * np.diff(controls, axis=-2)
    return by_order


def piece_derivative(pieces: Pieces) -> Pieces:
    """The hodograph: the derivative by the parameter, exact but for rounding; 0 on a piece without length.

    Of plain pieces it is one degree lower, of rational ones rational with twice the degree.
    """
    length = np.diff(pieces.knots)[:, None, None]
    per_length = np.divide(1.0, length, out=np.zeros_like(length), where=length > 0)
    top, _sizes = derivative_numerator(pieces.controls, pieces.weights)
    if pieces.weights is None:
        return Pieces(pieces.knots, per_length * np.moveaxis(top, -1, 1))
    below = product(pieces.weights[..., None], pieces.weights[..., None])
    raised = product(np.moveaxis(top, -1, 1), np.ones((1, 3, 1)))
    return Pieces(pieces.knots, per_length * raised / below, below[..., 0])
