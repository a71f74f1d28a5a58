"""How far points are from a curve in pieces, many points at a time, and where it is closest to one."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse
from workbench.geometry.curves.derivatives import local_derivatives
from workbench.geometry.curves.halving import lengths, product
from workbench.geometry.curves.pieces import Pieces, with_length
from workbench.geometry.curves.polynomials import derivative_numerator
from workbench.geometry.curves.roots import roots

Array = NDArray[np.float64]

_AT_ONCE = 2**19


def distances(pieces: Pieces, points: ArrayLike) -> Array:
    """The distance of each point (n, k) from the curve (n,), to about 1e-10 of the size of both.

    A point is looked at beside the pieces whose box is closer than the closest end of a piece, there at the
    ends and where the curve runs across the line to it. Raises: ValueError for points that are not finite.
    """
    refuse(faults(points, least=1))
    asked, kept = np.asarray(points, float), with_length(pieces)
    step = max(_AT_ONCE // len(kept.controls), 1)
    return np.concatenate([_some(kept, asked[k : k + step]) for k in range(0, len(asked), step)])


def closest_place(pieces: Pieces, point: ArrayLike) -> tuple[float, float]:
    """The parameter u at which the curve is closest to one point (k,), and the distance, as ``distances``."""
    asked = np.asarray(point, float)[None]
    refuse(faults(asked, least=1))
    kept = with_length(pieces)
    begin, end = (lengths(kept.controls[:, side] - asked) for side in (0, -1))
    places = [(kept.knots[:-1], begin), (kept.knots[1:], end)]
    _row, piece, v, away = _valleys(kept, asked, np.minimum(begin, end).min(keepdims=True))
    places.append((kept.u_at(piece, v), away))
    us, gaps = (np.concatenate(column) for column in zip(*places, strict=True))
    nearest = int(gaps.argmin())
    return float(us[nearest]), float(gaps[nearest])


def _some(pieces: Pieces, points: Array) -> Array:
    """The distances (n,) of so few points that each can be compared with the box of every piece."""
    ends = np.concatenate([pieces.controls[:, 0], pieces.controls[:, -1]])
    best: Array = np.sqrt(_squares(points, ends, ends).min(axis=1))
    row, _piece, _v, away = _valleys(pieces, points, best)
    np.minimum.at(best, row, away)
    return best


def _valleys(
    pieces: Pieces, points: Array, best: Array
) -> tuple[NDArray[np.intp], NDArray[np.intp], Array, Array]:
    """Where the curve runs across the line to a point, unless that is surely farther than its ``best`` (n,),
    and what lowered that one: rows of points, pieces, v within these, and how far (r,)."""
    _knots, controls, weights = pieces
    beside = _squares(points, controls.min(axis=1), controls.max(axis=1))
    row, piece = np.nonzero(beside < (best * best)[:, None])
    nearest = []
    # Three points of each of these pieces leave few of them, and the least coefficient of the distance fewer
    for part in (0.5, 0.25, 0.75):
        some, at = np.unique(piece, return_inverse=True)
        own = None if weights is None else weights[some]
        middle = local_derivatives(controls[some], own, np.full(len(some), part), 0)[0]
        away = lengths(middle[at] - points[row])
        lower = away < best[row]
        np.minimum.at(best, row, away)
        nearest.append((row[lower], piece[lower], np.full(lower.sum(), part), away[lower]))
        near = beside[row, piece] < best[row] ** 2
        row, piece = row[near], piece[near]
    pulls = None if weights is None else weights[piece]
    near = _least_squares(controls[piece] - points[row, None], pulls) < best[row] ** 2
    row, piece, pulls = row[near], piece[near], None if pulls is None else pulls[near]
    crossed, v = _across(controls[piece] - points[row, None], pulls)
    own = None if pulls is None else pulls[crossed]
    places = local_derivatives(controls[piece[crossed]], own, v, 0)[0]
    nearest.append((row[crossed], piece[crossed], v, lengths(places - points[row[crossed]])))
    rows, in_pieces, at_v, gaps = (np.concatenate(column) for column in zip(*nearest, strict=True))
    return rows, in_pieces, at_v, gaps


def _least_squares(controls: Array, weights: Array | None) -> Array:
    """What the squared distance of each piece (m, n+1, k) from the origin is nowhere less than (m,)."""
    if weights is None:
        plain: Array = product(controls, controls).sum(axis=-1).min(axis=1)
        return plain
    above = product(controls * weights[..., None], controls * weights[..., None]).sum(axis=-1)
    least: Array = (above / product(weights[..., None], weights[..., None])[..., 0]).min(axis=1)
    return least


def _squares(points: Array, low: Array, high: Array) -> Array:
    """The squared distance of each point (n, k) from each box (m, k): (n, m)."""
    total: Array = np.zeros((len(points), len(low)))
    for axis in range(points.shape[1]):
        at = points[:, axis, None]
        outside = np.maximum(np.maximum(low[:, axis] - at, at - high[:, axis]), 0.0)
        total += outside * outside
    return total


def _across(controls: Array, weights: Array | None) -> tuple[NDArray[np.intp], Array]:
    """Rows (r,) and v (r,) at which pieces (m, n+1, k) run across the line from the origin to them."""
    tops, sizes = (np.moveaxis(part, -1, 1) for part in derivative_numerator(controls, weights))
    lifted = controls if weights is None else controls * weights[..., None]
    slopes = product(lifted, tops).sum(axis=-1)
    return roots(slopes, product(np.abs(lifted), sizes).sum(axis=-1))
