"""Where plane curves in pieces change the side to which they bend.

Source: Farin, Curves and Surfaces for CAGD, chapter 10; Manocha and Canny, Detecting cusps and inflection
points in curves, 1992.
"""

import math

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.derivatives import local_derivatives
from workbench.geometry.curves.extrema import meets_itself
from workbench.geometry.curves.pieces import Pieces, with_length
from workbench.geometry.curves.polynomials import binomials, wronskian
from workbench.geometry.curves.roots import sign_changes

Array = NDArray[np.float64]

_SMOOTH = 1e-6


def inflections(pieces: Pieces) -> Array:
    """The u (n,) at which the curvature changes its sign, also where two pieces join without a corner.

    After a straight part that lies between, it is where the new bend begins.
    """
    kept = with_length(pieces)
    if kept.degree < 2:
        return np.empty(0)
    rows, v = sign_changes(*bend_polynomial(kept), closed=meets_itself(kept))
    at_joint = v == 0.0
    smooth = np.ones(len(rows), bool)
    smooth[at_joint] = _without_corner(kept, rows[at_joint])
    rows, v = rows[smooth], v[smooth]
    return kept.u_at(rows, v)


def bend_polynomial(pieces: Pieces) -> tuple[Array, Array]:
    """Polynomials (m, q+1) with the sign of the curvature of pieces of degree 2 or more; and the sizes of the
    numbers that they were made of."""
    return _of_plain(pieces) if pieces.weights is None else _of_rational(pieces)


def _without_corner(pieces: Pieces, rows: NDArray[np.intp]) -> NDArray[np.bool_]:
    """Whether the curve goes on in its direction where these pieces (r,) begin."""
    weights = pieces.weights
    pulls = (None, None) if weights is None else (weights[rows - 1], weights[rows])
    arriving = local_derivatives(pieces.controls[rows - 1], pulls[0], np.ones(len(rows)), 1)[1]
    leaving = local_derivatives(pieces.controls[rows], pulls[1], np.zeros(len(rows)), 1)[1]
    turn = arriving[:, 0] * leaving[:, 1] - arriving[:, 1] * leaving[:, 0]
    smooth: NDArray[np.bool_] = np.abs(turn) <= _SMOOTH * (arriving * leaving).sum(axis=1)
    return smooth


def _of_plain(pieces: Pieces) -> tuple[Array, Array]:
    """A polynomial (m, q+1) with the sign of the curvature: C' x C''; and the sizes it was made of."""
    legs = np.moveaxis(np.diff(pieces.controls, axis=1), 1, 0)
    large = np.abs(pieces.controls).max(axis=(1, 2))
    sizes = np.abs(legs).max(axis=2)
    crossed = wronskian(pieces.degree - 1, lambda i, j: _cross(legs[i], legs[j]))
    return crossed, wronskian(pieces.degree - 1, lambda i, j: large * (sizes[i] + sizes[j]))


def _of_rational(pieces: Pieces) -> tuple[Array, Array]:
    """The same for rational pieces: the determinant of (w x, w y, w) and its two derivatives.

    It is a sum over triangles of control points with factors above 0, of degree 3 n - 6.
    """
    degree, controls = pieces.degree, np.moveaxis(pieces.controls, 1, 0)
    assert pieces.weights is not None
    pulls, large = pieces.weights.T, np.abs(pieces.controls).max(axis=(1, 2))
    above, below = binomials(degree), binomials(3 * degree - 6)
    bends = np.zeros((len(pieces.controls), 3 * degree - 5))
    sizes = np.zeros_like(bends)
    for i in range(degree + 1):
        for j in range(i + 1, degree + 1):
            leg = controls[j] - controls[i]
            for k in range(j + 1, degree + 1):
                at = i + j + k - 3
                apart = (j - i) * (k - i) * (k - j) / below[at]
                share = apart * math.prod(above[[i, j, k]].tolist()) * pulls[i] * pulls[j] * pulls[k]
                other = controls[k] - controls[i]
                bends[:, at] += share * _cross(leg, other)
                sizes[:, at] += share * large * (np.abs(leg) + np.abs(other)).max(axis=1)
    return bends, sizes


def _cross(one: Array, other: Array) -> Array:
    """The cross product of vectors (m, 2)."""
    cross: Array = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    return cross
