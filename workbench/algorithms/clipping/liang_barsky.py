"""Liang and Barsky's line clipping.

dx, dy      the line is (x0 + u dx, y0 + u dy) for u from 0 to 1
p, q        it is inside an edge where u p <= q: entering there if p < 0, leaving if p > 0, parallel if 0
r           the u at which it crosses the edge
u1, u2      the part of the line that is left so far
k           number of the edge: 1 left, 2 right, 3 bottom, 4 top
"""

from collections.abc import Iterator

from workbench.algorithms.clipping.window import LINE, WINDOW
from workbench.algorithms.entry import Entry


def liang_barsky(
    x0: float, y0: float, x1: float, y1: float, xmin: float, ymin: float, xmax: float, ymax: float
) -> Iterator[tuple[float, float, float, float]]:
    """Emit the visible part of a line: each edge narrows the interval of its parameter u.

    Args: both ends and the window, in device coordinates. Emits: (x0, y0, x1, y1), ends in the order
    given, or nothing. Source: Hearn and Baker, Computer Graphics, C Version, section 6-7.
    """
    # Begin with the whole line
    dx = x1 - x0
    dy = y1 - y0
    u1 = 0.0
    u2 = 1.0

    for k, p, q in ((1, -dx, x0 - xmin), (2, dx, xmax - x0), (3, -dy, y0 - ymin), (4, dy, ymax - y0)):
        # Narrow u1 to u2 by this edge
        if p < 0.0:
            r = q / p
            u1 = max(u1, r)
        elif p > 0.0:
            r = q / p
            u2 = min(u2, r)
        elif q < 0.0:
            return
        if u1 > u2:
            return

    if u2 < 1.0:
        # Find the intersection on leaving
        x1 = min(max(x0 + u2 * dx, xmin), xmax)
        y1 = min(max(y0 + u2 * dy, ymin), ymax)

    if u1 > 0.0:
        # Find the intersection on entering
        x0 = min(max(x0 + u1 * dx, xmin), xmax)
        y0 = min(max(y0 + u1 * dy, ymin), ymax)

    # Emit what is left
    yield x0, y0, x1, y1


ENTRY = Entry(
    function=liang_barsky,
    topic="clipping",
    title="Liang-Barsky",
    summary="Four divisions at most narrow the parameter from u1 to u2; only then are points reckoned.",
    parameters=(*LINE, *WINDOW),
    emits="segments",
    source="Hearn and Baker, Computer Graphics, C Version, section 6-7",
    next_rung="sutherland_hodgman",
)
