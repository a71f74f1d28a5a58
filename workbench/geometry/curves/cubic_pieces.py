"""Any curve as cubic Bézier pieces: exactly where it is one already, else within a tolerance.

A piece of another kind gets the cubic with the same ends and end derivatives (of a conic: the cubic that also
touches its middle), and is halved until that is near enough. The error is proved, not sampled: curve and
cubic differ by a rational curve whose control points can be written down, and no point of a curve is farther
out than its farthest control point.
Source: Farin, Curves and Surfaces for CAGD, sections 6.5 (the hull) and 13.7 (rational derivatives).
"""

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.conic_cubics import conic_cubics
from workbench.geometry.curves.halving import halved_until_near, lengths, product
from workbench.geometry.curves.pieces import Pieces
from workbench.geometry.curves.refusals import refuse_tolerance

Array = NDArray[np.float64]


def to_cubic_pieces(pieces: Pieces, tolerance: float) -> tuple[Pieces, float]:
    """Cubic pieces nowhere farther than ``tolerance`` from the curve, and how far they are at most.

    Plain curves up to degree 3 are the same curve, error 0, at every u. Of others the knots stay, the
    points there and the directions; between two knots the way in u may differ. The error exceeds the
    tolerance only where that is below 1e-13 of the curve's size, or more than 50,000 parts wait to be halved.
    Raises: ValueError for a tolerance that is not above 0, or points that are not finite.
    """
    refuse_tolerance(tolerance)
    if not np.isfinite(pieces.controls).all():
        raise ValueError("A control point is not finite; give it numbers.")
    if pieces.weights is None and pieces.degree <= 3:
        return Pieces(pieces.knots, raised_to_cubic(pieces.controls)), 0.0
    starts, controls, errors = halved_until_near(pieces, tolerance, _nearest_cubics)
    number = starts.astype(np.intp)
    begins = pieces.u_at(number, starts - number)
    return Pieces(np.append(begins, pieces.knots[-1]), controls), float(errors.max())


def raised_to_cubic(controls: Array) -> Array:
    """Plain pieces (m, degree + 1, k), degree at most 3, as cubic ones (m, 4, k)."""
    while controls.shape[1] < 4:
        controls = product(controls, np.ones((len(controls), 2, 1)))
    return controls


def _nearest_cubics(whole: Array) -> tuple[Array, Array]:
    """The cubics (m, 4, k) of balanced pieces (m, n+1, k+1), and how far (m,) they are off at most."""
    cubics = _hermite_cubics(whole)
    off = _bounds(whole, cubics)
    if whole.shape[1] != 3:
        return cubics, off
    touching, away = conic_cubics(whole)
    better = away < off
    return np.where(better[:, None, None], touching, cubics), np.where(better, away, off)


def _hermite_cubics(whole: Array) -> Array:
    """The cubics (m, 4, k) with the ends and end derivatives of balanced pieces (m, n+1, k+1)."""
    points, weights = whole[..., :-1] / whole[..., -1:], whole[..., -1:]
    third = (whole.shape[1] - 1) / 3.0
    first, last = points[:, 0], points[:, -1]
    leaving = third * weights[:, 1] / weights[:, 0] * (points[:, 1] - first)
    arriving = third * weights[:, -2] / weights[:, -1] * (last - points[:, -2])
    return np.stack([first, first + leaving, last - arriving, last], axis=1)


def _bounds(whole: Array, cubics: Array) -> Array:
    """How far at most (m,) each cubic is from its piece.

    N / W - C = (N - C W) / W: with both in Bernstein form of one degree, a mean of their quotients.
    """
    points, weights = whole[..., :-1], whole[..., -1:]
    flat = np.ones((len(whole), 4, 1))
    apart = product(points, flat) - product(cubics, weights)
    errors: Array = lengths(apart / product(weights, flat)).max(axis=1)
    return errors
