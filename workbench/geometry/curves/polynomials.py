"""Polynomials by their Bernstein coefficients (..., degree + 1), and derivatives of quotients of them.

Source: Farouki and Rajan, Algorithms for polynomials in Bernstein form, 1988.
"""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def binomials(degree: int) -> Array:
    """The binomial coefficients of this degree (degree + 1,)."""
    return np.array([math.comb(degree, i) for i in range(degree + 1)], float)


def value(coefficients: Array, v: Array) -> Array:
    """The values at v (...,), one for each row (..., degree + 1), by de Casteljau's construction."""
    level, share = coefficients, v[..., None]
    while level.shape[-1] > 1:
        level = (1.0 - share) * level[..., :-1] + share * level[..., 1:]
    return level[..., 0]


def wronskian(degree: int, term: Callable[[int, int], Array]) -> Array:
    """The sum of ``term(i, j)`` (m, ...) times B_i B_j' - B_i' B_j, for i < j: coefficients (m, ..., q + 1).

    Of two Bernstein polynomials of this degree, that is (j - i) B_i B_j / (v (1 - v)): a factor above 0 times
    one Bernstein polynomial of degree q = 2 degree - 2.
    """
    above, below = binomials(degree), binomials(2 * degree - 2)
    products = [np.zeros_like(term(0, 1))] * (2 * degree - 1)
    for i in range(degree + 1):
        for j in range(i + 1, degree + 1):
            products[i + j - 1] = products[i + j - 1] + above[i] * above[j] * (j - i) / below[
                i + j - 1
            ] * term(i, j)
    return np.stack(products, axis=-1)


def derivative_numerator(controls: Array, weights: Array | None) -> tuple[Array, Array]:
    """What stands above in the derivative by v of each piece (m, n+1, k): Bernstein coefficients (m, k, q+1).

    Below it stands 1, or for rational pieces the square of the weight. Each coefficient is a sum over legs
    with factors above 0, so that weights of any size leave it exact to rounding; returned beside it is how
    large the numbers are whose rounding counts.
    """
    degree = controls.shape[1] - 1
    points, sizes = np.moveaxis(controls, 1, 0), np.abs(np.moveaxis(controls, 1, 0))
    if weights is None:
        legs, large = points[1:] - points[:-1], sizes[1:] + sizes[:-1]
        return degree * np.moveaxis(legs, 0, -1), degree * np.moveaxis(large, 0, -1)
    pulls = weights.T[..., None]
    return (
        wronskian(degree, lambda i, j: pulls[i] * pulls[j] * (points[j] - points[i])),
        wronskian(degree, lambda i, j: pulls[i] * pulls[j] * (sizes[j] + sizes[i])),
    )
