"""Clipping in exact fractions, by other ways than the texts go."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

Number = float | Fraction
Point = tuple[Fraction, Fraction]
Window = Sequence[Number]


def fractions(values: Sequence[Number]) -> tuple[Fraction, ...]:
    return tuple(map(Fraction, values))


def grown(window: Window, by: Number) -> tuple[Fraction, ...]:
    """The window with each edge moved outwards."""
    xmin, ymin, xmax, ymax = fractions(window)
    return xmin - Fraction(by), ymin - Fraction(by), xmax + Fraction(by), ymax + Fraction(by)


def inside(point: Sequence[Number], window: Window) -> bool:
    x, y = point
    xmin, ymin, xmax, ymax = window
    return bool(xmin <= x <= xmax and ymin <= y <= ymax)


def visible(line: Sequence[Number], window: Window) -> tuple[Point, Point] | None:
    """The ends of what is visible: the first and the last inside of all places where it may begin or end."""
    x0, y0, x1, y1 = fractions(line)
    xmin, ymin, xmax, ymax = fractions(window)
    places = {Fraction(0), Fraction(1)}
    if x0 != x1:
        places |= {(edge - x0) / (x1 - x0) for edge in (xmin, xmax)}
    if y0 != y1:
        places |= {(edge - y0) / (y1 - y0) for edge in (ymin, ymax)}
    points = [(x0 + u * (x1 - x0), y0 + u * (y1 - y0)) for u in sorted(places) if 0 <= u <= 1]
    found = [point for point in points if inside(point, window)]
    return (found[0], found[-1]) if found else None


def cross(o: Sequence[Number], a: Sequence[Number], b: Sequence[Number]) -> Fraction:
    """Twice the area of the triangle o, a, b; positive where that turns left."""
    (ox, oy), (ax, ay), (bx, by) = fractions(o), fractions(a), fractions(b)
    return (ax - ox) * (by - oy) - (ay - oy) * (bx - ox)


def hull(points: Sequence[Sequence[Number]]) -> list[Point]:
    """The convex hull, counter-clockwise, without points within its sides."""
    ordered = sorted({(Fraction(x), Fraction(y)) for x, y in points})
    if len(ordered) < 3:
        return ordered

    def chain(some: list[Point]) -> list[Point]:
        kept: list[Point] = []
        for point in some:
            while len(kept) > 1 and cross(kept[-2], kept[-1], point) <= 0:
                kept.pop()
            kept.append(point)
        return kept[:-1]

    return chain(ordered) + chain(ordered[::-1])


def corners(window: Window) -> list[Point]:
    xmin, ymin, xmax, ymax = fractions(window)
    return [(xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)]


def sides(polygon: Sequence[Sequence[Number]]) -> list[tuple[Sequence[Number], Sequence[Number]]]:
    return list(pairwise([polygon[-1], *polygon])) if len(polygon) else []


def clipped_convex(polygon: Sequence[Point], window: Window) -> list[Point]:
    """What of a convex polygon, counter-clockwise, lies in the window: the hull of all possible corners."""
    found = [corner for corner in corners(window) if all(cross(a, b, corner) >= 0 for a, b in sides(polygon))]
    for start, end in sides(polygon):
        part = visible((*start, *end), window)
        found += part or ()
    return hull(found)


def area(polygon: Sequence[Sequence[Number]]) -> Fraction:
    """The area with its sign: positive counter-clockwise."""
    exact = [fractions(point) for point in polygon]
    return sum((a[0] * b[1] - b[0] * a[1] for a, b in sides(exact)), Fraction(0)) / 2


def winding(polygon: Sequence[Sequence[Number]], point: Sequence[Number]) -> int:
    """How often the polygon goes round the point, which lies on none of its sides."""
    turns = 0
    for a, b in sides(polygon):
        if (a[1] <= point[1]) != (b[1] <= point[1]):
            left = cross(a, b, point) > 0
            turns += (a[1] <= point[1] and left) - (b[1] <= point[1] and not left)
    return turns


def near_a_side(polygon: Sequence[Sequence[Number]], point: Sequence[Number], distance: Number) -> bool:
    """Whether the point is nearer than this to the line of a side, within the side's box grown as much."""
    x, y = fractions(point)
    for a, b in sides(polygon):
        (ax, ay), (bx, by) = fractions(a), fractions(b)
        box = (min(ax, bx), min(ay, by), max(ax, bx), max(ay, by))
        length = max(abs(bx - ax), abs(by - ay))
        if (
            inside((x, y), grown(box, distance))
            and abs(cross(a, b, point)) <= 2 * Fraction(distance) * length
        ):
            return True
    return False
