"""The text ``beam_strokes`` at work: a whole display list on the face in one compiled call."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.scanning.beam_strokes import beam_strokes
from workbench.engine.at_hand import at_hand

_NO_PICTURE = np.zeros((1, 1), np.uint32)


def strokes_ready() -> bool:
    """Whether it is compiled and loaded; nothing here compiles or loads it."""
    return at_hand(beam_strokes, "run")


def draw_strokes(face: NDArray[np.float64], strokes: NDArray[Any], sigma_px: float) -> None:
    """Add to a face (h, w) what strokes (n, 5) leave: x0, y0, x1, y1 in pixels, and their energy."""
    from workbench.engine.compiled import paint

    paint(beam_strokes, _NO_PICTURE, 0, face, strokes, sigma_px, compiling=False)
