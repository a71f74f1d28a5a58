"""The easings of many tracks at once: the same as those of the course's text, for arrays."""

import numpy as np
from numpy.typing import NDArray

from workbench.algorithms.animation import easings
from workbench.algorithms.animation.easings import bezier_coordinate

Floats = NDArray[np.float64]
_NEWTON = 6
_SLOWEST, _CLOSE = 1e-6, 1e-14


def eased_parts(codes: NDArray[np.int64], handles: Floats, t: Floats) -> Floats:
    """The part of the way of each of n tracks: numbers of their easings (n,), handles (n, 4), times (n,).

    A spline goes as the time does.
    """
    parts = t.copy()
    for code in np.unique(codes).tolist():
        if code in _AT_ONCE:
            where = codes == code
            parts[where] = _AT_ONCE[code](t[where])
        elif code == easings.BEZIER:
            where = codes == code
            x1, y1, x2, y2 = handles[where].T
            parts[where] = _bezier(x1, y1, x2, y2, t[where])
    return parts


def _bezier(x1: Floats, y1: Floats, x2: Floats, y2: Floats, t: Floats) -> Floats:
    """The heights of Bézier easings; at both ends exactly 0 and 1.

    A few of Newton's steps find most parameters; the others, where the curve all but stands still in time,
    are halved as in the text.
    """
    u = t.copy()
    for _step in range(_NEWTON):
        rest = 1.0 - u
        speed = 3.0 * (rest * rest * x1 + 2.0 * rest * u * (x2 - x1) + u * u * (1.0 - x2))
        u = np.clip(u - (_coordinate(x1, x2, u) - t) / np.maximum(speed, _SLOWEST), 0.0, 1.0)
    heights = _coordinate(y1, y2, u)
    off = np.flatnonzero(np.abs(_coordinate(x1, x2, u) - t) > _CLOSE)
    for number in off.tolist():
        heights[number] = easings.cubic_bezier_easing(
            x1[number], y1[number], x2[number], y2[number], t[number]
        )
    return np.where(t <= 0.0, 0.0, np.where(t >= 1.0, 1.0, heights))


def _coordinate(first: Floats, second: Floats, u: Floats) -> Floats:
    height: Floats = bezier_coordinate(first, second, u)  # type: ignore[arg-type, assignment]  # of each
    return height


def _joined_cubic(t: Floats) -> Floats:
    rest = 1.0 - t
    return np.where(t < 0.5, 4.0 * t * t * t, 1.0 - 4.0 * rest * rest * rest)


_AT_ONCE = {
    easings.CONSTANT: lambda t: np.where(t >= 1.0, 1.0, 0.0),
    easings.EASE_IN: lambda t: 1.0 - np.cos(np.pi * t / 2.0),
    easings.EASE_OUT: lambda t: np.sin(np.pi * t / 2.0),
    easings.EASE_IN_OUT: lambda t: np.where(t == 0.5, 0.5, (1.0 - np.cos(np.pi * t)) / 2.0),
    easings.EASE_IN_CUBIC: lambda t: t * t * t,
    easings.EASE_OUT_CUBIC: lambda t: 1.0 - (1.0 - t) * (1.0 - t) * (1.0 - t),
    easings.EASE_IN_OUT_CUBIC: _joined_cubic,
}
