"""Where 1/m, added up, decides a pixel of a row otherwise than the exact crossings, in fractions."""

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from numpy.typing import NDArray

from workbench.algorithms.polygons.edge_table import Edge

# No sum of 1/m within 2^20 is further off.
_NEAR = 2.0**-10


class Drift(NamedTuple):
    """The crossing ``x`` of an edge, the pixel that it decides wrongly, and whether that one is lost."""

    x: float
    pixel: int
    lost: bool


def drifts(
    active: Sequence[Edge],
    vertices: NDArray[Any],
    spans: Sequence[tuple[int, int]],
    closed: bool,
    nonzero: bool,
    y: int,
) -> list[Drift]:
    """What the spans of row y have too little or too much, because a crossing has drifted past a centre."""
    wrong: dict[int, Drift] = {}
    for edge in active:
        pixel = math.floor(edge.x + 0.5)
        if edge.winding == 0 or edge.y_start == y or abs(edge.x - pixel) > _NEAR:
            continue
        belongs = _belongs(pixel, active, vertices, closed, nonzero, y)
        if belongs != any(left <= pixel <= right for left, right in spans):
            wrong[pixel] = Drift(edge.x, pixel, belongs)
    return list(wrong.values())


def drifted(drifts: Sequence[Drift]) -> str:
    """In words: x = 4.999999999999999, and pixel 5 is lost."""
    return "; ".join(
        f"x = {drift.x!r}, and pixel {drift.pixel} is {'lost' if drift.lost else 'too much'}".replace(
            "-", "−"
        )
        for drift in drifts
    )


def _belongs(
    pixel: int, active: Sequence[Edge], vertices: NDArray[Any], closed: bool, nonzero: bool, y: int
) -> bool:
    """Whether a pixel of row y belongs to the polygon whose edges on the row these are."""
    winding = 0
    for edge in active:
        x = _exact(edge, vertices, y)
        if closed and x <= pixel <= x + Fraction(edge.width):
            return True
        if x <= pixel:
            winding += edge.winding if nonzero else abs(edge.winding)
    return winding != 0 if nonzero else winding % 2 == 1


def _exact(edge: Edge, vertices: NDArray[Any], y: int) -> Fraction:
    """Where an edge crosses row y; a level one begins there."""
    (x_low, y_low), (x_high, y_high) = (
        map(Fraction, vertices[k, :2].tolist()) for k in (edge.low, edge.high)
    )
    if edge.winding == 0:
        return min(x_low, x_high)
    return x_low + (y - y_low) * (x_high - x_low) / (y_high - y_low)
