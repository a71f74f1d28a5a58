"""Systems of equations whose matrix has three diagonals, solved by elimination without a pivot.

That is safe where the diagonal outweighs its two neighbours, as it does in every spline here.
Source: Press and others, Numerical Recipes in C, sections 2.4 and 2.7.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def solve_tridiagonal(lower: Array, diagonal: Array, upper: Array, right: Array) -> Array:
    """The solution (n, k): lower[i] x[i-1] + diagonal[i] x[i] + upper[i] x[i+1] = right[i] for each row i."""
    factors, pivots = [0.0], [float(diagonal[0])]
    above = upper.tolist()
    for i, (below, own) in enumerate(zip(lower.tolist()[1:], diagonal.tolist()[1:], strict=True)):
        factor = below / pivots[i]
        factors.append(factor)
        pivots.append(own - factor * above[i])
    columns = []
    for column in right.T.tolist():
        for i in range(1, len(column)):
            column[i] -= factors[i] * column[i - 1]
        column[-1] /= pivots[-1]
        for i in range(len(column) - 2, -1, -1):
            column[i] = (column[i] - above[i] * column[i + 1]) / pivots[i]
        columns.append(column)
    return np.array(columns).T.reshape(right.shape)


def solve_cyclic(lower: Array, diagonal: Array, upper: Array, right: Array) -> Array:
    """As ``solve_tridiagonal``, where x[-1] is the last and x[n] the first unknown; three rows or more.

    The two corners are a product of two vectors, whose part the Sherman-Morrison formula adds.
    """
    gamma = -diagonal[0]
    inner = diagonal.copy()
    inner[0] -= gamma
    inner[-1] -= upper[-1] * lower[0] / gamma
    corner = np.zeros((len(diagonal), 1))
    corner[0, 0], corner[-1, 0] = gamma, upper[-1]
    solved = solve_tridiagonal(lower, inner, upper, np.hstack([right, corner]))
    found, around = solved[:, :-1], solved[:, -1:]
    share = lower[0] / gamma
    part = (found[0] + share * found[-1]) / (1.0 + around[0, 0] + share * around[-1, 0])
    solution: Array = found - around * part
    return solution
