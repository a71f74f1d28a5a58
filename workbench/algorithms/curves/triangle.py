"""The triangle of intermediate points, as it is shown while it grows."""

from collections.abc import Sequence

from workbench.algorithms.numerals import numeral

Level = Sequence[tuple[float, ...]]


def level_rows(triangle: Sequence[Level]) -> list[tuple[int, str]]:
    """The triangle level by level: (r, its points so far); a level without points is left out."""
    return [
        (r, "  ".join(f"({numeral(x)}, {numeral(y)})" for x, y, *_weight in level))
        for r, level in enumerate(triangle)
        if level
    ]


def weight_rows(triangle: Sequence[Level]) -> list[tuple[int, str]]:
    """The weights of the triangle's points level by level: (r, its weights so far)."""
    return [
        (r, "  ".join(numeral(weight) for _x, _y, weight in level))
        for r, level in enumerate(triangle)
        if level
    ]
