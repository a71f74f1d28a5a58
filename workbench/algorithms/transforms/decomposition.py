"""An affine matrix of the plane taken apart: M = T R S Sh, so that a point is sheared first.

The shear is along x, x' = x + sh y. Of every matrix there is one such chain, of singular ones too: what they
flatten has a scale factor of 0.
Source: Thomas, Decomposing a Matrix into Simple Transformations, Graphics Gems II, 1991, in the plane.
"""

import math
from typing import NamedTuple

import numpy as np

from workbench.algorithms.transforms.chain import Matrix, is_affine, product
from workbench.algorithms.transforms.plane import rotation, scaling, shear, translation

_CANCELLED = 4e-13
"""Of a determinant a d - b c: what rounding may have left of two equal products, as part of their size."""


class Loss(NamedTuple):
    """What cannot be seen any more of a figure that was transformed.

    ``rank`` is 2 where nothing is lost, 1 where all comes to lie on one line, 0 on one point. Where it is
    ``mirrored``, left and right have changed places.
    """

    rank: int
    mirrored: bool


class Parts(NamedTuple):
    """M = T(tx, ty) R(theta) S(sx, sy) Sh(sh); sx is not negative, sy is negative where M mirrors."""

    tx: float
    ty: float
    theta: float
    sx: float
    sy: float
    sh: float
    loss: Loss


def decomposed(matrix: Matrix) -> Parts:
    """The parts of an affine (3, 3) matrix.

    ``recomposed`` gives back each column to 1e-12 of its size, but one that is 1e-300 times the other or less
    may be lost. Raises: ValueError when it is not affine or not finite.
    """
    if matrix.shape != (3, 3) or not np.isfinite(matrix).all() or not is_affine(matrix):
        raise ValueError("Only a finite 3 x 3 matrix with the last row 0 0 1 can be decomposed.")
    (a, b, tx), (c, d, ty), _last = matrix.tolist()
    first_size, second_size = max(abs(a), abs(c)), max(abs(b), abs(d))
    cos, sin, sx = _direction(a, c, first_size)
    second = math.hypot(b, d)
    # The second column along and across the first
    along, across = _turned_back(b, d, cos, sin, second_size)
    sh = along / sx if sx > 0.0 else 0.0
    if sx == 0.0 or not math.isfinite(sh):
        theta, rank = math.atan2(-b, d), 1 if second > 0.0 else 0
        return Parts(tx, ty, theta if rank else 0.0, 0.0, second, 0.0, Loss(rank, False))
    if second == 0.0 or _cancels(a / first_size, b / second_size, c / first_size, d / second_size):
        return Parts(tx, ty, math.atan2(c, a), sx, 0.0, sh, Loss(1, False))
    return Parts(tx, ty, math.atan2(c, a), sx, across, sh, Loss(2, across < 0.0))


def recomposed(parts: Parts) -> Matrix:
    """The matrix that these are the parts of."""
    # First what is sheared and scaled: a tiny factor turned before would lose its last digits
    stretched = scaling(parts.sx, parts.sy) @ shear(parts.sh, 0.0)
    return product(translation(parts.tx, parts.ty), rotation(parts.theta), stretched)


def _direction(x: float, y: float, size: float) -> tuple[float, float, float]:
    """Cosine and sine of the direction of (x, y), and its length; none is lost where numbers end."""
    if size == 0.0:
        return 1.0, 0.0, 0.0
    x, y = x / size, y / size
    length = math.hypot(x, y)
    return x / length, y / length, size * length


def _turned_back(x: float, y: float, cos: float, sin: float, size: float) -> tuple[float, float]:
    """The vector (x, y) turned by -theta; no size of it overflows on the way."""
    if size == 0.0:
        return 0.0, 0.0
    x, y = x / size, y / size
    return size * (cos * x + sin * y), size * (cos * y - sin * x)


def _cancels(a: float, b: float, c: float, d: float) -> bool:
    """Whether the determinant is 0 but for rounding; no number is larger than 1."""
    return abs(a * d - b * c) <= _CANCELLED * (abs(a * d) + abs(b * c))
