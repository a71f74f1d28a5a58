"""How far outside the picture an algorithm is let walk.

A scan conversion visits every pixel of its figure, seen or not. What reaches further than ``REACH_PX`` beyond
the picture is cut there first; cutting nearer would change a line's slope in the picture by rounding.
"""

import numpy as np
from numpy.typing import NDArray

REACH_PX = 1 << 14

# The corners of a polygon are not rounded, so that it may be cut nearer; each row of it is walked.
POLYGON_REACH_PX = 1 << 8


@np.errstate(over="ignore", invalid="ignore", divide="ignore")
def clip_segments(
    table: NDArray[np.float64], window: tuple[float, float, float, float]
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """What of segments (n, 4) lies in a rectangle (xmin, ymin, xmax, ymax), and of which (n,) something does.

    An end inside stays exactly as it is.
    """
    x0, y0, x1, y1 = table.T
    dx, dy = x1 - x0, y1 - y0
    xmin, ymin, xmax, ymax = window
    enter, leave = np.zeros(len(table)), np.ones(len(table))
    beside = np.zeros(len(table), np.bool_)
    # Beyond all numbers inf and nan come up, which compare as they should.
    for p, q in ((-dx, x0 - xmin), (dx, xmax - x0), (-dy, y0 - ymin), (dy, ymax - y0)):
        u = np.divide(q, p, out=np.zeros(len(table)), where=p != 0.0)
        enter = np.where(p < 0.0, np.fmax(enter, u), enter)
        leave = np.where(p > 0.0, np.fmin(leave, u), leave)
        beside |= (p == 0.0) & (q < 0.0)
    kept = ~beside & (enter <= leave)
    parts = np.stack([x0 + enter * dx, y0 + enter * dy, x0 + leave * dx, y0 + leave * dy], axis=1)
    whole = np.stack([enter == 0.0, enter == 0.0, leave == 1.0, leave == 1.0], axis=1)
    return np.where(whole, table, parts)[kept], kept


def reach(width: int, height: int) -> tuple[float, float, float, float]:
    """How far lines are drawn around a picture of this size: (xmin, ymin, xmax, ymax), device coordinates."""
    return -REACH_PX, -REACH_PX, width + REACH_PX, height + REACH_PX


def polygon_reach(width: int, height: int) -> tuple[float, float, float, float]:
    """How far polygons are filled around a picture of this size, as ``reach``."""
    return -POLYGON_REACH_PX, -POLYGON_REACH_PX, width + POLYGON_REACH_PX, height + POLYGON_REACH_PX


def clip_ring(ring: NDArray[np.float64], width: int, height: int) -> NDArray[np.float64]:
    """A ring (n, 2) of device points, cut where it leaves the reach of a picture; one inside is unchanged.

    What lies beyond is folded onto the edge of the reach, so that insides stay as they were within it.
    """
    xmin, ymin, xmax, ymax = polygon_reach(width, height)
    for axis, sign, at in ((0, -1, xmin), (0, 1, xmax), (1, -1, ymin), (1, 1, ymax)):
        beyond = sign * ring[:, axis] > sign * at
        if beyond.any():
            ring = _cut(ring, beyond, axis, at)
    return ring


def _cut(ring: NDArray[np.float64], beyond: NDArray[np.bool_], axis: int, at: float) -> NDArray[np.float64]:
    kept: list[NDArray[np.float64]] = []
    for k in range(len(ring)):
        if beyond[k - 1] != beyond[k]:
            a, b = ring[k - 1], ring[k]
            crossing = a + (b - a) * ((at - a[axis]) / (b[axis] - a[axis]))
            crossing[axis] = at
            kept.append(crossing)
        if not beyond[k]:
            kept.append(ring[k])
    return np.array(kept, np.float64).reshape(-1, 2)
