"""The true line, in whole numbers and fractions: what the line algorithms are held against."""

from fractions import Fraction

Ends = tuple[int, int, int, int]
Point = tuple[Fraction, Fraction]


def true_points(ends: Ends) -> list[Point]:
    """One point of the true line for each step along the longer side."""
    x0, y0, x1, y1 = ends
    n = max(abs(x1 - x0), abs(y1 - y0))
    if n == 0:
        return [(Fraction(x0), Fraction(y0))]
    return [(x0 + Fraction(k * (x1 - x0), n), y0 + Fraction(k * (y1 - y0), n)) for k in range(n + 1)]


def is_tie(point: Point) -> bool:
    """Whether the point is exactly halfway between two pixels."""
    return any((2 * value).denominator == 1 and value.denominator == 2 for value in point)


def half_up(point: Point) -> tuple[int, int]:
    """The nearest pixel; halves go up and right."""
    x, y = point
    return int((x + Fraction(1, 2)) // 1), int((y + Fraction(1, 2)) // 1)


def half_away(point: Point, ends: Ends) -> tuple[int, int]:
    """The nearest pixel; halves go away from the first end point."""
    x0, y0, x1, y1 = ends

    def nearest(value: Fraction, start: int, end: int) -> int:
        sign = 1 if end >= start else -1
        return start + sign * int((sign * (value - start) + Fraction(1, 2)) // 1)

    return nearest(point[0], x0, x1), nearest(point[1], y0, y1)
