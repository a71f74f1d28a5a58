"""Knots taken out of a B-spline, as often as the curve allows within a tolerance.

Points are (n, k); a rational curve is treated by its homogeneous points.
Source: Tiller, Knot-removal algorithms for NURBS curves and surfaces, 1992; The NURBS Book, algorithm A5.8,
here with its equations solved by least squares instead of from both ends.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from workbench.geometry.curves.conditions import faults, refuse
from workbench.geometry.curves.knots import multiplicity
from workbench.geometry.curves.rational import gap_between

Array = NDArray[np.float64]


class Removal(NamedTuple):
    """Points and knots left, how often the knot was taken out, and how far the curve is off at most."""

    points: Array
    knots: Array
    times: int
    error: float


def remove_knot(
    points: ArrayLike,
    knots: ArrayLike,
    degree: int,
    u: float,
    times: int = 1,
    tolerance: float = math.inf,
    rational: bool = False,
) -> Removal:
    """Take the knot u out, once or several times, but only while the curve is off by ``tolerance`` at most.

    Args: ``rational`` when the last coordinate is the weight; the error is then that of the curve projected.
    Raises: ValueError for a u that is no knot between the ends, or that is there more often than the degree.
    """
    controls, t = np.asarray(points, float), np.asarray(knots, float)
    refuse(faults(controls, t, degree))
    if not (t[degree] < u < t[len(t) - degree - 1] and multiplicity(t, u)):
        raise ValueError(f"There is no knot {u:g} between the ends of the curve; choose one that is there.")
    if multiplicity(t, u) > degree:
        raise ValueError(f"At u = {u:g} the curve is in two parts; no knot can be removed there.")
    done, error = 0, 0.0
    while done < min(times, multiplicity(knots, u)):
        fewer, apart = _once_less(controls, t, degree, u, rational)
        if not error + apart <= tolerance:
            break
        last = int(np.searchsorted(t, u, side="right")) - 1
        controls, t = fewer, np.delete(t, last)
        done, error = done + 1, error + apart
    return Removal(controls, t, done, error)


def _once_less(points: Array, knots: Array, degree: int, u: float, rational: bool) -> tuple[Array, float]:
    """The points with the knot u once less, and how far the curve is off at most.

    Put in again by Boehm's formula, the knot gives points that bound the curves' distance: by their own.
    """
    end = int(np.searchsorted(knots, u, side="right"))
    begin = end - 1 - degree
    end -= multiplicity(knots, u)
    made = np.arange(begin, end)
    alpha = (u - knots[made]) / (knots[made + degree + 1] - knots[made])
    shares = np.zeros((len(made), len(made) + 1))
    np.fill_diagonal(shares, 1.0 - alpha)
    np.fill_diagonal(shares[:, 1:], alpha)
    known = shares[:, [0, -1]] @ points[[begin - 1, end]]
    inner = np.linalg.lstsq(shares[:, 1:-1], points[begin:end] - known, rcond=None)[0]
    again = points.copy()
    again[begin:end] = known + shares[:, 1:-1] @ inner
    fewer: Array = np.vstack([points[:begin], inner, points[end:]])
    return fewer, gap_between(points, again, rational)
