"""Knots put into a B-spline, by Boehm's formula: the curve stays, and gets control points nearer to it.

Points are (n, k); a rational curve is treated by its homogeneous points.
Source: Boehm, Inserting new knots into B-spline curves, 1980; The NURBS Book, algorithm A5.1.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.basis_functions import knot_spans
from workbench.geometry.curves.conditions import faults, refuse
from workbench.geometry.curves.knots import multiplicity

Array = NDArray[np.float64]


def insert_knot(
    points: ArrayLike, knots: ArrayLike, degree: int, u: float, times: int = 1
) -> tuple[Array, Array]:
    """Points and knots of the same curve with the knot u put in, once or several times.

    Raises: ValueError for a u outside the curve, or that would be repeated more often than the degree.
    """
    controls, t = np.asarray(points, float), np.asarray(knots, float)
    refuse(faults(controls, t, degree))
    there = multiplicity(t, u)
    if there + times > degree:
        sentence = f"Knot {u:g} is there {there} times, and the degree is {degree}"
        raise ValueError(f"{sentence}: insert it {max(degree - there, 0)} times at most.")
    for _time in range(times):
        span = int(knot_spans(t, degree, u))
        moved = np.arange(span - degree + 1, span + 1)
        alpha = ((u - t[moved]) / (t[moved + degree] - t[moved]))[:, None]
        new = (1.0 - alpha) * controls[moved - 1] + alpha * controls[moved]
        controls = np.vstack([controls[: span - degree + 1], new, controls[span:]])
        t = np.insert(t, span + 1, u)
    return controls, t


def split_b_spline(
    points: ArrayLike, knots: ArrayLike, degree: int, u: float
) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Points and knots of the parts before and after u, where the knot is repeated until they part.

    Raises: ValueError for a u that is not strictly inside the curve.
    """
    t = np.asarray(knots, float)
    refuse(faults(points, t, degree))
    if not t[degree] < u < t[len(t) - degree - 1]:
        raise ValueError(f"At u = {u:g} there is nothing to split; choose a u between the ends of the curve.")
    needed = max(degree - multiplicity(t, u), 0)
    controls, t = insert_knot(points, t, degree, u, needed) if needed else (np.asarray(points, float), t)
    begin = int(np.searchsorted(t, u, side="left"))
    end = int(np.searchsorted(t, u, side="right"))
    first = controls[:begin], np.append(t[: begin + degree], u)
    second = controls[end - degree - 1 :], np.insert(t[end - degree :], 0, u)
    return first, second
