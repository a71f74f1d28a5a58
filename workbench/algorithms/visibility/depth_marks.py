"""What is drawn of the depth buffer: the triangles, the one in hand, its scan line and where that ends."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import MOST_SPOTS, Mark, Ray, Spot, Stroke, Word, closed
from workbench.algorithms.numerals import numeral
from workbench.algorithms.visibility.device_plane import Corner


def marks(
    arguments: tuple[Any, ...], _now: Mapping[str, Any], _emitted: NDArray[Any], _ended: bool
) -> Iterator[Mark]:
    """Outlines of the triangles."""
    _image, _depth, vertices, faces, _colours = arguments
    for face in faces[:MOST_SPOTS]:
        yield Stroke(closed(np.array(vertices[face, :2], np.float64)), "muted", "hair")


def scan_line_marks(
    low: Corner, middle: Corner, high: Corner, y: int, x_left: float, x_right: float
) -> tuple[Mark, ...]:
    """The triangle in hand, its scan line, and where that enters and leaves it."""
    return (
        Stroke(closed(np.array([low[:2], middle[:2], high[:2]])), "accent", "thin"),
        Ray(0.0, float(y), 1.0, 0.0, "accent", "thin", "dash", both_ways=True),
        Spot(x_left, float(y), "data2", "ring"),
        Spot(x_right, float(y), "data2", "ring"),
    )


def depth_mark(x: int, y: int, z: float) -> Mark:
    """The depth of the triangle at the pixel."""
    return Word(f"z = {numeral(z)}", float(x), float(y), "text", 0, 1, carded=True)
