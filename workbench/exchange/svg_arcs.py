"""Elliptical arcs of SVG as cubic Bézier pieces, with the error stated.

Source: SVG 1.1, appendix F.6; Goldapp, Approximation of circular arcs by cubic polynomials, 1991.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbench.geometry.stretch import largest_stretch

Array = NDArray[np.float64]

_RIGHT = 0.5 * math.pi
_MOST_PIECES = 4096


class Arc(NamedTuple):
    """An arc as path data states it: radii, turn of the ellipse (degrees), and which of four arcs it is."""

    rx: float
    ry: float
    turn: float
    large: bool
    sweep: bool


def arc_pieces(arc: Arc, ends: Array, matrix: Array, tolerance: float) -> tuple[list[Array], float]:
    """The cubics (4, 2) of an arc between the columns of ``ends`` (2, 2), all under ``matrix`` (2, 3).

    Returns with them how far they are from the ellipse, at most. Radii that are too small grow until they
    reach; without a radius it is a line, without a way nothing.
    """
    begin, end = (matrix[:, :2] @ ends + matrix[:, 2:]).T
    radii = np.abs([arc.rx, arc.ry])
    if np.array_equal(ends[:, 0], ends[:, 1]):
        return [], 0.0
    if not radii.all():
        return [np.array([begin, end])], 0.0
    phi = math.radians(arc.turn % 360.0)
    turned = np.array([[math.cos(phi), -math.sin(phi)], [math.sin(phi), math.cos(phi)]])
    # In the frame in which the ellipse is the unit circle, its centre lies beside the middle of the chord.
    chord = turned.T @ (ends[:, 1] - ends[:, 0]) / radii
    half, whole = 0.5 * math.hypot(*chord), math.pi
    if half == 0.0:
        return [np.array([begin, end])], 0.0
    aside = np.zeros(2)
    if half < 1.0:
        away = math.sqrt((1.0 - half) * (1.0 + half)) / (2.0 * half)
        aside = (away if arc.large == arc.sweep else -away) * np.array([chord[1], -chord[0]])
        whole = 2.0 * math.asin(half)
        whole = 2.0 * math.pi - whole if arc.large else whole
    sweep = whole if arc.sweep else -whole
    axes = matrix[:, :2] @ turned * radii
    middle = 0.5 * (begin + end) + axes @ aside
    axes *= max(half, 1.0)
    radius = largest_stretch(axes)
    if not math.isfinite(radius):
        raise ValueError("the arc reaches beyond all numbers")
    count = max(math.ceil(whole / _RIGHT - 1e-9), 1)
    while radius * arc_error(sweep / count) > tolerance and count < _MOST_PIECES:
        count += 1
    step = sweep / count
    out = -0.5 * chord - aside
    angles = math.atan2(out[1], out[0]) + step * np.arange(count + 1)
    on = middle + np.column_stack([np.cos(angles), np.sin(angles)]) @ axes.T
    on[0], on[-1] = begin, end
    along = 4.0 / 3.0 * math.tan(step / 4.0) * np.column_stack([-np.sin(angles), np.cos(angles)]) @ axes.T
    cubics = np.stack([on[:-1], on[:-1] + along[:-1], on[1:] - along[1:], on[1:]], axis=1)
    return list(cubics), radius * arc_error(step)


def arc_error(turn: float) -> float:
    """How far the cubic with handles 4/3 tan(turn / 4) gets from the unit circle; ``turn`` in radians."""
    quarter = abs(turn) / 4.0
    return 2.0 / 27.0 * math.sin(quarter) ** 6 / math.cos(quarter) ** 2
