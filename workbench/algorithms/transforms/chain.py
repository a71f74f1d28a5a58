"""Matrices one after another: their product, the way back, and what becomes of points.

A chain is written as the course writes it, M = T R S: the last one acts first on a point. All matrices are
square, (3, 3) or (4, 4), and homogeneous.
"""

from functools import reduce

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]


def product(first: Matrix, *others: Matrix) -> Matrix:
    """The product in the order of writing; the last matrix acts first."""
    return reduce(np.matmul, others, first)


def inverse(matrix: Matrix) -> Matrix:
    """The matrix that brings back; of an affine one the last row is again exactly 0 ... 0 1.

    Raises: ValueError when the matrix is singular or not finite.
    """
    try:
        back = np.asarray(np.linalg.inv(matrix), np.float64)
    except np.linalg.LinAlgError:
        back = np.full_like(matrix, np.nan)
    if not np.isfinite(back).all():
        raise ValueError("The matrix cannot be undone: it is singular or not finite.")
    if is_affine(matrix):
        back[-1] = matrix[-1]
    return back


def inverse_of_chain(*matrices: Matrix) -> Matrix:
    """The inverse of their product: the inverses, multiplied in the opposite order.

    Raises: ValueError when one of them is singular or not finite.
    """
    return product(*(inverse(matrix) for matrix in reversed(matrices)))


def is_affine(matrix: Matrix) -> bool:
    """Whether the last row is 0 ... 0 1, so that w stays 1."""
    return bool(matrix[-1, -1] == 1.0 and not matrix[-1, :-1].any())


def transform_points(matrix: Matrix, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """The points (n, 2) or (n, 3) that the matrix makes of ``points``, divided by w where it is not 1.

    Raises: ValueError when a point goes to infinity, w = 0.
    """
    linear, offset = matrix[:-1, :-1], matrix[:-1, -1]
    moved: NDArray[np.float64] = points @ linear.T + offset
    if is_affine(matrix):
        return moved
    w = points @ matrix[-1, :-1] + matrix[-1, -1]
    if not w.all():
        raise ValueError("The matrix takes a point to infinity: its w is 0.")
    divided: NDArray[np.float64] = moved / w[:, None]
    return divided
