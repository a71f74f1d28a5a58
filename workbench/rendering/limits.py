"""How far outside the picture an algorithm is let walk.

A scan conversion visits every pixel of its figure, seen or not. What reaches further than ``REACH_PX`` beyond
the picture is cut there first; cutting nearer would change a line's slope in the picture by rounding.
"""

import numpy as np
from numpy.typing import NDArray

REACH_PX = 1 << 14

# The corners of a polygon are not rounded, so that it may be cut nearer; each row of it is walked.
POLYGON_REACH_PX = 1 << 8


def clip_segment(
    x0: float, y0: float, x1: float, y1: float, xmin: float, ymin: float, xmax: float, ymax: float
) -> tuple[float, float, float, float] | None:
    """What of a segment lies in a rectangle, or None; a segment inside comes back unchanged."""
    u_enter, u_leave = 0.0, 1.0
    dx, dy = x1 - x0, y1 - y0
    for p, q in ((-dx, x0 - xmin), (dx, xmax - x0), (-dy, y0 - ymin), (dy, ymax - y0)):
        if p == 0.0:
            if q < 0.0:
                return None
        elif p < 0.0:
            u_enter = max(u_enter, q / p)
        else:
            u_leave = min(u_leave, q / p)
    if u_enter > u_leave:
        return None
    start = (x0, y0) if u_enter == 0.0 else (x0 + u_enter * dx, y0 + u_enter * dy)
    end = (x1, y1) if u_leave == 1.0 else (x0 + u_leave * dx, y0 + u_leave * dy)
    return (*start, *end)


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
