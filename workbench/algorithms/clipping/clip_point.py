"""Point clipping: the four comparisons on which all clipping rests.

inside      whether the point passes all four
"""

from collections.abc import Iterator

from workbench.algorithms.clipping.window import POINT, WINDOW
from workbench.algorithms.entry import Entry


def clip_point(
    x: float, y: float, xmin: float, ymin: float, xmax: float, ymax: float
) -> Iterator[tuple[float, float]]:
    """Emit the point if it lies in the window or on its edge.

    Args: the point and the window, in device coordinates. Emits: (x, y), or nothing.
    Source: Hearn and Baker, Computer Graphics, C Version, section 6-6.
    """
    # Compare with all four edges
    inside = xmin <= x <= xmax and ymin <= y <= ymax

    # Keep the point if it is inside
    if inside:
        yield x, y


ENTRY = Entry(
    function=clip_point,
    topic="clipping",
    title="Point clipping",
    summary="Four comparisons tell whether a point lies in the window.",
    parameters=(*POINT, *WINDOW),
    emits="points",
    source="Hearn and Baker, Computer Graphics, C Version, section 6-6",
    next_rung="cohen_sutherland",
)
