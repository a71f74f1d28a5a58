"""What is shown while the tangents of a natural cubic spline are worked out: points, tangents, equations."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import MOST_SPOTS, Mark, Spot, Stroke, along
from workbench.algorithms.numerals import numeral


def tangent_marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The points, and at each that is solved the direction of its tangent."""
    points = np.asarray(arguments[0], np.float64)
    yield Stroke(points, "text", "hair", "dot")
    if len(emitted) > MOST_SPOTS:
        return
    reach = float(np.hypot(*np.diff(points, axis=0).T).max()) / 6.0
    for x, y, m_x, m_y in emitted.tolist():
        length = math.hypot(m_x, m_y)
        if length > 0.0:
            dx, dy = reach * m_x / length, reach * m_y / length
            yield Stroke(along((x - dx, y - dy), (x + dx, y + dy)), "data2", "thin")
        yield Spot(x, y, "data2", "dot", "small")
    if len(emitted) and not ended:
        yield Spot(float(emitted[-1, 0]), float(emitted[-1, 1]), "accent", "ring", "large")


def point_marks(points: NDArray[Any], i: int) -> tuple[Mark, ...]:
    """The point that an equation belongs to."""
    return (Spot(float(points[i, 0]), float(points[i, 1]), "accent", "ring", "large"),)


def system_rows(system: Sequence[tuple[float, ...]]) -> list[tuple[Any, ...]]:
    """The equations so far, numbered."""
    return [(i, *row) for i, row in enumerate(system)]


def equation_row(what: str, i: int, row: Any, m: object = "") -> tuple[Any, ...]:
    """One row of the hand table: what is done, and with which numbers."""
    return what, i, row.lower, row.diagonal, row.upper, (row.right_x, row.right_y), m


def times(coefficient: float) -> str:
    """A coefficient before its unknown, which stands alone where that is 1."""
    return "" if coefficient == 1.0 else f"{numeral(coefficient)} "
