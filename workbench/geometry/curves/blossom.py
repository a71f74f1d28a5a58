"""The blossom of a B-spline, and what it gives at once: Bézier pieces and a higher degree.

The blossom f(u_1 ... u_p) of one knot span is de Boor's construction with another u on each level. It is the
control point of the span for knots u_1 ... u_p, whatever knots are chosen.
Source: Ramshaw, Blossoms are polar forms, 1989; Farin, Curves and Surfaces for CAGD, chapters 4 and 8.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse
from workbench.geometry.curves.pieces import Pieces

Array = NDArray[np.float64]


def blossom(controls: Array, knots: Array, degree: int, spans: NDArray[np.int64], us: Array) -> Array:
    """f(u_1 ... u_degree) of each span: (m, k) for spans (m,), none of them empty, and us (m, degree)."""
    level: Array = controls[spans[:, None] + np.arange(-degree, 1)]
    for r in range(1, degree + 1):
        left = knots[spans[:, None] + np.arange(r - degree, 1)]
        right = knots[spans[:, None] + np.arange(1, degree + 2 - r)]
        # Not 1 - alpha: where that is tiny its rounding error counts, with weights that differ
        alpha = ((us[:, r - 1, None] - left) / (right - left))[..., None]
        rest = ((right - us[:, r - 1, None]) / (right - left))[..., None]
        level = rest * level[:, :-1] + alpha * level[:, 1:]
    return level[:, 0]


def b_spline_to_bezier(points: ArrayLike, knots: ArrayLike, degree: int) -> Pieces:
    """The Bézier piece of every knot span that is not empty. Exact but for rounding. Raises: ValueError."""
    controls, t = np.asarray(points, float), np.asarray(knots, float)
    refuse(faults(controls, t, degree))
    spans = _full_spans(t, degree)
    left, right = t[spans, None], t[spans + 1, None]
    turned = np.arange(degree) >= degree - np.arange(degree + 1)[:, None]
    us = np.where(turned, right[:, None], left[:, None]).reshape(-1, degree)
    polar = blossom(controls, t, degree, np.repeat(spans, degree + 1), us)
    return Pieces(np.append(left[:, 0], right[-1]), polar.reshape(len(spans), degree + 1, -1))


def elevate_b_spline(points: ArrayLike, knots: ArrayLike, degree: int) -> tuple[Array, Array]:
    """Points and knots of the same curve, one degree higher, every knot repeated once more.

    Each new control point is the mean of the blossoms at its knots but one. Raises: ValueError.
    """
    controls, t = np.asarray(points, float), np.asarray(knots, float)
    refuse(faults(controls, t, degree))
    values, counts = np.unique(t, return_counts=True)
    raised = np.repeat(values, counts + 1)
    begin = int(np.searchsorted(raised, t[degree], side="right")) - 1
    end = int(np.searchsorted(raised, t[len(controls)], side="left"))
    raised = raised[begin - degree - 1 : end + degree + 2]
    new = np.arange(len(raised) - degree - 2)
    spans = _full_spans(t, degree)
    # Any span between the outer knots will do: the first one there
    span = spans[np.minimum(np.searchsorted(t[spans + 1], raised[new], side="right"), len(spans) - 1)]
    own = raised[new[:, None] + np.arange(1, degree + 2)]
    # The order is free; with the nearest on the last level, which is the narrowest, the least is lost
    away = np.maximum(t[span, None] - own, own - t[span + 1, None])
    own = np.take_along_axis(own, np.argsort(-away, axis=1, kind="stable"), axis=1)
    total = np.zeros((len(new), controls.shape[1]))
    for left_out in range(degree + 1):
        total += blossom(controls, t, degree, span, np.delete(own, left_out, axis=1))
    return total / (degree + 1), raised


def _full_spans(knots: Array, degree: int) -> NDArray[np.int64]:
    """Numbers of the knot spans of the curve that are not empty."""
    inner = knots[degree : len(knots) - degree]
    return degree + np.flatnonzero(np.diff(inner) > 0)
