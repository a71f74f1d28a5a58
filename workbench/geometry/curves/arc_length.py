"""Lengths along curves in pieces.

A part is halved until its length by 16 points of Gauss and Legendre agrees with that of its halves, and
neither of these stops or turns back: beside a cusp the points may all lie on one side.
Source: Guenter and Parent, Computing the arc length of parametric curves, 1990.
"""

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.bernstein import bernstein, subdivide
from workbench.geometry.curves.halving import balanced, halves, lifted
from workbench.geometry.curves.pieces import Pieces, located, with_length
from workbench.geometry.curves.polynomials import derivative_numerator
from workbench.geometry.curves.rational import projected

Array = NDArray[np.float64]

_MEASURED = 2.5e-10
_DEEPEST = 40
_SLOWEST = 0.05
_MOST = 2**18
WHOLE = np.ones(1)


class Parts(NamedTuple):
    """Parts (r, ...) of a curve that Gauss and Legendre's points measure: homogeneous, balanced ``controls``;
    ``low`` and ``width`` say where in its piece a part is."""

    piece: NDArray[np.intp]
    low: Array
    width: Array
    length: Array
    controls: Array


def arc_length(pieces: Pieces, u0: float | None = None, u1: float | None = None) -> float:
    """The length from u0 to u1, to a relative 1e-9; by default of the whole curve. Jumps do not count.

    Beside weights of a billion a piece may run to its end within one step of u: that counts as a jump.

    Raises: ValueError where u0 or u1 is not on the curve, or u1 is less than u0.
    """
    begin, end = float(pieces.knots[0]), float(pieces.knots[-1])
    first, last = begin if u0 is None else u0, end if u1 is None else u1
    if not begin <= first <= last <= end:
        raise ValueError(f"From u = {first:g} to {last:g} is not along the curve, {begin:g} to {end:g}.")
    return float(measured_parts(_between(pieces, first, last)).length.sum())


def _between(pieces: Pieces, u0: float, u1: float) -> Pieces:
    """The part of the curve from u0 to u1."""
    kept = with_length(pieces)
    if u0 <= kept.knots[0] and u1 >= kept.knots[-1]:
        return kept
    first, last = (int(number) for number in located(kept.knots, [u0, u1])[0])
    whole = lifted(kept)[first : last + 1]
    knots = kept.knots[first : last + 2].copy()
    whole[-1] = subdivide(whole[-1], float(located(kept.knots, u1)[1]))[0]
    share = (u0 - knots[0]) / ((u1 if first == last else knots[1]) - knots[0]) if u0 > knots[0] else 0.0
    whole[0] = subdivide(whole[0], share)[1]
    knots[0], knots[-1] = u0, u1
    return with_length(Pieces(knots, *projected(whole)))


def measured_parts(pieces: Pieces) -> Parts:
    """The whole curve in parts that can be measured, in order."""
    controls = balanced(lifted(pieces))
    piece, low, width = np.arange(len(controls)), np.zeros(len(controls)), 1.0
    length = length_up_to(controls, WHOLE)
    # Where there is hardly a length, rounding must not be mistaken for one
    rounding = 2.0**-44 * np.abs(pieces.controls).max(axis=(1, 2))
    least = np.maximum(_MEASURED * length.sum() / len(controls), rounding)
    found = []
    for depth in range(_DEEPEST + 1):
        controls, width = halves(controls), 0.5 * width
        piece, low = np.repeat(piece, 2), np.repeat(low, 2)
        low[1::2] += width
        part = length_up_to(controls, WHOLE)
        whole_part, small = part[::2] + part[1::2], least[piece[::2]]
        done = (np.abs(whole_part - length) <= small) & (one_way(controls).reshape(-1, 2).all(axis=1))
        done = np.repeat(done | (whole_part <= small) | (depth == _DEEPEST or len(part) > _MOST), 2)
        found.append(Parts(piece[done], low[done], np.full(done.sum(), width), part[done], controls[done]))
        piece, low, length, controls = piece[~done], low[~done], part[~done], controls[~done]
        if not len(piece):
            break
    whole = Parts(*(np.concatenate(columns) for columns in zip(*found, strict=True)))
    order = np.lexsort((whole.low, whole.piece))
    return Parts(*[column[order] for column in whole])  # type: ignore[arg-type]


def one_way(controls: Array) -> NDArray[np.bool_]:
    """Whether each part (r,) certainly goes one way, nowhere much slower than elsewhere."""
    points, weights = projected(controls)
    tops = derivative_numerator(points, None if (weights == 1.0).all() else weights)[0]
    mean = tops.sum(axis=-1, keepdims=True)
    along = (tops * mean).sum(axis=1).min(axis=-1)
    fastest = np.sqrt((tops * tops).sum(axis=1)).max(axis=-1)
    moving: NDArray[np.bool_] = along >= _SLOWEST * fastest * np.sqrt((mean[..., 0] ** 2).sum(axis=-1))
    return moving


@cache
def _gauss_points() -> tuple[Array, Array]:
    """Gauss and Legendre's 16 points between 0 and 1, and the share (16,) that each has in a mean.

    NumPy loads its polynomials when they are first asked for, which is not before a length is.
    """
    nodes, shares = np.polynomial.legendre.leggauss(16)
    return 0.5 * (nodes + 1.0), 0.5 * shares


def length_up_to(controls: Array, end: Array) -> Array:
    """The lengths (r,) of curves (r, n+1, k+1) from 0 to each ``end`` (r,), or to one for all (1,)."""
    nodes, shares = _gauss_points()
    length: Array = end * (speeds_of(controls, end[:, None] * nodes) @ shares)
    return length


def speeds_of(controls: Array, v: Array) -> Array:
    """The speed of each curve (r, n+1, k+1) at each of its v (r, s), or at the same for all (1, s)."""
    points, weights = projected(controls)
    plain = bool((weights == 1.0).all())
    tops, _sizes = derivative_numerator(points, None if plain else weights)
    moved = tops @ bernstein(tops.shape[-1] - 1, v).swapaxes(1, 2)
    speeds: Array = np.sqrt((moved * moved).sum(axis=1))
    if plain:
        return speeds
    below = weights[:, None] @ bernstein(controls.shape[1] - 1, v).swapaxes(1, 2)
    return speeds / below[:, 0] ** 2
