"""What is drawn of the shadings: the triangle in hand, its scan line and where that ends."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.marks import Mark, Spot, Stroke, closed

_MOST_OUTLINED = 24
"""Of more triangles only the one in hand has an outline: a net over all would hide their light."""


def marks(
    arguments: tuple[Any, ...], now: Mapping[str, Any], _emitted: NDArray[Any], ended: bool
) -> Iterator[Mark]:
    """Outlines of few triangles, of the one in hand, and both ends of its scan line."""
    _light, vertices, faces, *_rest = arguments
    if len(faces) <= _MOST_OUTLINED:
        for face in faces:
            yield _outline(vertices, face, "muted", "hair")
    if ended or "face" not in now:
        return
    yield _outline(vertices, faces[now["face"]], "accent", "medium")
    if "start" in now and "end" in now:
        for end in (now["start"], now["end"]):
            yield Spot(end.x, float(now["y"]), "data2", "ring")


def _outline(vertices: NDArray[Any], face: NDArray[Any], ink: Any, weight: Any) -> Mark:
    return Stroke(closed(np.array(vertices[face, :2], np.float64)), ink, weight)
