"""The triangle of intermediate points, as it is shown while it grows."""

from collections.abc import Iterator, Sequence


def levels(triangle: Sequence[tuple[float, ...]], count: int) -> Iterator[Sequence[tuple[float, ...]]]:
    """The points of each level so far, level 0 with ``count`` points first."""
    first = 0
    for r in range(count):
        level = triangle[first : first + count - r]
        first += count - r
        if level:
            yield level


def level_rows(triangle: Sequence[tuple[float, ...]], count: int) -> list[tuple[int, str]]:
    """The triangle level by level: (r, its points so far)."""
    return [
        (r, "  ".join(f"({x:.6g}, {y:.6g})" for x, y, *_weight in level))
        for r, level in enumerate(levels(triangle, count))
    ]


def weight_rows(triangle: Sequence[tuple[float, ...]], count: int) -> list[tuple[int, str]]:
    """The weights of the triangle's points level by level: (r, its weights so far)."""
    return [
        (r, "  ".join(f"{weight:.6g}" for _x, _y, weight in level))
        for r, level in enumerate(levels(triangle, count))
    ]
