"""How far a value has come from one key to the next, as a function of the part t of the time, 0 to 1.

Source: Hearn and Baker, Computer Graphics, C Version, section 16-5; the cubic ones: Penner, Programming
Macromedia Flash MX, 2002; the Bézier one: CSS Easing Functions, W3C.
"""

import math

CONSTANT, LINEAR, EASE_IN, EASE_OUT, EASE_IN_OUT = 0, 1, 2, 3, 4
EASE_IN_CUBIC, EASE_OUT_CUBIC, EASE_IN_OUT_CUBIC, BEZIER = 5, 6, 7, 8

NAMES = (
    "constant",
    "linear",
    "ease_in",
    "ease_out",
    "ease_in_out",
    "ease_in_cubic",
    "ease_out_cubic",
    "ease_in_out_cubic",
    "bezier",
)
"""The easings by their numbers."""

NEAREST_HANDLES = (
    (0.0, 0.0, 1.0, 0.0),
    (1.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0),
    (0.3603, 0.0, 0.671, 0.4827),
    (0.329, 0.5173, 0.6397, 1.0),
    (0.3643, 0.0, 0.6357, 1.0),
    (1.0 / 3.0, 0.0, 2.0 / 3.0, 0.0),
    (1.0 / 3.0, 1.0, 2.0 / 3.0, 1.0),
    (0.66, 0.0, 0.34, 1.0),
    (0.25, 0.1, 0.25, 1.0),
)
"""(x1, y1, x2, y2) of the Bézier easing that is nearest to each, fitted: what its handles are drawn at.

A constant has none that comes near; for the Bézier easing itself these are the ones it begins with.
"""

_HALVINGS = 54


def constant(t: float) -> float:
    """The value is held until the next key."""
    return 1.0 if t >= 1.0 else 0.0


def linear(t: float) -> float:
    """As far as the time."""
    return t


def ease_in(t: float) -> float:
    """Starts slowly: 1 - cos(pi t / 2)."""
    return 1.0 - math.cos(math.pi * t / 2.0) if t < 1.0 else 1.0  # in floats cos(pi / 2) is not quite 0


def ease_out(t: float) -> float:
    """Ends slowly: sin(pi t / 2)."""
    return math.sin(math.pi * t / 2.0)


def ease_in_out(t: float) -> float:
    """Starts and ends slowly: (1 - cos(pi t)) / 2."""
    return (1.0 - math.cos(math.pi * t)) / 2.0 if t != 0.5 else 0.5  # in floats cos(pi / 2) is not quite 0


def ease_in_cubic(t: float) -> float:
    """Starts slowly: t^3."""
    return t * t * t


def ease_out_cubic(t: float) -> float:
    """Ends slowly: 1 - (1 - t)^3."""
    rest = 1.0 - t
    return 1.0 - rest * rest * rest


def ease_in_out_cubic(t: float) -> float:
    """Starts and ends slowly: 4 t^3 up to the middle, and from there 1 - 4 (1 - t)^3."""
    rest = 1.0 - t
    return 4.0 * t * t * t if t < 0.5 else 1.0 - 4.0 * rest * rest * rest


def cubic_bezier_easing(x1: float, y1: float, x2: float, y2: float, t: float) -> float:
    """The y of the Bézier curve (0, 0), (x1, y1), (x2, y2), (1, 1) where its x is t; x1 and x2 are 0 to 1.

    Then x never runs back, and halving finds the parameter to the last digit.
    """
    if t <= 0.0:
        return 0.0
    if t >= 1.0:
        return 1.0
    low = 0.0
    high = 1.0
    for _halving in range(_HALVINGS):
        u = 0.5 * (low + high)
        if bezier_coordinate(x1, x2, u) < t:
            low = u
        else:
            high = u
    return bezier_coordinate(y1, y2, 0.5 * (low + high))


def bezier_coordinate(first: float, second: float, u: float) -> float:
    """One coordinate of a cubic Bézier curve from 0 to 1 at the parameter u; its handles are at these."""
    rest = 1.0 - u
    return 3.0 * rest * rest * u * first + 3.0 * rest * u * u * second + u * u * u


def eased(easing: int, x1: float, y1: float, x2: float, y2: float, t: float) -> float:
    """The easing with this number at t; only that of Bézier has the handles (x1, y1) and (x2, y2)."""
    if easing == CONSTANT:
        return constant(t)
    if easing == EASE_IN:
        return ease_in(t)
    if easing == EASE_OUT:
        return ease_out(t)
    if easing == EASE_IN_OUT:
        return ease_in_out(t)
    if easing == EASE_IN_CUBIC:
        return ease_in_cubic(t)
    if easing == EASE_OUT_CUBIC:
        return ease_out_cubic(t)
    if easing == EASE_IN_OUT_CUBIC:
        return ease_in_out_cubic(t)
    if easing == BEZIER:
        return cubic_bezier_easing(x1, y1, x2, y2, t)
    return linear(t)
