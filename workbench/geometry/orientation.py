"""On which side of a line a point lies, with the right sign whatever the numbers.

The plain determinant is right unless it nearly vanishes. Then it is added up again from parts that are exact:
a product of two floats is the sum of two floats, and so is their difference.
Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997.
"""

import math

_WHOLE = 2.0**25
_BOUND = 2.0**-50
_SPLITTER = 2.0**27 + 1.0


def side_of(x0: float, y0: float, x1: float, y1: float, x: float, y: float) -> float:
    """Positive when (x, y) is right of the line going up from (x0, y0) to (x1, y1), 0 on it, else negative.

    Only the sign is exact, for coordinates that are 0 or between 1e-70 and 1e70 in size.
    """
    first = (x - x0) * (y1 - y0)
    second = (y - y0) * (x1 - x0)
    side = first - second
    if abs(side) > _BOUND * (abs(first) + abs(second)) or _all_whole(x0, y0, x1, y1, x, y):
        return side
    return _added_exactly(x0, y0, x1, y1, x, y)


def _all_whole(x0: float, y0: float, x1: float, y1: float, x: float, y: float) -> bool:
    """Whether the numbers are whole and so small that their products are exact."""
    if max(abs(x0), abs(y0), abs(x1), abs(y1), abs(x), abs(y)) > _WHOLE:
        return False
    whole = x0 == math.floor(x0) and y0 == math.floor(y0) and x1 == math.floor(x1)
    return whole and y1 == math.floor(y1) and x == math.floor(x) and y == math.floor(y)


def _added_exactly(x0: float, y0: float, x1: float, y1: float, x: float, y: float) -> float:
    """The determinant x y1 - x y0 - x0 y1 - y x1 + y x0 + y0 x1, its products and their sum exact.

    ``parts`` never overlap and grow in size, so that the last one has the sign of their sum.
    """
    parts = [0.0]
    for a, b in ((x, y1), (-x, y0), (-x0, y1), (-y, x1), (y, x0), (y0, x1)):
        product = a * b
        for term in (product_error(a, b, product), product):
            kept = 0
            rest = term
            for part in parts:
                total = rest + part
                error = sum_error(rest, part, total)
                if error != 0.0:
                    parts[kept] = error
                    kept += 1
                rest = total
            while len(parts) > kept:
                parts.pop()
            if rest != 0.0 or kept == 0:
                parts.append(rest)
    return parts[-1]


def sum_error(a: float, b: float, total: float) -> float:
    """What a + b is more than ``total``, its rounded value: an exact float."""
    b_in_total = total - a
    return (a - (total - b_in_total)) + (b - b_in_total)


def product_error(a: float, b: float, product: float) -> float:
    """What a b is more than ``product``, its rounded value: an exact float."""
    scaled = _SPLITTER * a
    a_high = scaled - (scaled - a)
    a_low = a - a_high
    scaled = _SPLITTER * b
    b_high = scaled - (scaled - b)
    b_low = b - b_high
    return a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low)
