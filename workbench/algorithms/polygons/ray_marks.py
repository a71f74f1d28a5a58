"""What is drawn of the inside-outside test: the point, its ray, and the crossings on it."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import MOST_WORDS, Mark, Ray, Spot, Stroke, Word
from workbench.algorithms.numerals import numeral


def marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """The ray to the right, the edge it is held against, and each crossing with its number and direction."""
    vertices, _ring_ends, x, y, _nonzero = arguments
    x, y = float(x), float(y)
    crossings = sorted((float(at), direction) for at, _y, direction in emitted.tolist())
    least = crossings[-1][0] + 1.0 - x if crossings else 0.0
    yield Ray(x, y, 1.0, 0.0, "accent", "medium", least=least)
    if "low" in now and not ended:
        edge = np.asarray(vertices, np.float64)[[now["low"], now["high"]], :2]
        yield Stroke(edge, "data2", "bold")
    yield Spot(x, y, "accent", "dot", "medium")
    yield Word(f"({numeral(x)}, {numeral(y)})", x, y, "text", -1, 1, carded=True)
    for number, (at, direction) in enumerate(crossings[:MOST_WORDS], 1):
        yield Spot(at, y, "data2", "ring")
        arrow = "↑" if direction > 0 else "↓"
        yield Word(f"{number} {arrow}", at, y, "text", 0, 1 if number % 2 else -1, carded=True)
