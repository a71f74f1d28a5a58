"""Where polynomials change their sign, many at a time, by their Bernstein coefficients.

The coefficients change their sign at least as often as the polynomial does: where they do so once, there is
one root, where they never do, none, and anything else is divided in the middle.
Source: Lane and Riesenfeld, Bounds on a polynomial, 1981.
"""

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.curves.halving import halves
from workbench.geometry.curves.polynomials import value

Array = NDArray[np.float64]
Numbers = NDArray[np.intp]

# What is smaller than this part of the numbers it was made of may be rounding
_NOISE = 2.0**-49
_DEEPEST = 48


def roots(coefficients: Array, sizes: Array) -> tuple[Numbers, Array]:
    """Rows (r,) and places (r,) between 0 and 1 at which a row (m, degree + 1) passes through 0, in order.

    ``sizes`` (m, degree + 1) are coefficients too: how large the numbers are that each one was made of. What
    is within their rounding counts as 0.
    """
    rows = np.arange(len(coefficients))
    low, width = np.zeros(len(rows)), 1.0
    found_rows, found = [np.empty(0, np.intp)], [np.empty(0)]
    for _depth in range(_DEEPEST):
        signs = _signs(coefficients, sizes)
        changes, begin = _changes(signs)
        one = changes == 1
        if one.any():
            found_rows.append(rows[one])
            found.append(low[one] + width * _single(coefficients[one], begin[one]))
        more = changes > 1
        if not more.any():
            break
        rows, low, width = np.repeat(rows[more], 2), np.repeat(low[more], 2), 0.5 * width
        low[1::2] += width
        both = halves(np.stack([coefficients[more], sizes[more]], axis=-1))
        coefficients, sizes = both[..., 0], both[..., 1]
        # A root at the very place of division belongs to no half
        middle = _signs(coefficients[1::2, :1], sizes[1::2, :1])[:, 0] == 0
        found_rows.append(rows[1::2][middle])
        found.append(low[1::2][middle])
    all_rows, places = np.concatenate(found_rows), np.concatenate(found)
    order = np.lexsort((places, all_rows))
    return all_rows[order], places[order]


def parted(count: int, *found: tuple[Numbers, Array]) -> tuple[Numbers, Array, Array]:
    """The rows 0 to ``count`` - 1 in parts between their roots: the row, the begin and the end (r,) of each.

    Every one of ``found`` are rows and places as ``roots`` gives them.
    """
    rows = np.concatenate([np.arange(count), *(each[0] for each in found)])
    begin = np.concatenate([np.zeros(count), *(each[1] for each in found)])
    order = np.lexsort((begin, rows))
    rows, begin = rows[order], begin[order]
    last = np.append(rows[1:] != rows[:-1], True)
    return rows, begin, np.where(last, 1.0, np.append(begin[1:], 1.0))


def sign_changes(coefficients: Array, sizes: Array, closed: bool = False) -> tuple[Numbers, Array]:
    """Rows (r,) and places (r,) from 0 to 1 where the rows (m, degree + 1), one after the other, change sign.

    Between two rows, and if ``closed`` between the last and the first, the place is 0 in the later one.
    """
    rows, begin, end = parted(len(coefficients), roots(coefficients, sizes))
    middle = 0.5 * (begin + end)
    limits = _NOISE * value(sizes[rows], middle)
    found = value(coefficients[rows], middle)
    sign = np.where(np.abs(found) > limits, np.sign(found), 0.0)
    sure = np.flatnonzero(sign)
    if not len(sure):
        return np.empty(0, np.intp), np.empty(0)
    before = np.roll(sign[sure], 1)
    if not closed:
        before[0] = sign[sure[0]]
    turned = sure[sign[sure] != before]
    return rows[turned], begin[turned]


def _signs(coefficients: Array, sizes: Array) -> Array:
    """-1, 0 or 1 for each, 0 within rounding."""
    limits = _NOISE * sizes
    return (coefficients > limits).astype(float) - (coefficients < -limits)


def _changes(signs: Array) -> tuple[Numbers, Array]:
    """How often each row changes its sign, zeros left out, and its first sign."""
    changes = np.zeros(len(signs), np.intp)
    begin, last = signs[:, 0].copy(), signs[:, 0].copy()
    for column in signs.T[1:]:
        changes += column * last < 0
        last = np.where(column != 0, column, last)
        begin = np.where(begin == 0, column, begin)
    return changes, begin


def _single(coefficients: Array, begin: Array) -> Array:
    """The one root of each row, which has the sign ``begin`` before it."""
    return _of_parabola(coefficients, begin) if coefficients.shape[1] == 3 else _by_steps(coefficients, begin)


def _of_parabola(coefficients: Array, begin: Array) -> Array:
    """The root at which a v^2 + 2 b v + c loses its sign, by the formula in which nothing cancels."""
    c = coefficients[:, 0]
    b = coefficients[:, 1] - c
    a = coefficients[:, 2] - coefficients[:, 1] - b
    slope = begin * np.sqrt(np.maximum(b * b - a * c, 0.0))
    grows = begin * b > 0
    below = np.where(grows, a, slope - b)
    found = np.divide(np.where(grows, -b - slope, c), below, out=np.zeros_like(c), where=below != 0)
    return np.clip(found, 0.0, 1.0)


def _by_steps(coefficients: Array, begin: Array) -> Array:
    """The same for any degree: Newton's steps, and a bisection where they leave the bounds or creep."""
    first, last = coefficients[:, 0], coefficients[:, -1]
    slopes = (coefficients.shape[1] - 1) * np.diff(coefficients, axis=1)
    sizes = np.abs(coefficients)
    low, high = np.zeros(len(begin)), np.ones(len(begin))
    apart = first * last < 0
    at = np.where(apart, np.divide(first, first - last, out=low + 0.5, where=apart), 0.5)
    going = np.ones(len(begin), bool)
    moved = np.full(len(begin), np.inf)
    for _turn in range(200):
        found, slope = value(coefficients, at), value(slopes, at)
        below = found * begin > 0
        low, high = np.where(below, at, low), np.where(below, high, at)
        step = np.divide(found, slope, out=np.full(len(at), np.inf), where=slope * begin < 0)
        rounding = 2.0**-50 * value(sizes, at)
        going = going & (np.abs(step) > 2.0**-51) & (high - low > 2.0**-53) & (np.abs(found) > rounding)
        if not going.any():
            break
        newton = (low < at - step) & (at - step < high) & (np.abs(step) < 0.5 * moved)
        to = np.where(newton, at - step, 0.5 * (low + high))
        moved = np.abs(to - at)
        at = np.where(going, to, at)
    return at
