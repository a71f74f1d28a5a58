"""Cohen and Sutherland's line clipping.

code_0, code_1      region codes of both ends: top, bottom, right, left from the highest bit
edge                the edge that one end is cut off at, as the bit of its code
k                   number of the step, from 0
"""

from collections.abc import Iterator

from workbench.algorithms.clipping.edges import BOTTOM, LEFT, RIGHT, TOP, intersection, region_code
from workbench.algorithms.clipping.window import LINE, WINDOW
from workbench.algorithms.entry import Entry


def cohen_sutherland(
    x0: float, y0: float, x1: float, y1: float, xmin: float, ymin: float, xmax: float, ymax: float
) -> Iterator[tuple[float, float, float, float]]:
    """Emit the visible part of a line: accept, reject, or cut off one end at one edge and look again.

    Args: both ends and the window, in device coordinates. Emits: (x0, y0, x1, y1), ends in the order
    given, or nothing. Source: Hearn and Baker, Computer Graphics, C Version, section 6-7.
    """
    # Code both ends
    code_0 = region_code(x0, y0, xmin, ymin, xmax, ymax)
    code_1 = region_code(x1, y1, xmin, ymin, xmax, ymax)

    for k in range(5):
        # Accept, reject or cut off one end
        if code_0 | code_1 == 0:
            yield x0, y0, x1, y1
            return
        if code_0 & code_1 != 0:
            return
        code = code_0 if code_0 != 0 else code_1
        edge = TOP if code & TOP else BOTTOM if code & BOTTOM else RIGHT if code & RIGHT else LEFT
        if code_0 != 0:
            x0, y0 = intersection(x0, y0, x1, y1, edge, xmin, ymin, xmax, ymax)
            code_0 = region_code(x0, y0, xmin, ymin, xmax, ymax)
        else:
            x1, y1 = intersection(x1, y1, x0, y0, edge, xmin, ymin, xmax, ymax)
            code_1 = region_code(x1, y1, xmin, ymin, xmax, ymax)


ENTRY = Entry(
    function=cohen_sutherland,
    topic="clipping",
    title="Cohen-Sutherland",
    summary="Codes of four bits accept or reject a line at a glance; otherwise an end is cut off at an edge.",
    parameters=(*LINE, *WINDOW),
    emits="segments",
    source="Hearn and Baker, Computer Graphics, C Version, section 6-7",
    next_rung="liang_barsky",
)
