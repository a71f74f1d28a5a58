"""The triangle of intermediate points, as it is shown while it grows."""

from collections.abc import Sequence

Point = tuple[float, float]


def level_rows(triangle: Sequence[Point], count: int) -> list[tuple[int, str]]:
    """The triangle level by level: (r, its points so far), where level 0 has ``count`` points."""
    rows = []
    first = 0
    for r in range(count):
        level = triangle[first : first + count - r]
        first += count - r
        if level:
            rows.append((r, "  ".join(f"({x:.6g}, {y:.6g})" for x, y in level)))
    return rows
