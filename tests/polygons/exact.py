"""An oracle of its own: which pixels a polygon covers, point by point, in fractions."""

from collections.abc import Sequence
from fractions import Fraction

Point = tuple[Fraction, Fraction]


def rings_of(vertices: Sequence[Sequence[float]], ring_ends: Sequence[int]) -> list[list[Point]]:
    """The rings, as exact points."""
    exact = [(Fraction(x), Fraction(y)) for x, y in vertices]
    starts = [0, *ring_ends[:-1]]
    return [exact[start:end] for start, end in zip(starts, ring_ends, strict=True)]


def _on_edge(a: Point, b: Point, x: Fraction, y: Fraction) -> bool:
    cross = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
    between = min(a[0], b[0]) <= x <= max(a[0], b[0]) and min(a[1], b[1]) <= y <= max(a[1], b[1])
    return cross == 0 and between


def winding_left_of(rings: list[list[Point]], x: Fraction, y: Fraction) -> tuple[int, int]:
    """Winding number and number of edges on the ray to the left, which takes in the point itself."""
    winding = count = 0
    for ring in rings:
        for k, a in enumerate(ring):
            b = ring[(k + 1) % len(ring)]
            low, high, turn = (a, b, 1) if a[1] <= b[1] else (b, a, -1)
            if low[1] <= y < high[1]:
                crossed = low[0] + (y - low[1]) * (high[0] - low[0]) / (high[1] - low[1])
                if crossed <= x:
                    winding += turn
                    count += 1
    return winding, count


def covered(
    vertices: Sequence[Sequence[float]], ring_ends: Sequence[int], closed: bool, nonzero: bool
) -> set[tuple[int, int]]:
    """Every pixel (x, y) whose centre belongs to the polygon."""
    rings = rings_of(vertices, ring_ends)
    points = [point for ring in rings for point in ring]
    found: set[tuple[int, int]] = set()
    if not points:
        return found
    xs, ys = [float(p[0]) for p in points], [float(p[1]) for p in points]
    for y in range(int(min(ys)) - 2, int(max(ys)) + 3):
        for x in range(int(min(xs)) - 2, int(max(xs)) + 3):
            winding, count = winding_left_of(rings, Fraction(x), Fraction(y))
            inside = winding != 0 if nonzero else count % 2 == 1
            if not inside and closed:
                inside = any(
                    _on_edge(ring[k], ring[(k + 1) % len(ring)], Fraction(x), Fraction(y))
                    for ring in rings
                    for k in range(len(ring))
                )
            if inside:
                found.add((x, y))
    return found
